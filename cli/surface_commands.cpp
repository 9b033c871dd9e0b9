// SPDX-License-Identifier: MIT
#include "cli/context.hpp"

#include <cmath>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/surfaces/dug_earth.hpp"
#include "app/surfaces/surface_reports.hpp"
#include "core/base/error.hpp"
#include "core/base/text.hpp"

namespace planum::cli {

using nlohmann::ordered_json;
using store::OpenMode;

namespace {

struct Arguments {
    std::string surface;
    std::string since;
    std::string output;
    std::string area;
    double cell = 0.02;
    bool volumes = false;
};

ordered_json to_json(const app::Earth& earth) {
    return {{"net_m3", earth.net}, {"bound_m3", earth.bound}, {"area_m2", earth.area}};
}

ordered_json to_json(const std::vector<app::EarthOfUnit>& units) {
    ordered_json list = ordered_json::array();
    for (const app::EarthOfUnit& one : units) {
        ordered_json row = {{"unit", one.is_unit ? ordered_json(one.unit) : ordered_json(nullptr)}};
        if (!one.is_unit) row["other"] = one.unit.empty() ? "outside all outlines" : one.unit;
        row.update(to_json(one.earth));
        list.push_back(std::move(row));
    }
    return list;
}

ordered_json to_json(const app::EarthStep& step) {
    ordered_json json = {{"before", step.before}, {"after", step.after}};
    json.update(to_json(step.total));
    json.update(ordered_json{{"gone_m3", step.gone},
                             {"added_m3", step.added},
                             {"overhung_m3", step.overhung},
                             {"filled_area_m2", step.filled},
                             {"unseen_area_m2", step.unseen},
                             {"units", to_json(step.units)}});
    return json;
}

ordered_json to_json(const app::HeightsReport& made) {
    ordered_json disputed = ordered_json::array();
    for (const app::DisputeReport& patch : made.disputed) {
        disputed.push_back({{"x", patch.x},
                            {"y", patch.y},
                            {"area_m2", patch.area},
                            {"difference_m", patch.difference},
                            {"higher", patch.higher},
                            {"lower", patch.lower}});
    }
    return {{"surface", made.surface},
            {"scans", made.scans},
            {"raw", made.raw},
            {"points", made.points},
            {"area_m2", made.area},
            {"face_area_m2", made.face_area},
            {"z_min", made.area > 0.0 ? ordered_json(made.lowest) : ordered_json(nullptr)},
            {"z_max", made.area > 0.0 ? ordered_json(made.highest) : ordered_json(nullptr)},
            {"disputed", disputed}};
}

// What rounds to nothing is nothing, whatever its sign: "-0.000 m³" reads like a mistake.
double rounded(double cubic_metres) { return std::abs(cubic_metres) < 0.0005 ? 0.0 : cubic_metres; }

void print_units(const Context& context, const std::vector<app::EarthOfUnit>& units) {
    for (const app::EarthOfUnit& one : units) {
        const std::string name = one.unit.empty() ? "outside all outlines" : one.unit;
        *context.out << fmt::format("  {:<20} {:9.3f} m³  within {:.3f} m³\n", name, rounded(one.earth.net),
                                    one.earth.bound);
    }
}

void print_step(const Context& context, const app::EarthStep& step) {
    *context.out << fmt::format("{} to {}: {:.3f} m³ dug, within {:.3f} m³ (95 %), on {:.2f} m²", step.before,
                                step.after, rounded(step.total.net), step.total.bound, step.total.area);
    if (std::abs(step.overhung) >= 0.0005)
        *context.out << fmt::format(", {:.3f} m³ of it under overhangs, as far as their sides show", step.overhung);
    if (step.filled > 0.005)
        *context.out << fmt::format(", {:.2f} m² of them filled in, between points, in shadows and on sides",
                                    step.filled);
    *context.out << '\n';
    print_units(context, step.units);
    if (step.unseen > 0.005) {
        context.say(fmt::format("{} to {}: {:.2f} m² were not counted: no ground was seen near them", step.before,
                                step.after, step.unseen));
    }
}

void run_heights(const Context& context, const Arguments& arguments) {
    app::Project project = context.open(OpenMode::ReadOnly);
    const app::HeightsReport made =
        app::write_heights(project, arguments.surface, arguments.cell, arguments.output, *context.progress);
    if (context.json) return context.print(to_json(made));
    if (made.area > 0.0) {
        *context.out << fmt::format(
            "{}: {:.2f} m² of ground between {:.3f} and {:.3f} m, {:.2f} m² of sides, from {}\n", made.surface,
            made.area, made.lowest, made.highest, made.face_area, text::join(made.scans, ", "));
    } else {
        *context.out << fmt::format("{}: its scans show no ground here\n", made.surface);
    }
    for (const app::DisputeReport& patch : made.disputed) {
        *context.out << fmt::format(
            "at {:.2f} {:.2f}: {} lies {:.0f} mm above {} over {:.2f} m²; the ground changed between the two scans, or "
            "one is placed badly\n",
            patch.x, patch.y, patch.higher, 1000.0 * patch.difference, patch.lower, patch.area);
    }
    for (const std::string& scan : made.raw) context.say(scan + " is not registered and was left out");
}

void run_change(const Context& context, const Arguments& arguments) {
    app::Project project = context.open(OpenMode::ReadOnly);
    const app::ChangeReport change = app::write_change(project, arguments.since, arguments.surface, arguments.cell,
                                                       arguments.output, *context.progress);
    const app::EarthReport earth =
        app::dug_earth(project, {arguments.since, arguments.surface, {}, arguments.cell}, *context.progress);
    const app::EarthStep& step = earth.steps.at(0);
    if (context.json) {
        ordered_json json = to_json(step);
        json["compared_area_m2"] = change.compared_area;
        json["lowered_area_m2"] = change.lowered_area;
        json["raised_area_m2"] = change.raised_area;
        json["detectable_m"] = change.detectable;
        return context.print(json);
    }
    *context.out << fmt::format(
        "{} to {}: {:.2f} m² compared, {:.2f} m² lower and {:.2f} m² higher by more than can be told from none "
        "({:.0f} mm on half of it)\n",
        change.before, change.after, change.compared_area, change.lowered_area, change.raised_area,
        1000.0 * change.detectable);
    print_step(context, step);
}

void run_volumes(const Context& context, const Arguments& arguments) {
    app::Project project = context.open(OpenMode::ReadOnly);
    const app::EarthReport earth = app::dug_earth(project, {{}, {}, arguments.area, arguments.cell}, *context.progress);
    if (context.json) {
        ordered_json steps = ordered_json::array();
        for (const app::EarthStep& step : earth.steps) steps.push_back(to_json(step));
        ordered_json json = {{"steps", steps}, {"units", to_json(earth.units)}};
        json["total"] = to_json(earth.total);
        json["unseen"] = ordered_json::array();
        for (const app::PassedSurface& passed : earth.unseen) json["unseen"].push_back(passed.name);
        json["out_of_order"] = earth.out_of_order;
        return context.print(json);
    }
    for (const app::EarthStep& step : earth.steps) print_step(context, step);
    if (earth.steps.size() > 1) {
        *context.out << fmt::format("in total {:.3f} m³ dug, within {:.3f} m³ (95 %)\n", rounded(earth.total.net),
                                    earth.total.bound);
        print_units(context, earth.units);
    }
    for (const app::PassedSurface& passed : earth.unseen)
        context.say(fmt::format("{} was passed over: {}", passed.name, passed.why));
    for (const std::string& surface : earth.out_of_order)
        context.say(surface + " was passed over: its days and its place in the order of surfaces disagree; planum "
                              "check says with which");
    if (earth.steps.empty()) context.say("nothing to compare: it takes two surfaces with registered scans");
}

void run(const Context& context, const Arguments& arguments) {
    if (context.site.empty())
        throw Error(ErrorCode::Usage, "planum surface SITE SURFACE -o F.tif, or one of add, set, list, show, delete");
    if (arguments.volumes) {
        if (!arguments.surface.empty() || !arguments.output.empty())
            throw Error(ErrorCode::Usage, "--volumes lists all surfaces; for two of them: SURFACE --since BEFORE");
        return run_volumes(context, arguments);
    }
    if (arguments.surface.empty()) {
        throw Error(ErrorCode::Usage,
                    "which surface? planum surface SITE SURFACE -o F.tif; planum surface list SITE names all");
    }
    if (!arguments.since.empty()) return run_change(context, arguments);
    run_heights(context, arguments);
}

} // namespace

void add_surface_commands(CLI::App& root, Context& context) {
    CLI::App* group = root.get_subcommand("surface");
    group->description("heights, change and volumes from the scans; add, set, list, show or delete a surface");
    group->require_subcommand(0, 1);
    auto arguments = std::make_shared<Arguments>();
    group->add_option("SITE", context.site, "the project file (NAME.gpkg)");
    group->add_option("SURFACE", arguments->surface, "name, DAY or AREA::NAME");
    group->add_option("-o,--output", arguments->output,
                      "heights, or with --since their change: F.tif, F.tfw beside it");
    group->add_option("--since", arguments->since, "an earlier surface: what changed, and what was dug");
    group->add_flag("--volumes", arguments->volumes, "earth dug from surface to surface, by unit and in total");
    group->add_option("--area", arguments->area, "with --volumes: only this area");
    group->add_option("--cell", arguments->cell, "side of a cell in metres")
        ->check(CLI::Range(0.005, 10.0))
        ->capture_default_str();
    add_common_flags(*group, context);
    group->callback([group, &context, arguments] {
        if (group->get_subcommands().empty()) run(context, *arguments);
    });
}

} // namespace planum::cli
