// SPDX-License-Identifier: MIT
#include "app/demo/simulator_formation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace planum::app::demo {

namespace {

constexpr double kBucket = 0.25; ///< side of the squares that know which events concern them [m]

bool takes_side(const FormationEvent& event, double x) noexcept {
    return event.side == 0 || event.side * (x - event.side_x) > 0.0;
}

} // namespace

Formation::Formation(std::vector<FormationEvent> events, std::vector<FormedUnit> units, const Bounds& extent)
    : events_(std::move(events)), units_(std::move(units)), extent_(extent),
      bucket_columns_(static_cast<std::size_t>(std::ceil((extent.high.x - extent.low.x) / kBucket)) + 1),
      bucket_rows_(static_cast<std::size_t>(std::ceil((extent.high.y - extent.low.y) / kBucket)) + 1),
      buckets_(bucket_columns_ * bucket_rows_) {
    for (std::size_t row = 0; row < bucket_rows_; ++row) {
        for (std::size_t column = 0; column < bucket_columns_; ++column) {
            const double x = extent.low.x + static_cast<double>(column) * kBucket;
            const double y = extent.low.y + static_cast<double>(row) * kBucket;
            for (std::size_t i = 0; i < events_.size(); ++i) {
                const Bounds& b = events_[i].bounds;
                if (b.high.x < x || b.low.x > x + kBucket || b.high.y < y || b.low.y > y + kBucket) continue;
                buckets_[row * bucket_columns_ + column].push_back(static_cast<std::uint16_t>(i));
            }
        }
    }
}

const std::vector<std::uint16_t>& Formation::events_near(double x, double y) const noexcept {
    const double u = std::clamp((x - extent_.low.x) / kBucket, 0.0, static_cast<double>(bucket_columns_ - 1));
    const double v = std::clamp((y - extent_.low.y) / kBucket, 0.0, static_cast<double>(bucket_rows_ - 1));
    return buckets_[static_cast<std::size_t>(v) * bucket_columns_ + static_cast<std::size_t>(u)];
}

Body Formation::body_at(const Vec3& p) const noexcept {
    Body body;
    for (const std::uint16_t i : events_near(p.x, p.y)) {
        const FormationEvent& event = events_[i];
        if (p.z > event.bounds.high.z || !event.bounds.holds(p.x, p.y)) continue;
        switch (event.type) {
        case FormationEvent::Type::Deposit:
            if (body.unit != kAir || (event.within != kAir && body.cut != event.within)) break;
            if (takes_side(event, p.x) && p.z < event.top.at(p.x, p.y)) body.unit = event.unit;
            break;
        case FormationEvent::Type::Cut:
            if (body.unit == kAir || !event.cut.contains(p)) break;
            body = {kAir, event.unit};
            break;
        case FormationEvent::Type::Structure:
            if (body.unit == kAir && event.wall.contains(p, body.cut == event.within)) body.unit = event.unit;
            break;
        }
    }
    return body;
}

UnitNo Formation::wall_over(const Vec3& p) const noexcept {
    constexpr double kStone = 0.01; // nothing thinner is built [m]
    for (const std::uint16_t i : events_near(p.x, p.y)) {
        const FormationEvent& event = events_[i];
        if (event.type != FormationEvent::Type::Structure || !event.bounds.holds(p.x, p.y)) continue;
        for (double z = std::max(p.z, event.wall.base) + kStone; z < event.bounds.high.z; z += kStone) {
            const Vec3 above{p.x, p.y, z};
            // Whether it was built there at all is asked first: that is quick, what became of it later is not.
            if (!event.wall.contains(above, true)) continue;
            if (body_at(above).unit == event.unit) return event.unit;
        }
    }
    return kAir;
}

} // namespace planum::app::demo
