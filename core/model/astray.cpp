// SPDX-License-Identifier: MIT
#include "core/model/astray.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace planum::model {

namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();
constexpr std::array<std::size_t, 2> kXY = {3, 7}; // of a set-up, in a row-major matrix

} // namespace

std::string astray_words(double distance) {
    return fmt::format("reaches {:.0f} {} away from all set-ups of the scanner: plans leave it out and nothing is "
                       "concluded from it; is it in other coordinates than the site?",
                       distance < 1e4 ? distance : distance * 1e-3, distance < 1e4 ? "m" : "km");
}

ScannedBox::ScannedBox(const Record& record) : low_{kNone, kNone}, high_{-kNone, -kNone} {
    for (const Scan& scan : record.scans) {
        const ScanPose* pose = pose_in_force(record, scan.id);
        if (pose == nullptr) continue;
        for (std::size_t axis = 0; axis < 2; ++axis) {
            low_[axis] = std::min(low_[axis], pose->site_from_scan[kXY[axis]]);
            high_[axis] = std::max(high_[axis], pose->site_from_scan[kXY[axis]]);
        }
    }
}

double ScannedBox::distance(const Region& region) const noexcept {
    if (low_[0] > high_[0]) return 0.0;
    double farthest = 0.0;
    for (const Polygon& polygon : region.outline) {
        for (const auto& corner : polygon.outer) {
            std::array<double, 2> out{};
            for (std::size_t axis = 0; axis < 2; ++axis)
                out[axis] = std::max({0.0, low_[axis] - corner[axis], corner[axis] - high_[axis]});
            farthest = std::max(farthest, std::hypot(out[0], out[1]));
        }
    }
    return farthest;
}

} // namespace planum::model
