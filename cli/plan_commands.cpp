// SPDX-License-Identifier: MIT
#include "cli/context.hpp"

#include <array>
#include <filesystem>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/surfaces/plan_sheet.hpp"
#include "app/surfaces/section_sheet.hpp"
#include "core/base/error.hpp"
#include "core/base/file.hpp"
#include "core/base/text.hpp"
#include "paint/map_sheet_painter.hpp"

namespace planum::cli {

using nlohmann::ordered_json;

namespace {

struct Options {
    app::PlanRequest plan;
    app::SectionRequest section;
    std::string from;
    std::string to;
    std::string file;
    std::string scale = "1:20";
    double dpi = 200.0;
};

// `1:20`, `1 : 20` or `20`.
double parse_scale(std::string_view text) {
    std::string_view number = text::trim(text);
    if (const std::size_t colon = number.find(':'); colon != std::string_view::npos) {
        if (text::trim(number.substr(0, colon)) != "1")
            throw Error(ErrorCode::Usage, fmt::format("“{}” is no scale; write it as 1:20", text));
        number = text::trim(number.substr(colon + 1));
    }
    const auto value = text::parse_double(number);
    if (!value || !(*value >= 0.1 && *value <= 1e5))
        throw Error(ErrorCode::Usage, fmt::format("“{}” is no scale; write it as 1:20", text));
    return *value;
}

// Returns the scale, 1 : what it says.
double write_sheet(const Context& context, const geometry::MapSheet& sheet, const Options& options) {
    paint::MapSheetOptions how;
    how.scale = options.scale.empty() ? paint::section_scale(sheet) : parse_scale(options.scale);
    how.dpi = options.dpi;
    const std::filesystem::path file(options.file);
    const std::string ending = text::fold_case(file.extension().string());
    if (ending == ".png") {
        write_file_atomically(file, paint::render_map_png(sheet, how));
    } else if (ending == ".pdf") {
        write_file_atomically(file, paint::render_map_pdf(sheet, how, *context.progress));
    } else {
        throw Error(ErrorCode::Usage, fmt::format("{}: plans and sections are written as .png or .pdf", options.file));
    }
    return how.scale;
}

void run_plan(const Context& context, const Options& options) {
    app::Project project = context.open(store::OpenMode::ReadOnly);
    const app::PlanSheet made = app::plan_sheet(project, options.plan, *context.progress);
    const double scale = write_sheet(context, made.sheet, options);
    const geometry::Extent& extent = made.sheet.extent;
    if (context.json) {
        return context.print({{"file", options.file},
                              {"surface", made.surface.empty() ? ordered_json(nullptr) : ordered_json(made.surface)},
                              {"scale", scale},
                              {"west", extent.low[0]},
                              {"south", extent.low[1]},
                              {"east", extent.high[0]},
                              {"north", extent.high[1]},
                              {"units", made.units},
                              {"notes", made.notes}});
    }
    *context.out << fmt::format("{}: {:.1f} x {:.1f} m at 1:{:g}, {}\n", options.file, extent.high[0] - extent.low[0],
                                extent.high[1] - extent.low[1], parse_scale(options.scale),
                                text::counted(made.units.size(), "unit"));
    for (const std::string& note : made.notes) context.say(note);
}

// `X,Y` in site coordinates.
std::array<double, 2> parse_place(std::string_view text) {
    const auto parts = text::split(text, ',');
    if (parts.size() == 2) {
        const auto x = text::parse_double(text::trim(parts[0]));
        const auto y = text::parse_double(text::trim(parts[1]));
        if (x && y) return {*x, *y};
    }
    throw Error(ErrorCode::Usage, fmt::format("“{}” is no place; write it as X,Y in site coordinates", text));
}

void run_section(const Context& context, Options& options) {
    app::Project project = context.open(store::OpenMode::ReadOnly);
    options.section.from = parse_place(options.from);
    options.section.to = parse_place(options.to);
    options.section.surface = options.plan.surface;
    options.section.cell = options.plan.cell;
    options.section.surfaces_apart = true;
    const app::SectionSheet made = app::section_sheet(project, options.section, *context.progress);
    const double scale = write_sheet(context, made.sheet, options);
    const geometry::Extent& extent = made.sheet.extent;
    if (context.json) {
        return context.print({{"file", options.file},
                              {"scale", scale},
                              {"length_m", extent.high[0]},
                              {"z_min", extent.low[1]},
                              {"z_max", extent.high[1]},
                              {"points", made.points},
                              {"units", made.units}});
    }
    *context.out << fmt::format("{}: {:.1f} m long, {:.1f} to {:.1f} m high, at 1:{:g}, {}, {}\n", options.file,
                                extent.high[0], extent.low[1], extent.high[1], scale,
                                text::counted(made.points, "point"), text::counted(made.outlines, "outline"));
}

void add_paper(CLI::App& command, Options& options, const std::string& scale_words) {
    command.add_option("-o,--output", options.file, "F.png or F.pdf")->required();
    command.add_option("--scale", options.scale, scale_words);
    command.add_option("--dpi", options.dpi, "of a PNG")->check(CLI::Range(20.0, 1200.0))->capture_default_str();
    command.add_option("--cell", options.plan.cell, "of the picture under the outlines, in metres")
        ->check(CLI::Range(0.002, 10.0))
        ->capture_default_str();
}

} // namespace

void add_plan_commands(CLI::App& root, Context& context) {
    auto options = std::make_shared<Options>();
    CLI::App* plan =
        add_command(root, context, "plan", "draw a surface with its outlines, numbers and levels to scale");
    plan->add_option("--surface", options->plan.surface, "name, DAY or AREA::NAME (default: the last one)");
    plan->add_option("--over", options->plan.over, "a unit: its outlines on successive surfaces, one over the other");
    plan->add_flag("--colour", options->plan.colour, "scan colour (or reflectance) in place of the shaded relief");
    add_paper(*plan, *options, "1:20, 1:50, … (default: 1:20)");
    plan->callback([&context, options] { run_plan(context, *options); });
    auto given = std::make_shared<Options>();
    CLI::App* section = add_command(root, context, "section", "draw what scans and outlines show in a vertical plane");
    section->add_option("--from", given->from, "left end: X,Y in site coordinates")->required();
    section->add_option("--to", given->to, "right end")->required();
    section->add_option("--surface", given->plan.surface,
                        "only its scans, as one picture (default: all scans, each surface in a tone)");
    section->add_option("--depth", given->section.depth, "points so far from the plane are shown, in metres")
        ->check(CLI::Range(0.005, 5.0))
        ->capture_default_str();
    given->scale.clear();
    add_paper(*section, *given, "1:20, 1:50, … (default: the largest of 1:5, 1:10 and 1:20 that fits A4)");
    section->callback([&context, given] { run_section(context, *given); });
}

} // namespace planum::cli
