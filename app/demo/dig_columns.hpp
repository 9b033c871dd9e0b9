// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "app/demo/simulator_composition.hpp"
#include "app/demo/simulator_formation.hpp"
#include "core/base/progress.hpp"
#include "core/model/relation.hpp"

namespace planum::app::demo {

/// A piece of one vertical column that is one unit.
struct Run {
    float low = 0.0F; ///< [m, site]
    float high = 0.0F;
    std::int16_t unit = 0;
    std::int16_t cut = kAir; ///< the last cut that had emptied it

    friend bool operator==(const Run&, const Run&) = default;
};

/// The trench as vertical columns through the middles of square cells, each from the top down.
class ColumnGrid {
  public:
    ColumnGrid(const SiteShape& site, const Formation& formation, Progress& progress);

    [[nodiscard]] std::size_t columns() const noexcept { return columns_; }

    [[nodiscard]] std::size_t rows() const noexcept { return rows_; }

    [[nodiscard]] std::size_t size() const noexcept { return columns_ * rows_; }

    [[nodiscard]] double cell() const noexcept { return cell_; }

    [[nodiscard]] double x_of(std::size_t column) const noexcept {
        return x0_ + (static_cast<double>(column) + 0.5) * cell_;
    }

    [[nodiscard]] double y_of(std::size_t row) const noexcept { return y0_ + (static_cast<double>(row) + 0.5) * cell_; }

    [[nodiscard]] double x0() const noexcept { return x0_; }

    [[nodiscard]] double y0() const noexcept { return y0_; }

    [[nodiscard]] std::span<const Run> at(std::size_t index) const noexcept {
        return {runs_.data() + first_[index], first_[index + 1] - first_[index]};
    }

  private:
    double x0_;
    double y0_;
    double cell_;
    std::size_t columns_;
    std::size_t rows_;
    std::vector<std::size_t> first_;
    std::vector<Run> runs_;
};

/// Two units that touch. `later` is the subject of the relation.
struct Contact {
    UnitNo later = 0;
    UnitNo earlier = 0;
    model::RelationKind kind = model::RelationKind::Covers;
    double plan_area = 0.0; ///< of the contact seen from above [m²]
    double side_area = 0.0; ///< of its steep parts, seen from the side [m²]
};

/// All contacts, sorted by later and earlier; those of a cut count where the hollow's side is.
[[nodiscard]] std::vector<Contact> find_contacts(const ColumnGrid& grid, const Formation& formation);

} // namespace planum::app::demo
