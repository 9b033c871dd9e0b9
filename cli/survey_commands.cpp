// SPDX-License-Identifier: MIT
#include "cli/context.hpp"

#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/survey/survey_import.hpp"
#include "core/base/text.hpp"

namespace planum::cli {

using nlohmann::ordered_json;

namespace {

struct Arguments {
    std::vector<std::string> files;
    std::string codes;
    app::SurveyOptions options;
};

ordered_json to_json(const app::SurveyReport& report) {
    ordered_json json = {{"points", report.points},
                         {"new_levels", report.new_levels},
                         {"new_finds", report.new_finds},
                         {"changed_finds", report.changed_finds},
                         {"new_units", report.new_units},
                         {"other_codes", ordered_json::object()},
                         {"conflicts", ordered_json::array()},
                         {"notes", ordered_json::array()},
                         {"changed", report.changed}};
    for (const auto& [code, count] : report.other_codes) json["other_codes"][code] = count;
    for (const auto& c : report.conflicts) {
        json["conflicts"].push_back(
            {{"what", c.what}, {"field", c.field}, {"kept", c.kept}, {"offered", c.offered}, {"replaced", c.replaced}});
    }
    for (const auto& n : report.notes) {
        json["notes"].push_back(
            {{"file", n.file}, {"line", n.line}, {"code", n.code}, {"raw", n.raw_text}, {"message", n.message}});
    }
    return json;
}

void print_text(const Context& context, const app::SurveyReport& report, bool dry_run) {
    *context.out << fmt::format("{}; {}: {}, {}; {} changed\n", text::counted(report.points, "point"),
                                dry_run ? "would be new" : "new", text::counted(report.new_levels, "level"),
                                text::counted(report.new_finds, "find"), text::counted(report.changed_finds, "find"));
    if (!report.new_units.empty()) *context.out << "units made: " << text::join(report.new_units, ", ") << '\n';
    for (const auto& [code, count] : report.other_codes) {
        *context.out << fmt::format("left out, neither level nor find: {} with code {}\n",
                                    text::counted(count, "point"), code);
    }
    for (const auto& c : report.conflicts) {
        *context.out << fmt::format("{}, {}: {} {} (file: {})\n", c.what, c.field, c.replaced ? "replaced" : "kept",
                                    c.kept, c.offered);
    }
    for (const auto& n : report.notes) *context.out << fmt::format("{}:{}: {}\n", n.file, n.line, n.message);
    if (!report.changed) *context.out << "nothing new: the project is as it was\n";
}

} // namespace

void add_survey_commands(CLI::App& root, Context& context) {
    CLI::App* group = root.add_subcommand("survey", "levels and finds measured by a total station");
    group->require_subcommand(1);
    auto arguments = std::make_shared<Arguments>();
    CLI::App* import = add_command(*group, context, "import", "take levels and finds in from tables and DXF drawings");
    import->add_option("FILE", arguments->files, "CSV or text tables, DXF drawings")->required();
    import->add_option("--codes", arguments->codes, "table code,meaning (top, base, cut, other, find, ignore)");
    import->add_option("--columns", arguments->options.columns,
                       "of tables without headings (default name,x,y,z,code; also unit, find, text)");
    import->add_option("--area", arguments->options.area, "whose units are meant where several areas have a number");
    import->add_option("--day", arguments->options.day, "the finds were found on it");
    import->add_flag("--create-units", arguments->options.create_units, "make the units that the project has not yet");
    import->add_flag("--update", arguments->options.update, "values of the file replace differing ones of finds");
    import->add_flag("--dry-run", arguments->options.dry_run, "say what would be new; write nothing");
    import->callback([&context, arguments] {
        app::SurveyOptions options = arguments->options;
        options.codes = arguments->codes;
        app::Project project = context.open(options.dry_run ? store::OpenMode::ReadOnly : store::OpenMode::ReadWrite);
        const std::vector<std::filesystem::path> files(arguments->files.begin(), arguments->files.end());
        const app::SurveyReport report = app::import_survey(project, files, options);
        if (context.json) return context.print(to_json(report));
        print_text(context, report, options.dry_run);
    });
}

} // namespace planum::cli
