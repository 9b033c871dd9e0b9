// SPDX-License-Identifier: MIT
#include "cli/context.hpp"

#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/finds/assign_finds.hpp"
#include "core/base/text.hpp"

namespace planum::cli {

using nlohmann::ordered_json;

namespace {

ordered_json to_json(const app::FindAssignment& assignment) {
    ordered_json json = {{"finds", ordered_json::array()}, {"problems", ordered_json::array()}};
    for (const app::FindProposal& proposal : assignment.proposals) {
        json["finds"].push_back({{"find", proposal.find},
                                 {"unit", proposal.unit.empty() ? ordered_json(nullptr) : ordered_json(proposal.unit)},
                                 {"z", proposal.z ? ordered_json(*proposal.z) : ordered_json(nullptr)},
                                 {"candidates", proposal.candidates},
                                 {"reason", proposal.reason}});
    }
    for (const auto& problem : assignment.problems) {
        json["problems"].push_back({{"where", problem.where}, {"what", problem.what}});
    }
    json["applied"] = assignment.applied;
    return json;
}

void print_text(const Context& context, const app::FindAssignment& assignment, bool applied) {
    std::size_t with_unit = 0;
    for (const app::FindProposal& proposal : assignment.proposals) {
        with_unit += proposal.unit.empty() ? 0U : 1U;
        *context.out << fmt::format("{:<10} {:<10} {}\n", proposal.find, proposal.unit.empty() ? "-" : proposal.unit,
                                    proposal.reason);
    }
    for (const auto& problem : assignment.problems) context.say("without its points: " + problem.what);
    if (assignment.proposals.empty()) {
        *context.out << "no find is without unit\n";
        return;
    }
    *context.out << fmt::format("{} of {} without unit {}\n", with_unit,
                                text::counted(assignment.proposals.size(), "find"),
                                applied ? "got one" : "would get one; --apply writes it");
}

} // namespace

void add_find_commands(CLI::App& root, Context& context) {
    CLI::App* group = root.get_subcommand("find");
    auto options = std::make_shared<app::AssignOptions>();
    CLI::App* assign =
        add_command(*group, context, "assign", "propose the unit whose body holds each find without unit");
    assign->add_option("--day", options->day, "finds of one day only");
    assign->add_flag("--apply", options->apply, "write the units, and heights for finds without, as one undo step");
    assign->callback([&context, options] {
        app::Project project = context.open(options->apply ? store::OpenMode::ReadWrite : store::OpenMode::ReadOnly);
        const app::FindAssignment assignment = app::assign_finds(project, *options, *context.progress);
        if (context.json) return context.print(to_json(assignment));
        print_text(context, assignment, options->apply);
    });
}

} // namespace planum::cli
