// SPDX-License-Identifier: MIT
#include "cli/context.hpp"

#include <map>
#include <memory>
#include <utility>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/records/record_kind.hpp"
#include "app/records/relation_entry.hpp"
#include "core/base/text.hpp"

namespace planum::cli {

using app::RecordKind;
using nlohmann::ordered_json;
using store::OpenMode;

namespace {

// What the options of one verb were given; name words are joined, so that `relation add S 12 cuts 14` works.
struct Given {
    std::vector<std::string> name;
    std::map<std::string, std::string> fields;

    [[nodiscard]] std::string full_name() const { return text::join(name, " "); }

    [[nodiscard]] app::FieldValues values(const CLI::App& command) const {
        app::FieldValues set;
        for (const auto& [field, value] : fields) {
            if (command.count("--" + field) > 0) set.emplace_back(field, value);
        }
        return set;
    }
};

// What goes into the record is text without control characters, names stand on one line; what was replaced is said.
struct Entered {
    std::string name;
    app::FieldValues values;
};

Entered entered(const Context& context, const Given& given, const CLI::App& command) {
    const auto clean = [&](text::Cleaned cleaned, const std::string& what) {
        if (cleaned.replaced > 0) {
            context.say(fmt::format("{}: {} {} no text there and {} replaced: {}", what, cleaned.replaced,
                                    cleaned.replaced == 1 ? "character is" : "characters are",
                                    cleaned.replaced == 1 ? "was" : "were", cleaned.text));
        }
        return std::move(cleaned.text);
    };
    Entered all{clean(text::on_one_line(given.full_name()), "name"), given.values(command)};
    for (auto& [field, value] : all.values) value = clean(text::clean_utf8(value), field);
    return all;
}

CLI::App* add_verb(CLI::App& parent, Context& context, const RecordKind& kind, Given& given, const std::string& verb,
                   const std::string& help, bool with_fields) {
    CLI::App* command = add_command(parent, context, verb, help);
    CLI::Option* name = command->add_option("NAME", given.name, std::string(kind.name_form()))->required();
    // Words that make one new name by being put together are a mistake, but for a relation, which is said in words.
    if (verb == "add" && kind.word() != "relation") name->expected(1);
    if (with_fields) {
        for (const app::FieldInfo& field : kind.fields()) {
            command->add_option("--" + field.name, given.fields[field.name], field.help);
        }
    }
    return command;
}

void warn_of_cycle(const Context& context, app::Project& project, const RecordKind& kind, const std::string& name) {
    if (kind.word() != "relation") return;
    const auto cycle = app::would_close_cycle(project, app::parse_relation(project, name));
    if (cycle.empty()) return;
    std::vector<std::string> names;
    for (const model::UnitId unit : cycle) names.push_back(project.index().name(unit));
    names.push_back(names.front());
    constexpr std::size_t kShown = 6; // at both ends: a cycle through hundreds fills a screen and says nothing
    if (names.size() > 2 * kShown + 2) {
        const std::size_t between = names.size() - 2 * kShown;
        names.erase(names.begin() + kShown, names.end() - kShown);
        names.insert(names.begin() + kShown, fmt::format("({} more)", between));
    }
    context.say(fmt::format("warning: this closes a cycle: {}; planum check says which statement to suspect",
                            text::join(names, " over ")));
}

ordered_json to_json(const app::FieldValues& values) {
    ordered_json json = ordered_json::object();
    for (const auto& [field, value] : values) json[text::replace_all(field, "-", "_")] = value;
    return json;
}

void run_list(const Context& context, const RecordKind& kind) {
    app::Project project = context.open(OpenMode::ReadOnly);
    ordered_json list = ordered_json::array();
    for (const std::string& name : kind.names(project)) {
        if (!context.json && !context.verbose) {
            *context.out << name << '\n';
            continue;
        }
        const app::FieldValues values = kind.show(project, name);
        list.push_back(to_json(values));
        if (context.json) continue;
        std::vector<std::string> parts;
        for (const auto& [field, value] : values) {
            if (field != "name") parts.push_back(fmt::format("{}: {}", field, value));
        }
        *context.out << fmt::format("{:<10} {}\n", name, text::join(parts, "; "));
    }
    if (context.json) context.print({{std::string(kind.word()) + "s", list}});
}

void run_show(const Context& context, const RecordKind& kind, const std::string& name) {
    app::Project project = context.open(OpenMode::ReadOnly);
    const app::FieldValues values = kind.show(project, name);
    if (context.json) return context.print(to_json(values));
    for (const auto& [field, value] : values) *context.out << fmt::format("{:<20} {}\n", field, value);
    if (kind.word() != "unit") return;
    const model::UnitId unit = project.record().units[project.unit_named(name)].id;
    for (const model::PhysicalRelation& relation : project.record().relations) {
        if (relation.subject == unit) {
            *context.out << fmt::format("{:<20} {}\n", phrase(relation.kind), project.index().name(relation.object));
        } else if (relation.object == unit) {
            *context.out << fmt::format("{:<20} {}\n", inverse_phrase(relation.kind),
                                        project.index().name(relation.subject));
        }
    }
}

void add_kind(CLI::App& root, Context& context, const RecordKind& kind) {
    const std::string word{kind.word()};
    // "a unit" is said with a consonant, "an area" and "an interpretation" are not.
    const char* article = std::string_view("aeio").find(word.front()) == std::string_view::npos ? "a" : "an";
    CLI::App* group = root.add_subcommand(word, fmt::format("add, set, list, show or delete {} {}", article, word));
    group->require_subcommand(1);
    auto added = std::make_shared<Given>();
    CLI::App* add = add_verb(*group, context, kind, *added, "add", "add one", true);
    add->callback([&context, &kind, added, add] {
        app::Project project = context.open(OpenMode::ReadWrite);
        const auto [given, values] = entered(context, *added, *add);
        warn_of_cycle(context, project, kind, given);
        const std::string name = kind.add(project, given, values);
        *context.out << name << '\n';
        for (const std::string& remark : kind.remarks(project, name, values)) context.say(remark);
    });
    auto changed = std::make_shared<Given>();
    CLI::App* set = add_verb(*group, context, kind, *changed, "set", "change fields of one", true);
    set->callback([&context, &kind, changed, set] {
        app::Project project = context.open(OpenMode::ReadWrite);
        const app::FieldValues values = entered(context, *changed, *set).values;
        // Before: a region is called by its unit, which may be another one afterwards.
        const auto remarks = kind.remarks(project, changed->full_name(), values);
        kind.set(project, changed->full_name(), values);
        for (const std::string& remark : remarks) context.say(remark);
    });
    if (word != "region") { // which lists areas and heights, see region_commands.cpp
        add_command(*group, context, "list", "all of them")->callback([&context, &kind] { run_list(context, kind); });
    }
    auto shown = std::make_shared<Given>();
    add_verb(*group, context, kind, *shown, "show", "all that is recorded of one", false)
        ->callback([&context, &kind, shown] { run_show(context, kind, shown->full_name()); });
    auto gone = std::make_shared<Given>();
    add_verb(*group, context, kind, *gone, "delete", "mark one as deleted (undo brings it back)", false)
        ->callback([&context, &kind, gone] {
            app::Project project = context.open(OpenMode::ReadWrite);
            kind.remove(project, gone->full_name());
        });
}

} // namespace

void add_record_commands(CLI::App& root, Context& context) {
    for (const auto& kind : app::record_kinds()) add_kind(root, context, *kind);
}

} // namespace planum::cli
