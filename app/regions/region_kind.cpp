// SPDX-License-Identifier: MIT
#include <algorithm>

#include "app/records/field_table.hpp"
#include "app/regions/outline.hpp"
#include "app/regions/outline_remarks.hpp"
#include "app/regions/outline_text.hpp"
#include "app/regions/region_layout.hpp"
#include "app/regions/region_names.hpp"
#include "app/regions/section_plane.hpp"
#include "app/scans/days_surface.hpp"
#include "core/geometry/polygon_overlay.hpp"

namespace planum::app {

namespace {

using model::Region;

constexpr const char* kShowsWords = "top, level, cut, overdug, machine, face, nothing";
constexpr const char* kCategoryWords = "unit, spoil, slump, backfill, water, equipment, baulk, unexcavated";

// In site coordinates; on a section it is made sound in its plane.
geometry::SoundPolygon sound_outline(const Region& region, const geometry::MultiPolygon& shape, Project& project) {
    return sound_in_site(shape, section_of(project.record(), region));
}

void set_outline(Region& region, const std::string& text, Project& project) {
    geometry::MultiPolygon shape = parse_outline(text);
    region.has_heights = settle_heights(shape) || !region.section.is_nil();
    region.outline = outline_of(sound_outline(region, shape, project).shape);
    region.drawn_on = "typed";
}

std::vector<Field<Region>> region_fields() {
    std::vector<Field<Region>> fields = {unit_field<Region>("unit", "unit it shows; empty: none", &Region::unit),
                                         word_field<Region>("category", "what it encloses", &Region::category,
                                                            model::region_category_from_word, kCategoryWords),
                                         word_field<Region>("shows", "what of the unit it shows", &Region::shows,
                                                            model::region_shows_from_word, kShowsWords)};
    fields.push_back({{"outline", "corners in site coordinates: \"x y z, x y z, …\" or without heights, or WKT"},
                      [](const Region& region, Project&) { return outline_text(shape_with_heights(region)); },
                      set_outline});
    fields.push_back({{"sigma", "uncertainty of the outline [m]"},
                      [](const Region& region, Project&) { return fmt::format("{}", region.sigma); },
                      [](Region& region, const std::string& text, Project&) {
                          const auto sigma = number_from("sigma", text);
                          if (!sigma || *sigma < 0.0) throw Error(ErrorCode::BadInput, "sigma: metres, not below 0");
                          region.sigma = *sigma;
                      }});
    fields.push_back(unit_field<Region>("seen-in", "cut whose side shows it", &Region::seen_in));
    fields.push_back(text_field<Region>("notes", "notes", &Region::notes));
    return fields;
}

// Regions are `SURFACE/UNIT#n`; to add one, name `SURFACE/UNIT` (or `SURFACE/CATEGORY`) and give its outline.
class RegionKind final : public FieldTableKind<Region> {
  public:
    RegionKind()
        : FieldTableKind("region", "SURFACE/UNIT (to add) or SURFACE/UNIT#n", &model::Record::regions,
                         region_fields()) {}

    [[nodiscard]] FieldValues show(Project& project, const std::string& name) const override {
        FieldValues values = FieldTableKind::show(project, name);
        const Region& region = find(project, name);
        if (!region.unit_as_drawn.empty()) values.emplace_back("unit-as-drawn", region.unit_as_drawn);
        values.emplace_back("drawn-on", region.drawn_on);
        values.emplace_back("area-m2", fmt::format("{:.4f}", region_area(project.record(), region)));
        return values;
    }

    std::string add(Project& project, const std::string& name, const FieldValues& values) const override {
        const auto given = [&](const char* field) {
            return std::any_of(values.begin(), values.end(), [&](const auto& v) { return v.first == field; });
        };
        if (!given("outline"))
            throw Error(ErrorCode::Usage, "a region needs its outline: --outline \"x y z, x y z, …\"");
        if (given("shows")) return FieldTableKind::add(project, name, values);
        FieldValues with = values;
        with.emplace_back("shows", std::string(to_word(shows_of(project, name, values))));
        return FieldTableKind::add(project, name, with);
    }

    // What a region shows follows its unit and its category, unless somebody said otherwise.
    void set(Project& project, const std::string& name, const FieldValues& values) const override {
        const Region& old = find(project, name);
        Region wished = old;
        bool shows_given = false;
        for (const auto& [field, text] : values) {
            shows_given = shows_given || field == "shows";
            if (field == "category") wished.category = model::region_category_from_word(text).value_or(wished.category);
            if (field != "unit") continue;
            wished.unit = text.empty() ? model::UnitId{} : project.record().units[project.unit_named(text)].id;
        }
        const bool as_usual = old.shows == usual_shows(project.record(), old);
        const bool no_unit_now = wished.category != old.category && wished.category != model::RegionCategory::Unit;
        if (shows_given || !(as_usual || no_unit_now)) return FieldTableKind::set(project, name, values);
        FieldValues with = values;
        with.emplace_back("shows", std::string(to_word(usual_shows(project.record(), wished))));
        FieldTableKind::set(project, name, with);
    }

    // What was mended of a typed outline, and what is odd about where it lies.
    [[nodiscard]] std::vector<std::string> remarks(Project& project, const std::string& name,
                                                   const FieldValues& values) const override {
        std::vector<std::string> said;
        for (const auto& [field, text] : values) {
            if (field != "outline") continue;
            geometry::MultiPolygon settled = parse_outline(text);
            (void)settle_heights(settled);
            Region wished = find(project, name);
            const geometry::SoundPolygon sound = sound_outline(wished, settled, project);
            for (const std::string& repair : sound.repairs) said.push_back("outline mended: " + repair);
            wished.outline = outline_of(sound.shape);
            for (std::string& remark : outline_remarks(project.record(), project.index(), wished))
                said.push_back(std::move(remark));
        }
        return said;
    }

  protected:
    [[nodiscard]] std::string name_of(const Region& region, Project& project) const override {
        return region_name(project.record(), project.index(), region);
    }

    [[nodiscard]] const Region& find(Project& project, const std::string& name) const override {
        return region_named(project, name);
    }

    [[nodiscard]] Region make(Project& project, const std::string& name) const override {
        const std::size_t slash = name.find('/');
        if (slash == std::string::npos) {
            throw Error(ErrorCode::BadInput, fmt::format("{}: name a new region SURFACE/UNIT", name));
        }
        Region region;
        const std::string place = name.substr(0, slash);
        for (const model::Section& section : project.record().sections) {
            if (section.name == place) region.section = section.id;
        }
        if (region.section.is_nil()) {
            const model::Surface* surface = surface_named(project.record(), place, {});
            if (surface == nullptr) {
                throw Error(ErrorCode::NotFound, fmt::format("no surface {}; planum surface list names all", place));
            }
            region.surface = surface->id;
        }
        std::string label = name.substr(slash + 1);
        label = label.substr(0, label.find('#'));
        if (const auto category = model::region_category_from_word(label)) {
            region.category = *category;
        } else {
            region.unit = project.record().units[project.unit_named(label)].id;
        }
        region.part = free_part(project.record(), region);
        return region;
    }

    // The number as drawn stays with a region that gets another unit: the same outlines, imported again, are found by
    // it.
    void write(Project& project, const Region& value) const override {
        Region region = value;
        for (const Region& old : project.record().regions) {
            if (old.id != region.id || old.unit == region.unit || old.unit.is_nil()) continue;
            if (!region.unit_as_drawn.empty() || region.drawn_on == "typed") continue;
            const model::StratigraphicUnit& unit = project.record().units[project.index().find(old.unit)];
            region.unit_as_drawn = number_as_drawn(project.record(), old, unit.number, unit.area);
        }
        region.part = free_part(project.record(), region);
        project.file().update(region);
    }

  private:
    [[nodiscard]] model::RegionShows shows_of(Project& project, const std::string& name,
                                              const FieldValues& values) const {
        Region region = make(project, name);
        for (const auto& [field, text] : values) {
            if (field == "category") region.category = model::region_category_from_word(text).value_or(region.category);
        }
        return usual_shows(project.record(), region);
    }
};

} // namespace

std::unique_ptr<RecordKind> make_region_kind() { return std::make_unique<RegionKind>(); }

} // namespace planum::app
