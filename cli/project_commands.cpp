// SPDX-License-Identifier: MIT
#include "cli/context.hpp"

#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/project/clean.hpp"
#include "app/records/record_kind.hpp"
#include "app/scans/verify_scans.hpp"
#include "core/base/error.hpp"
#include "core/base/text.hpp"

namespace planum::cli {

using nlohmann::ordered_json;
using store::OpenMode;

namespace {

struct NewOptions {
    std::string name;
    std::int64_t srs = -1;
    double tolerance = 0.02;
    std::string method = "stratigraphic";
    std::string numbers = "site";
    std::string strictness = "normal";
};

void run_new(const Context& context, const NewOptions& options) {
    model::ProjectSettings settings;
    settings.name = options.name.empty() ? std::filesystem::path(context.site).stem().string() : options.name;
    settings.srs_id = options.srs;
    settings.tolerance = options.tolerance;
    settings.method = *model::dig_method_from_word(options.method);
    settings.numbers = *model::number_scope_from_word(options.numbers);
    settings.strictness = *model::strictness_from_word(options.strictness);
    app::Project::create(context.site, settings, context.session());
    context.say(fmt::format("made {}", context.site));
}

void add_new(CLI::App& root, Context& context) {
    auto options = std::make_shared<NewOptions>();
    CLI::App* command = add_command(root, context, "new", "make a new project file");
    command->add_option("--name", options->name, "name of the dig (default: the file's)");
    command->add_option("--srs", options->srs, "EPSG code of the site grid (default: -1, a local grid)");
    command->add_option("--tolerance", options->tolerance, "height tolerance of the project [m]")
        ->capture_default_str()
        ->check(CLI::Range(0.0, 1.0));
    command->add_option("--method", options->method, "how it is dug")
        ->capture_default_str()
        ->check(CLI::IsMember({"stratigraphic", "planum", "mixed"}));
    command->add_option("--numbers", options->numbers, "unit numbers are unique per site or per area")
        ->capture_default_str()
        ->check(CLI::IsMember({"site", "area"}));
    command->add_option("--strictness", options->strictness, "how strict the checks of kinds are")
        ->capture_default_str()
        ->check(CLI::IsMember({"lenient", "normal", "strict"}));
    command->callback([&context, options] { run_new(context, *options); });
}

ordered_json info_of(app::Project& project) {
    const model::Record& record = project.record();
    std::set<std::string> days;
    std::int64_t points = 0;
    for (const model::Scan& scan : record.scans) {
        days.insert(scan.day);
        points += scan.points;
    }
    for (const model::Surface& surface : record.surfaces) days.insert(surface.first_day);
    days.erase("");
    ordered_json info;
    info["name"] = record.settings.name;
    info["schema_version"] = project.file().schema_version();
    info["srs"] = record.settings.srs_id;
    info["units"] = record.units.size();
    info["relations"] = record.relations.size();
    info["days"] = days.size();
    info["surfaces"] = record.surfaces.size();
    info["scans"] = record.scans.size();
    info["registered_scans"] = record.poses.size();
    info["regions"] = record.regions.size();
    info["finds"] = record.finds.size();
    info["points"] = points;
    info["statements"] = record.statements.size();
    info["levels"] = record.levels.size();
    info["numbers"] = to_word(record.settings.numbers);
    info["method"] = to_word(record.settings.method);
    info["tolerance_m"] = record.settings.tolerance;
    return info;
}

void run_info(const Context& context) {
    app::Project project = context.open(OpenMode::ReadOnly);
    const ordered_json info = info_of(project);
    if (context.json) return context.print(info);
    for (const auto& [key, value] : info.items()) {
        *context.out << fmt::format("{:<17} {}\n", key, value.is_string() ? value.get<std::string>() : value.dump());
    }
}

struct VerifyOptions {
    bool clean = false;
    std::string forget_undo_before;
};

void say_cleaned(const Context& context, const app::Cleaned& cleaned) {
    for (const auto& file : cleaned.removed) context.say("removed " + file.string());
    context.say(fmt::format(
        "removed {} of {:.1f} MB; the project is {:.1f} MB shorter", text::counted(cleaned.removed.size(), "file"),
        static_cast<double>(cleaned.removed_bytes) / 1e6, static_cast<double>(cleaned.freed_bytes) / 1e6));
    if (cleaned.forgotten_changes > 0) {
        context.say(fmt::format("{} can no longer be taken back", text::counted(cleaned.forgotten_changes, "change")));
    }
}

// A damaged project is not cleaned: what looks useless may be what a rescue needs.
void run_verify(Context& context, const VerifyOptions& options) {
    const std::string day = app::date_from("forget-undo-before", options.forget_undo_before);
    app::Project project = context.open(options.clean ? OpenMode::ReadWrite : OpenMode::ReadOnly);
    std::vector<std::pair<std::string, std::string>> problems;
    for (const auto& problem : project.file().verify(*context.progress))
        problems.emplace_back(problem.where, problem.what);
    const bool is_sound = problems.empty();
    for (const auto& problem : app::verify_scans(project, *context.progress)) {
        problems.emplace_back(problem.where, problem.what);
    }
    if (context.json) {
        ordered_json list = ordered_json::array();
        for (const auto& [where, what] : problems) list.push_back({{"where", where}, {"what", what}});
        context.print({{"problems", list}});
    } else {
        for (const auto& [where, what] : problems) *context.out << where << ": " << what << '\n';
        if (problems.empty()) *context.out << "no problem found in " << context.site << '\n';
    }
    if (!problems.empty()) context.status = exit_status(ErrorCode::BadInput);
    if (!options.clean) return;
    if (is_sound) return say_cleaned(context, app::clean_project(project, day, *context.progress));
    context.say("nothing was cleaned: the project file itself is not sound");
}

void run_backup(const Context& context, const std::string& target) {
    const app::Project project = context.open(OpenMode::ReadOnly);
    const std::filesystem::path file(context.site);
    std::filesystem::path to(target);
    if (target.empty()) {
        std::string stamp = project.clock().now().substr(0, 19);
        std::replace(stamp.begin(), stamp.end(), ':', '-');
        to = file.parent_path() / (file.stem().string() + ".backup-" + stamp + ".gpkg");
    }
    if (std::filesystem::is_directory(to)) to /= file.filename();
    project.file().backup(to, *context.progress);
    *context.out << to.string() << '\n';
}

ordered_json change_json(const store::ChangeEntry& entry) {
    return {{"number", entry.number},
            {"label", entry.label},
            {"author", entry.author},
            {"made_at", entry.made_at},
            {"undone", entry.undone}};
}

void run_undo(const Context& context, bool redo) {
    app::Project project = context.open(OpenMode::ReadWrite);
    const store::ChangeEntry entry = redo ? project.redo() : project.undo();
    if (context.json) return context.print(change_json(entry));
    *context.out << (redo ? "done again: " : "undone: ") << entry.label << '\n';
}

struct HistoryOptions {
    std::size_t most = 50;
    std::string unit;
};

void run_history(const Context& context, const HistoryOptions& options) {
    app::Project project = context.open(OpenMode::ReadOnly);
    ordered_json changes = ordered_json::array();
    if (!options.unit.empty()) {
        const Uuid unit = project.record().units[project.unit_named(options.unit)].id.value;
        for (const auto& entry : project.file().log(unit, options.most)) {
            changes.push_back({{"made_at", entry.made_at},
                               {"author", entry.author},
                               {"action", entry.action},
                               {"field", entry.field},
                               {"old", entry.old_value},
                               {"new", entry.new_value}});
            if (!context.json) {
                *context.out << fmt::format(
                    "{}  {:<12} {:<7} {}{}\n", entry.made_at, entry.author, entry.action, entry.field,
                    entry.field.empty() ? "" : fmt::format(": {} → {}", entry.old_value, entry.new_value));
            }
        }
    } else {
        for (const auto& entry : project.file().history(options.most)) {
            changes.push_back(change_json(entry));
            if (!context.json) {
                const std::string number = entry.number > 0 ? fmt::format("{}", entry.number) : "-";
                *context.out << fmt::format("{:>5}  {}  {:<12} {}{}\n", number, entry.made_at, entry.author,
                                            entry.label, entry.undone ? "  (undone)" : "");
            }
        }
    }
    if (context.json) context.print({{"changes", changes}});
}

} // namespace

void add_project_commands(CLI::App& root, Context& context) {
    add_new(root, context);
    add_command(root, context, "info", "what the project holds")->callback([&context] { run_info(context); });

    auto verifying = std::make_shared<VerifyOptions>();
    CLI::App* verify =
        add_command(root, context, "verify", "check the file itself, its scans and their points, deeply");
    CLI::Option* clean = verify->add_flag("--clean", verifying->clean,
                                          "also remove point stores and files that nothing needs, and free space");
    verify
        ->add_option("--forget-undo-before", verifying->forget_undo_before,
                     "with --clean: changes made before this day can no longer be taken back")
        ->needs(clean);
    verify->callback([&context, verifying] { run_verify(context, *verifying); });

    auto target = std::make_shared<std::string>();
    CLI::App* backup = add_command(root, context, "backup", "a checked copy, safe while others work");
    backup->add_option("TARGET", *target, "file or folder (default: beside the project, with the time)");
    backup->callback([&context, target] { run_backup(context, *target); });

    add_command(root, context, "undo", "take the newest change back")->callback([&context] {
        run_undo(context, false);
    });
    add_command(root, context, "redo", "make it again")->callback([&context] { run_undo(context, true); });

    auto options = std::make_shared<HistoryOptions>();
    CLI::App* history = add_command(root, context, "history", "who changed what, and when");
    history->add_option("--unit", options->unit, "only what happened to this unit, field by field");
    history->add_option("--most", options->most, "at most so many lines")->capture_default_str();
    history->callback([&context, options] { run_history(context, *options); });
}

} // namespace planum::cli
