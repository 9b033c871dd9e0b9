// SPDX-License-Identifier: MIT
#include "bench/bench_registration_features.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <future>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "app/demo/simulator.hpp"
#include "app/registration/register_scans.hpp"
#include "app/registration/scan_shelf.hpp"
#include "app/scans/add_scans.hpp"
#include "app/scans/scan_stores.hpp"
#include "bench/bench_support.hpp"
#include "core/base/error.hpp"
#include "scans/registration/coarse_alignment.hpp"

namespace planum::bench {

namespace fs = std::filesystem;
using geometry::Rigid3;
using Stores = std::vector<std::shared_ptr<const scans::PointStore>>;

namespace {

std::vector<fs::path> folders_in(const fs::path& folder) {
    std::vector<fs::path> days;
    for (const auto& entry : fs::directory_iterator(folder)) {
        if (entry.is_directory()) days.push_back(entry.path());
    }
    std::sort(days.begin(), days.end());
    return days;
}

double median_of(std::vector<double> values) {
    if (values.empty()) return 0.0;
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

std::vector<scans::FeatureSet> features_of_all(const Stores& stores, const app::FeatureView& view) {
    std::vector<scans::FeatureSet> all(stores.size());
    for (std::size_t i = 0; i < stores.size(); i += 2) {
        std::vector<std::future<void>> running;
        for (std::size_t k = i; k < std::min(i + 2, stores.size()); ++k) {
            running.push_back(std::async(std::launch::async, [&, k] { all[k] = app::features_of(*stores[k], view); }));
        }
        for (auto& one : running) one.get();
    }
    return all;
}

void print_row(const std::string& name, const Stores& stores, const std::vector<Rigid3>& truth,
               const app::FeatureView& view) {
    std::vector<scans::FeatureSet> features;
    const double seconds = median_seconds(1, [&] { features = features_of_all(stores, view); });
    double count = 0.0;
    for (const auto& set : features) count += static_cast<double>(set.features.size());
    std::vector<double> matches;
    std::vector<double> inliers;
    std::vector<double> shift;
    std::vector<double> turn;
    int pairs = 0;
    for (std::size_t a = 0; a < stores.size(); ++a) {
        for (std::size_t b = a + 1; b < stores.size(); ++b) {
            ++pairs;
            const auto found = scans::align_coarsely(features[a], features[b]);
            matches.push_back(found.matches);
            inliers.push_back(found.inliers);
            if (!found.is_accepted) continue;
            const auto error = geometry::step_between(truth[a].inverse() * truth[b], found.target_from_source);
            shift.push_back(1e3 * error.tail<3>().norm());
            turn.push_back(180.0 / std::numbers::pi * error.head<3>().norm());
        }
    }
    fmt::print("| {} | {:.0f} | {:.0f} | {:.0f} | {}/{} | {:.1f} | {:.1f} | {:.3f} | {:.2f} |\n", name,
               count / static_cast<double>(stores.size()), median_of(matches), median_of(inliers), shift.size(), pairs,
               median_of(shift), shift.empty() ? 0.0 : *std::max_element(shift.begin(), shift.end()), median_of(turn),
               seconds / static_cast<double>(stores.size()));
    std::fflush(stdout);
}

} // namespace

void bench_projections(const fs::path& folder) {
    const Scratch scratch;
    const fs::path file = scratch / "site.gpkg";
    app::Project project = app::Project::create(file, {}, {});
    (void)app::add_scans(project, folders_in(folder), {}, Progress::none());
    Stores stores;
    std::vector<Rigid3> truth;
    for (const auto& scan : project.record().scans) {
        stores.push_back(app::open_store(file, scan, Progress::none()));
        if (!scan.header_pose) throw Error(ErrorCode::BadInput, scan.name + ": no pose in its header");
        truth.push_back(geometry::from_row_major(*scan.header_pose));
    }
    fmt::print("{} scans, all pairs; features of a scan, medians over pairs; {}\n", stores.size(), machine());
    fmt::print("| projection, channels | features | matches | inliers | accepted | error [mm] | worst | [degrees] | "
               "s a scan |\n|---|---|---|---|---|---|---|---|---|\n");
    using enum scans::ProjectionKind;
    for (const auto kind :
         {Equirectangular, Cylindrical, Mercator, Miller, EqualArea, Rectilinear, Pannini, Stereographic}) {
        for (const auto& [name, view] : {std::pair("reflectance", app::FeatureView{kind, true, false}),
                                         std::pair("range", app::FeatureView{kind, false, true}),
                                         std::pair("both", app::FeatureView{kind, true, true})}) {
            print_row(fmt::format("{}, {}", scans::projection_name(kind), name), stores, truth, view);
        }
    }
}

namespace {

/// A point as a line of text.
struct Line {
    double x = 0.0;
    double y = 0.0;
    double z = 0.0;
    std::uint16_t intensity = 0;
};

std::vector<Line> lines_of(const scans::PointStore& store) {
    std::vector<Line> lines;
    store.for_each(
        [&](const scans::FoundPoints& found) {
            const auto& p = found.points;
            for (std::size_t i = 0; i < p.size(); ++i) lines.push_back({p.x[i], p.y[i], p.z[i], p.intensity[i]});
        },
        Progress::none());
    return lines;
}

std::vector<Line> lines_of(const app::demo::ScanImage& image) {
    std::vector<Line> lines;
    for (std::size_t i = 0; i < image.returns.size(); ++i) {
        const auto& back = image.returns[i];
        if (back.range <= 0.0F) continue;
        const auto rows = static_cast<std::size_t>(image.rows);
        const auto ray = image.direction_in_scan(static_cast<int>(i / rows), static_cast<int>(i % rows));
        const auto range = static_cast<double>(back.range);
        lines.push_back({range * ray.x, range * ray.y, range * ray.z,
                         static_cast<std::uint16_t>(65535.0F * std::clamp(back.intensity, 0.0F, 1.0F))});
    }
    return lines;
}

void write(const fs::path& file, const std::vector<Line>& lines) {
    std::ofstream out(file);
    for (const auto& p : lines) out << fmt::format("{:.4f} {:.4f} {:.4f} {}\n", p.x, p.y, p.z, p.intensity);
}

/// The points in the sector that makes the given share of all, or those outside of it.
std::vector<Line> sector_of(std::vector<Line> lines, double share, bool inside) {
    std::sort(lines.begin(), lines.end(),
              [](const Line& a, const Line& b) { return std::atan2(a.y, a.x) < std::atan2(b.y, b.x); });
    const auto border = lines.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(lines.size()));
    return inside ? std::vector<Line>(lines.begin(), border) : std::vector<Line>(border, lines.end());
}

void write_strangers(const scans::PointStore& of_site, const fs::path& folder) {
    const auto elsewhere = [](std::uint64_t seed) {
        app::demo::SimulationOptions simulation;
        simulation.seed = seed;
        const auto dig = app::demo::simulate(simulation, Progress::none());
        return lines_of(app::demo::scan_surface(dig, 0, Progress::none()).at(0).image);
    };
    const std::vector<Line> other = elsewhere(77);
    const std::vector<Line> known = lines_of(of_site);
    write(folder / "othersite.xyz", other);
    write(folder / "empty.xyz", {});
    std::vector<Line> mirrored = known;
    for (auto& p : mirrored) p.y = -p.y;
    write(folder / "mirror.xyz", mirrored);
    std::vector<Line> little = sector_of(known, 0.05, true);
    const std::vector<Line> rest = sector_of(elsewhere(78), 0.05, false);
    little.insert(little.end(), rest.begin(), rest.end());
    write(folder / "fivepercent.xyz", little);
}

} // namespace

void bench_strangers(const fs::path& folder) {
    const Scratch scratch;
    const fs::path file = scratch / "site.gpkg";
    app::Project project = app::Project::create(file, {}, {});
    (void)app::add_scans(project, folders_in(folder), {}, Progress::none());
    const std::string origin = project.record().scans.front().name;
    const fs::path day = scratch / "2012-05-09";
    fs::create_directory(day);
    write_strangers(*app::open_store(file, project.record().scans.front(), Progress::none()), day);
    app::AddScansOptions columns;
    columns.columns = "x,y,z,intensity";
    for (const auto& entry : fs::directory_iterator(day)) {
        try {
            (void)app::add_scans(project, {entry.path()}, columns, Progress::none());
        } catch (const Error& e) {
            fmt::print("{}: not added: {}\n", entry.path().filename().string(), e.what());
        }
    }
    app::RegisterOptions options;
    options.origin = origin;
    const auto report = app::register_scans(project, options, Progress::none());
    for (const auto& scan : report.scans) {
        fmt::print("{:<26} {:>8} points  {}  {}\n", scan.scan, scan.points, scan.site_from_scan ? "PLACED" : "unplaced",
                   scan.verdict);
    }
}

} // namespace planum::bench
