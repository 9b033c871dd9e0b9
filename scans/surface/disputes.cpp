// SPDX-License-Identifier: MIT
#include "scans/surface/disputes.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <optional>

#include "scans/surface/cell_patches.hpp"

namespace planum::scans {

namespace {

constexpr double kTwoSided = 1.959964; // 95 % of a normal distribution

/// Two scans that say different heights in a cell.
struct Dispute {
    ScanHeight lower;
    ScanHeight higher;
    double difference = 0.0; ///< [m]
    double detectable = 0.0; ///< [m]
};

double variance(const ScanHeight& seen, const SurfaceScan& scan, double lift, double slope, double cell) {
    const auto n = static_cast<double>(std::max<std::uint16_t>(seen.count, 1));
    const double spread = std::max(static_cast<double>(seen.spread), scan.noise);
    // Few points do not lie about the middle of the cell: on a slope that is a difference in height.
    const double beside = slope * cell / std::sqrt(12.0);
    return (spread * spread + beside * beside) / n + lift * lift;
}

class Finder {
  public:
    Finder(const LayerField& field, std::span<const SurfaceScan> scans, const SurfaceOptions& options,
           const SurfaceGrid& grid)
        : field_(field), scans_(scans), options_(options), grid_(grid) {}

    [[nodiscard]] std::optional<Dispute> at(std::int32_t row, std::int32_t column) const {
        const std::size_t cell = field_.frame.at(row, column);
        const std::span<const HeightLayer> layers = field_.at(cell);
        if (layers.size() == 1 && layers[0].lowest.scan != layers[0].highest.scan)
            return test(row, column, layers[0].lowest, layers[0].highest);
        if (layers.size() < 2 || (layers.front().scans & layers.back().scans) != 0) return std::nullopt;
        return test(row, column, of_layer(layers.front()), of_layer(layers.back()));
    }

  private:
    static ScanHeight of_layer(const HeightLayer& layer) {
        if (layer.lowest.count > 0) return layer.lowest.count >= layer.highest.count ? layer.lowest : layer.highest;
        return {layer.height, layer.spread, static_cast<std::uint16_t>(std::countr_zero(layer.scans)), layer.count};
    }

    [[nodiscard]] std::optional<Dispute> test(std::int32_t row, std::int32_t column, const ScanHeight& lower,
                                              const ScanHeight& higher) const {
        const std::size_t cell = field_.frame.at(row, column);
        const double slope =
            std::isnan(grid_.slope[cell]) ? 0.0 : std::min(static_cast<double>(grid_.slope[cell]), options_.steepest);
        const Eigen::Vector3d x(field_.frame.x(column), field_.frame.y(row), static_cast<double>(grid_.height[cell]));
        double sum = 0.0;
        for (const ScanHeight* seen : {&lower, &higher}) {
            const SurfaceScan& scan = scans_[seen->scan];
            // The direction of the slope is not kept; along x does for what is left of the horizontal σ.
            sum += variance(*seen, scan, lift_of_pose(scan, x, {slope, 0.0}), slope, field_.frame.cell);
        }
        Dispute dispute{lower, higher, static_cast<double>(higher.height) - static_cast<double>(lower.height), 0.0};
        dispute.detectable = std::sqrt(options_.tolerance * options_.tolerance + kTwoSided * kTwoSided * sum);
        if (dispute.difference <= dispute.detectable) return std::nullopt;
        return dispute;
    }

    const LayerField& field_;
    std::span<const SurfaceScan> scans_;
    const SurfaceOptions& options_;
    const SurfaceGrid& grid_;
};

double median(std::vector<double> values) {
    if (values.empty()) return 0.0;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

std::string most_named(const std::map<std::uint16_t, std::size_t>& votes, std::span<const SurfaceScan> scans) {
    const auto best =
        std::max_element(votes.begin(), votes.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
    return best == votes.end() ? std::string() : scans[best->first].name;
}

} // namespace

double lift_of_pose(const SurfaceScan& scan, const Eigen::Vector3d& x_in_site, const std::array<double, 2>& gradient) {
    const Eigen::Vector3d n(-gradient[0], -gradient[1], 1.0);
    geometry::Vector6 lift;
    lift << (x_in_site - scan.station).cross(n), n;
    return std::sqrt(std::max(0.0, lift.dot(scan.covariance * lift)));
}

double mean_lift(std::span<const SurfaceScan> scans, std::uint32_t mask, const Eigen::Vector3d& x_in_site,
                 std::array<double, 2> gradient, double steepest) {
    const double tangent = std::hypot(gradient[0], gradient[1]);
    if (tangent > steepest) {
        for (double& g : gradient) g *= steepest / tangent;
    }
    double sum = 0.0;
    double number = 0.0;
    for (std::size_t scan = 0; scan < scans.size(); ++scan) {
        if ((mask & mask_of(static_cast<std::uint16_t>(scan))) == 0) continue;
        sum += lift_of_pose(scans[scan], x_in_site, gradient);
        number += 1.0;
    }
    return number > 0.0 ? sum / number : 0.0;
}

std::vector<DisputedPatch> settle_disputes(const LayerField& field, std::span<const SurfaceScan> scans,
                                           const SurfaceOptions& options, SurfaceGrid& grid) {
    const GridFrame& frame = field.frame;
    const Finder finder(field, scans, options, grid);
    CellSet disputed(frame.cells());
    for (std::int32_t row = 0; row < frame.rows; ++row) {
        for (std::int32_t column = 0; column < frame.columns; ++column)
            disputed[frame.at(row, column)] = finder.at(row, column) ? 1 : 0;
    }
    CellSet open = opened(frame, disputed);
    std::vector<DisputedPatch> patches;
    for (std::size_t start = 0; start < open.size(); ++start) {
        if (open[start] == 0) continue;
        const std::vector<std::size_t> cells = take_patch(frame, open, start);
        DisputedPatch patch;
        patch.area = static_cast<double>(cells.size()) * frame.cell * frame.cell;
        if (patch.area < options.disputed_area) continue;
        std::map<std::uint16_t, std::size_t> lower;
        std::map<std::uint16_t, std::size_t> higher;
        std::vector<double> differences;
        std::vector<double> detectable;
        for (const std::size_t cell : cells) {
            const auto row = static_cast<std::int32_t>(cell / static_cast<std::size_t>(frame.columns));
            const auto column = static_cast<std::int32_t>(cell % static_cast<std::size_t>(frame.columns));
            const std::optional<Dispute> found = finder.at(row, column);
            if (!found) continue;
            ++lower[found->lower.scan];
            ++higher[found->higher.scan];
            differences.push_back(found->difference);
            detectable.push_back(found->detectable);
            grid.state[cell] = CellState::Disputed;
            grid.height[cell] = found->higher.count > found->lower.count ? found->higher.height : found->lower.height;
            patch.cells.push_back(cell);
        }
        const std::size_t middle = cells[cells.size() / 2];
        patch.x = frame.x(static_cast<std::int32_t>(middle % static_cast<std::size_t>(frame.columns)));
        patch.y = frame.y(static_cast<std::int32_t>(middle / static_cast<std::size_t>(frame.columns)));
        patch.difference = median(std::move(differences));
        patch.detectable = median(std::move(detectable));
        patch.lower = most_named(lower, scans);
        patch.higher = most_named(higher, scans);
        patches.push_back(std::move(patch));
    }
    std::stable_sort(patches.begin(), patches.end(),
                     [](const DisputedPatch& a, const DisputedPatch& b) { return a.area > b.area; });
    return patches;
}

} // namespace planum::scans
