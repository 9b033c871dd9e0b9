// SPDX-License-Identifier: MIT
#include "app/records/field_table.hpp"

#include <algorithm>

#include "app/scans/days_surface.hpp"
#include "core/model/surface_order.hpp"

namespace planum::app {

namespace {

constexpr const char* kMethods = "stratigraphic, planum, mixed";

std::vector<Field<model::Area>> area_fields() {
    using A = model::Area;
    return {text_field<A>("title", "name in full", &A::title),
            word_field<A>("method", "how it is dug", &A::method, model::dig_method_from_word, kMethods),
            text_field<A>("first-number", "first unit number issued to it", &A::first_number),
            text_field<A>("last-number", "last unit number issued to it", &A::last_number)};
}

std::vector<Field<model::Surface>> surface_fields() {
    using S = model::Surface;
    std::vector<Field<S>> fields = {
        named_field<S, model::Area>("area", "trench", &S::area, &model::Record::areas, &model::Area::name),
        word_field<S>("method", "how it was made", &S::method, model::dig_method_from_word, kMethods),
        date_field<S>("first-day", "first day", &S::first_day), date_field<S>("last-day", "last day", &S::last_day)};
    fields.push_back({{"order", "place in time among the surfaces of its area"},
                      [](const S& surface, Project&) { return fmt::format("{}", surface.order); },
                      [](S& surface, const std::string& text, Project&) {
                          surface.order = integer_from("order", text).value_or(0);
                      }});
    return fields;
}

// A surface without a name of its own goes by its day.
class SurfaceKind final : public NamedKind<model::Surface> {
  public:
    SurfaceKind() : NamedKind("surface", &model::Record::surfaces, &model::Surface::name, surface_fields()) {}

    [[nodiscard]] std::vector<std::string> remarks(Project& project, const std::string& name,
                                                   const FieldValues& values) const override {
        model::Record wished = project.record();
        const model::SurfaceId id = find(project, name).id;
        model::Surface& surface = *std::find_if(wished.surfaces.begin(), wished.surfaces.end(),
                                                [&](const model::Surface& one) { return one.id == id; });
        for (const auto& [field, text] : values) {
            if (field == "first-day") surface.first_day = date_from(field, text);
            if (field == "last-day") surface.last_day = date_from(field, text);
            if (field == "order") surface.order = integer_from(field, text).value_or(0);
        }
        std::vector<std::string> said;
        if (!surface.last_day.empty() && surface.last_day < surface.first_day)
            said.push_back(
                fmt::format("{} ends on {}, before it begins on {}", name, surface.last_day, surface.first_day));
        for (const model::OrderClash& clash : model::clashes_of_order(wished)) {
            if (clash.earlier->id != id && clash.later->id != id) continue;
            said.push_back(
                fmt::format("surface {} stands before {}, though its day is later: nothing is concluded from "
                            "either until --order or their days are put right",
                            surface_name(wished, *clash.earlier), surface_name(wished, *clash.later)));
        }
        return said;
    }

  protected:
    [[nodiscard]] std::string name_of(const model::Surface& surface, Project& project) const override {
        return surface_name(project.record(), surface);
    }
};

} // namespace

void add_place_kinds(std::vector<std::unique_ptr<RecordKind>>& kinds) {
    using model::Record;
    kinds.push_back(
        std::make_unique<NamedKind<model::Area>>("area", &Record::areas, &model::Area::name, area_fields()));
    kinds.push_back(std::make_unique<SurfaceKind>());
    kinds.push_back(make_region_kind());
}

} // namespace planum::app
