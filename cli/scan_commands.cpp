// SPDX-License-Identifier: MIT
#include "cli/context.hpp"

#include <algorithm>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/scans/add_scans.hpp"
#include "app/scans/list_scans.hpp"
#include "core/base/text.hpp"

namespace planum::cli {

using nlohmann::ordered_json;
using store::OpenMode;

namespace {

struct AddOptions {
    std::vector<std::string> files;
    app::AddScansOptions add;
};

ordered_json to_json(const app::AddScansReport& report) {
    ordered_json added = ordered_json::array();
    for (const app::AddedScan& one : report.added) {
        added.push_back({{"scan", one.scan.name},
                         {"day", one.scan.day},
                         {"file", one.scan.path},
                         {"format", one.scan.format},
                         {"points", one.scan.points},
                         {"rows", one.scan.rows},
                         {"columns", one.scan.columns},
                         {"notes", one.notes}});
    }
    ordered_json there = ordered_json::array();
    for (const app::ScanThere& one : report.there_already) {
        there.push_back({{"file", one.file},
                         {"scan", one.scan},
                         {"moved_from", one.moved.empty() ? ordered_json(nullptr) : ordered_json(one.moved)}});
    }
    return {{"added", added}, {"there_already", there}, {"left_aside", report.left_aside}};
}

void run_add(const Context& context, const AddOptions& options) {
    app::Project project = context.open(OpenMode::ReadWrite);
    const std::vector<std::filesystem::path> files(options.files.begin(), options.files.end());
    const app::AddScansReport report = app::add_scans(project, files, options.add, *context.progress);
    if (context.json) return context.print(to_json(report));
    std::ostream& out = *context.out;
    for (const app::AddedScan& one : report.added) {
        const std::string grid =
            one.scan.rows > 0 ? fmt::format(", grid {} x {}", one.scan.rows, one.scan.columns) : "";
        out << fmt::format("added {}: {}, {}{}\n", one.scan.name, one.scan.format,
                           text::counted(one.scan.points, "point"), grid);
        for (const std::string& note : one.notes) out << "  " << note << '\n';
    }
    for (const app::ScanThere& one : report.there_already) {
        out << fmt::format("{} is in the project already, as {}\n", one.file, one.scan);
        if (!one.moved.empty()) {
            out << fmt::format("its original was no longer at {}; it is looked for here from now on\n", one.moved);
        }
        if (options.add.columns.empty()) continue;
        out << fmt::format("to read its columns otherwise, take it out first: planum scan delete SITE {}\n", one.scan);
    }
    if (context.verbose) {
        for (const std::string& line : report.left_aside) out << line << '\n';
    }
    if (report.change == 0) out << "nothing new: the project is as it was\n";
}

ordered_json numbers_or_null(const app::ListedScan& scan) {
    if (scan.status != "registered") return nullptr;
    return scan.site_from_scan;
}

// Letters of UTF-8 text: bytes that begin one.
std::size_t letters(const std::string& name) {
    return static_cast<std::size_t>(std::count_if(
        name.begin(), name.end(), [](char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U; }));
}

void run_list(const Context& context) {
    app::Project project = context.open(OpenMode::ReadOnly);
    const std::vector<app::ListedScan> scans = app::list_scans(project);
    if (context.json) {
        ordered_json all = ordered_json::array();
        for (const app::ListedScan& scan : scans) {
            const bool placed = scan.status == "registered";
            const auto measured = [&](double value) { return placed ? ordered_json(value) : ordered_json(nullptr); };
            all.push_back({{"scan", scan.scan},
                           {"day", scan.day},
                           {"surface", scan.surface},
                           {"points", scan.points},
                           {"status", scan.status},
                           {"method", scan.method},
                           {"site_from_scan", numbers_or_null(scan)},
                           {"rms_m", measured(scan.rms)},
                           {"overlap", measured(scan.overlap)},
                           {"sigma_position_m", measured(scan.sigma_position)},
                           {"sigma_rotation_deg", measured(scan.sigma_rotation_deg)},
                           {"file", scan.file},
                           {"original_there", scan.original_there}});
        }
        return context.print({{"scans", all}});
    }
    std::size_t width = 28;
    for (const app::ListedScan& scan : scans) width = std::max(width, letters(scan.scan));
    for (const app::ListedScan& scan : scans) {
        std::string line = fmt::format("{:<{}} {:>12} points  {}", scan.scan, width, scan.points, scan.status);
        if (scan.status == "registered") {
            line += fmt::format(", rms {:5.1f} mm, position within {:5.1f} mm, turn within {:.3f} degrees",
                                scan.rms * 1e3, scan.sigma_position * 1e3, scan.sigma_rotation_deg);
        }
        if (!scan.verdict.empty() && context.verbose) line += " (" + scan.verdict + ")";
        if (!scan.original_there) line += ", original not found: " + scan.file;
        *context.out << line << '\n';
    }
    if (scans.empty()) context.say("no scans yet; planum scan add SITE FILE|FOLDER brings them in");
}

} // namespace

void add_scan_commands(CLI::App& root, Context& context) {
    CLI::App* scan = root.add_subcommand("scan", "scans: add files or folders, list them");
    scan->require_subcommand(1);
    auto options = std::make_shared<AddOptions>();
    CLI::App* add =
        add_command(*scan, context, "add", "add scan files, or all in a folder; the originals are only read");
    add->add_option("FILE", options->files, "PTX, E57, LAS, PLY, PCD, PTS, XYZ or 3DTK files, or folders")->required();
    add->add_option("--day", options->add.day, "day they were made (default: the folder named by its date)");
    add->add_option("--surface", options->add.surface, "surface they show (default: that of the day)");
    add->add_option("--area", options->add.area, "area whose surface it is (default: the only one)");
    add->add_option("--columns", options->add.columns,
                    "columns of XYZ and CSV, as x,y,z,-,intensity (default: guessed)");
    add->callback([&context, options] { run_add(context, *options); });

    CLI::App* list = add_command(*scan, context, "list", "list the scans and where they stand");
    list->callback([&context] { run_list(context); });

    auto name = std::make_shared<std::string>();
    CLI::App* remove = add_command(*scan, context, "delete", "take a scan out of the project; the original stays");
    remove->add_option("SCAN", *name, "DAY/STEM")->required();
    remove->callback([&context, name] {
        app::Project project = context.open(OpenMode::ReadWrite);
        app::delete_scan(project, *name);
        context.say("deleted scan " + *name + "; planum undo brings it back");
    });
}

} // namespace planum::cli
