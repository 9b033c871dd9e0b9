// SPDX-License-Identifier: MIT
#include "bench/bench_evidence_history.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "app/evidence/evidence.hpp"
#include "app/project/project.hpp"
#include "app/scans/add_scans.hpp"
#include "bench/bench_support.hpp"
#include "core/base/error.hpp"

namespace planum::bench {

namespace fs = std::filesystem;

namespace {

constexpr double kSide = 20.0;      ///< of the trench [m]
constexpr int kColumns = 10;        ///< of plots
constexpr int kRows = 6;            ///< of plots
constexpr int kTurn = 5;            ///< a plot goes down every so many days
constexpr double kLayer = 0.08;     ///< that goes [m]
constexpr double kPoseSigma = 5e-4; ///< [m]

int layers_gone(int plot, int day) { return (day + plot) / kTurn; }

int plot_at(double x, double y) {
    const int column = std::min(kColumns - 1, static_cast<int>(x / kSide * kColumns));
    const int row = std::min(kRows - 1, static_cast<int>(y / kSide * kRows));
    return row * kColumns + column;
}

double height_at(double x, double y, int day) {
    return 50.0 + 0.05 * std::sin(x) * std::cos(0.7 * y) - kLayer * layers_gone(plot_at(x, y), day);
}

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

// The peak since the last call [MB].
double peak_mb() {
    std::ifstream in("/proc/self/status");
    double peak = 0.0;
    for (std::string word; in >> word;) {
        if (word == "VmHWM:") in >> peak;
    }
    std::ofstream("/proc/self/clear_refs") << 5;
    return peak / 1024.0;
}

// Rows of points a little out of step with those of other scans, as PLY.
void write_scan(const fs::path& file, std::int64_t points, int day, double shift) {
    std::ofstream out(file, std::ios::binary);
    const auto side = static_cast<std::int64_t>(std::sqrt(static_cast<double>(points)));
    out << "ply\nformat binary_little_endian 1.0\nelement vertex " << side * side
        << "\nproperty float x\nproperty float y\nproperty float z\nend_header\n";
    const double step = kSide / static_cast<double>(side);
    std::vector<float> row;
    for (std::int64_t r = 0; r < side; ++r) {
        row.clear();
        const double y = (static_cast<double>(r) + shift) * step;
        for (std::int64_t c = 0; c < side; ++c) {
            const double x = (static_cast<double>(c) + shift) * step;
            row.push_back(static_cast<float>(x - 0.5 * kSide));
            row.push_back(static_cast<float>(y - 0.5 * kSide));
            row.push_back(static_cast<float>(height_at(x, y, day) - 50.0));
        }
        out.write(reinterpret_cast<const char*>(row.data()), static_cast<std::streamsize>(row.size() * sizeof(float)));
    }
}

class History {
  public:
    explicit History(const fs::path& folder)
        : folder_(folder), project_(app::Project::create(folder / "history.gpkg", {}, {})) {}

    app::Project& project() { return project_; }

    void write_record(int days) {
        project_.change("Import", [&] {
            std::vector<std::vector<model::UnitId>> units(kColumns * kRows);
            for (int day = 0; day < days; ++day) {
                model::Surface surface;
                surface.name = fmt::format("S{}", day + 1);
                surface.first_day = fmt::format("2025-{:02}-{:02}", 1 + day / 28, 1 + day % 28);
                surface.order = day;
                surface.id = project_.file().insert(surface);
                surfaces_.push_back(surface.id);
                for (int plot = 0; plot < kColumns * kRows; ++plot) {
                    auto& of_plot = units[static_cast<std::size_t>(plot)];
                    const auto layer = static_cast<std::size_t>(layers_gone(plot, day));
                    while (of_plot.size() <= layer) {
                        model::StratigraphicUnit unit;
                        unit.number = fmt::format("{}", 1000 * (plot + 1) + static_cast<int>(of_plot.size()));
                        of_plot.push_back(project_.file().insert(unit));
                    }
                    insert_region(surface.id, of_plot[layer], plot);
                }
            }
        });
    }

    void add_scans(int day, int scans, std::int64_t points) {
        std::vector<fs::path> files;
        for (int i = 0; i < scans; ++i) {
            files.push_back(folder_ / fmt::format("day{}-{}.ply", day + 1, i + 1));
            write_scan(files.back(), points, day, (i + 0.5) / scans);
        }
        app::AddScansOptions options;
        options.day = fmt::format("2025-{:02}-{:02}", 1 + day / 28, 1 + day % 28);
        options.surface = fmt::format("S{}", day + 1);
        const auto added = app::add_scans(project_, files, options, Progress::none()).added;
        for (const auto& file : files) fs::remove(file);
        project_.change("Place", [&] {
            model::RegistrationRun run;
            run.name = fmt::format("day {}", day + 1);
            run.state = "accepted";
            run.made_at = project_.clock().now();
            const model::RegistrationRunId id = project_.file().insert(run);
            for (const auto& scan : added) {
                model::ScanPose pose;
                pose.scan = scan.scan.id;
                pose.run = id;
                pose.site_from_scan = {1, 0, 0, 0.5 * kSide, 0, 1, 0, 0.5 * kSide, 0, 0, 1, 50, 0, 0, 0, 1};
                for (std::size_t axis = 3; axis < 6; ++axis) pose.covariance[7 * axis] = kPoseSigma * kPoseSigma;
                project_.file().insert(pose);
            }
        });
    }

    // Moves one corner of the outline of the first plot that has one on that day.
    void redraw(int day) {
        const auto& regions = project_.record().regions;
        const auto it = std::find_if(regions.begin(), regions.end(), [&](const model::Region& region) {
            return region.surface == surfaces_[static_cast<std::size_t>(day)];
        });
        if (it == regions.end()) throw Error(ErrorCode::Internal, "no outline on that day");
        model::Region region = *it;
        region.outline.front().outer.front()[0] += 0.15;
        project_.change("Redraw", [&] { project_.file().update(region); });
    }

  private:
    void insert_region(model::SurfaceId surface, model::UnitId unit, int plot) {
        model::Region region;
        region.surface = surface;
        region.unit = unit;
        const double width = kSide / kColumns;
        const double depth = kSide / kRows;
        const double x = plot % kColumns * width;
        const double y = plot / kColumns * depth;
        region.outline = {
            {{{x, y, 50.0}, {x + width, y, 50.0}, {x + width, y + depth, 50.0}, {x, y + depth, 50.0}}, {}}};
        project_.file().insert(region);
    }

    fs::path folder_;
    app::Project project_;
    std::vector<model::SurfaceId> surfaces_;
};

} // namespace

void bench_history(int surfaces, std::int64_t points) {
    constexpr std::int64_t kPointsOfHistory = 1'700'000;
    const Scratch scratch;
    History history(scratch / "");
    history.write_record(surfaces + 1);
    fmt::print("{}\n{} × {} m, {} outlines a surface, {} surfaces of one scan of {} million points each\n", machine(),
               kSide, kSide, kColumns * kRows, surfaces, static_cast<double>(kPointsOfHistory) * 1e-6);
    for (int day = 0; day < surfaces; ++day) history.add_scans(day, 1, kPointsOfHistory);
    const auto gather = [&](const std::string& what) {
        (void)peak_mb();
        const double began = now();
        const auto areas = app::gather_evidence(history.project(), Progress::none());
        const double took = now() - began;
        std::size_t relations = 0;
        std::size_t questions = 0;
        std::size_t unseen = 0;
        double cell = 0.0;
        for (const auto& area : areas) {
            unseen += area.unseen.size();
            cell = area.frame.cell;
            for (const auto& c : area.conclusions) ++(c.is_question ? questions : relations);
        }
        fmt::print("{:<52} {:>7.2f} s  peak {:>5.0f} MB  {} relations, {} questions in cells of {} m{}\n", what, took,
                   peak_mb(), relations, questions, cell,
                   unseen > 0 ? fmt::format("; {} surfaces could not be judged", unseen) : "");
        std::fflush(stdout);
    };
    gather("the whole history for the first time");
    gather("the same again");
    history.add_scans(surfaces, 5, points);
    gather(fmt::format("a day of 5 scans of {} million points", static_cast<double>(points) * 1e-6));
    gather("the same again");
    history.redraw(surfaces);
    gather("an outline of that day redrawn");
    history.redraw(surfaces / 2);
    gather("an outline in the middle of the history redrawn");
}

} // namespace planum::bench
