// SPDX-License-Identifier: MIT
#include "scans/surface/point_source.hpp"

#include <algorithm>

namespace planum::scans {

namespace {

constexpr double kStoredWithin = 0.001; // a store gives points back off by up to half a step, 0.06 mm [m]

} // namespace

void BlockPoints::over(const PlanBox& /*box*/, const PointSink& sink) const { sink(points_); }

StorePoints::StorePoints(std::shared_ptr<const PointStore> store, const geometry::Rigid3& site_from_scan)
    : store_(std::move(store)), site_from_scan_(site_from_scan) {
    const Bounds& bounds = store_->bounds();
    lowest_ = 1e300;
    highest_ = -1e300;
    for (unsigned corner = 0; corner < 8; ++corner) {
        Eigen::Vector3d x;
        for (unsigned k = 0; k < 3; ++k) x[k] = (corner >> k & 1U) != 0 ? bounds.maximum[k] : bounds.minimum[k];
        const double z = (site_from_scan_ * x).z();
        lowest_ = std::min(lowest_, z);
        highest_ = std::max(highest_, z);
    }
    lowest_ -= kStoredWithin;
    highest_ += kStoredWithin;
}

void StorePoints::over(const PlanBox& box, const PointSink& sink) const {
    if (store_->points() == 0) return;
    const geometry::Rigid3 scan_from_site = site_from_scan_.inverse();
    // The box around the tile drawn out in height, seen from the scan: a little more than the tile when the
    // scanner stood out of plumb.
    Box around{Eigen::Vector3d::Constant(1e300), Eigen::Vector3d::Constant(-1e300)};
    for (const double x : {box.west, box.east}) {
        for (const double y : {box.south, box.north}) {
            for (const double z : {lowest_, highest_}) {
                const Eigen::Vector3d corner = scan_from_site * Eigen::Vector3d(x, y, z);
                around.minimum = around.minimum.cwiseMin(corner);
                around.maximum = around.maximum.cwiseMax(corner);
            }
        }
    }
    around.minimum.array() -= 1e-6;
    around.maximum.array() += 1e-6;
    PointBlock in_site;
    store_->in_box(around, [&](const FoundPoints& found) {
        in_site = found.points;
        for (std::size_t i = 0; i < in_site.size(); ++i) {
            const Eigen::Vector3d x = site_from_scan_ * Eigen::Vector3d(in_site.x[i], in_site.y[i], in_site.z[i]);
            in_site.x[i] = x.x();
            in_site.y[i] = x.y();
            in_site.z[i] = x.z();
        }
        sink(in_site);
    });
}

} // namespace planum::scans
