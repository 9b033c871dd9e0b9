// SPDX-License-Identifier: MIT
#include "scans/panorama/scan_extent.hpp"

#include <algorithm>
#include <cmath>

namespace planum::scans {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr std::size_t kAcross = 1440; // cells of a quarter of a degree
constexpr std::size_t kUp = 720;
constexpr double kCell = 2.0 * kPi / kAcross;
constexpr double kSmallestGap = 10.0 * kPi / 180.0; // less is no end of the scan, only a post beside the scanner
constexpr std::uint32_t kMostLines = 1U << 20U;
constexpr double kFinestStep = 0.01 * kPi / 180.0;
constexpr double kCoarsestStep = 1.0 * kPi / 180.0;
constexpr double kEnoughInCell = 4.0;
constexpr double kWidestView = 120.0 * kPi / 180.0;

// Beyond, a picture of equal pixels at the horizon would be mostly its own stretched rim.
double most_elevation(ProjectionKind kind) noexcept {
    switch (kind) {
    case ProjectionKind::Equirectangular:
    case ProjectionKind::EqualArea:
    case ProjectionKind::Miller: return kPi / 2.0;
    case ProjectionKind::Mercator: return 75.0 * kPi / 180.0;
    case ProjectionKind::Stereographic: return 80.0 * kPi / 180.0;
    case ProjectionKind::Cylindrical:
    case ProjectionKind::Rectilinear:
    case ProjectionKind::Pannini: return 60.0 * kPi / 180.0;
    }
    return kPi / 2.0;
}

struct Sample {
    double at = 0.0;
    double value = 0.0;
    double weight = 0.0;
};

struct Fitted {
    double first = 0.0;
    double step = 0.0;
    double deviation = 0.0; ///< root of the weighted mean square
};

Fitted straight_line(const std::vector<Sample>& samples) {
    double w = 0.0;
    double x = 0.0;
    double y = 0.0;
    for (const Sample& s : samples) {
        w += s.weight;
        x += s.weight * s.at;
        y += s.weight * s.value;
    }
    x /= w;
    y /= w;
    double xx = 0.0;
    double xy = 0.0;
    for (const Sample& s : samples) {
        xx += s.weight * (s.at - x) * (s.at - x);
        xy += s.weight * (s.at - x) * (s.value - y);
    }
    Fitted line;
    line.step = xx > 0.0 ? xy / xx : 0.0;
    line.first = y - line.step * x;
    double rest = 0.0;
    for (const Sample& s : samples) {
        const double off = s.value - (line.first + line.step * s.at);
        rest += s.weight * off * off;
    }
    line.deviation = std::sqrt(rest / w);
    return line;
}

} // namespace

ScanExtent::ScanExtent(Columns has) : has_(has), seen_(kAcross * kUp) {}

void ScanExtent::add(const PointBlock& block) {
    for (std::size_t i = 0; i < block.size(); ++i) {
        if (block.validity[i] != Validity::Valid) continue;
        const double flat = std::sqrt(block.x[i] * block.x[i] + block.y[i] * block.y[i]);
        const double range = std::sqrt(flat * flat + block.z[i] * block.z[i]);
        if (!(range > 0.0)) continue;
        const double azimuth = std::atan2(block.y[i], block.x[i]);
        const double elevation = std::atan2(block.z[i], flat);
        const auto across = std::min(static_cast<std::size_t>((azimuth + kPi) / kCell), kAcross - 1);
        const auto up = std::min(static_cast<std::size_t>((elevation + kPi / 2.0) / kCell), kUp - 1);
        seen_[up * kAcross + across] = 1;
        ++points_;
        if (!has_.grid || block.row[i] >= kMostLines || block.column[i] >= kMostLines) continue;
        const auto line = [](std::vector<Line>& lines, std::uint32_t number) -> Line& {
            if (number >= lines.size()) lines.resize(number + 1);
            return lines[number];
        };
        Line& column = line(columns_, block.column[i]);
        column.x += block.x[i] / range;
        column.y += block.y[i] / range;
        column.flat += flat / range;
        column.count += 1.0;
        Line& row = line(rows_, block.row[i]);
        row.elevation += elevation;
        row.square += elevation * elevation;
        row.count += 1.0;
    }
}

std::optional<GridSteps> ScanExtent::grid() const {
    std::vector<Sample> azimuths;
    double together = 0.0; // sums that point one way: a column of a dome scanner has two sides
    double apart = 0.0;
    for (std::size_t c = 0; c < columns_.size(); ++c) {
        const Line& column = columns_[c];
        const double sum = std::hypot(column.x, column.y);
        if (!(sum > 0.0)) continue;
        double azimuth = std::atan2(column.y, column.x);
        if (!azimuths.empty()) azimuth += 2.0 * kPi * std::round((azimuths.back().value - azimuth) / (2.0 * kPi));
        azimuths.push_back({static_cast<double>(c), azimuth, sum});
        together += sum;
        apart += column.flat - sum;
    }
    std::vector<Sample> elevations;
    double spread = 0.0;
    for (std::size_t r = 0; r < rows_.size(); ++r) {
        const Line& row = rows_[r];
        if (row.count < 1.0) continue;
        const double mean = row.elevation / row.count;
        elevations.push_back({static_cast<double>(r), mean, row.count});
        spread += row.square - row.count * mean * mean;
    }
    if (azimuths.size() < 8 || elevations.size() < 8 || apart > 0.01 * together) return std::nullopt;
    const Fitted across = straight_line(azimuths);
    const Fitted up = straight_line(elevations);
    const double within = std::sqrt(std::max(0.0, spread) / static_cast<double>(points_));
    const bool regular = across.deviation < 0.25 * std::abs(across.step) && up.deviation < 0.25 * std::abs(up.step) &&
                         within < 0.5 * std::abs(up.step);
    if (!regular) return std::nullopt;
    GridSteps steps{across.first, across.step, up.first, up.step, 0, 0, 0, 0};
    steps.column_from = static_cast<std::uint32_t>(azimuths.front().at);
    steps.column_to = static_cast<std::uint32_t>(azimuths.back().at);
    steps.row_from = static_cast<std::uint32_t>(elevations.front().at);
    steps.row_to = static_cast<std::uint32_t>(elevations.back().at);
    return steps;
}

// About one point a pixel where there are points. Counted in cells large enough to hold several points each: smaller
// ones lie empty between the points and tell nothing of the density.
double ScanExtent::free_step() const {
    double step = kCoarsestStep;
    for (std::size_t side = 1; side <= 16; side *= 2) {
        std::vector<std::uint8_t> coarse((kAcross / side) * (kUp / side + 1));
        for (std::size_t i = 0; i < seen_.size(); ++i) {
            if (seen_[i] != 0) coarse[i / kAcross / side * (kAcross / side) + i % kAcross / side] = 1;
        }
        const auto cells = static_cast<double>(std::count(coarse.begin(), coarse.end(), 1));
        const double cell = kCell * static_cast<double>(side);
        step = std::sqrt(cells * cell * cell / static_cast<double>(points_));
        if (static_cast<double>(points_) >= kEnoughInCell * cells) break;
    }
    return std::clamp(step, kFinestStep, kCoarsestStep);
}

void ScanExtent::fit_azimuths(ProjectionOptions& options) const {
    std::vector<bool> seen(kAcross);
    for (std::size_t i = 0; i < seen_.size(); ++i) {
        if (seen_[i] != 0) seen[i % kAcross] = true;
    }
    // The longest run of nothing, around the circle; the picture is cut there.
    std::size_t longest = 0;
    std::size_t ends = 0; // first cell behind it
    std::size_t run = 0;
    for (std::size_t i = 0; i < 2 * kAcross; ++i) {
        run = seen[i % kAcross] ? 0 : std::min(run + 1, kAcross);
        if (run > longest) {
            longest = run;
            ends = (i + 1) % kAcross;
        }
    }
    if (static_cast<double>(longest) * kCell < kSmallestGap) return;
    options.azimuth_from = -kPi + static_cast<double>(ends) * kCell;
    options.azimuth_to = options.azimuth_from + static_cast<double>(kAcross - longest) * kCell;
}

void ScanExtent::fit_elevations(ProjectionOptions& options) const {
    const auto row_of = [](std::size_t cell) { return static_cast<double>(cell / kAcross) * kCell - kPi / 2.0; };
    const auto first = std::find(seen_.begin(), seen_.end(), 1) - seen_.begin();
    const auto last = seen_.rend() - std::find(seen_.rbegin(), seen_.rend(), 1) - 1;
    options.elevation_from = row_of(static_cast<std::size_t>(first));
    options.elevation_to = row_of(static_cast<std::size_t>(last)) + kCell;
}

ProjectionOptions ScanExtent::fit(ProjectionKind kind, int most_width) const {
    ProjectionOptions options;
    options.kind = kind;
    if (points_ == 0) return options;
    fit_azimuths(options);
    fit_elevations(options);
    double step = free_step();
    const std::optional<GridSteps> steps = grid();
    if (steps) {
        step = std::min(std::abs(steps->azimuth_step), std::abs(steps->elevation_step));
        const auto border = [](double first, double by, double from, double to) {
            const double a = first + by * from;
            const double b = first + by * to;
            return std::pair{std::min(a, b) - std::abs(by) / 2.0, std::max(a, b) + std::abs(by) / 2.0};
        };
        auto [right, left] = border(steps->first_azimuth, steps->azimuth_step, steps->column_from, steps->column_to);
        left = std::min(left, right + 2.0 * kPi);
        const double turns = 2.0 * kPi * std::floor((right + kPi) / (2.0 * kPi));
        options.azimuth_from = right - turns;
        options.azimuth_to = left - turns;
        std::tie(options.elevation_from, options.elevation_to) =
            border(steps->first_elevation, steps->elevation_step, steps->row_from, steps->row_to);
    }
    const double most = most_elevation(kind);
    options.elevation_from = std::clamp(options.elevation_from, -most, most - kCell);
    options.elevation_to = std::clamp(options.elevation_to, options.elevation_from + kCell / 2.0, most);
    options.views =
        std::max(1, static_cast<int>(std::ceil((options.azimuth_to - options.azimuth_from) / kWidestView - 1e-9)));
    if (steps && kind == ProjectionKind::Equirectangular) {
        const double across = (options.azimuth_to - options.azimuth_from) / std::abs(steps->azimuth_step);
        const double up = (options.elevation_to - options.elevation_from) / std::abs(steps->elevation_step);
        if (across <= most_width) {
            options.width = std::max(1, static_cast<int>(std::lround(across)));
            options.height = std::max(1, static_cast<int>(std::lround(up)));
            return options;
        }
    }
    return with_square_pixels(options, step, most_width);
}

} // namespace planum::scans
