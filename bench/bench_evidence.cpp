// SPDX-License-Identifier: MIT
// What is proposed from scans and outlines, from the files of simulated digs to the truth.
// ./dev bench evidence [FROM TO [SIZE [markers|auto]]]: each seed dug in all three ways
// ./dev bench evidence history [SURFACES [MILLION POINTS]]: a day of five large scans after a long history
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "bench/bench_evidence_history.hpp"
#include "bench/bench_support.hpp"
#include "core/base/error.hpp"
#include "tests/support/evidence_dig.hpp"

using namespace planum;

namespace {

constexpr std::array kMethods = {model::DigMethod::Stratigraphic, model::DigMethod::Planum, model::DigMethod::Mixed};

struct Sum {
    test::EvidenceTally tally;
    std::size_t false_contradictions = 0;
    std::size_t visible_mistakes = 0;
    std::size_t found_mistakes = 0;
    std::size_t hidden_mistakes = 0;
    double first = 0.0;
    double again = 0.0;
    double volume_seconds = 0.0;
    test::DugTally totals;
    test::DugTally days;
    test::DugTally bare;
    test::DugTally units;

    void add(const test::EvidenceDig& dig) {
        tally += dig.tally;
        false_contradictions += dig.false_contradictions.size();
        visible_mistakes += dig.visible_mistakes;
        found_mistakes += dig.found_mistakes;
        hidden_mistakes += dig.hidden_mistakes.size();
        first += dig.first_seconds;
        again += dig.again_seconds;
        volume_seconds += dig.volume_seconds;
        totals += dig.volumes.total;
        for (const test::ToldVolume& day : dig.volumes.days) days += day;
        for (const test::ToldVolume& day : dig.volumes.bare) bare += day;
        for (const test::ToldVolume& unit : dig.volumes.units) units += unit;
    }
};

void print_sum(const std::string& name, const Sum& sum) {
    sum.tally.print(name);
    fmt::print("{:<24} height contradictions of true records {}; mistakes that surfaces can show found {} of {} ({} "
               "they cannot); evidence {:.1f} s, "
               "again {:.2f} s a dig\n",
               "", sum.false_contradictions, sum.found_mistakes, sum.visible_mistakes, sum.hidden_mistakes,
               sum.first / sum.tally.digs, sum.again / sum.tally.digs);
    sum.totals.print("  earth of whole digs");
    sum.days.print("  of days");
    sum.bare.print("  of days, from above");
    sum.units.print("  of units, from above");
    fmt::print("{:<24} volumes in {:.1f} s a dig\n", "", sum.volume_seconds / sum.tally.digs);
    std::fflush(stdout);
}

int run(const std::vector<std::string>& arguments) {
    const auto number = [&](std::size_t i, std::uint64_t otherwise) {
        return i < arguments.size() ? static_cast<std::uint64_t>(std::atoll(arguments[i].c_str())) : otherwise;
    };
    if (!arguments.empty() && arguments[0] == "history") {
        bench::bench_history(static_cast<int>(number(1, 200)), static_cast<std::int64_t>(number(2, 20)) * 1'000'000);
        return 0;
    }
    const std::string size = arguments.size() > 2 ? arguments[2] : "small";
    const auto method = app::register_method_from_word(arguments.size() > 3 ? arguments[3] : "markers");
    if (!method) throw Error(ErrorCode::Usage, "register by markers, features, icp or auto");
    const bool loud = std::getenv("PLANUM_LOUD") != nullptr;
    std::map<model::DigMethod, Sum> sums;
    for (std::uint64_t seed = number(0, 1); seed <= number(1, 3); ++seed) {
        for (const model::DigMethod dug : kMethods) {
            const bench::Scratch scratch;
            app::demo::SimulationOptions options;
            options.seed = seed;
            options.size = size == "small" ? app::demo::DemoSize::Small : app::demo::DemoSize::Medium;
            options.method = dug;
            const test::EvidenceDig dig = test::evidence_of_dig(scratch / "dig", options, *method, {loud, true});
            const std::string name = fmt::format("{} {} {}", seed, size, model::to_word(dug));
            Sum one;
            one.add(dig);
            print_sum(name, one);
            fmt::print("{:<24} {} of {} scans placed in {:.1f} s\n", "", dig.placed, dig.scans, dig.register_seconds);
            for (const test::ToldVolume& day : dig.volumes.days) {
                fmt::print("    {}: {:.2f} m³ dug, told {:+.2f} ± {:.2f} m³ of that\n", day.of, day.dug, day.error(),
                           day.bound);
            }
            for (const test::ToldVolume& unit : dig.volumes.units) {
                if (!loud || std::abs(unit.error()) <= unit.bound) continue;
                fmt::print("    unit {}: {:.3f} m³, told {:+.3f} ± {:.3f} m³ of that\n", unit.of, unit.dug,
                           unit.error(), unit.bound);
            }
            for (const std::string& message : dig.false_contradictions) fmt::print("    false: {}\n", message);
            if (loud) {
                for (const std::string& hidden : dig.hidden_mistakes) fmt::print("    not to be seen: {}\n", hidden);
            }
            for (const std::string& missed : dig.missed_mistakes) fmt::print("    missed: {}\n", missed);
            sums[dug].add(dig);
        }
    }
    fmt::print("together\n");
    for (const auto& [dug, sum] : sums) print_sum(std::string(model::to_word(dug)), sum);
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
