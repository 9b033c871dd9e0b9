// SPDX-License-Identifier: MIT
// Registration against the truth of simulated digs.
// ./dev bench registration [digs FROM TO [SIZE]] | [dig FOLDER] | [wrong SITE SITE [PAIRS]]
// | [trench FOLDER] | [pair FOLDER] | [sequence FOLDER] | [graphs FOLDER] | [large] | [projections FOLDER]
// | [strangers FOLDER]: folders of shared data (trench, pairs, 3dtk, g2o, trench, trench)
#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "app/registration/scan_shelf.hpp"
#include "app/scans/scan_stores.hpp"
#include "bench/bench_registration_features.hpp"
#include "bench/bench_registration_parts.hpp"
#include "bench/bench_registration_real.hpp"
#include "bench/bench_support.hpp"
#include "core/base/error.hpp"
#include "scans/registration/coarse_alignment.hpp"
#include "tests/support/registered_dig.hpp"

using namespace planum;

namespace {

constexpr double kChi95 = 12.592; ///< χ² of six numbers, 95 %

double share_within(const std::vector<double>& chi) {
    double within = 0.0;
    for (const double value : chi) within += value < kChi95 ? 1.0 : 0.0;
    return chi.empty() ? 1.0 : within / static_cast<double>(chi.size());
}

void print_head() {
    fmt::print("{:<22} {:>7} {:>19} {:>29} {:>13} {:>9} {:>8}\n", "dig", "placed", "to first scan [mm]",
               "site grid [mm]", "links in 95 %", "site in", "time [s]");
    // The worst point of the trench in the worst and in the middle scan; on the grid also the middle point of all.
    fmt::print("{:<22} {:>7} {:>10} {:>8} {:>10} {:>8} {:>9}\n", "", "", "worst", "median", "worst", "median",
               "points");
}

void print_dig(const std::string& name, const test::RegisteredDig& dig) {
    fmt::print(
        "{:<22} {:>3}/{:<3} {:>10.2f} {:>8.2f} {:>10.2f} {:>8.2f} {:>9.2f} {:>7.0f} % {:>3} {:>7.0f} % {:>8.1f}\n",
        name, dig.placed, dig.scans, test::largest_of(dig.relative) * 1e3, test::median_of(dig.relative) * 1e3,
        test::largest_of(dig.absolute) * 1e3, test::median_of(dig.absolute) * 1e3,
        test::median_of(dig.absolute_points) * 1e3, share_within(dig.link_chi) * 100.0, dig.link_chi.size(),
        share_within(dig.absolute_chi) * 100.0, dig.seconds);
    std::fflush(stdout);
    for (const auto& scan : dig.report.scans) {
        if (!scan.site_from_scan) fmt::print("    {}: {}\n", scan.scan, scan.verdict);
    }
}

void bench_digs(std::uint64_t from, std::uint64_t to, const std::string& size) {
    print_head();
    std::vector<double> links;
    std::vector<double> points;
    int digs_within = 0;
    for (std::uint64_t seed = from; seed <= to; ++seed) {
        const bench::Scratch scratch;
        app::demo::SimulationOptions options;
        options.seed = seed;
        options.size = size == "small" ? app::demo::DemoSize::Small : app::demo::DemoSize::Medium;
        constexpr model::DigMethod kMethods[] = {model::DigMethod::Stratigraphic, model::DigMethod::Planum,
                                                 model::DigMethod::Mixed};
        options.method = kMethods[(seed - 1) % 3];
        const auto dig = test::register_dig(scratch / "dig", options);
        print_dig(fmt::format("{} {} {}", seed, size, to_word(options.method)), dig);
        points.insert(points.end(), dig.absolute_points.begin(), dig.absolute_points.end());
        links.insert(links.end(), dig.link_chi.begin(), dig.link_chi.end());
        digs_within += share_within(dig.absolute_chi) >= 0.9 ? 1 : 0;
    }
    fmt::print("points of the trench on the site grid, all digs and scans: median {:.2f} mm\n",
               test::median_of(points) * 1e3);
    fmt::print("links within their 95 % bounds: {:.1f} % of {}; digs whose poses are within theirs: {} of {}\n",
               share_within(links) * 100.0, links.size(), digs_within, to - from + 1);
}

struct SiteFeatures {
    std::vector<std::string> names;
    std::vector<scans::FeatureSet> features;
    std::vector<scans::PreparedScan> prepared;
};

SiteFeatures features_of_site(const std::filesystem::path& file) {
    app::Project project = app::Project::open(file, store::OpenMode::ReadOnly, {});
    SiteFeatures site;
    for (const auto& scan : project.record().scans) {
        const auto store = app::open_store(file, scan, Progress::none());
        site.names.push_back(scan.name);
        site.features.push_back(app::features_of(*store));
        site.prepared.push_back(scans::prepare_scan(app::points_of(*store)));
    }
    return site;
}

// Turned any way and up to 2 m aside, both scanners at one height above their ground: what a wrong guess may look like.
geometry::Rigid3 wrong_start(std::mt19937_64& random) {
    std::uniform_real_distribution<double> turn(0.0, 6.283185307179586);
    std::uniform_real_distribution<double> aside(-2.0, 2.0);
    const double yaw = turn(random);
    geometry::Rigid3 start;
    start.rotation = Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    start.translation = {aside(random), aside(random), 0.0};
    return start;
}

// Scans of two sites that have nothing to do with each other, paired at random: none may be accepted, neither by their
// features nor, without asking these, by the fine alignment from a wrong guess.
void bench_wrong_pairs(const std::string& first, const std::string& second, std::uint64_t pairs) {
    const SiteFeatures a = features_of_site(first);
    const SiteFeatures b = features_of_site(second);
    std::mt19937_64 random(1);
    int coarse = 0;
    int fine = 0;
    int most = 0;
    int guesses = 0;
    for (std::uint64_t i = 0; i < pairs; ++i) {
        const std::size_t t = random() % a.names.size();
        const std::size_t s = random() % b.names.size();
        const auto guessed = scans::align_scans(a.prepared[t], b.prepared[s], wrong_start(random));
        guesses += guessed.is_accepted ? 1 : 0;
        if (guessed.is_accepted) fmt::print("{} and {}: {}\n", a.names[t], b.names[s], guessed.verdict);
        const auto found = scans::align_coarsely(a.features[t], b.features[s]);
        most = std::max(most, found.inliers);
        if (!found.is_accepted) continue;
        ++coarse;
        fine += scans::align_scans(a.prepared[t], b.prepared[s], found.target_from_source).is_accepted ? 1 : 0;
    }
    fmt::print("{} random pairs of scans of two sites: {} passed the features (at most {} inliers), {} the fine "
               "alignment; {} the fine alignment alone, from a wrong guess\n",
               pairs, coarse, most, fine, guesses);
}

int run(const std::vector<std::string>& arguments) {
    const auto number = [&](std::size_t i, std::uint64_t otherwise) {
        return i < arguments.size() ? static_cast<std::uint64_t>(std::atoll(arguments[i].c_str())) : otherwise;
    };
    if (arguments.size() >= 2 && arguments[0] == "dig") {
        print_head();
        for (std::size_t i = 1; i < arguments.size(); ++i)
            print_dig(std::filesystem::path(arguments[i]).filename().string(),
                      test::register_written_dig(arguments[i]));
        return 0;
    }
    if (arguments.size() >= 3 && arguments[0] == "wrong") {
        bench_wrong_pairs(arguments[1], arguments[2], number(3, 200));
        return 0;
    }
    if (arguments.size() >= 2 && arguments[0] == "trench") {
        bench::bench_trench(arguments[1]);
        return 0;
    }
    const std::pair<const char*, void (*)(const std::filesystem::path&)> parts[] = {
        {"pair", bench::bench_pair},           {"sequence", bench::bench_sequence},
        {"graphs", bench::bench_graphs},       {"projections", bench::bench_projections},
        {"strangers", bench::bench_strangers},
    };
    for (const auto& [name, work] : parts) {
        if (arguments.size() < 2 || arguments[0] != name) continue;
        work(arguments[1]);
        return 0;
    }
    if (!arguments.empty() && arguments[0] == "large") {
        bench::bench_large_pair();
        return 0;
    }
    if (!arguments.empty() && arguments[0] == "digs") {
        bench_digs(number(1, 1), number(2, 20), arguments.size() > 3 ? arguments[3] : "medium");
        return 0;
    }
    bench_digs(1, 3, "small");
    return 0;
}

} // namespace

int main(int argc, char** argv) {
    try {
        return run({argv + 1, argv + argc});
    } catch (const Error& e) {
        fmt::print(stderr, "{}\n", e.what());
        return 1;
    }
}
