// SPDX-License-Identifier: MIT
#include "app/demo/dig_columns.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "app/demo/dig_parallel.hpp"

namespace planum::app::demo {

namespace {

using model::RelationKind;
using model::UnitForm;
using model::UnitKind;

constexpr double kStep = 0.01;    ///< nothing thinner than this is missed [m]
constexpr double kExact = 0.0001; ///< boundaries are found to this [m]

std::vector<Run> scan_column(const Formation& formation, double x, double y, double top, double bottom) {
    std::vector<Run> runs;
    const auto body = [&](double z) { return formation.body_at({x, y, z}); };
    Body current = body(top);
    double start = top;
    const auto close = [&](double end) {
        if (current.unit == kAir) return;
        runs.push_back({static_cast<float>(end), static_cast<float>(start), static_cast<std::int16_t>(current.unit),
                        static_cast<std::int16_t>(current.cut)});
    };
    const int steps = static_cast<int>(std::ceil((top - bottom) / kStep));
    for (int i = 1; i <= steps; ++i) {
        const double z = top - i * kStep;
        const Body next = body(z);
        if (next == current) continue;
        double same = z + kStep;
        double other = z;
        while (same - other > kExact) {
            const double middle = 0.5 * (same + other);
            (body(middle) == current ? same : other) = middle;
        }
        close(same);
        start = same;
        current = next;
    }
    close(bottom);
    return runs;
}

class ContactCounter {
  public:
    explicit ContactCounter(const Formation& formation) : formation_(formation) {}

    void touch(const Run& a, const Run& b, double plan, double side) {
        if (a.unit == b.unit) return;
        const Run& later = a.unit > b.unit ? a : b;
        const Run& earlier = a.unit > b.unit ? b : a;
        const FormedUnit& unit = formation_.units()[static_cast<std::size_t>(later.unit)];
        if (unit.twin == earlier.unit) return add(later.unit, earlier.unit, RelationKind::SameAs, plan, side);
        if (unit.bonded == earlier.unit) return add(later.unit, earlier.unit, RelationKind::BondsWith, plan, side);
        if (later.cut > earlier.unit) {
            const bool fills = unit.form == UnitForm::Fill || unit.kind == UnitKind::Structure;
            add(later.unit, later.cut, fills ? RelationKind::Fills : RelationKind::Covers, plan, side);
            add(later.cut, earlier.unit, RelationKind::Cuts, plan, side);
            return;
        }
        add(later.unit, earlier.unit, RelationKind::Covers, plan, side);
    }

    std::vector<Contact> result() {
        std::vector<Contact> all;
        for (auto& [pair, contact] : contacts_) {
            const FormedUnit& earlier = formation_.units()[static_cast<std::size_t>(contact.earlier)];
            const double total = contact.plan_area + contact.side_area;
            // Against the face of a wall, not over it.
            if (contact.kind == RelationKind::Covers && earlier.kind == UnitKind::Structure &&
                contact.plan_area < 0.3 * total) {
                contact.kind = RelationKind::Abuts;
            }
            all.push_back(contact);
        }
        return all;
    }

  private:
    void add(UnitNo later, UnitNo earlier, RelationKind kind, double plan, double side) {
        Contact& contact = contacts_[{later, earlier}];
        contact.later = later;
        contact.earlier = earlier;
        contact.kind = kind;
        contact.plan_area += plan;
        contact.side_area += side;
    }

    const Formation& formation_;
    std::map<std::pair<UnitNo, UnitNo>, Contact> contacts_;
};

void touch_sideways(ContactCounter& counter, std::span<const Run> a, std::span<const Run> b, double cell) {
    std::size_t i = 0;
    std::size_t j = 0;
    while (i < a.size() && j < b.size()) {
        const float low = std::max(a[i].low, b[j].low);
        const float high = std::min(a[i].high, b[j].high);
        if (high > low) counter.touch(a[i], b[j], 0.0, static_cast<double>(high - low) * cell);
        if (a[i].low > b[j].low) {
            ++i;
        } else {
            ++j;
        }
    }
}

} // namespace

ColumnGrid::ColumnGrid(const SiteShape& site, const Formation& formation, Progress& progress)
    : x0_(site.trench.low.x), y0_(site.trench.low.y), cell_(site.cell),
      columns_(static_cast<std::size_t>(std::lround((site.trench.high.x - site.trench.low.x) / site.cell))),
      rows_(static_cast<std::size_t>(std::lround((site.trench.high.y - site.trench.low.y) / site.cell))) {
    std::vector<std::vector<std::vector<Run>>> by_row(rows_);
    for_each_index(rows_, progress, [&](std::size_t row) {
        by_row[row].resize(columns_);
        for (std::size_t column = 0; column < columns_; ++column) {
            by_row[row][column] =
                scan_column(formation, x_of(column), y_of(row), formation.extent().high.z, site.trench.low.z);
        }
    });
    first_.reserve(size() + 1);
    first_.push_back(0);
    for (const auto& row : by_row) {
        for (const auto& runs : row) {
            runs_.insert(runs_.end(), runs.begin(), runs.end());
            first_.push_back(runs_.size());
        }
    }
}

std::vector<Contact> find_contacts(const ColumnGrid& grid, const Formation& formation) {
    constexpr float kGap = 0.001F; // air between two runs of a column: they do not touch
    ContactCounter counter(formation);
    const double area = grid.cell() * grid.cell();
    for (std::size_t row = 0; row < grid.rows(); ++row) {
        for (std::size_t column = 0; column < grid.columns(); ++column) {
            const std::size_t index = row * grid.columns() + column;
            const auto runs = grid.at(index);
            for (std::size_t i = 1; i < runs.size(); ++i) {
                if (runs[i - 1].low - runs[i].high < kGap) counter.touch(runs[i - 1], runs[i], area, 0.0);
            }
            if (column + 1 < grid.columns()) touch_sideways(counter, runs, grid.at(index + 1), grid.cell());
            if (row + 1 < grid.rows()) touch_sideways(counter, runs, grid.at(index + grid.columns()), grid.cell());
        }
    }
    return counter.result();
}

} // namespace planum::app::demo
