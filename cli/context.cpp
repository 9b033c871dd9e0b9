// SPDX-License-Identifier: MIT
#include "cli/context.hpp"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

namespace planum::cli {

app::Session Context::session() const {
    app::Session session;
    session.author = author;
    return session;
}

app::Project Context::open(store::OpenMode mode) const {
    app::Project project = app::Project::open(site, mode, session());
    for (const std::string& note : project.file().open_report().notes) say(note);
    return project;
}

void Context::say(std::string_view sentence) const {
    if (!quiet) *err << sentence << '\n';
}

void Context::print(const nlohmann::ordered_json& value) const {
    *out << value.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << '\n';
}

void add_common_flags(CLI::App& command, Context& context) {
    command.add_flag("--json", context.json, "print the result as JSON");
    command.add_flag("-q,--quiet", context.quiet, "no remarks, no progress");
    command.add_flag("-v,--verbose", context.verbose, "say more");
    command.add_option("--by", context.author, "who does this (default: $PLANUM_AUTHOR or the account)");
}

CLI::App* add_command(CLI::App& parent, Context& context, const std::string& name, const std::string& help,
                      bool with_site) {
    CLI::App* command = parent.add_subcommand(name, help);
    if (with_site) command->add_option("SITE", context.site, "the project file (NAME.gpkg)")->required();
    add_common_flags(*command, context);
    return command;
}

} // namespace planum::cli
