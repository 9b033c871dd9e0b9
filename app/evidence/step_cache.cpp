// SPDX-License-Identifier: MIT
#include "app/evidence/step_cache.hpp"

#include <algorithm>
#include <cstring>
#include <string_view>
#include <tuple>
#include <unordered_map>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/project/sealed_file.hpp"
#include "core/base/error.hpp"

namespace planum::app {

namespace fs = std::filesystem;
using nlohmann::json;
using scans::UnitNumber;

namespace {

fs::path file_of(const fs::path& folder, const std::string& key, std::string_view ending) {
    return folder / (key.substr(0, 32) + std::string(ending));
}

// Units by id in a file, by number in memory.
class Names {
  public:
    explicit Names(std::span<const scans::KnownUnit> units) : units_(units) {}

    [[nodiscard]] std::string text(UnitNumber number) const {
        return units_[static_cast<std::size_t>(number)].id.value.to_string();
    }

    // Throws NotFound for a unit that is not outlined here.
    [[nodiscard]] UnitNumber number(const json& text) {
        if (numbers_.empty()) {
            for (std::size_t i = 0; i < units_.size(); ++i)
                numbers_.emplace(units_[i].id.value.to_string(), static_cast<UnitNumber>(i));
        }
        const auto found = numbers_.find(text.get<std::string>());
        if (found == numbers_.end()) throw Error(ErrorCode::NotFound, "a unit that is not outlined");
        return found->second;
    }

  private:
    std::span<const scans::KnownUnit> units_;
    std::unordered_map<std::string, UnitNumber> numbers_;
};

json to_json(const scans::SurfaceSummary& summary, const Names& names) {
    json showings = json::array();
    for (const scans::Showing& s : summary.showings) {
        showings.push_back({names.text(s.unit), s.cells, s.level_cells, s.cut_cells, s.overdug_cells, s.height,
                            s.perimeter, s.open_edge});
    }
    json edges = json::array();
    for (const scans::SharedEdge& e : summary.edges) edges.push_back({names.text(e.a), names.text(e.b), e.length});
    return {{"showings", std::move(showings)}, {"edges", std::move(edges)}};
}

scans::SurfaceSummary summary_from(const json& j, Names& names) {
    scans::SurfaceSummary summary;
    for (const json& s : j.at("showings")) {
        summary.showings.push_back(
            {names.number(s.at(0)), s.at(1), s.at(2), s.at(3), s.at(4), s.at(5), s.at(6), s.at(7)});
    }
    for (const json& e : j.at("edges")) {
        const auto [a, b] = std::minmax({names.number(e.at(0)), names.number(e.at(1))});
        summary.edges.push_back({a, b, e.at(2)});
    }
    std::sort(summary.showings.begin(), summary.showings.end(),
              [](const auto& x, const auto& y) { return x.unit < y.unit; });
    std::sort(summary.edges.begin(), summary.edges.end(),
              [](const auto& x, const auto& y) { return std::tie(x.a, x.b) < std::tie(y.a, y.b); });
    return summary;
}

json to_json(const scans::SurfaceStep& step, const Names& names) {
    json successions = json::array();
    for (const scans::Succession& s : step.successions) {
        successions.push_back({names.text(s.first), names.text(s.then), s.cells, s.lower, s.thin, s.drop, s.tolerance,
                               s.level, s.cut_first, s.cut_then, s.overdug, s.hidden});
    }
    json edges = json::array();
    for (const scans::EdgeMigration& e : step.edges) {
        edges.push_back({names.text(e.a), names.text(e.b), e.length, e.followed, e.into_a, e.into_b, e.spit});
    }
    return {{"cell", step.cell}, {"successions", std::move(successions)}, {"edges", std::move(edges)}};
}

scans::SurfaceStep step_from(const json& j, Names& names) {
    scans::SurfaceStep step;
    step.cell = j.at("cell");
    for (const json& s : j.at("successions")) {
        step.successions.push_back({names.number(s.at(0)), names.number(s.at(1)), s.at(2), s.at(3), s.at(4), s.at(5),
                                    s.at(6), s.at(7), s.at(8), s.at(9), s.at(10), s.at(11)});
    }
    for (const json& e : j.at("edges")) {
        scans::EdgeMigration edge{
            names.number(e.at(0)), names.number(e.at(1)), e.at(2), e.at(3), e.at(4), e.at(5), e.at(6)};
        if (edge.a > edge.b) {
            std::swap(edge.a, edge.b);
            std::swap(edge.into_a, edge.into_b);
        }
        step.edges.push_back(edge);
    }
    std::sort(step.successions.begin(), step.successions.end(),
              [](const auto& x, const auto& y) { return std::tie(x.first, x.then) < std::tie(y.first, y.then); });
    std::sort(step.edges.begin(), step.edges.end(),
              [](const auto& x, const auto& y) { return std::tie(x.a, x.b) < std::tie(y.a, y.b); });
    return step;
}

template<class Read>
auto read_as(const fs::path& file, std::span<const scans::KnownUnit> units, Read read)
    -> std::optional<decltype(read(json{}, std::declval<Names&>()))> {
    const auto bytes = read_sealed(file);
    if (!bytes) return std::nullopt;
    Names names(units);
    try {
        return read(json::parse(*bytes), names);
    } catch (const json::exception&) {
        return std::nullopt;
    } catch (const Error&) {
        return std::nullopt;
    }
}

} // namespace

std::optional<scans::SurfaceSummary> StepCache::summary(const std::string& key, Units units) const {
    return read_as(file_of(folder_, key, ".summary"), units, summary_from);
}

void StepCache::keep(const std::string& key, const scans::SurfaceSummary& summary, Units units) const {
    write_sealed(file_of(folder_, key, ".summary"), to_json(summary, Names(units)).dump());
}

std::optional<scans::SurfaceStep> StepCache::step(const std::string& key, Units units) const {
    return read_as(file_of(folder_, key, ".step"), units, step_from);
}

void StepCache::keep(const std::string& key, const scans::SurfaceStep& step, Units units) const {
    write_sealed(file_of(folder_, key, ".step"), to_json(step, Names(units)).dump());
}

std::optional<double> StepCache::density(const std::string& key) const {
    return read_as(file_of(folder_, key, ".density"), {},
                   [](const json& j, const Names&) { return j.at("density").get<double>(); });
}

void StepCache::keep_density(const std::string& key, double density) const {
    write_sealed(file_of(folder_, key, ".density"), json{{"density", density}}.dump());
}

std::optional<std::vector<float>> StepCache::floor(const std::string& key, std::size_t cells) const {
    const auto bytes = read_sealed(file_of(folder_, key, ".floor"));
    if (!bytes || bytes->size() != cells * sizeof(float)) return std::nullopt;
    std::vector<float> floor(cells);
    std::memcpy(floor.data(), bytes->data(), bytes->size());
    return floor;
}

void StepCache::keep_floor(const std::string& key, std::span<const float> floor) const {
    std::string bytes(floor.size_bytes(), '\0');
    std::memcpy(bytes.data(), floor.data(), bytes.size());
    write_sealed(file_of(folder_, key, ".floor"), std::move(bytes));
}

} // namespace planum::app
