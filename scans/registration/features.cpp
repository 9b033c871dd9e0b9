// SPDX-License-Identifier: MIT
#include "scans/registration/features.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <opencv2/core.hpp>
#include <opencv2/features2d.hpp>
#include <opencv2/imgproc.hpp>

#include "core/base/error.hpp"

namespace planum::scans {

namespace {

constexpr int kSeam = 96; ///< [px] repeated beyond both ends of a full turn

bool is_full_turn(const ProjectionOptions& o) {
    return o.azimuth_to - o.azimuth_from > 2.0 * std::numbers::pi - 1e-6 && o.kind != ProjectionKind::Rectilinear &&
           o.kind != ProjectionKind::Pannini && o.kind != ProjectionKind::Stereographic;
}

cv::Mat grey_picture(const Panorama& panorama, Channel channel) {
    const Picture picture = panorama.picture(channel);
    cv::Mat image(picture.height, picture.width, picture.channels == 3 ? CV_8UC3 : CV_8UC1);
    std::copy(picture.values.begin(), picture.values.end(), image.data);
    if (picture.channels == 3) cv::cvtColor(image, image, cv::COLOR_RGB2GRAY);
    return image;
}

/// Bumps and hollows: how much farther a place is than its surroundings, as a share of the range. The picture for the
/// eye shows near and far, in which the relief of the ground is less than one shade of grey.
cv::Mat relief_picture(const Panorama& panorama) {
    cv::Mat depth(panorama.height(), panorama.width(), CV_32F, cv::Scalar(0.0));
    cv::Mat shown(panorama.height(), panorama.width(), CV_32F, cv::Scalar(0.0));
    for (int row = 0; row < panorama.height(); ++row) {
        for (int column = 0; column < panorama.width(); ++column) {
            const auto points = panorama.points_at(column, row);
            if (points.empty()) continue;
            depth.at<float>(row, column) = static_cast<float>(std::log(panorama.place(points.front()).norm()));
            shown.at<float>(row, column) = 1.0F;
        }
    }
    const auto smooth = [&](double sigma) {
        cv::Mat sum;
        cv::Mat weight;
        cv::GaussianBlur(depth.mul(shown), sum, {0, 0}, sigma, sigma);
        cv::GaussianBlur(shown, weight, {0, 0}, sigma, sigma);
        cv::Mat mean;
        cv::divide(sum, cv::max(weight, 1e-3F), mean);
        return mean;
    };
    // Measured on the simulated trench: half as fine finds a quarter of the features, much wider or flatter fewer
    // still.
    constexpr double kFine = 1.0;  // [px]
    constexpr double kWide = 12.0; // [px]
    constexpr double kFull = 0.02; // of the range: as high as black and white go
    const cv::Mat relief = smooth(kWide) - smooth(kFine);
    cv::Mat image;
    relief.convertTo(image, CV_8U, 127.0 / kFull, 128.0);
    return image;
}

/// What is empty takes the blurred grey of its surroundings, so that the borders of holes are no features.
void soften_holes(cv::Mat& image, const cv::Mat& is_empty) {
    cv::Mat weight;
    cv::Mat sum;
    cv::Mat shown;
    cv::bitwise_not(is_empty, shown);
    shown.convertTo(weight, CV_32F, 1.0 / 255.0);
    image.convertTo(sum, CV_32F);
    sum = sum.mul(weight);
    cv::GaussianBlur(sum, sum, {0, 0}, 4.0, 4.0);
    cv::GaussianBlur(weight, weight, {0, 0}, 4.0, 4.0);
    cv::Mat filled;
    cv::divide(sum, cv::max(weight, 1e-3F), filled);
    filled.convertTo(filled, CV_8U);
    filled.copyTo(image, is_empty);
}

cv::Mat emptiness(const Panorama& panorama) {
    cv::Mat empty(panorama.height(), panorama.width(), CV_8UC1);
    for (int row = 0; row < panorama.height(); ++row) {
        auto* line = empty.ptr<std::uint8_t>(row);
        for (int column = 0; column < panorama.width(); ++column) {
            line[column] = panorama.points_at(column, row).empty() ? 255 : 0;
        }
    }
    return empty;
}

/// Largest relative difference of the range between the feature's middle and a ring around it.
double relief_around(const Panorama& panorama, const Feature& feature) {
    const double here = feature.x_in_scan.norm();
    double relief = 0.0;
    for (int k = 0; k < 8; ++k) {
        const double angle = k * std::numbers::pi / 4.0;
        const double radius = std::max(1.5, 0.5 * static_cast<double>(feature.size));
        int column = static_cast<int>(std::floor(feature.pixel.x() + radius * std::cos(angle)));
        const int row = static_cast<int>(std::floor(feature.pixel.y() + radius * std::sin(angle)));
        column = (column + panorama.width()) % panorama.width();
        const auto points = panorama.points_at(column, row);
        if (points.empty()) continue;
        relief = std::max(relief, std::abs(panorama.place(points.front()).norm() - here) / here);
    }
    return relief;
}

void take_roots(cv::Mat& descriptors) {
    for (int row = 0; row < descriptors.rows; ++row) {
        auto* values = descriptors.ptr<float>(row);
        float sum = 0.0F;
        for (int k = 0; k < descriptors.cols; ++k) sum += values[k];
        for (int k = 0; k < descriptors.cols; ++k) values[k] = sum > 0.0F ? std::sqrt(values[k] / sum) : 0.0F;
    }
}

/// In the order of their places, so that the order does not depend on how they were found.
void sort_by_place(std::vector<cv::KeyPoint>& points) {
    std::sort(points.begin(), points.end(), [](const cv::KeyPoint& a, const cv::KeyPoint& b) {
        return std::pair(std::pair(a.pt.y, a.pt.x), std::pair(a.size, a.angle)) <
               std::pair(std::pair(b.pt.y, b.pt.x), std::pair(b.size, b.angle));
    });
}

} // namespace

FeatureSet find_features(const Panorama& panorama, Channel channel, const FeatureOptions& options) {
    cv::Mat image = channel == Channel::Range ? relief_picture(panorama) : grey_picture(panorama, channel);
    soften_holes(image, emptiness(panorama));
    const int seam = is_full_turn(panorama.projection().options()) ? std::min(kSeam, image.cols) : 0;
    if (seam > 0) cv::copyMakeBorder(image, image, 0, 0, seam, seam, cv::BORDER_WRAP);
    const auto sift = cv::SIFT::create(0, 3, options.contrast, options.edge, 1.6);
    std::vector<cv::KeyPoint> points;
    sift->detect(image, points);
    FeatureSet set;
    std::vector<cv::KeyPoint> kept;
    if (options.is_upright) {
        for (auto& point : points) point.angle = 0.0F;
    }
    sort_by_place(points);
    const auto same = [](const cv::KeyPoint& a, const cv::KeyPoint& b) {
        return a.pt == b.pt && a.size == b.size && a.angle == b.angle;
    };
    points.erase(std::unique(points.begin(), points.end(), same), points.end());
    if (points.size() > static_cast<std::size_t>(options.most)) {
        std::stable_sort(points.begin(), points.end(),
                         [](const cv::KeyPoint& a, const cv::KeyPoint& b) { return a.response > b.response; });
        points.resize(static_cast<std::size_t>(options.most));
        sort_by_place(points);
    }
    for (const auto& point : points) {
        // OpenCV counts from the middle of the first pixel, we from its border.
        const Eigen::Vector2d pixel(static_cast<double>(point.pt.x) + 0.5 - seam,
                                    static_cast<double>(point.pt.y) + 0.5);
        if (pixel.x() < 0.0 || pixel.x() >= panorama.width() || pixel.y() < 0.0 || pixel.y() >= panorama.height()) {
            continue;
        }
        const auto x = panorama.surface_at(pixel);
        if (!x) continue;
        const Feature feature{pixel, *x, point.size, channel};
        if (relief_around(panorama, feature) > options.most_relief) continue;
        set.features.push_back(feature);
        kept.push_back(point);
    }
    cv::Mat descriptors;
    if (!kept.empty()) sift->compute(image, kept, descriptors);
    if (kept.size() != set.features.size()) throw Error(ErrorCode::Internal, "SIFT left out features");
    take_roots(descriptors);
    set.descriptors.resize(static_cast<Eigen::Index>(kept.size()), kDescriptorSize);
    for (int row = 0; row < descriptors.rows; ++row) {
        const auto* values = descriptors.ptr<float>(row);
        for (int k = 0; k < descriptors.cols; ++k) set.descriptors(row, k) = values[k];
    }
    return set;
}

void append(FeatureSet& all, const FeatureSet& more) {
    const Eigen::Index before = all.descriptors.rows();
    all.features.insert(all.features.end(), more.features.begin(), more.features.end());
    Descriptors both(before + more.descriptors.rows(), kDescriptorSize);
    both.topRows(before) = all.descriptors;
    both.bottomRows(more.descriptors.rows()) = more.descriptors;
    all.descriptors = std::move(both);
}

} // namespace planum::scans
