// SPDX-License-Identifier: MIT
#include "app/drawing/former_places.hpp"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <pugixml.hpp>

#include "core/base/error.hpp"
#include "core/base/file.hpp"
#include "core/base/text.hpp"
#include "strat/layout/box_label.hpp"

namespace planum::app {

namespace {

constexpr std::uintmax_t kLargest = 256'000'000; // bytes; a drawing of 20,000 units has 30 million

// The points of a path; they are written as `M36,112 L74,112 …`.
std::vector<strat::DrawPoint> points_of(std::string_view path) {
    std::vector<double> numbers;
    for (std::size_t i = 0; i < path.size();) {
        double value = 0.0;
        const auto [end, trouble] = std::from_chars(path.data() + i, path.data() + path.size(), value);
        if (trouble != std::errc{}) {
            ++i;
            continue;
        }
        numbers.push_back(value);
        i = static_cast<std::size_t>(end - path.data());
    }
    std::vector<strat::DrawPoint> points;
    for (std::size_t i = 1; i < numbers.size(); i += 2) points.push_back({numbers[i - 1], numbers[i]});
    return points;
}

/// Of what the points enclose.
std::optional<strat::DrawPoint> middle_of(const std::vector<strat::DrawPoint>& points) {
    if (points.empty()) return std::nullopt;
    strat::DrawPoint low = points.front();
    strat::DrawPoint high = low;
    for (const strat::DrawPoint& p : points) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    return strat::DrawPoint{(low.x + high.x) / 2.0, (low.y + high.y) / 2.0};
}

bool has_class(const pugi::xml_node& node, std::string_view wanted) {
    const auto words = text::split(node.attribute("class").value(), ' ');
    return std::find(words.begin(), words.end(), wanted) != words.end();
}

class Places : public pugi::xml_tree_walker {
  public:
    explicit Places(const model::Record& record) {
        const model::RecordIndex index(record);
        for (const model::StratigraphicUnit& unit : record.units) {
            units_.emplace(strat::xml_id("unit-", index.name(unit.id)), unit.id);
        }
    }

    bool for_each(pugi::xml_node& node) override {
        if (std::string_view(node.name()) != "g") return true;
        if (has_class(node, "unit")) take_box(node);
        if (has_class(node, "order")) lines_.push_back(node);
        return true;
    }

    [[nodiscard]] strat::PreviousDrawing found() && {
        for (const pugi::xml_node& line : lines_) { // they may stand before their boxes
            const auto later = first_in_.find(line.attribute("data-later").value());
            const auto earlier = first_in_.find(line.attribute("data-earlier").value());
            if (later == first_in_.end() || earlier == first_in_.end()) continue;
            found_.lines.push_back(
                {later->second, earlier->second, points_of(line.child("path").attribute("d").value())});
        }
        return std::move(found_);
    }

  private:
    void take_box(const pugi::xml_node& node) {
        if (has_class(node, "isolated") || has_class(node, "folded")) return;
        const auto middle = middle_of(points_of(node.child("path").attribute("d").value()));
        if (!middle) return;
        const std::string box = node.attribute("id").value();
        const std::string_view all = node.attribute("data-units").value();
        for (const std::string_view id : text::split(all.empty() ? std::string_view(box) : all, ' ')) {
            const auto unit = units_.find(std::string(id));
            if (unit == units_.end()) continue;
            found_.units.push_back({unit->second, *middle});
            first_in_.emplace(box, unit->second);
        }
    }

    std::unordered_map<std::string, model::UnitId> units_;
    std::unordered_map<std::string, model::UnitId> first_in_; // by the id of a box
    std::vector<pugi::xml_node> lines_;
    strat::PreviousDrawing found_;
};

} // namespace

strat::PreviousDrawing former_places(const std::filesystem::path& svg, const model::Record& record) {
    const std::string bytes = read_file(svg, kLargest);
    pugi::xml_document document;
    const pugi::xml_parse_result parsed = document.load_buffer(bytes.data(), bytes.size());
    if (!parsed || std::string_view(document.document_element().name()) != "svg") {
        throw Error(ErrorCode::BadInput,
                    fmt::format("{}: no SVG{}", svg.string(), parsed ? "" : fmt::format(": {}", parsed.description())));
    }
    Places places(record);
    document.traverse(places);
    strat::PreviousDrawing found = std::move(places).found();
    if (found.units.empty()) {
        throw Error(ErrorCode::BadInput,
                    svg.string() + ": none of the units stands in it; give a drawing that planum matrix made as SVG");
    }
    return found;
}

} // namespace planum::app
