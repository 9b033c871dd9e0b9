// SPDX-License-Identifier: MIT
#include "app/scans/scan_panorama.hpp"

#include <fmt/format.h>

#include "core/base/error.hpp"

namespace planum::app {

namespace {

constexpr int kMostWidth = 16000; ///< [px], of pictures that nobody gave a width

scans::ProjectionKind kind_of(const std::string& name) {
    const auto kind = scans::projection_from_name(name);
    if (!kind) {
        throw Error(ErrorCode::Usage, fmt::format("no projection {}; there are equirectangular, cylindrical, mercator, "
                                                  "miller, equal-area, rectilinear, pannini and stereographic",
                                                  name));
    }
    return *kind;
}

scans::ProjectionOptions frame_of(const scans::ScanExtent& extent, const PanoramaRequest& request) {
    if (request.width < 0 || request.width > 100000 || request.views < 0 || request.views > 100) {
        throw Error(ErrorCode::Usage, fmt::format("a panorama of {} pixels in {} views; at most 100000 and 100",
                                                  request.width, request.views));
    }
    scans::ProjectionOptions options = extent.fit(kind_of(request.projection), kMostWidth);
    if (request.width == 0 && request.views == 0) return options;
    if (request.views > 0) options.views = request.views;
    return scans::with_square_pixels(options, 0.0, request.width > 0 ? request.width : options.width);
}

} // namespace

scans::ScanExtent scan_extent(const scans::PointStore& store, Progress& progress) {
    scans::ScanExtent extent(store.info().has);
    progress.step("looking at what " + store.info().name + " shows");
    store.for_each([&](const scans::FoundPoints& found) { extent.add(found.points); }, progress);
    return extent;
}

scans::Panorama scan_panorama(const scans::PointStore& store, const scans::ScanExtent& extent,
                              const PanoramaRequest& request, Progress& progress) {
    if (store.points() == 0) {
        throw Error(ErrorCode::BadInput,
                    fmt::format("scan {} has no points: there is nothing to unroll", store.info().name));
    }
    scans::PanoramaOptions options;
    options.projection = frame_of(extent, request);
    scans::PanoramaBuilder builder(options, store.info().has);
    builder.expect(store.points());
    progress.step("unrolling " + store.info().name);
    store.for_each([&](const scans::FoundPoints& found) { builder.add(found.points); }, progress);
    return builder.finish(progress);
}

scans::Channel panorama_channel(const scans::PointStore& store, std::string_view name) {
    const scans::Columns& has = store.info().has;
    if (name.empty()) {
        if (has.intensity) return scans::Channel::Reflectance;
        return has.colour ? scans::Channel::Colour : scans::Channel::Range;
    }
    for (const scans::Channel channel :
         {scans::Channel::Reflectance, scans::Channel::Range, scans::Channel::Colour, scans::Channel::Normals}) {
        if (scans::channel_name(channel) != name) continue;
        const bool lacks = (channel == scans::Channel::Reflectance && !has.intensity) ||
                           (channel == scans::Channel::Colour && !has.colour);
        if (!lacks) return channel;
        throw Error(ErrorCode::BadInput,
                    fmt::format("scan {}: has no {}; range and normals can always be drawn", store.info().name, name));
    }
    throw Error(ErrorCode::Usage, fmt::format("no channel {}; there are reflectance, range, colour and normals", name));
}

} // namespace planum::app
