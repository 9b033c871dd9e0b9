// SPDX-License-Identifier: MIT
#include "cli/context.hpp"

#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/registration/import_markers.hpp"
#include "app/registration/register_scans.hpp"
#include "app/registration/registration_runs.hpp"
#include "core/base/text.hpp"

namespace planum::cli {

using nlohmann::ordered_json;
using store::OpenMode;

namespace {

struct Options {
    app::RegisterOptions run;
    std::string method = "auto";
    bool propose = false;
    std::string accept;
    std::string discard;
    std::vector<std::string> compare;
};

void print_scan(const Context& context, const app::ReportedScan& scan) {
    std::ostream& out = *context.out;
    if (!scan.site_from_scan) {
        out << fmt::format("{:<24} {}\n", scan.scan, scan.verdict);
        return;
    }
    const std::string overlap = scan.links > 0 ? fmt::format(", overlap {:.0f} %", scan.overlap * 100.0) : "";
    out << fmt::format("{:<24} {}, position within {:.1f} mm, direction within {:.3f} degrees{}\n", scan.scan,
                       scan.verdict, scan.sigma_position * 1e3, scan.sigma_rotation_deg, overlap);
    if (!context.verbose) return;
    for (const auto& marker : scan.markers) {
        out << fmt::format("    marker {:<6} {:6.1f} mm{}\n", marker.name, marker.residual * 1e3,
                           marker.is_used ? "" : "  left out: " + marker.reason);
    }
}

void print_link(const Context& context, const app::ReportedLink& link) {
    *context.out << fmt::format("  {} - {}: {}, rms {:.1f} mm, overlap {:.0f} %, {}, ground: {} "
                                "stable, {} changed, {} shifted; "
                                "{:.1f} → {:.1f} σ, {}\n",
                                link.from, link.to, link.is_accepted ? "used" : "not used", link.rms * 1e3,
                                link.overlap * 100.0, text::counted(link.inliers, "feature"),
                                text::counted(link.stable_patches, "piece"), link.changed_patches, link.shifted_patches,
                                link.error_before, link.error_after, link.verdict);
}

void print_report(const Context& context, const app::RegistrationReport& report) {
    if (context.json) return context.print(app::to_json(report));
    std::size_t placed = 0;
    for (const auto& scan : report.scans) {
        print_scan(context, scan);
        placed += scan.site_from_scan ? 1U : 0U;
    }
    if (context.verbose) {
        for (const auto& link : report.links) print_link(context, link);
    }
    if (!report.run.empty()) {
        *context.out << fmt::format("run {} ({}): {} of {} placed, {} tried, {}\n", report.run, report.state, placed,
                                    text::counted(report.scans.size(), "scan"),
                                    text::counted(report.pairs_tried, "pair"),
                                    text::counted(report.links.size(), "link"));
    }
    for (const auto& note : report.notes) *context.out << note << '\n';
}

void print_state(const Context& context, const app::RegistrationReport& report) {
    if (context.json) return context.print(app::to_json(report));
    *context.out << fmt::format("run {} is {}; planum scan list shows where the scans are now\n", report.run,
                                report.state);
}

void print_comparison(const Context& context, const app::RunComparison& comparison) {
    if (context.json) {
        ordered_json scans = ordered_json::array();
        for (const auto& scan : comparison.scans) {
            const bool both = scan.in_first && scan.in_second;
            const auto known = [](bool is_known, double value) {
                return is_known ? ordered_json(value) : ordered_json(nullptr);
            };
            scans.push_back({{"scan", scan.scan},
                             {"shift_m", known(both, scan.shift)},
                             {"turn_deg", known(both, scan.turn_deg)},
                             {"sigma_first_m", known(scan.in_first, scan.sigma_first)},
                             {"sigma_second_m", known(scan.in_second, scan.sigma_second)}});
        }
        return context.print({{"first", comparison.first}, {"second", comparison.second}, {"scans", scans}});
    }
    for (const auto& scan : comparison.scans) {
        std::string what =
            fmt::format("moves {:.1f} mm, turns {:.3f} degrees (σ {:.1f} and {:.1f} mm)", scan.shift * 1e3,
                        scan.turn_deg, scan.sigma_first * 1e3, scan.sigma_second * 1e3);
        if (!scan.in_second) what = "only in run " + comparison.first;
        if (!scan.in_first) what = "only in run " + comparison.second;
        *context.out << fmt::format("{:<24} {}\n", scan.scan, what);
    }
}

void run_register(const Context& context, const Options& options) {
    if (!options.compare.empty()) {
        app::Project project = context.open(OpenMode::ReadOnly);
        return print_comparison(context, app::compare_runs(project, options.compare[0], options.compare[1]));
    }
    app::Project project = context.open(OpenMode::ReadWrite);
    if (!options.accept.empty()) return print_state(context, app::accept_run(project, options.accept));
    if (!options.discard.empty()) return print_state(context, app::discard_run(project, options.discard));
    app::RegisterOptions run = options.run;
    run.method = app::register_method_from_word(options.method).value_or(app::RegisterMethod::Auto);
    run.acceptance = options.propose ? app::Acceptance::Never : app::Acceptance::WhenGood;
    print_report(context, app::register_scans(project, run, *context.progress));
}

void run_markers(const Context& context, const std::string& file, bool update) {
    app::Project project = context.open(OpenMode::ReadWrite);
    const app::MarkerImport report = app::import_markers(project, file, {update});
    if (context.json) {
        return context.print({{"added", report.added},
                              {"updated", report.updated},
                              {"same", report.same},
                              {"conflicts", report.conflicts},
                              {"warnings", report.warnings}});
    }
    *context.out << fmt::format("{} added, {} updated, {} as before\n", text::counted(report.added, "marker"),
                                report.updated, report.same);
    for (const auto& line : report.conflicts) *context.out << line << '\n';
    for (const auto& line : report.warnings) *context.out << line << '\n';
}

} // namespace

void add_register_commands(CLI::App& root, Context& context) {
    auto options = std::make_shared<Options>();
    CLI::App* command = add_command(root, context, "register", "put scans on the site grid, and say how well");
    command->add_option("--day", options->run.day, "only the scans of this day, placed before or not");
    command->add_flag("--again", options->run.again, "place all scans anew, also those that have their place");
    command->add_option("--method", options->method, "auto, markers, features or icp (from where the files say)")
        ->capture_default_str()
        ->check(CLI::IsMember({"auto", "markers", "features", "icp"}));
    command->add_option("--origin", options->run.origin,
                        "scan whose own frame is the site grid, if there are no markers");
    command->add_flag("--propose", options->propose, "keep the result as a proposal even if it is good");
    command->add_option("--seed", options->run.seed, "of the random trials")->capture_default_str();
    CLI::Option* accept = command->add_option("--accept", options->accept, "put a run in force");
    CLI::Option* discard = command->add_option("--discard", options->discard, "take a run out of force");
    CLI::Option* compare = command->add_option("--compare", options->compare, "what differs between two runs");
    compare->expected(2);
    accept->excludes(discard)->excludes(compare);
    discard->excludes(compare);
    command->callback([&context, options] { run_register(context, *options); });

    CLI::App* markers = root.add_subcommand("markers", "markers: surveyed and measured in scans");
    markers->require_subcommand(1);
    auto file = std::make_shared<std::string>();
    auto update = std::make_shared<bool>(false);
    CLI::App* import =
        add_command(*markers, context, "import", "bring in markers: scan,marker,x,y,z; rows of site are the survey");
    import->add_option("FILE", *file, "CSV")->required();
    import->add_flag("--update", *update, "take the file's coordinates where they differ");
    import->callback([&context, file, update] { run_markers(context, *file, *update); });
}

} // namespace planum::cli
