// SPDX-License-Identifier: MIT
#include "app/demo/trench_history.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <tuple>

namespace planum::app {

namespace {

using model::RelationKind;
using model::UnitForm;
using model::UnitKind;

constexpr int kWide = 20;
constexpr int kHigh = 14;
constexpr double kCell = 0.5; // m

struct Entry {
    std::uint32_t unit;
    double top;
};

class Trench {
  public:
    explicit Trench(Random& random) : random_(random), columns_(static_cast<std::size_t>(kWide * kHigh)) {
        const std::uint32_t natural = add_unit(UnitKind::Natural, UnitForm::None);
        const double slope_x = random_.between(-0.03, 0.03);
        const double slope_y = random_.between(-0.03, 0.03);
        const double height = random_.between(90.0, 110.0);
        for (int y = 0; y < kHigh; ++y) {
            for (int x = 0; x < kWide; ++x) {
                column(x, y).push_back(
                    {natural, height + kCell * (slope_x * x + slope_y * y) + 0.01 * random_.normal()});
            }
        }
    }

    void grow(std::size_t units) {
        while (units_.size() < units) {
            const double what = random_.unit();
            if (what < 0.58) {
                lay();
            } else if (what < 0.84) {
                dig_pit();
            } else if (what < 0.88) {
                dig_grave();
            } else {
                build();
            }
        }
    }

    [[nodiscard]] TrenchHistory finish() {
        for (int y = 0; y < kHigh; ++y) {
            for (int x = 0; x < kWide; ++x) {
                const auto& stack = column(x, y);
                for (std::size_t i = 0; i < stack.size(); ++i) {
                    const double base = i == 0 ? stack[i].top - 0.5 : stack[i - 1].top;
                    const double cx = kCell * (x + 0.5);
                    const double cy = kCell * (y + 0.5);
                    units_[stack[i].unit].cells.push_back({cx, cy, stack[i].top, std::min(base, stack[i].top)});
                }
            }
        }
        return keep_what_is_left();
    }

  private:
    Random& random_;
    std::vector<std::vector<Entry>> columns_;
    std::vector<TrenchUnit> units_;
    std::map<std::tuple<std::uint32_t, std::uint32_t, RelationKind>, std::uint32_t> contacts_;

    struct Spot {
        int x;
        int y;
        double depth; // 1 in the middle, 0 at the edge
    };

    std::vector<Entry>& column(int x, int y) {
        return columns_[static_cast<std::size_t>(y) * kWide + static_cast<std::size_t>(x)];
    }

    std::uint32_t add_unit(UnitKind kind, UnitForm form) {
        units_.push_back({kind, form, static_cast<double>(units_.size()), {}});
        return static_cast<std::uint32_t>(units_.size() - 1);
    }

    void touch(std::uint32_t later, std::uint32_t earlier, RelationKind kind) {
        if (later != earlier) ++contacts_[{later, earlier, kind}];
    }

    std::vector<Spot> blob(double least_radius, double most_radius) {
        const double rx = random_.between(least_radius, most_radius);
        const double ry = random_.between(least_radius, most_radius);
        const double mx = random_.between(0.0, kWide);
        const double my = random_.between(0.0, kHigh);
        std::vector<Spot> spots;
        for (int y = 0; y < kHigh; ++y) {
            for (int x = 0; x < kWide; ++x) {
                const double dx = (x + 0.5 - mx) / rx;
                const double dy = (y + 0.5 - my) / ry;
                const double inside = 1.0 - dx * dx - dy * dy;
                if (inside > 0.0) spots.push_back({x, y, inside});
            }
        }
        if (spots.empty()) {
            spots.push_back(
                {std::min(static_cast<int>(mx), kWide - 1), std::min(static_cast<int>(my), kHigh - 1), 1.0});
        }
        return spots;
    }

    // A layer does not climb a wall that stands higher than the layer is thick; it leans on it.
    void lay() {
        const double thickness = random_.between(0.05, 0.25);
        const std::vector<Spot> spots = blob(1.5, 7.0);
        const std::uint32_t layer = add_unit(UnitKind::Deposit, UnitForm::Layer);
        std::vector<Spot> taken;
        for (const Spot& s : spots) {
            if (stands_out(s.x, s.y, thickness)) continue;
            taken.push_back(s);
        }
        if (taken.empty()) taken = {spots.front()};
        for (const Spot& s : taken) {
            lean(layer, s);
            auto& stack = column(s.x, s.y);
            touch(layer, stack.back().unit, RelationKind::Covers);
            stack.push_back({layer, stack.back().top + thickness * (0.3 + 0.7 * s.depth)});
        }
    }

    [[nodiscard]] bool stands_out(int x, int y, double thickness) {
        const Entry& top = column(x, y).back();
        if (units_[top.unit].kind != UnitKind::Structure) return false;
        for (const auto& [dx, dy] : kBeside) {
            if (!inside(x + dx, y + dy)) continue;
            const Entry& beside = column(x + dx, y + dy).back();
            if (units_[beside.unit].kind != UnitKind::Structure && beside.top + thickness < top.top) return true;
        }
        return false;
    }

    void lean(std::uint32_t layer, const Spot& s) {
        for (const auto& [dx, dy] : kBeside) {
            if (!inside(s.x + dx, s.y + dy)) continue;
            const Entry& beside = column(s.x + dx, s.y + dy).back();
            if (units_[beside.unit].kind == UnitKind::Structure && beside.top > column(s.x, s.y).back().top) {
                touch(layer, beside.unit, RelationKind::Abuts);
            }
        }
    }

    static constexpr std::array<std::pair<int, int>, 4> kBeside = {{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};

    static bool inside(int x, int y) { return x >= 0 && y >= 0 && x < kWide && y < kHigh; }

    // Takes the ground away and leaves the cut's surface; natural ground is never dug through.
    std::uint32_t cut(const std::vector<Spot>& spots, double depth) {
        const std::uint32_t cut = add_unit(UnitKind::Cut, UnitForm::None);
        for (const Spot& s : spots) {
            auto& stack = column(s.x, s.y);
            const double bottom = stack.back().top - depth * (0.4 + 0.6 * s.depth);
            while (stack.size() > 1 && stack[stack.size() - 2].top >= bottom) {
                touch(cut, stack.back().unit, RelationKind::Cuts);
                stack.pop_back();
            }
            touch(cut, stack.back().unit, RelationKind::Cuts);
            stack.back().top = bottom;
            stack.push_back({cut, bottom});
        }
        return cut;
    }

    // Every fill touches the cut at its side, the lowest one all over.
    void fill(std::uint32_t cut, const std::vector<Spot>& spots, double thickness, UnitKind kind, UnitForm form) {
        const std::uint32_t fill = add_unit(kind, form);
        for (const Spot& s : spots) {
            auto& stack = column(s.x, s.y);
            touch(fill, cut, RelationKind::Fills);
            if (stack.back().unit != cut) touch(fill, stack.back().unit, RelationKind::Covers);
            stack.push_back({fill, stack.back().top + thickness * (0.4 + 0.6 * s.depth)});
        }
    }

    void dig_pit() {
        const std::vector<Spot> spots = blob(0.7, 2.6);
        const double depth = random_.between(0.2, 0.9);
        const std::uint32_t pit = cut(spots, depth);
        const std::size_t fills = 1 + (random_.chance(0.45) ? 1U : 0U) + (random_.chance(0.2) ? 1U : 0U);
        for (std::size_t i = 0; i < fills; ++i) {
            fill(pit, spots, depth / static_cast<double>(fills) * random_.between(0.8, 1.0), UnitKind::Deposit,
                 UnitForm::Fill);
        }
    }

    void dig_grave() {
        const std::vector<Spot> spots = blob(1.0, 1.8);
        const double depth = random_.between(0.5, 0.9);
        const std::uint32_t grave = cut(spots, depth);
        const std::vector<Spot> middle(spots.begin() + static_cast<std::ptrdiff_t>(spots.size() / 3),
                                       spots.begin() + static_cast<std::ptrdiff_t>(spots.size() - spots.size() / 3));
        fill(grave, middle.empty() ? spots : middle, 0.15, UnitKind::Skeleton, UnitForm::Burial);
        fill(grave, spots, depth - 0.1, UnitKind::Deposit, UnitForm::Fill);
    }

    void build() {
        const std::uint32_t wall =
            add_unit(UnitKind::Structure, random_.chance(0.8) ? UnitForm::Masonry : UnitForm::Timber);
        const bool along_x = random_.chance(0.5);
        const int length = 4 + static_cast<int>(random_.below(8));
        int x = static_cast<int>(random_.below(kWide));
        int y = static_cast<int>(random_.below(kHigh));
        const double height = random_.between(0.3, 0.8);
        for (int i = 0; i < length && inside(x, y); ++i) {
            auto& stack = column(x, y);
            touch(wall, stack.back().unit, RelationKind::Covers);
            stack.push_back({wall, stack.back().top + height});
            (along_x ? x : y) += 1;
        }
    }

    [[nodiscard]] TrenchHistory keep_what_is_left() {
        TrenchHistory history;
        std::vector<std::uint32_t> place(units_.size(), 0);
        std::vector<char> kept(units_.size(), 0);
        for (std::size_t u = 0; u < units_.size(); ++u) {
            if (units_[u].cells.empty()) continue;
            kept[u] = 1;
            place[u] = static_cast<std::uint32_t>(history.units.size());
            history.units.push_back(std::move(units_[u]));
        }
        for (const auto& [key, cells] : contacts_) {
            const auto& [later, earlier, kind] = key;
            if (kept[later] != 0 && kept[earlier] != 0)
                history.contacts.push_back({place[later], place[earlier], kind, cells});
        }
        std::sort(history.contacts.begin(), history.contacts.end());
        return history;
    }
};

} // namespace

TrenchHistory simulate_trench(Random& random, std::size_t units) {
    Trench trench(random);
    trench.grow(units);
    return trench.finish();
}

} // namespace planum::app
