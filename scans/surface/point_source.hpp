// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/geometry/rigid.hpp"
#include "scans/cloud/point_store.hpp"
#include "scans/formats/point_block.hpp"

namespace planum::scans {

/// Rectangle of the plan in site coordinates [m]; west and south border included, east and north not.
struct PlanBox {
    double west = 0.0;
    double south = 0.0;
    double east = 0.0;
    double north = 0.0;

    [[nodiscard]] bool contains(double x, double y) const noexcept {
        return x >= west && x < east && y >= south && y < north;
    }
};

/// Points in site coordinates, wherever they come from. Several threads may ask one object.
class PointSource {
  public:
    PointSource() = default;
    PointSource(const PointSource&) = delete;
    PointSource& operator=(const PointSource&) = delete;
    virtual ~PointSource() = default;

    /// Gives every point of the box once, in blocks whose x, y, z are site coordinates; others may be among
    /// them. The same call gives the same points.
    virtual void over(const PlanBox& box, const PointSink& sink) const = 0;
};

/// Points held in memory, as tests and simulations have them.
class BlockPoints final : public PointSource {
  public:
    explicit BlockPoints(PointBlock in_site) : points_(std::move(in_site)) {}

    void over(const PlanBox& box, const PointSink& sink) const override;

  private:
    PointBlock points_;
};

/// Points of a store that is placed on the site.
class StorePoints final : public PointSource {
  public:
    StorePoints(std::shared_ptr<const PointStore> store, const geometry::Rigid3& site_from_scan);

    void over(const PlanBox& box, const PointSink& sink) const override;

  private:
    std::shared_ptr<const PointStore> store_; // shared with those who look at the same points
    geometry::Rigid3 site_from_scan_;
    double lowest_ = 0.0; // heights of the store in site
    double highest_ = 0.0;
};

/// One scan of a surface: its points, and how well it is placed.
struct SurfaceScan {
    std::string name;
    std::shared_ptr<const PointSource> points;
    Eigen::Vector3d station = Eigen::Vector3d::Zero();        ///< in site; where the pose turns about
    geometry::Matrix6 covariance = geometry::Matrix6::Zero(); ///< of the pose, in the numbers of geometry::moved()
    double noise = 0.002;                                     ///< σ of one measured point [m]
};

} // namespace planum::scans
