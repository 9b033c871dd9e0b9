// SPDX-License-Identifier: MIT
#include "app/demo/simulator_composer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace planum::app::demo {

namespace {

using model::UnitForm;
using model::UnitKind;

constexpr double kAround = 0.6; ///< the strata go on behind the sides of the trench [m]
constexpr double kGone = 0.3;   ///< how far below the ground the top of a deposit is put where it has ended [m]

constexpr std::array kSpreads = {"grey-brown loam with charcoal flecks",
                                 "yellow clay with pebbles",
                                 "dark humic silt",
                                 "sandy silt with brick crumbs",
                                 "greenish silt, compact",
                                 "ashy layer with daub",
                                 "gravelly sand",
                                 "brown clay with oyster shell"};
constexpr std::array kFills = {"dark loose fill with bone", "brown silt fill",  "grey ashy fill", "stony fill",
                               "greenish cess-like fill",   "mottled clay fill"};

template<std::size_t N>
std::string pick(const std::array<const char*, N>& words, Draw& draw) {
    return words[static_cast<std::size_t>(draw.below(static_cast<int>(N)))];
}

Bounds widened(const Bounds& b, double by) {
    return {{b.low.x - by, b.low.y - by, b.low.z}, {b.high.x + by, b.high.y + by, b.high.z}};
}

} // namespace

int units_in(const FeaturePlan& feature) noexcept {
    switch (feature.type) {
    case FeatureType::Wall: return 2 + feature.fills;
    case FeatureType::WallPair: return 4 + feature.fills;
    case FeatureType::Floor:
    case FeatureType::Mound: return 1;
    case FeatureType::PostHole:
    case FeatureType::Pit:
    case FeatureType::BellPit:
    case FeatureType::Ditch: return 1 + feature.fills;
    }
    return 0;
}

SiteComposer::SiteComposer(const SiteShape& site, std::uint64_t seed)
    : site_(site), seed_(seed), draw_(seed, 101), soil_(widened(site.trench, kAround), site.table_step) {
    soil_.fill([&](double, double) { return site.trench.low.z - 1.0; });
}

UnitNo SiteComposer::add_unit(UnitKind kind, UnitForm form, std::string title, int phase) {
    FormedUnit unit;
    unit.kind = kind;
    unit.form = form;
    unit.title = std::move(title);
    unit.phase = phase;
    units_.push_back(std::move(unit));
    return static_cast<UnitNo>(units_.size()) - 1;
}

UnitNo SiteComposer::add_deposit(HeightTable top, FormedUnit unit, UnitNo within) {
    units_.push_back(std::move(unit));
    FormationEvent event;
    event.type = FormationEvent::Type::Deposit;
    event.unit = static_cast<UnitNo>(units_.size()) - 1;
    event.bounds = top.extent();
    event.bounds.high.z = top.highest();
    event.top = std::move(top);
    event.within = within;
    events_.push_back(std::move(event));
    return events_.back().unit;
}

void SiteComposer::settle(HeightTable& top) {
    constexpr double kThinnest = 0.02; // a film thinner than this is nobody's unit [m]
    for (std::size_t j = 0; j < top.rows(); ++j) {
        for (std::size_t i = 0; i < top.columns(); ++i) {
            const double ground = soil_.at(top.x_of(i), top.y_of(j));
            if (top.node(i, j) - ground < kThinnest) top.node(i, j) = static_cast<float>(ground - kGone);
        }
    }
    for (std::size_t j = 0; j < soil_.rows(); ++j) {
        for (std::size_t i = 0; i < soil_.columns(); ++i) {
            const double x = soil_.x_of(i);
            const double y = soil_.y_of(j);
            if (!top.extent().holds(x, y)) continue;
            soil_.node(i, j) = std::max(soil_.node(i, j), static_cast<float>(top.at(x, y)));
        }
    }
}

void SiteComposer::natural() {
    HeightTable top(widened(site_.trench, kAround), site_.table_step);
    const double tilt_x = draw_.between(-0.015, 0.015);
    const double tilt_y = draw_.between(-0.015, 0.015);
    top.fill([&](double x, double y) {
        return site_.natural + tilt_x * (x - site_.trench.low.x) + tilt_y * (y - site_.trench.low.y) +
               0.05 * noise(mix(seed_, 21), x / 2.7, y / 2.7) + 0.008 * noise(mix(seed_, 22), x / 0.4, y / 0.4);
    });
    FormedUnit unit;
    unit.kind = UnitKind::Natural;
    unit.form = UnitForm::None;
    unit.title = "natural: yellow gravelly clay";
    soil_.fill([&](double x, double y) { return top.at(x, y); });
    add_deposit(std::move(top), std::move(unit));
}

void SiteComposer::spread(int phase, double mean_height, bool split) {
    HeightTable top(widened(site_.trench, kAround), site_.table_step);
    const double tilt_x = draw_.between(-0.02, 0.02) * 6.0 / (site_.trench.high.x - site_.trench.low.x);
    const double tilt_y = draw_.between(-0.02, 0.02) * 6.0 / (site_.trench.high.x - site_.trench.low.x);
    const double middle_x = 0.5 * (site_.trench.low.x + site_.trench.high.x);
    const double middle_y = 0.5 * (site_.trench.low.y + site_.trench.high.y);
    const std::uint64_t key = mix(seed_, static_cast<std::uint64_t>(30 + phase));
    top.fill([&](double x, double y) {
        const double height = mean_height + tilt_x * (x - middle_x) + tilt_y * (y - middle_y) +
                              0.06 * noise(key, x / 2.2, y / 2.2) + 0.015 * noise(mix(key, 1), x / 0.6, y / 0.6) +
                              0.004 * noise(mix(key, 2), x / 0.12, y / 0.12);
        return std::min(height, turf_height(site_, seed_, x, y) - 0.14);
    });
    settle(top);
    FormedUnit unit;
    unit.title = pick(kSpreads, draw_);
    unit.phase = phase;
    if (!split) {
        add_deposit(std::move(top), std::move(unit));
        return;
    }
    const double line = middle_x + draw_.between(-0.5, 0.5);
    const UnitNo west = add_deposit(top, unit);
    unit.twin = west;
    const UnitNo east = add_deposit(std::move(top), std::move(unit));
    units_[static_cast<std::size_t>(west)].twin = east;
    events_[events_.size() - 2].side = -1;
    events_.back().side = 1;
    events_[events_.size() - 2].side_x = line;
    events_.back().side_x = line;
}

void SiteComposer::topsoil() {
    HeightTable top(widened(site_.trench, kAround), site_.table_step);
    top.fill([&](double x, double y) { return turf_height(site_, seed_, x, y); });
    FormedUnit unit;
    unit.title = "topsoil with roots";
    unit.phase = site_.phases;
    add_deposit(std::move(top), std::move(unit));
}

UnitNo SiteComposer::add_cut(const CutShape& shape, std::string title, int phase) {
    const UnitNo unit = add_unit(UnitKind::Cut, UnitForm::None, std::move(title), phase);
    units_.back().feature = features_;
    FormationEvent event;
    event.type = FormationEvent::Type::Cut;
    event.unit = unit;
    event.bounds = shape.bounds();
    event.cut = shape;
    events_.push_back(std::move(event));
    return unit;
}

UnitNo SiteComposer::add_wall(const WallShape& shape, UnitNo cut, int phase) {
    const UnitNo unit =
        add_unit(UnitKind::Structure, UnitForm::Masonry, "wall of roughly squared stone, lime mortar", phase);
    units_.back().feature = features_;
    units_.back().cut = cut;
    FormationEvent event;
    event.type = FormationEvent::Type::Structure;
    event.unit = unit;
    event.bounds = shape.bounds();
    event.wall = shape;
    event.within = cut;
    events_.push_back(std::move(event));
    return unit;
}

void SiteComposer::add_fills(const CutShape& shape, UnitNo cut, int fills, int phase) {
    for (int i = 0; i < fills; ++i) {
        const bool last = i == fills - 1;
        const double share = (i + draw_.between(0.8, 1.1)) / fills;
        const double tip_x = draw_.between(-0.12, 0.12);
        const double tip_y = draw_.between(-0.12, 0.12);
        const double sag = last ? draw_.between(0.005, 0.03) : 0.0;
        const std::uint64_t key = draw_.next();
        HeightTable top(shape.bounds(), 0.02);
        top.fill([&](double x, double y) {
            if (last) return soil_.at(x, y) - sag + 0.003 * noise(key, x / 0.2, y / 0.2);
            return shape.base + share * (shape.mouth - shape.base) + tip_x * (x - shape.x) + tip_y * (y - shape.y) +
                   0.02 * noise(key, x / 0.3, y / 0.3);
        });
        FormedUnit unit;
        unit.form = UnitForm::Fill;
        unit.title = pick(kFills, draw_);
        unit.phase = phase;
        unit.feature = features_;
        unit.cut = cut;
        add_deposit(std::move(top), std::move(unit), cut);
    }
}

SiteComposer::Circle SiteComposer::find_place(double radius, int phase) {
    const double margin = radius * 1.35 + 0.15;
    Circle best{};
    double best_room = -std::numeric_limits<double>::infinity();
    for (int attempt = 0; attempt < 80; ++attempt) {
        const Circle here{draw_.between(site_.trench.low.x + margin, site_.trench.high.x - margin),
                          draw_.between(site_.trench.low.y + margin, site_.trench.high.y - margin), radius, phase,
                          false};
        double room = 1.0;
        for (const Circle& other : taken_) {
            if (other.phase != phase && !other.wall) continue;
            room = std::min(room, std::hypot(here.x - other.x, here.y - other.y) - radius * 1.3 - other.radius * 1.3);
        }
        if (room > best_room) {
            best_room = room;
            best = here;
        }
        if (best_room > 0.1) break;
    }
    taken_.push_back(best);
    return best;
}

void SiteComposer::feature(const FeaturePlan& plan, int phase) {
    switch (plan.type) {
    case FeatureType::Wall: wall(false, phase); break;
    case FeatureType::WallPair: wall(true, phase); break;
    case FeatureType::Floor: floor(phase); break;
    case FeatureType::PostHole: post_hole(phase); break;
    case FeatureType::Pit: pit(false, plan.fills, phase); break;
    case FeatureType::BellPit: pit(true, plan.fills, phase); break;
    case FeatureType::Ditch: ditch(plan.fills, phase); break;
    case FeatureType::Mound: mound(phase); break;
    }
    ++features_;
}

Formation SiteComposer::finish() {
    Bounds extent = widened(site_.trench, kAround);
    extent.high.z += 0.3;
    return {std::move(events_), std::move(units_), extent};
}

void SiteComposer::post_hole(int phase) {
    const double radius = draw_.between(0.11, 0.19);
    const Circle place = find_place(radius, phase);
    CutShape shape;
    shape.x = place.x;
    shape.y = place.y;
    shape.radius = radius;
    shape.wobble = {draw_.between(-0.06, 0.06), draw_.between(-0.06, 0.06), 0.0};
    shape.mouth = soil_.at(place.x, place.y);
    shape.base = std::max(shape.mouth - draw_.between(0.3, 0.55), site_.trench.low.z + 0.1);
    const UnitNo cut = add_cut(shape, "cut of a post-hole", phase);
    add_fills(shape, cut, 1, phase);
}

void SiteComposer::pit(bool bell, int fills, int phase) {
    constexpr std::array kProfiles = {Profile::Vertical, Profile::Sloping, Profile::Bowl};
    const double width = site_.trench.high.y - site_.trench.low.y;
    CutShape shape;
    shape.profile = bell ? Profile::Bell : kProfiles[static_cast<std::size_t>(draw_.below(3))];
    shape.radius = draw_.between(0.42, std::min(0.75, 0.17 * width));
    if (bell) shape.radius = std::max(shape.radius, 0.5);
    shape.aspect = bell ? 1.0 : draw_.between(1.0, 1.35);
    const Circle place = find_place(shape.radius * shape.aspect, phase);
    const double angle = draw_.between(0.0, std::numbers::pi);
    shape.x = place.x;
    shape.y = place.y;
    shape.axis_x = std::cos(angle);
    shape.axis_y = std::sin(angle);
    shape.wobble = {draw_.between(-0.07, 0.07), draw_.between(-0.07, 0.07), draw_.between(-0.05, 0.05)};
    shape.mouth = soil_.at(place.x, place.y);
    shape.base =
        std::max(shape.mouth - draw_.between(bell ? 0.65 : 0.35, bell ? 0.95 : 0.8), site_.trench.low.z + 0.15);
    const UnitNo cut = add_cut(shape, bell ? "cut of a bell-shaped storage pit" : "cut of a pit", phase);
    add_fills(shape, cut, fills, phase);
}

void SiteComposer::ditch(int fills, int phase) {
    CutShape shape;
    shape.plan = Plan::Linear;
    shape.profile = Profile::Vee;
    const double angle = std::numbers::pi * 0.5 + draw_.between(-0.15, 0.15);
    shape.axis_x = std::cos(angle);
    shape.axis_y = std::sin(angle);
    shape.x = site_.trench.low.x + draw_.between(0.2, 0.8) * (site_.trench.high.x - site_.trench.low.x);
    shape.y = 0.5 * (site_.trench.low.y + site_.trench.high.y);
    shape.half_length = 0.75 * (site_.trench.high.y - site_.trench.low.y);
    shape.radius = draw_.between(0.5, 0.8);
    shape.wobble = {0.06, draw_.unit(), 0.0};
    shape.mouth = soil_.at(shape.x, shape.y);
    shape.base = std::max(shape.mouth - draw_.between(0.5, 0.8), site_.trench.low.z + 0.15);
    for (double t = -shape.half_length; t <= shape.half_length; t += shape.radius) {
        taken_.push_back({shape.x + t * shape.axis_x, shape.y + t * shape.axis_y, shape.radius, phase, false});
    }
    const UnitNo cut = add_cut(shape, "cut of a ditch", phase);
    add_fills(shape, cut, fills, phase);
}

} // namespace planum::app::demo
