// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
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
    /// Units by id in a file, by number in memory.
    class Names {
      public:
        explicit Names(std::span<const scans::KnownUnit> units);

        [[nodiscard]] const std::string& text(scans::UnitNumber number) const {
            return texts_[static_cast<std::size_t>(number)];
        }

        /// Throws NotFound for a unit that is not among them.
        [[nodiscard]] scans::UnitNumber number(const std::string& text) const;

      private:
        std::vector<std::string> texts_;
        std::unordered_map<std::string, scans::UnitNumber> numbers_;
    };

    /// `units` by number.
    StepCache(std::filesystem::path folder, std::span<const scans::KnownUnit> units);

    [[nodiscard]] std::optional<scans::SurfaceSummary> summary(const std::string& key) const;
    void keep(const std::string& key, const scans::SurfaceSummary& summary) const;

    [[nodiscard]] std::optional<scans::SurfaceStep> step(const std::string& key) const;
    void keep(const std::string& key, const scans::SurfaceStep& step) const;

    /// Points a cell inside the outlines.
    [[nodiscard]] std::optional<double> density(const std::string& key) const;
    void keep_density(const std::string& key, double density) const;

    /// Lowest heights so far, one a cell.
    [[nodiscard]] std::optional<std::vector<float>> floor(const std::string& key, std::size_t cells) const;
    void keep_floor(const std::string& key, std::span<const float> floor) const;

  private:
    std::filesystem::path folder_;
    Names names_;
};

} // namespace planum::app
