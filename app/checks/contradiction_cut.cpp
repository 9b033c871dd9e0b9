// SPDX-License-Identifier: MIT
#include "app/checks/contradiction_cut.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>

#include "app/checks/contradiction_looks.hpp"

namespace planum::app {

namespace {

constexpr double kBeyond = 0.006; // of the faces, so that their ends are seen [m on paper]

std::optional<std::size_t> cell_at(const scans::GridFrame& frame, const std::array<double, 2>& p) {
    const double column = std::floor(p[0] / frame.cell) - static_cast<double>(frame.west);
    const double row = std::floor(p[1] / frame.cell) - static_cast<double>(frame.south);
    if (!(column >= 0.0 && row >= 0.0 && column < frame.columns && row < frame.rows)) return std::nullopt;
    return frame.at(static_cast<std::int32_t>(row), static_cast<std::int32_t>(column));
}

// The part of a line, at most `longest`, that shows the faces: with the worst place in the middle as far as they go on
// both ways.
FaceCut along_faces(const ContradictingFaces& faces, FaceCut line, double longest, double beyond) {
    double low = line.worst;
    double high = line.worst;
    for (const FaceSample& s : samples_along(faces, line)) {
        if (s.first != faces.upper && s.then != faces.lower) continue;
        low = std::min(low, s.along);
        high = std::max(high, s.along);
    }
    low -= beyond;
    high += beyond;
    const double length = std::min(longest, high - low);
    const double begin = std::clamp(line.worst - 0.5 * length, low, high - length);
    line.from = line.at(begin);
    line.worst -= begin;
    line.length = length;
    return line;
}

double score_of(const ContradictingFaces& faces, const FaceCut& cut) {
    double score = 0.0;
    for (const FaceSample& s : samples_along(faces, cut)) {
        if (s.clash) score += 1.0;
        if (s.first == faces.upper || s.then == faces.lower) score += 0.5;
        if (s.first == faces.lower || s.then == faces.upper) score += 0.25;
    }
    return score;
}

} // namespace

std::vector<FaceSample> samples_along(const ContradictingFaces& faces, const FaceCut& cut) {
    const double cell = faces.before.frame.cell;
    std::vector<FaceSample> all;
    for (double along = 0.5 * cell; along < cut.length; along += cell) {
        FaceSample s;
        s.along = along;
        s.before = s.after = std::nanf("");
        if (const auto at = cell_at(faces.before.frame, cut.at(along))) {
            s.before = faces.before.height[*at];
            s.after = faces.after.height[*at];
            s.first = faces.before.unit[*at];
            s.then = faces.after.unit[*at];
            s.clash = std::binary_search(faces.clash.begin(), faces.clash.end(), *at);
        }
        all.push_back(s);
    }
    return all;
}

FaceCut choose_cut(const ContradictingFaces& faces, const std::array<double, 2>& worst, double thickness) {
    constexpr double kApart = 0.008; // both lines [m on paper]
    constexpr double kMost = 0.04;   // from line to line, where a larger scale is chosen because there is room for it
    constexpr double kSmallest = 20.0;
    constexpr int kDirections = 16;
    double scale = kContradictionScales.front();
    for (const double one : kContradictionScales) {
        if (one <= kSmallest && thickness / one >= kApart) scale = one;
    }
    const double longest = kContradictionWidth * scale;
    FaceCut chosen;
    double best = -1.0;
    for (int i = 0; i < kDirections; ++i) {
        const double angle = std::numbers::pi * i / kDirections;
        FaceCut line;
        line.way = {std::cos(angle), std::sin(angle)};
        if (line.way[0] < -1e-9) line.way = {-line.way[0], -line.way[1]}; // west or south on the left
        line.length = 2.0 * longest;
        line.worst = longest;
        for (std::size_t k = 0; k < 2; ++k) line.from[k] = worst[k] - longest * line.way[k];
        const FaceCut cut = along_faces(faces, line, longest, kBeyond * scale);
        const double score = score_of(faces, cut);
        if (score <= best + 1e-9) continue;
        best = score;
        chosen = cut;
    }
    chosen.scale = scale;
    for (const double larger : kContradictionScales) {
        if (larger >= scale) break;
        if (chosen.length > kContradictionWidth * larger || thickness > kMost * larger) continue;
        chosen.scale = larger;
        break;
    }
    return chosen;
}

} // namespace planum::app
