// SPDX-License-Identifier: MIT
#include "cli/context.hpp"

#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "app/demo/record_demo.hpp"
#include "paint/font_measure.hpp"

namespace planum::cli {

namespace {

struct Options {
    std::string folder;
    std::uint64_t seed = 1;
    std::string size = "small";
};

void run_demo(const Context& context, const Options& options) {
    const paint::FontTextMeasure measure;
    const app::RecordDemo demo =
        app::make_record_demo(options.folder, options.seed, options.size, context.session(), measure, *context.progress);
    *context.out << fmt::format("a sample dig of {} units in {}\n", demo.units, options.folder);
    *context.out << fmt::format("  mistakes were put into the record; check found {} errors and {} warnings\n\n", demo.errors,
                                demo.warnings);
    *context.out << "look at these next:\n";
    for (const auto& file : demo.files) *context.out << "  " << file.string() << '\n';
    *context.out << fmt::format("  planum check {0}\n  planum today {0}\n", demo.project.string());
}

} // namespace

void add_demo_commands(CLI::App& root, Context& context) {
    auto options = std::make_shared<Options>();
    CLI::App* demo = add_command(root, context, "demo", "make a sample dig in a folder and run the whole job on it", false);
    demo->add_option("DIR", options->folder, "folder to make")->required();
    demo->add_option("--seed", options->seed, "the same seed gives the same dig")->capture_default_str();
    demo->add_option("--size", options->size, "small, medium or large")
        ->capture_default_str()
        ->check(CLI::IsMember({"small", "medium", "large"}));
    demo->callback([&context, options] { run_demo(context, *options); });
}

} // namespace planum::cli
