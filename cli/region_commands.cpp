// SPDX-License-Identifier: MIT
#include "cli/context.hpp"

#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/regions/ready_patches.hpp"
#include "app/regions/region_import.hpp"
#include "app/regions/region_list.hpp"
#include "app/regions/region_names.hpp"
#include "app/regions/region_ply.hpp"
#include "core/base/file.hpp"
#include "core/base/text.hpp"
#include "core/geometry/polygon_overlay.hpp"

namespace planum::cli {

using nlohmann::ordered_json;

namespace {

struct ImportArguments {
    std::vector<std::string> files;
    app::RegionImportOptions options;
};

ordered_json notes_json(const std::vector<app::OutlineNote>& notes) {
    ordered_json json = ordered_json::array();
    for (const auto& note : notes) json.push_back({{"where", note.where}, {"message", note.message}});
    return json;
}

ordered_json to_json(const app::RegionImportReport& report) {
    ordered_json json;
    json["new"] = report.fresh;
    json["redrawn"] = report.redrawn;
    json["named"] = report.named;
    json["same"] = report.same;
    json["units"] = report.units;
    json["areas"] = report.areas;
    json["surfaces"] = report.surfaces;
    json["sections"] = report.sections;
    json["unknown"] = ordered_json::array();
    for (const auto& unknown : report.unknown) {
        json["unknown"].push_back(
            {{"where", unknown.where}, {"region", unknown.region}, {"drawn", unknown.drawn}, {"near", unknown.near}});
    }
    json["overlaps"] = ordered_json::array();
    for (const auto& overlap : report.overlaps) {
        json["overlaps"].push_back(
            {{"surface", overlap.surface}, {"regions", {overlap.first, overlap.second}}, {"area_m2", overlap.area}});
    }
    json["refused"] = notes_json(report.refused);
    json["repaired"] = notes_json(report.repaired);
    json["conflicts"] = notes_json(report.conflicts);
    json["notes"] = notes_json(report.notes);
    json["changed"] = report.changed;
    return json;
}

void print_notes(const Context& context, const char* what, const std::vector<app::OutlineNote>& notes) {
    for (const auto& note : notes) {
        *context.out << fmt::format("{}{}{}: {}\n", what, note.where.empty() ? "" : ", ", note.where, note.message);
    }
}

void print_names(const Context& context, const char* what, const std::vector<std::string>& names) {
    if (!names.empty()) *context.out << fmt::format("{}: {}\n", what, text::join(names, ", "));
}

void print_text(const Context& context, const app::RegionImportReport& report, bool dry_run) {
    *context.out << fmt::format("{}: {}; {} redrawn, {} named, {} as they were\n", dry_run ? "would be new" : "new",
                                text::counted(report.fresh.size(), "region"), report.redrawn.size(),
                                report.named.size(), report.same);
    print_names(context, "areas made", report.areas);
    print_names(context, "surfaces made", report.surfaces);
    print_names(context, "sections made", report.sections);
    print_names(context, "units made", report.units);
    for (const auto& unknown : report.unknown) {
        const std::string near = unknown.near.empty() ? "" : "; near it: " + text::join(unknown.near, ", ");
        *context.out << fmt::format("{}: no unit {}{}; kept as region {} without unit\n", unknown.where, unknown.drawn,
                                    near, unknown.region);
    }
    for (const auto& overlap : report.overlaps) {
        *context.out << fmt::format("overlap on {}: {} and {} both claim {:.2f} m²; neither gets it\n", overlap.surface,
                                    overlap.first, overlap.second, overlap.area);
    }
    print_notes(context, "not taken", report.refused);
    print_notes(context, "mended", report.repaired);
    print_notes(context, "kept", report.conflicts);
    print_notes(context, "note", report.notes);
    if (!report.changed) *context.out << "nothing new: the project is as it was\n";
}

void run_import(const Context& context, const ImportArguments& arguments) {
    const auto mode = arguments.options.dry_run ? store::OpenMode::ReadOnly : store::OpenMode::ReadWrite;
    app::Project project = context.open(mode);
    const app::RegionImportReport report = app::import_outline_files(
        project, {arguments.files.begin(), arguments.files.end()}, arguments.options, *context.progress);
    if (context.json) return context.print(to_json(report));
    print_text(context, report, arguments.options.dry_run);
}

ordered_json height_json(const std::optional<double>& z) { return z ? ordered_json(*z) : ordered_json(nullptr); }

void run_list(const Context& context, const std::string& day) {
    app::Project project = context.open(store::OpenMode::ReadOnly);
    const app::RegionList regions = app::list_regions(project, day, *context.progress);
    if (context.json) {
        ordered_json list = ordered_json::array();
        for (const app::RegionRow& row : regions.rows) {
            list.push_back({{"region", row.region},
                            {"unit", row.unit.empty() ? ordered_json(nullptr) : ordered_json(row.unit)},
                            {"day", row.day},
                            {"shows", row.shows},
                            {"category", row.category},
                            {"area_m2", row.area},
                            {"drawn_m2", row.drawn_area},
                            {"points", row.points},
                            {"z_min", height_json(row.z_min)},
                            {"z_median", height_json(row.z_median)},
                            {"z_max", height_json(row.z_max)}});
            if (!row.drawn.empty()) {
                list.back()["drawn"] = row.drawn;
                list.back()["near"] = row.near;
            }
            if (row.outside_scans) list.back()["outside_scans"] = true;
            if (row.incomplete) list.back()["incomplete"] = true;
        }
        ordered_json problems = ordered_json::array();
        for (const auto& problem : regions.problems) {
            problems.push_back({{"where", problem.where}, {"what", problem.what}});
        }
        return context.print({{"regions", list}, {"problems", problems}});
    }
    for (const app::RegionRow& row : regions.rows) {
        std::string line = fmt::format("{:<24} {:<8} {:>8.2f} m²", row.region, row.shows, row.area);
        if (row.points > 0) line += "  " + text::counted(row.points, "point");
        if (row.z_min) line += fmt::format("  {:.2f} … {:.2f} m", *row.z_min, *row.z_max);
        if (!row.drawn.empty()) {
            line += fmt::format("  no unit {}{}", row.drawn,
                                row.near.empty() ? "" : "; near it: " + text::join(row.near, ", "));
        }
        if (row.outside_scans) line += "  outside all scans of its day";
        if (row.incomplete) line += "  without the scans that cannot be read";
        *context.out << line << '\n';
    }
    for (const auto& problem : regions.problems) context.say("not counted: " + problem.what);
}

struct PatchArguments {
    app::PatchQuery query;
    std::string output;
};

void run_patches(const Context& context, const PatchArguments& arguments) {
    app::Project project = context.open(store::OpenMode::ReadOnly);
    const app::ReadyPatches found = app::ready_patches(project, arguments.query, *context.progress);
    if (!arguments.output.empty()) {
        write_file_atomically(arguments.output, app::patches_geojson(project.record(), found));
    }
    ordered_json list = ordered_json::array();
    for (const app::ReadyPatch& patch : found.patches) {
        const auto [x, y] = geometry::inner_place(patch.shape);
        list.push_back({{"surface", patch.surface},
                        {"unit", patch.proposed.empty() ? ordered_json(nullptr) : ordered_json(patch.proposed)},
                        {"was", patch.was.empty() ? ordered_json(nullptr) : ordered_json(patch.was)},
                        {"area_m2", patch.area},
                        {"change_m", patch.change},
                        {"x", x},
                        {"y", y},
                        {"because", patch.because}});
        if (context.json) continue;
        *context.out << fmt::format("{}  {:>7.2f} m²  {:+.2f} m  at {:.2f} {:.2f}  {}\n    {}\n", patch.surface,
                                    patch.area, patch.change, x, y, patch.proposed.empty() ? "?" : patch.proposed,
                                    patch.because);
    }
    if (context.json) return context.print({{"patches", list}, {"outside", found.outside}, {"notes", found.notes}});
    if (found.patches.empty()) *context.out << "all ground that changed is outlined\n";
    if (found.outside > 0) {
        context.say(fmt::format("{} more outside all outlines: heaps, paths, or the trench grew", found.outside));
    }
    for (const std::string& note : found.notes) context.say(note);
    if (!arguments.output.empty() && found.patches.empty()) {
        context.say("wrote " + arguments.output + " without outlines");
    } else if (!arguments.output.empty()) {
        context.say(fmt::format("wrote {} to {}; after a look, planum region import takes {}",
                                text::counted(found.patches.size(), "patch", "patches"), arguments.output,
                                found.patches.size() == 1 ? "it" : "them"));
    }
}

} // namespace

void add_region_commands(CLI::App& root, Context& context) {
    CLI::App* group = root.get_subcommand("region");
    auto arguments = std::make_shared<ImportArguments>();
    CLI::App* import =
        add_command(*group, context, "import", "take outlines in: GeoJSON, or pixel polygons of panoramas");
    import
        ->add_option("FILE", arguments->files,
                     "GeoJSON in site coordinates, or JSON of pixel polygons; several at once")
        ->required();
    import->add_flag("--create-units", arguments->options.create_units, "make the units that the project has not yet");
    import->add_flag("--update", arguments->options.update, "redrawn outlines replace those of the project");
    import->add_flag("--dry-run", arguments->options.dry_run, "say what would be new; write nothing");
    import->add_option("--area", arguments->options.area, "area of outlines that name none");
    import->add_option("--day", arguments->options.day, "day of outlines that name neither day nor surface");
    import->callback([&context, arguments] { run_import(context, *arguments); });

    struct Points {
        std::string region;
        std::string file;
    };

    auto points = std::make_shared<Points>();
    CLI::App* cut_out =
        add_command(*group, context, "points", "write the points of one region as PLY, site coordinates");
    cut_out->add_option("REGION", points->region, "SURFACE/UNIT#n")->required();
    cut_out->add_option("-o,--output", points->file, "the PLY file")->required();
    cut_out->callback([&context, points] {
        app::Project project = context.open(store::OpenMode::ReadOnly);
        const model::Region region = app::region_named(project, points->region);
        const auto count = app::write_region_points(project, region, points->file, *context.progress);
        if (context.json) return context.print({{"region", points->region}, {"file", points->file}, {"points", count}});
        context.say(fmt::format("wrote {} to {}", text::counted(count, "point"), points->file));
    });
    auto patches = std::make_shared<PatchArguments>();
    CLI::App* ready = add_command(*group, context, "patches",
                                  "ground that changed and is not outlined yet, each with the unit it may be");
    ready->add_option("SURFACE", patches->query.surface, "default: the last of each area");
    ready->add_flag("--all", patches->query.all, "all surfaces");
    ready
        ->add_option("--cell", patches->query.cell,
                     "side of a cell in metres (default: 2, 4 or 8 cm, as dense as the scans are)")
        ->check(CLI::Range(0.005, 1.0));
    ready->add_option("--least-area", patches->query.least_area, "smaller patches are left out, square metres")
        ->check(CLI::Range(0.0, 1000.0))
        ->capture_default_str();
    ready->add_option("-o,--output", patches->output, "their outlines as GeoJSON, for planum region import");
    ready->callback([&context, patches] { run_patches(context, *patches); });

    auto day = std::make_shared<std::string>();
    CLI::App* list = add_command(*group, context, "list", "all regions with area and heights");
    list->add_option("--day", *day, "of one day only");
    list->callback([&context, day] { run_list(context, *day); });
}

} // namespace planum::cli
