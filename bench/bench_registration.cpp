// SPDX-License-Identifier: MIT
// Registration against the truth of simulated digs. ./dev bench registration [digs FROM TO [SIZE]] | [dig FOLDER]
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "bench/bench_support.hpp"
#include "core/base/error.hpp"
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
    fmt::print("{:<22} {:>7} {:>19} {:>19} {:>13} {:>9} {:>8}\n", "dig", "placed", "to first scan [mm]",
               "site grid [mm]", "links in 95 %", "site in", "time [s]");
    fmt::print("{:<22} {:>7} {:>10} {:>8} {:>10} {:>8}\n", "", "", "worst", "median", "worst", "median");
}

void print_dig(const std::string& name, const test::RegisteredDig& dig) {
    fmt::print("{:<22} {:>3}/{:<3} {:>10.2f} {:>8.2f} {:>10.2f} {:>8.2f} {:>7.0f} % {:>3} {:>7.0f} % {:>8.1f}\n", name,
               dig.placed, dig.scans, test::largest_of(dig.relative) * 1e3, test::median_of(dig.relative) * 1e3,
               test::largest_of(dig.absolute) * 1e3, test::median_of(dig.absolute) * 1e3,
               share_within(dig.link_chi) * 100.0, dig.link_chi.size(), share_within(dig.absolute_chi) * 100.0,
               dig.seconds);
    std::fflush(stdout);
    for (const auto& scan : dig.report.scans) {
        if (!scan.site_from_scan) fmt::print("    {}: {}\n", scan.scan, scan.verdict);
    }
}

void bench_digs(std::uint64_t from, std::uint64_t to, const std::string& size) {
    print_head();
    std::vector<double> links;
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
        links.insert(links.end(), dig.link_chi.begin(), dig.link_chi.end());
        digs_within += share_within(dig.absolute_chi) >= 0.9 ? 1 : 0;
    }
    fmt::print("links within their 95 % bounds: {:.1f} % of {}; digs whose poses are within theirs: {} of {}\n",
               share_within(links) * 100.0, links.size(), digs_within, to - from + 1);
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
