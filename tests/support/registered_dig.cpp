// SPDX-License-Identifier: MIT
#include "tests/support/registered_dig.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <fstream>
#include <map>
#include <sstream>

#include <Eigen/Cholesky>
#include <nlohmann/json.hpp>

#include "app/registration/import_markers.hpp"
#include "app/scans/add_scans.hpp"
#include "app/scans/days_surface.hpp"
#include "core/geometry/rigid.hpp"

namespace planum::test {

namespace fs = std::filesystem;
using geometry::Rigid3;

namespace {

struct Truth {
    std::vector<std::string> names; ///< in the order of the file, first day's first scan in front
    std::map<std::string, Rigid3> site_from_scan;
    std::vector<Eigen::Vector3d> trench; ///< an even lattice, corners included
};

Truth read_truth(const fs::path& folder) {
    std::ifstream in(folder / "truth.json");
    const auto json = nlohmann::json::parse(in);
    Truth truth;
    double floor = 1e9;
    for (const auto& scan : json.at("scans")) {
        const auto name = scan.at("scan").get<std::string>();
        const Rigid3 pose = geometry::from_row_major(scan.at("site_from_scan").get<std::array<double, 16>>());
        truth.names.push_back(name);
        truth.site_from_scan[name] = pose;
        floor = std::min(floor, pose.translation.z());
    }
    const auto trench = json.at("trench").get<std::array<std::array<double, 2>, 2>>();
    constexpr int kSteps = 4;
    for (int i = 0; i <= kSteps; ++i) {
        for (int j = 0; j <= kSteps; ++j) {
            for (int k = 0; k <= kSteps; ++k) {
                const auto between = [](double low, double high, int step) {
                    return low + (high - low) * step / kSteps;
                };
                truth.trench.emplace_back(between(trench[0][0], trench[1][0], i),
                                          between(trench[0][1], trench[1][1], j), floor - between(1.6, 3.6, k));
            }
        }
    }
    return truth;
}

/// How far each point of the trench is moved from where it should be [m].
std::vector<double> displacements(const Truth& truth, const Rigid3& found, const Rigid3& right) {
    std::vector<double> moved;
    for (const auto& x : truth.trench) moved.push_back((found * (right.inverse() * x) - x).norm());
    return moved;
}

double chi_square(const Rigid3& right, const Rigid3& found, const geometry::Matrix6& covariance) {
    const geometry::Vector6 error = geometry::step_between(right, found);
    return error.dot(covariance.ldlt().solve(error));
}

/// The rows of the survey and of one scan.
fs::path markers_of_one(const fs::path& folder, const std::string& scan) {
    std::ifstream in(folder / "markers.csv");
    const fs::path file = folder / "markers-of-one.csv";
    std::ofstream out(file);
    std::string line;
    bool is_header = true;
    while (std::getline(in, line)) {
        if (is_header || line.starts_with("site,") || line.starts_with(scan + ",")) out << line << '\n';
        is_header = false;
    }
    return file;
}

std::vector<fs::path> day_folders(const fs::path& folder) {
    std::vector<fs::path> days;
    for (const auto& entry : fs::directory_iterator(folder)) {
        if (entry.is_directory() && is_day(entry.path().filename().string())) days.push_back(entry.path());
    }
    return days;
}

void measure(RegisteredDig& dig, const Truth& truth) {
    std::map<std::string, const app::ReportedScan*> placed;
    for (const auto& scan : dig.report.scans) {
        if (scan.site_from_scan) placed[scan.scan] = &scan;
    }
    dig.scans = truth.names.size();
    dig.placed = placed.size();
    const auto first = placed.find(truth.names.front());
    for (const auto& name : truth.names) {
        if (!placed.contains(name)) continue;
        const app::ReportedScan& scan = *placed.at(name);
        const Rigid3& right = truth.site_from_scan.at(name);
        const Rigid3 found = geometry::from_row_major(*scan.site_from_scan);
        const auto moved = displacements(truth, found, right);
        dig.absolute.push_back(largest_of(moved));
        dig.absolute_points.insert(dig.absolute_points.end(), moved.begin(), moved.end());
        dig.absolute_chi.push_back(chi_square(
            right, found, Eigen::Map<const Eigen::Matrix<double, 6, 6, Eigen::RowMajor>>(scan.covariance.data())));
        if (first == placed.end() || name == truth.names.front()) continue;
        const Rigid3 mend = truth.site_from_scan.at(truth.names.front()) *
                            geometry::from_row_major(*first->second->site_from_scan).inverse();
        dig.relative.push_back(largest_of(displacements(truth, mend * found, right)));
    }
    for (const auto& link : dig.report.links) {
        if (!link.is_accepted) continue;
        const Rigid3 right = truth.site_from_scan.at(link.from).inverse() * truth.site_from_scan.at(link.to);
        dig.link_chi.push_back(
            chi_square(right, geometry::from_row_major(link.from_from_to),
                       Eigen::Map<const Eigen::Matrix<double, 6, 6, Eigen::RowMajor>>(link.covariance.data())));
    }
}

} // namespace

RegisteredDig register_written_dig(const fs::path& folder, bool all_markers) {
    const Truth truth = read_truth(folder);
    const fs::path file = folder / "registered.gpkg";
    fs::remove(file);
    app::Project project = app::Project::create(file, {}, {});
    app::add_scans(project, day_folders(folder), {}, Progress::none());
    app::import_markers(project, all_markers ? folder / "markers.csv" : markers_of_one(folder, truth.names.front()),
                        {});
    RegisteredDig dig;
    const auto start = std::chrono::steady_clock::now();
    dig.report = app::register_scans(project, {}, Progress::none());
    dig.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    measure(dig, truth);
    return dig;
}

RegisteredDig register_dig(const fs::path& folder, const app::demo::SimulationOptions& options, bool all_markers) {
    app::demo::write_demo(app::demo::simulate(options, Progress::none()), folder, Progress::none());
    return register_written_dig(folder, all_markers);
}

double median_of(std::vector<double> values) {
    if (values.empty()) return 0.0;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

double largest_of(const std::vector<double>& values) {
    return values.empty() ? 0.0 : *std::max_element(values.begin(), values.end());
}

} // namespace planum::test
