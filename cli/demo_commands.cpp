// SPDX-License-Identifier: MIT
#include "cli/context.hpp"

#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/demo/demo_job.hpp"
#include "core/base/text.hpp"
#include "paint/font_measure.hpp"

namespace planum::cli {

namespace {

struct Options {
    std::string folder;
    std::uint64_t seed = 1;
    std::string size = "small";
    std::string method = "stratigraphic";
};

app::demo::SimulationOptions simulation(const Options& options) {
    app::demo::SimulationOptions simulation;
    simulation.seed = options.seed;
    if (options.size == "medium") simulation.size = app::demo::DemoSize::Medium;
    if (options.size == "large") simulation.size = app::demo::DemoSize::Large;
    simulation.method = model::dig_method_from_word(options.method).value_or(model::DigMethod::Stratigraphic);
    return simulation;
}

void print_json(const Context& context, const app::DemoJob& job, const Options& options) {
    nlohmann::ordered_json files = nlohmann::ordered_json::array();
    for (const auto& file : job.drawings) files.push_back(file.string());
    context.print({{"folder", options.folder},
                   {"seed", options.seed},
                   {"size", options.size},
                   {"method", options.method},
                   {"project", job.project.string()},
                   {"units", job.units},
                   {"scans", job.scans},
                   {"points", job.points},
                   {"registered", job.registered},
                   {"regions", job.regions},
                   {"errors", job.errors},
                   {"warnings", job.warnings},
                   {"project_with_mistakes", job.mistaken_project.string()},
                   {"mistakes", job.mistakes},
                   {"errors_with_mistakes", job.errors_mistaken},
                   {"warnings_with_mistakes", job.warnings_mistaken},
                   {"drawings", files}});
}

void run_demo(const Context& context, const Options& options) {
    const paint::FontTextMeasure measure;
    const app::DemoJob job =
        app::run_demo_job(options.folder, simulation(options), context.session(), measure, *context.progress);
    if (context.json) return print_json(context, job, options);
    std::ostream& out = *context.out;
    out << fmt::format("a simulated dig in {}: {}, {} with {}, dug in the {} way\n", options.folder,
                       text::counted(job.units, "unit"), text::counted(job.scans, "scan"),
                       text::counted(job.points, "point"), options.method);
    out << fmt::format("  record/         its sheets; check says {}, {}\n", text::counted(job.errors, "error"),
                       text::counted(job.warnings, "warning"));
    out << fmt::format("  with-mistakes/  a copy with {}; check says {}, {}\n", text::counted(job.mistakes, "mistake"),
                       text::counted(job.errors_mistaken, "error"), text::counted(job.warnings_mistaken, "warning"));
    const std::string placed =
        job.registered > 0 ? fmt::format("; {} on the site grid", text::counted(job.registered, "is", "are")) : "";
    out << fmt::format("  DAY/*.ptx       the scans, markers.csv what was measured of the markers{}\n", placed);
    out << "  outlines/       what the draughtsman drew on each day\n"
           "  truth.json      what is true: poses, order, contacts, volumes, mistakes\n\n";
    out << "look at these next:\n";
    for (const auto& file : job.drawings) out << "  " << file.string() << '\n';
    if (job.registered == 0) out << fmt::format("  planum register {}   (takes minutes)\n", job.project.string());
    const std::string site = job.project.string();
    const std::string mistaken = job.mistaken_project.string();
    out << fmt::format("  planum check {0}\n  planum suggest {0}\n", mistaken);
    out << fmt::format("  planum today {0}\n  planum plan {0} -o plan.png\n  planum scan list {0}\n", site);
    out << fmt::format("  planum-desktop {}\n", site);
}

} // namespace

void add_demo_commands(CLI::App& root, Context& context) {
    auto options = std::make_shared<Options>();
    CLI::App* demo =
        add_command(root, context, "demo", "simulate a dig in a new folder and run the whole job on it", false);
    demo->add_option("DIR", options->folder, "folder to make")->required();
    demo->add_option("--seed", options->seed, "the same seed gives the same dig")->capture_default_str();
    demo->add_option("--size", options->size, "small (12 units, seconds), medium (40) or large (300, gigabytes)")
        ->capture_default_str()
        ->check(CLI::IsMember({"small", "medium", "large"}));
    demo->add_option("--method", options->method, "how it was dug: stratigraphic, planum (in levels) or mixed")
        ->capture_default_str()
        ->check(CLI::IsMember({"stratigraphic", "planum", "mixed"}));
    demo->callback([&context, options] { run_demo(context, *options); });
}

} // namespace planum::cli
