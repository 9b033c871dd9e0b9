// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/model/ids.hpp"
#include "scans/surface/surface_step.hpp"

namespace planum::app {

/// What was found about surfaces, pair of units by pair, in NAME.scans/evidence by the hash of what it was made from.
/// Files name units by id, so a new unit in the list moves nothing. A file that is missing, damaged or names a unit
/// that is not outlined any more reads as nothing; what cannot be written is done without.
class StepCache {
  public:
    using Units = std::span<const scans::KnownUnit>;

    explicit StepCache(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// `units` by number, here and below.
    [[nodiscard]] std::optional<scans::SurfaceSummary> summary(const std::string& key, Units units) const;
    void keep(const std::string& key, const scans::SurfaceSummary& summary, Units units) const;

    [[nodiscard]] std::optional<scans::SurfaceStep> step(const std::string& key, Units units) const;
    void keep(const std::string& key, const scans::SurfaceStep& step, Units units) const;

    /// Points a cell inside the outlines.
    [[nodiscard]] std::optional<double> density(const std::string& key) const;
    void keep_density(const std::string& key, double density) const;

    /// Lowest heights so far, one a cell.
    [[nodiscard]] std::optional<std::vector<float>> floor(const std::string& key, std::size_t cells) const;
    void keep_floor(const std::string& key, std::span<const float> floor) const;

  private:
    std::filesystem::path folder_;
};

} // namespace planum::app
