// SPDX-License-Identifier: MIT
#include "cli/context.hpp"

#include <algorithm>
#include <exception>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <unistd.h>

#include "cli/terminal_progress.hpp"
#include "core/base/error.hpp"
#include "core/base/text.hpp"

namespace planum::cli {

namespace {

constexpr const char* kDay = R"(A day with Planum:
  planum new site.gpkg                        a project file, once
  planum import site.gpkg units.csv           the list of units, every day anew
  planum check site.gpkg                      what contradicts what, and which statement to suspect
  planum today site.gpkg                      what to do next
  planum matrix site.gpkg -o matrix.svg       the Harris matrix (svg, pdf, png, dot, graphml, …)
  planum report site.gpkg -o report.xml       the record for the archive

)";
constexpr const char* kExitStatus =
    "Exit status: 0 fine, 1 check found undecided errors, 2 usage, 3 bad input, 4 disk, 70 our fault.";

void fill(CLI::App& root, Context& context) {
    root.description("Planum keeps the stratigraphy of a dig, says what contradicts what and why, and draws it.");
    root.set_version_flag("--version", "planum " PLANUM_VERSION);
    root.require_subcommand(1);
    root.footer(kExitStatus); // of every command; the day stands in the first help only
    root.get_formatter()->column_width(34);
    add_project_commands(root, context);
    add_import_commands(root, context);
    add_record_commands(root, context);
    add_region_commands(root, context);
    add_find_commands(root, context);
    add_survey_commands(root, context);
    add_interpretation_commands(root, context);
    add_check_commands(root, context);
    add_matrix_commands(root, context);
    add_report_commands(root, context);
    add_scan_commands(root, context);
    add_scan_details_commands(root, context);
    add_panorama_commands(root, context);
    add_surface_commands(root, context);
    add_plan_commands(root, context);
    add_register_commands(root, context);
    add_suggest_commands(root, context);
    add_demo_commands(root, context);
    root.footer(std::string(kDay) + kExitStatus); // last: commands added after it would take it over
}

// CLI11 only says that a command is missing; a mistyped one deserves better.
void refuse_unknown_command(const CLI::App& root, const std::vector<std::string>& arguments) {
    if (arguments.empty() || arguments.front().empty() || arguments.front().front() == '-') return;
    std::vector<std::string> names;
    for (const CLI::App* command : root.get_subcommands([](const CLI::App*) { return true; })) {
        if (command->get_name() == arguments.front()) return;
        names.push_back(command->get_name());
    }
    throw Error(ErrorCode::Usage,
                fmt::format("there is no command {}; there are {}", arguments.front(), text::join(names, ", ")));
}

int report(const Error& e, std::ostream& err) {
    err << "planum: " << e.what() << '\n';
    return exit_status(e.code());
}

} // namespace

int run_command_line(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& err) {
    Context context;
    context.out = &out;
    context.err = &err;
    TerminalProgress progress(err, isatty(STDERR_FILENO) == 1, stop_on_interrupt().get_token());
    context.progress = &progress;
    CLI::App root;
    try {
        fill(root, context);
        refuse_unknown_command(root, arguments);
        std::vector<std::string> reversed(arguments.rbegin(), arguments.rend()); // as CLI11 2.1 wants them
        root.parse(std::move(reversed));
        return context.status;
    } catch (const CLI::ParseError& e) {
        const int code = root.exit(e, out, err);
        return code == 0 ? 0 : exit_status(ErrorCode::Usage);
    } catch (const Error& e) {
        return report(e, err);
    } catch (const std::exception& e) {
        err << "planum: internal error: " << e.what() << "; please report it with the command you gave\n";
        return exit_status(ErrorCode::Internal);
    }
}

} // namespace planum::cli
