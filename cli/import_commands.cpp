// SPDX-License-Identifier: MIT
#include "cli/context.hpp"

#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/import/import_service.hpp"
#include "core/base/text.hpp"

namespace planum::cli {

using nlohmann::ordered_json;

namespace {

struct Options {
    std::vector<std::string> files;
    std::string numbers;
    app::ImportOptions import;
};

ordered_json to_json(const app::ImportReport& report) {
    ordered_json json;
    json["readings"] = ordered_json::array();
    for (const auto& reading : report.readings) {
        json["readings"].push_back(
            {{"format", reading.format}, {"title", reading.title}, {"files", reading.files}, {"note", reading.note}});
    }
    json["new"] = {{"units", report.new_units},
                   {"mentioned_units", report.mentioned_units},
                   {"relations", report.new_relations},
                   {"statements", report.new_statements},
                   {"others", report.new_others}};
    json["filled_units"] = report.filled_units;
    json["changed"] = report.changed;
    json["conflicts"] = ordered_json::array();
    for (const auto& c : report.conflicts) {
        json["conflicts"].push_back(
            {{"what", c.what}, {"field", c.field}, {"kept", c.kept}, {"offered", c.offered}, {"replaced", c.replaced}});
    }
    json["warnings"] = report.warnings;
    json["notes"] = ordered_json::array();
    for (const auto& n : report.notes) {
        json["notes"].push_back(
            {{"file", n.file}, {"line", n.line}, {"code", n.code}, {"raw", n.raw_text}, {"message", n.message}});
    }
    return json;
}

void print_notes(const Context& context, const app::ImportReport& report) {
    constexpr std::size_t kShown = 20;
    std::size_t shown = 0;
    for (const auto& note : report.notes) {
        if (!context.verbose && shown == kShown) {
            *context.out << fmt::format("  … and {} more; --verbose shows all, planum check keeps them\n",
                                        report.notes.size() - kShown);
            break;
        }
        const std::string line = note.line > 0 ? fmt::format(":{}", note.line) : "";
        *context.out << fmt::format("  {}{}: {}\n", note.file, line, note.message);
        ++shown;
    }
}

void print_text(const Context& context, const app::ImportReport& report, bool dry_run) {
    for (const auto& reading : report.readings) {
        *context.out << fmt::format("read {} as {}\n", text::join(reading.files, ", "), reading.title);
        if (!reading.note.empty()) *context.out << "  " << reading.note << '\n';
    }
    *context.out << fmt::format("{}: {} ({} only mentioned), {}, {}, {}; {} filled\n", dry_run ? "would be new" : "new",
                                text::counted(report.new_units, "unit"), report.mentioned_units,
                                text::counted(report.new_relations, "relation"),
                                text::counted(report.new_statements, "statement"),
                                text::counted(report.new_others, "other"), text::counted(report.filled_units, "unit"));
    if (!report.changed) *context.out << "nothing new: the project is as it was\n";
    for (const std::string& warning : report.warnings) *context.out << "warning: " << warning << '\n';
    for (const auto& c : report.conflicts) {
        *context.out << fmt::format("{}, {}: {} {} (file: {})\n", c.what, c.field, c.replaced ? "replaced" : "kept",
                                    c.kept, c.offered);
    }
    if (!report.notes.empty()) {
        *context.out << fmt::format("not understood or mended, {}:\n", report.notes.size());
        print_notes(context, report);
    }
}

void run_import(const Context& context, Options& options) {
    if (!options.numbers.empty()) options.import.numbers = model::number_scope_from_word(options.numbers);
    const auto mode = options.import.dry_run ? store::OpenMode::ReadOnly : store::OpenMode::ReadWrite;
    app::Project project = context.open(mode);
    const std::vector<std::filesystem::path> files(options.files.begin(), options.files.end());
    const app::ImportReport report = app::import_files(project, files, options.import, *context.progress);
    if (context.json) return context.print(to_json(report));
    print_text(context, report, options.import.dry_run);
}

} // namespace

void add_import_commands(CLI::App& root, Context& context) {
    auto options = std::make_shared<Options>();
    CLI::App* command = add_command(root, context, "import", "read records of units and relations and merge them");
    command->add_option("FILE", options->files, "files of one or several formats, or folders; in any order")
        ->required();
    command->add_option("--format", options->import.format, "read all files as this format (default: by content)");
    command->add_option("--numbers", options->numbers, "unit numbers are unique per site or per area")
        ->check(CLI::IsMember({"site", "area"}));
    command->add_option("--area", options->import.area, "area of units in files that name none");
    command->add_option("--site", options->import.site,
                        "of several sites in one file the one to read (default: that with most units; * for all)");
    command->add_flag("--update", options->import.update, "values of the files replace differing ones of the project");
    command->add_flag("--dry-run", options->import.dry_run, "say what is new, changed and conflicting; write nothing");
    command->callback([&context, options] { run_import(context, *options); });
}

} // namespace planum::cli
