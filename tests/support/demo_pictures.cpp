// SPDX-License-Identifier: MIT
#include "tests/support/demo_pictures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include "app/demo/simulator_random.hpp"

namespace planum::test {

namespace {

using namespace app::demo;

using Colour = std::array<unsigned char, 3>;

class Picture {
  public:
    Picture(int width, int height)
        : width_(width), height_(height), pixels_(static_cast<std::size_t>(width * height)) {}

    void set(int x, int y, Colour colour) {
        if (x >= 0 && y >= 0 && x < width_ && y < height_) pixels_[static_cast<std::size_t>(y * width_ + x)] = colour;
    }

    void line(double x0, double y0, double x1, double y1, Colour colour) {
        const int steps = static_cast<int>(std::max(std::abs(x1 - x0), std::abs(y1 - y0))) + 1;
        for (int i = 0; i <= steps; ++i) {
            const double t = static_cast<double>(i) / steps;
            set(static_cast<int>(x0 + t * (x1 - x0)), static_cast<int>(y0 + t * (y1 - y0)), colour);
        }
    }

    void write(const std::filesystem::path& file) const {
        std::ofstream out(file, std::ios::binary);
        out << "P6\n" << width_ << ' ' << height_ << "\n255\n";
        for (const Colour& c : pixels_) out.write(reinterpret_cast<const char*>(c.data()), 3);
    }

  private:
    int width_;
    int height_;
    std::vector<Colour> pixels_;
};

unsigned char tone(double v) { return static_cast<unsigned char>(std::clamp(v, 0.0, 1.0) * 255.0); }

void draw_plan(const DemoDig& dig, SurfaceNo surface, const std::filesystem::path& file) {
    constexpr int kZoom = 2;
    const ColumnGrid& grid = *dig.grid;
    const SurfaceMap& map = dig.maps[static_cast<std::size_t>(surface)];
    const int width = static_cast<int>(grid.columns()) * kZoom;
    const int height = static_cast<int>(grid.rows()) * kZoom;
    Picture picture(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const auto column = static_cast<std::size_t>(x / kZoom);
            const auto row = static_cast<std::size_t>((height - 1 - y) / kZoom);
            const SurfaceCell& cell = map[row * grid.columns() + column];
            const SurfaceCell& west = map[row * grid.columns() + (column > 0 ? column - 1 : 0)];
            const SurfaceCell& north = map[std::min(row + 1, grid.rows() - 1) * grid.columns() + column];
            const double shade =
                0.62 + 4.0 * (static_cast<double>(cell.z - west.z) - static_cast<double>(north.z - cell.z));
            const std::uint64_t key = mix(static_cast<std::uint64_t>(cell.unit + 10) * 7919U);
            const double tint = cell.unit == kAir ? 0.0 : 0.25;
            const bool cut = cell.shown == SurfaceCell::Shown::Cut;
            picture.set(x, y,
                        {tone(shade * (1 - tint * unit_of(key)) * (cut ? 0.8 : 1.0)),
                         tone(shade * (1 - tint * unit_of(key + 1))), tone(shade * (1 - tint * unit_of(key + 2)))});
        }
    }
    const auto to_picture = [&](const std::array<double, 3>& p) {
        return std::array{(p[0] - grid.x0()) / grid.cell() * kZoom, height - (p[1] - grid.y0()) / grid.cell() * kZoom};
    };
    for (const DrawnRegion& region : dig.regions) {
        if (region.surface != surface) continue;
        std::vector<model::Ring> rings = region.outline.holes;
        rings.push_back(region.outline.outer);
        for (const model::Ring& ring : rings) {
            for (std::size_t i = 0; i < ring.size(); ++i) {
                const auto a = to_picture(ring[i]);
                const auto b = to_picture(ring[(i + 1) % ring.size()]);
                picture.line(a[0], a[1], b[0], b[1], {200, 0, 0});
            }
        }
    }
    picture.write(file);
}

void draw_scan(const SimulatedScan& scan, const std::filesystem::path& file) {
    Picture picture(scan.image.columns, scan.image.rows);
    for (int column = 0; column < scan.image.columns; ++column) {
        for (int row = 0; row < scan.image.rows; ++row) {
            const Return& back = scan.image.returns[static_cast<std::size_t>(column * scan.image.rows + row)];
            const unsigned char t = back.range > 0.0F ? tone(static_cast<double>(back.intensity) * 1.2) : 0;
            const Colour colour = back.mixed ? Colour{255, 0, 0} : Colour{t, t, t};
            picture.set(scan.image.columns - 1 - column, scan.image.rows - 1 - row, colour);
        }
    }
    picture.write(file);
}

} // namespace

void write_demo_pictures(const DemoDig& dig, const std::filesystem::path& folder) {
    std::filesystem::create_directories(folder);
    for (SurfaceNo s = 0; s < dig.plan.surfaces; ++s) {
        const std::string& day = dig.plan.days[static_cast<std::size_t>(s)];
        draw_plan(dig, s, folder / ("plan-" + day + ".ppm"));
        const auto scans = scan_surface(dig, s, Progress::none());
        draw_scan(scans.front(), folder / ("scan-" + day + ".ppm"));
    }
}

} // namespace planum::test
