// SPDX-License-Identifier: MIT
#include "app/drawing/former_places.hpp"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>

#include <fmt/format.h>
#include <pugixml.hpp>

#include "core/base/error.hpp"
#include "core/base/file.hpp"
#include "core/base/text.hpp"
#include "strat/layout/box_label.hpp"

namespace planum::app {

namespace {

constexpr std::uintmax_t kLargest = 256'000'000; // bytes; a drawing of 20,000 units has 30 million

// The middle of what a path's points enclose; they are written as `M36,112 L74,112 …`.
std::optional<strat::DrawPoint> middle_of(std::string_view path) {
    double low[2] = {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    double high[2] = {-low[0], -low[1]};
    int axis = 0;
    for (std::size_t i = 0; i < path.size();) {
        double value = 0.0;
        const auto [end, trouble] = std::from_chars(path.data() + i, path.data() + path.size(), value);
        if (trouble != std::errc{}) {
            ++i;
            continue;
        }
        low[axis] = std::min(low[axis], value);
        high[axis] = std::max(high[axis], value);
        axis = 1 - axis;
        i = static_cast<std::size_t>(end - path.data());
    }
    if (!(low[0] <= high[0] && low[1] <= high[1])) return std::nullopt;
    return strat::DrawPoint{(low[0] + high[0]) / 2.0, (low[1] + high[1]) / 2.0};
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
        if (std::string_view(node.name()) != "g" || !has_class(node, "unit")) return true;
        if (has_class(node, "isolated") || has_class(node, "folded")) return true;
        const auto middle = middle_of(node.child("path").attribute("d").value());
        if (!middle) return true;
        const std::string_view all = node.attribute("data-units").value();
        for (const std::string_view id : text::split(all.empty() ? node.attribute("id").value() : all, ' ')) {
            const auto unit = units_.find(std::string(id));
            if (unit != units_.end()) found.push_back({unit->second, *middle});
        }
        return true;
    }

    std::vector<strat::PreviousPosition> found;

  private:
    std::unordered_map<std::string, model::UnitId> units_;
};

} // namespace

std::vector<strat::PreviousPosition> former_places(const std::filesystem::path& svg, const model::Record& record) {
    const std::string bytes = read_file(svg, kLargest);
    pugi::xml_document document;
    const pugi::xml_parse_result parsed = document.load_buffer(bytes.data(), bytes.size());
    if (!parsed || std::string_view(document.document_element().name()) != "svg") {
        throw Error(ErrorCode::BadInput,
                    fmt::format("{}: no SVG{}", svg.string(), parsed ? "" : fmt::format(": {}", parsed.description())));
    }
    Places places(record);
    document.traverse(places);
    if (places.found.empty()) {
        throw Error(ErrorCode::BadInput,
                    svg.string() + ": none of the units stands in it; give a drawing that planum matrix made as SVG");
    }
    return std::move(places.found);
}

} // namespace planum::app
