// SPDX-License-Identifier: MIT
#include "app/registration/scan_shelf.hpp"

#include <algorithm>
#include <cmath>
#include <future>

#include <fmt/format.h>

#include "app/scans/scan_stores.hpp"

namespace planum::app {

namespace {

constexpr std::size_t kKept = 24; ///< prepared scans, some 40 MB each

/// Lowest and highest of what panoramas show [rad].
constexpr double kLowest = -1.2;
constexpr double kHighest = 0.8;

scans::PanoramaOptions panorama_options(std::uint64_t points, scans::ProjectionKind projection) {
    scans::PanoramaOptions options;
    options.projection.kind = projection;
    // About one point a pixel; SIFT finds little in pictures under 1,000 pixels around and nothing more over 2,000.
    const double width = std::clamp(2.2 * std::sqrt(static_cast<double>(points)), 1000.0, 1800.0);
    options.projection.width = static_cast<int>(width);
    options.projection.height = static_cast<int>(width * (kHighest - kLowest) / 6.283);
    options.projection.elevation_from = kLowest;
    options.projection.elevation_to = kHighest;
    return options;
}

} // namespace

scans::FeatureSet features_of(const scans::PointStore& store, const FeatureView& view) {
    const scans::Columns has = store.info().has;
    scans::PanoramaBuilder builder(panorama_options(store.points(), view.projection),
                                   {has.intensity, has.colour, false, false});
    builder.expect(store.points());
    store.for_each([&](const scans::FoundPoints& found) { builder.add(found.points); }, Progress::none());
    const scans::Panorama panorama = builder.finish(Progress::none());
    scans::FeatureSet features;
    if (view.looks && has.intensity) {
        append(features, find_features(panorama, scans::Channel::Reflectance));
    } else if (view.looks && has.colour) {
        append(features, find_features(panorama, scans::Channel::Colour));
    }
    if (view.range || !(has.intensity || has.colour)) append(features, find_features(panorama, scans::Channel::Range));
    return features;
}

std::vector<Eigen::Vector3d> points_of(const scans::PointStore& store) {
    std::vector<Eigen::Vector3d> points;
    points.reserve(store.points());
    store.for_each(
        [&](const scans::FoundPoints& found) {
            for (std::size_t i = 0; i < found.points.size(); ++i) {
                points.emplace_back(found.points.x[i], found.points.y[i], found.points.z[i]);
            }
        },
        Progress::none());
    return points;
}

ScanShelf::ScanShelf(std::filesystem::path project, std::vector<model::Scan> scans, scans::FineOptions fine,
                     Progress& progress)
    : project_(std::move(project)), scans_(std::move(scans)), fine_(std::move(fine)), progress_(progress) {}

void ScanShelf::make_features(const std::vector<std::size_t>& scans) {
    progress_.step("looking for features");
    std::vector<std::size_t> missing;
    for (const std::size_t scan : scans) {
        if (!features_.contains(scan)) missing.push_back(scan);
    }
    for (std::size_t i = 0; i < missing.size(); i += 2) {
        progress_.check();
        progress_.fraction(static_cast<double>(i) / static_cast<double>(missing.size()));
        std::vector<std::future<scans::FeatureSet>> running;
        for (std::size_t k = i; k < std::min(i + 2, missing.size()); ++k) {
            // Opened here: a store that has to be made again reports its progress.
            auto store = open_store(project_, scans_[missing[k]], progress_);
            running.push_back(std::async(std::launch::async, [store] { return features_of(*store); }));
        }
        for (std::size_t k = 0; k < running.size(); ++k) features_[missing[i + k]] = running[k].get();
    }
}

std::shared_ptr<const scans::PreparedScan> ScanShelf::prepared(std::size_t scan, Progress& progress) {
    const auto it = std::find_if(prepared_.begin(), prepared_.end(), [&](const auto& p) { return p.first == scan; });
    if (it != prepared_.end()) {
        auto found = *it;
        prepared_.erase(it);
        prepared_.push_front(found);
        return found.second;
    }
    progress.step(fmt::format("thinning {}", scans_[scan].name));
    const auto store = open_store(project_, scans_[scan], progress);
    auto made = std::make_shared<const scans::PreparedScan>(scans::prepare_scan(points_of(*store), fine_));
    prepared_.emplace_front(scan, made);
    if (prepared_.size() > kKept) prepared_.pop_back();
    return made;
}

} // namespace planum::app
