// SPDX-License-Identifier: MIT
#include "cli/context.hpp"

#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/checks/interpretation_diff.hpp"

namespace planum::cli {

using nlohmann::ordered_json;

namespace {

struct Names {
    std::string first;
    std::string second;

    [[nodiscard]] const std::string& of(app::Reading reading) const {
        return reading == app::Reading::First ? first : second;
    }
};

ordered_json to_json(const app::InterpretationDiff& diff, const Names& names) {
    ordered_json json = {{"first", names.first},
                         {"second", names.second},
                         {"relations", ordered_json::array()},
                         {"orders", ordered_json::array()},
                         {"problems", ordered_json::array()}};
    for (const auto& r : diff.relations) {
        json["relations"].push_back({{"in", names.of(r.in)},
                                     {"unit", r.unit},
                                     {"kind", to_word(r.kind)},
                                     {"other", r.other},
                                     {"contradicted", r.contradicted}});
    }
    for (const auto& o : diff.orders) {
        json["orders"].push_back(
            {{"in", names.of(o.in)}, {"later", o.later}, {"earlier", o.earlier}, {"reversed", o.reversed}});
    }
    for (const auto& p : diff.problems) {
        json["problems"].push_back({{"in", names.of(p.in)},
                                    {"id", p.problem.id},
                                    {"code", p.problem.code},
                                    {"severity", to_word(p.problem.severity)},
                                    {"message", p.problem.message}});
    }
    return json;
}

void print_text(const Context& context, const app::InterpretationDiff& diff, const Names& names) {
    for (const auto& r : diff.relations) {
        *context.out << fmt::format("only in {}: {} {} {}{}\n", names.of(r.in), r.unit, phrase(r.kind), r.other,
                                    r.contradicted ? "; the other reading orders them the other way round" : "");
    }
    for (const auto& o : diff.orders) {
        const std::string& other = names.of(o.in == app::Reading::First ? app::Reading::Second : app::Reading::First);
        *context.out << fmt::format("order of {}: {} later than {}; {} {}\n", names.of(o.in), o.later, o.earlier, other,
                                    o.reversed ? "says the opposite" : "does not order them so");
    }
    for (const auto& p : diff.problems) {
        *context.out << fmt::format("only {} contradicts: {} {}\n", names.of(p.in), p.problem.code, p.problem.message);
    }
    if (diff.relations.empty() && diff.orders.empty() && diff.problems.empty()) {
        *context.out << fmt::format("{} and {} say the same\n", names.first, names.second);
    }
}

} // namespace

void add_interpretation_commands(CLI::App& root, Context& context) {
    const auto there = root.get_subcommands([](const CLI::App* app) { return app->get_name() == "interpretation"; });
    CLI::App* group = there.empty() ? root.add_subcommand("interpretation", "readings of the record") : there.front();
    group->require_subcommand(1);
    auto names = std::make_shared<Names>();
    CLI::App* diff = add_command(*group, context, "diff", "relations and orders that differ, what each contradicts");
    diff->add_option("A", names->first, "an interpretation, or record for the field record")->required();
    diff->add_option("B", names->second, "an interpretation, or record for the field record")->required();
    diff->callback([&context, names] {
        app::Project project = context.open(store::OpenMode::ReadOnly);
        const app::InterpretationDiff found =
            app::diff_interpretations(project, names->first, names->second, *context.progress);
        if (context.json) return context.print(to_json(found, *names));
        print_text(context, found, *names);
    });
}

} // namespace planum::cli
