// SPDX-License-Identifier: MIT
#include "bench/bench_registration_real.hpp"

#include <algorithm>
#include <fstream>
#include <random>
#include <vector>

#include <Eigen/Cholesky>
#include <fmt/format.h>

#include "app/registration/register_scans.hpp"
#include "app/registration/scan_shelf.hpp"
#include "app/scans/add_scans.hpp"
#include "app/scans/scan_stores.hpp"
#include "bench/bench_support.hpp"
#include "core/base/error.hpp"
#include "core/geometry/rigid.hpp"
#include "scans/registration/fine_alignment.hpp"
#include "scans/registration/scan_network.hpp"

namespace planum::bench {

namespace fs = std::filesystem;
using geometry::Rigid3;
using geometry::Vector6;

namespace {

constexpr double kDegrees = 57.29577951308232;
constexpr double kChi95 = 12.592; ///< χ² of six numbers, 95 %

/// Errors of poses or links.
struct Errors {
    std::vector<double> shift; ///< [mm]
    std::vector<double> turn;  ///< [degrees]
    std::vector<double> chi;

    void add(const Vector6& error, const geometry::Matrix6& covariance) {
        shift.push_back(1e3 * error.tail<3>().norm());
        turn.push_back(kDegrees * error.head<3>().norm());
        chi.push_back(error.dot(covariance.ldlt().solve(error)));
    }

    void print(const std::string& what) const {
        if (shift.empty()) {
            fmt::print("{:<44} none\n", what);
            return;
        }
        double sum = 0.0;
        for (const double s : shift) sum += s;
        fmt::print("{:<44} worst {:.3f} mm {:.4f}°, mean {:.3f} mm; {} of {} within their 95 % bounds\n", what,
                   *std::max_element(shift.begin(), shift.end()), *std::max_element(turn.begin(), turn.end()),
                   sum / static_cast<double>(shift.size()),
                   std::count_if(chi.begin(), chi.end(), [](double c) { return c < kChi95; }), chi.size());
    }
};

Rigid3 disturbed(const Rigid3& pose, double metres, double radians, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    const Eigen::Vector3d turn(normal(random), normal(random), normal(random));
    const Eigen::Vector3d shift(normal(random), normal(random), normal(random));
    Vector6 step;
    step << radians * turn.normalized(), metres * shift.normalized();
    return geometry::moved(pose, step);
}

Rigid3 truth_of(const model::Scan& scan) {
    if (!scan.header_pose) throw Error(ErrorCode::BadInput, scan.name + ": no pose in its header");
    return geometry::from_row_major(*scan.header_pose);
}

// Every pair from 5 cm and 0.5° off, then all of them relaxed with the first scan held.
void bench_pairs(app::Project& project, const fs::path& file) {
    const auto& all = project.record().scans;
    std::vector<scans::PreparedScan> prepared;
    for (const auto& scan : all) {
        prepared.push_back(scans::prepare_scan(app::points_of(*app::open_store(file, scan, Progress::none()))));
    }
    Errors pairs;
    std::vector<scans::NetworkLink> links;
    for (std::size_t a = 0; a < all.size(); ++a) {
        for (std::size_t b = a + 1; b < all.size(); ++b) {
            const Rigid3 right = truth_of(all[a]).inverse() * truth_of(all[b]);
            const auto found =
                scans::align_scans(prepared[a], prepared[b], disturbed(right, 0.05, 0.5 / kDegrees, 100 * a + b));
            if (!found.is_accepted) fmt::print("    {} to {}: {}\n", all[b].name, all[a].name, found.verdict);
            if (!found.is_accepted) continue;
            pairs.add(geometry::step_between(right, found.target_from_source), found.covariance);
            links.push_back({a, b, found.target_from_source, found.covariance});
        }
    }
    pairs.print(fmt::format("{} pairs from 5 cm and 0.5° off", links.size()));
    const scans::NetworkAnchor first{0, truth_of(all[0]), geometry::Matrix6::Zero(), true};
    const auto network = scans::solve_network(all.size(), links, {&first, 1});
    Errors poses;
    for (std::size_t i = 1; i < all.size(); ++i) {
        if (!network.poses[i]) continue;
        poses.add(geometry::step_between(truth_of(all[i]), network.poses[i]->site_from_scan),
                  network.poses[i]->link_covariance);
    }
    poses.print(fmt::format("{} poses relaxed over them", poses.shift.size()));
}

// A PTX of one scan with another pose in its header.
void copy_with_pose(const fs::path& from, const fs::path& to, const Rigid3& pose) {
    std::ifstream in(from);
    std::ofstream out(to);
    std::string line;
    constexpr int kPoseFrom = 2;
    constexpr int kPoseTo = 10; // origin, three axes, four rows of the transposed matrix
    const Eigen::Matrix3d axes = pose.rotation.transpose();
    const Eigen::Vector3d& origin = pose.translation;
    for (int i = 0; std::getline(in, line); ++i) {
        if (i < kPoseFrom || i >= kPoseTo) out << line << '\n';
        if (i != kPoseFrom) continue;
        const std::string place = fmt::format("{:.6f} {:.6f} {:.6f}", origin.x(), origin.y(), origin.z());
        out << place << '\n';
        for (const char* last : {"", " 0"}) {
            for (const auto& row : axes.rowwise()) {
                out << fmt::format("{:.9f} {:.9f} {:.9f}{}\n", row[0], row[1], row[2], last);
            }
        }
        out << place << " 1\n";
    }
    if (!in.eof() || !out.flush()) throw Error(ErrorCode::BadInput, from.string() + ": cannot be copied");
}

// The files again with headers 2 m and 40° off, but the first, which is the grid.
std::vector<fs::path> disturbed_days(const std::vector<fs::path>& days, const model::Record& record,
                                     const fs::path& folder) {
    std::vector<fs::path> copies;
    std::uint64_t seed = 1;
    for (const auto& day : days) {
        copies.push_back(folder / day.filename());
        fs::create_directories(copies.back());
        for (const auto& entry : fs::directory_iterator(day)) {
            if (entry.path().extension() != ".ptx") continue;
            const auto name = fs::path(day.filename() / entry.path().stem()).generic_string();
            const auto it = std::find_if(record.scans.begin(), record.scans.end(),
                                         [&](const auto& scan) { return scan.name == name; });
            if (it == record.scans.end()) throw Error(ErrorCode::BadInput, name + ": not among the scans");
            const bool is_grid = it == record.scans.begin();
            copy_with_pose(entry.path(), copies.back() / entry.path().filename(),
                           is_grid ? truth_of(*it) : disturbed(truth_of(*it), 2.0, 40.0 / kDegrees, ++seed));
        }
    }
    return copies;
}

} // namespace

void bench_trench(const fs::path& folder) {
    const Scratch scratch;
    const fs::path file = scratch / "trench.gpkg";
    app::Project project = app::Project::create(file, {}, {});
    std::vector<fs::path> days;
    for (const auto& entry : fs::directory_iterator(folder)) {
        if (entry.is_directory()) days.push_back(entry.path());
    }
    std::sort(days.begin(), days.end());
    (void)app::add_scans(project, days, {}, Progress::none());
    bench_pairs(project, file);
    app::Project far_off = app::Project::create(scratch / "far-off.gpkg", {}, {});
    (void)app::add_scans(far_off, disturbed_days(days, project.record(), scratch / "far-off"), {}, Progress::none());
    app::RegisterOptions options;
    options.origin = project.record().scans.front().name;
    const auto report = app::register_scans(far_off, options, Progress::none());
    Errors poses;
    for (const auto& scan : report.scans) {
        if (!scan.site_from_scan) fmt::print("    {}: {}\n", scan.scan, scan.verdict);
        if (!scan.site_from_scan || scan.scan == options.origin) continue;
        const auto& all = project.record().scans;
        const auto it = std::find_if(all.begin(), all.end(), [&](const auto& s) { return s.name == scan.scan; });
        poses.add(geometry::step_between(truth_of(*it), geometry::from_row_major(*scan.site_from_scan)),
                  Eigen::Map<const Eigen::Matrix<double, 6, 6, Eigen::RowMajor>>(scan.covariance.data()));
    }
    poses.print(fmt::format("{} poses by the whole chain from 2 m and 40° off", poses.shift.size()));
}

} // namespace planum::bench
