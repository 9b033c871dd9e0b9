// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <ostream>
#include <string>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

#include "app/export/export_record.hpp"
#include "app/project/project.hpp"
#include "core/base/progress.hpp"

namespace CLI {
class App;
}

namespace planum::cli {

/// What every command shares: where it writes, and what the flags that all of them take say.
struct Context {
    std::ostream* out = nullptr; ///< results
    std::ostream* err = nullptr; ///< everything else
    bool json = false;
    bool quiet = false;
    bool verbose = false;
    std::string author;
    std::string site; ///< the project file, first argument of nearly every command
    int status = 0;   ///< what the program ends with when nothing was thrown
    Progress* progress = nullptr;

    [[nodiscard]] app::Session session() const;
    /// Opens `site`; says on `err` what opening did to it.
    [[nodiscard]] app::Project open(store::OpenMode mode) const;
    /// A remark for people, unless --quiet.
    void say(std::string_view sentence) const;
    void print(const nlohmann::ordered_json& value) const;
};

/// The flags that all commands share.
void add_common_flags(CLI::App& command, Context& context);

/// Adds a command with the flags that all share, and SITE as first argument where `with_site`.
CLI::App* add_command(CLI::App& parent, Context& context, const std::string& name, const std::string& help,
                      bool with_site = true);

/// Commands by group; each adds itself to `root` and runs from its callback.
void add_project_commands(CLI::App& root, Context& context);
void add_import_commands(CLI::App& root, Context& context);
void add_record_commands(CLI::App& root, Context& context);
/// After the record commands: adds to `region` what only regions have.
void add_region_commands(CLI::App& root, Context& context);
/// After the record commands: adds to `find` the proposal of units.
void add_find_commands(CLI::App& root, Context& context);
void add_survey_commands(CLI::App& root, Context& context);
/// After the record commands: adds to `interpretation` the comparison of two.
void add_interpretation_commands(CLI::App& root, Context& context);
void add_check_commands(CLI::App& root, Context& context);
void add_matrix_commands(CLI::App& root, Context& context);
void add_report_commands(CLI::App& root, Context& context);
void add_scan_commands(CLI::App& root, Context& context);
/// After the scan commands: adds to `scan` what one scan says of itself, and the images in its file.
void add_scan_details_commands(CLI::App& root, Context& context);
void add_panorama_commands(CLI::App& root, Context& context);
/// After the record commands: adds to `surface` what scans give.
void add_surface_commands(CLI::App& root, Context& context);
/// Plans and sections on paper.
void add_plan_commands(CLI::App& root, Context& context);
void add_register_commands(CLI::App& root, Context& context);
void add_suggest_commands(CLI::App& root, Context& context);
void add_demo_commands(CLI::App& root, Context& context);

/// Writes the record for another program and says what was not carried.
void write_export(const Context& context, app::Project& project, const std::filesystem::path& file,
                  const app::ExportOptions& options);

/// Runs the program on its arguments (without its own name) and returns the exit status of DESIGN 5.
int run_command_line(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& err);

} // namespace planum::cli
