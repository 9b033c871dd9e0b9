// SPDX-License-Identifier: MIT
#include "app/evidence/step_cache.hpp"

#include <algorithm>
#include <cstring>
#include <string_view>
#include <tuple>
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

using Names = StepCache::Names;

UnitNumber number(const Names& names, const json& text) { return names.number(text.get_ref<const std::string&>()); }

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

scans::SurfaceSummary summary_from(const json& j, const Names& names) {
    scans::SurfaceSummary summary;
    for (const json& s : j.at("showings")) {
        summary.showings.push_back(
            {number(names, s.at(0)), s.at(1), s.at(2), s.at(3), s.at(4), s.at(5), s.at(6), s.at(7)});
    }
    for (const json& e : j.at("edges")) {
        const auto [a, b] = std::minmax({number(names, e.at(0)), number(names, e.at(1))});
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

scans::SurfaceStep step_from(const json& j, const Names& names) {
    scans::SurfaceStep step;
    step.cell = j.at("cell");
    for (const json& s : j.at("successions")) {
        step.successions.push_back({number(names, s.at(0)), number(names, s.at(1)), s.at(2), s.at(3), s.at(4), s.at(5),
                                    s.at(6), s.at(7), s.at(8), s.at(9), s.at(10), s.at(11)});
    }
    for (const json& e : j.at("edges")) {
        scans::EdgeMigration edge{
            number(names, e.at(0)), number(names, e.at(1)), e.at(2), e.at(3), e.at(4), e.at(5), e.at(6)};
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
auto read_as(const fs::path& file, const Read& read) -> std::optional<decltype(read(json{}))> {
    const auto bytes = read_sealed(file);
    if (!bytes) return std::nullopt;
    try {
        return read(json::parse(*bytes));
    } catch (const json::exception&) {
        return std::nullopt;
    } catch (const Error&) {
        return std::nullopt;
    }
}

} // namespace

StepCache::Names::Names(std::span<const scans::KnownUnit> units) {
    texts_.reserve(units.size());
    for (const scans::KnownUnit& unit : units) {
        texts_.push_back(unit.id.value.to_string());
        numbers_.emplace(texts_.back(), static_cast<UnitNumber>(numbers_.size()));
    }
}

scans::UnitNumber StepCache::Names::number(const std::string& text) const {
    const auto found = numbers_.find(text);
    if (found == numbers_.end()) throw Error(ErrorCode::NotFound, "a unit that is not outlined");
    return found->second;
}

StepCache::StepCache(fs::path folder, std::span<const scans::KnownUnit> units)
    : folder_(std::move(folder)), names_(units) {}

std::optional<scans::SurfaceSummary> StepCache::summary(const std::string& key) const {
    return read_as(file_of(folder_, key, ".summary"), [&](const json& j) { return summary_from(j, names_); });
}

void StepCache::keep(const std::string& key, const scans::SurfaceSummary& summary) const {
    write_sealed(file_of(folder_, key, ".summary"), to_json(summary, names_).dump());
}

std::optional<scans::SurfaceStep> StepCache::step(const std::string& key) const {
    return read_as(file_of(folder_, key, ".step"), [&](const json& j) { return step_from(j, names_); });
}

void StepCache::keep(const std::string& key, const scans::SurfaceStep& step) const {
    write_sealed(file_of(folder_, key, ".step"), to_json(step, names_).dump());
}

std::optional<double> StepCache::density(const std::string& key) const {
    return read_as(file_of(folder_, key, ".density"), [](const json& j) { return j.at("density").get<double>(); });
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
