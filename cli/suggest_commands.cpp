// SPDX-License-Identifier: MIT
#include "cli/context.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/scans/days_surface.hpp"
#include "app/suggestions/suggestions.hpp"
#include "core/base/error.hpp"
#include "core/base/text.hpp"

namespace planum::cli {

using nlohmann::ordered_json;
using store::OpenMode;

namespace {

struct Options {
    std::vector<std::string> accept;
    std::vector<std::string> reject;
    std::string because;
    std::string into;
    std::string day;
    bool questions = false;
    std::size_t most = 20;
};

std::string_view to_word(model::SuggestionState state) {
    switch (state) {
    case model::SuggestionState::Open: return "open";
    case model::SuggestionState::Accepted: return "accepted";
    case model::SuggestionState::Rejected: return "rejected";
    case model::SuggestionState::Recorded: return "recorded";
    }
    return "";
}

std::string_view to_word(model::EvidenceSource source) {
    switch (source) {
    case model::EvidenceSource::StratigraphicSurfaces: return "surfaces";
    case model::EvidenceSource::Levels: return "levels";
    case model::EvidenceSource::Section: return "section";
    }
    return "";
}

std::string name_of_surface(const model::Record& record, model::SurfaceId id) {
    const auto found =
        std::find_if(record.surfaces.begin(), record.surfaces.end(), [&](const auto& s) { return s.id == id; });
    return found == record.surfaces.end() ? std::string{} : app::surface_name(record, *found);
}

// A tenth of a millimetre, a square centimetre: more digits would only look exact.
double rounded(double value) { return std::round(value * 1e4) / 1e4; }

ordered_json to_json(app::Project& project, const app::SuggestionList& list) {
    ordered_json all = ordered_json::array();
    for (const model::Suggestion& s : list.suggestions) {
        ordered_json surfaces = ordered_json::array();
        for (const model::SurfaceId id : s.surfaces) surfaces.push_back(name_of_surface(project.record(), id));
        const bool is_question = s.type == model::SuggestionType::Question;
        all.push_back({{"id", s.id},
                       {"type", is_question ? "question" : "relation"},
                       {"unit", project.index().name(s.unit)},
                       {"kind", is_question ? ordered_json(nullptr) : ordered_json(model::to_word(s.kind))},
                       {"other", project.index().name(s.other)},
                       {"direct", s.direct},
                       {"confidence", s.confidence},
                       {"area_m2", rounded(s.area)},
                       {"thickness_m", rounded(s.thickness)},
                       {"surfaces", surfaces},
                       {"reason", s.reason},
                       {"state", to_word(s.state)},
                       {"from", to_word(s.source)}});
    }
    ordered_json unused = ordered_json::array();
    for (const app::UnusedSurface& one : list.unused) unused.push_back({{"surface", one.surface}, {"why", one.why}});
    return {{"suggestions", all}, {"unused", unused}, {"without_kind", list.without_kind}};
}

// What somebody asked for, in the order it came.
void narrow(const model::Record& record, const Options& options, std::vector<model::Suggestion>& all) {
    std::erase_if(all, [&](const model::Suggestion& s) {
        return (options.questions && s.type != model::SuggestionType::Question) ||
               (!options.day.empty() && !app::concerns_day(record, s, options.day));
    });
}

void print_open(const Context& context, app::Project& project, const std::vector<model::Suggestion>& suggestions,
                model::SuggestionType type, std::size_t most) {
    std::vector<const model::Suggestion*> open;
    for (const model::Suggestion& s : suggestions) {
        if (s.type == type && s.state == model::SuggestionState::Open) open.push_back(&s);
    }
    if (open.empty()) return;
    const bool is_question = type == model::SuggestionType::Question;
    *context.out << fmt::format("{} ({})\n", is_question ? "questions" : "proposed relations", open.size());
    for (std::size_t i = 0; i < open.size(); ++i) {
        if (i == most && !context.verbose) {
            *context.out << fmt::format("  … and {} more; --verbose shows all\n", open.size() - most);
            break;
        }
        const model::Suggestion& s = *open[i];
        const std::string what =
            is_question ? fmt::format("{} and {}", project.index().name(s.unit), project.index().name(s.other))
                        : fmt::format("{} {} {}", project.index().name(s.unit), model::phrase(s.kind),
                                      project.index().name(s.other));
        const char* levels = s.source == model::EvidenceSource::Levels && !is_question ? ", from levels" : "";
        *context.out << fmt::format("  {}  {}{}\n      {}\n", s.id, what, levels, s.reason);
    }
}

// Why there is nothing, which is another thing before and after surfaces could be compared.
std::string nothing_proposed(const app::SuggestionList& list) {
    if (list.compared == 0) {
        return "nothing to propose; outlines on two surfaces of an area with registered scans are needed: planum scan "
               "add, planum register, planum region import\n";
    }
    return fmt::format("nothing to propose: {} compared, and nowhere clear of the outlines did a unit come out below "
                       "another\n",
                       list.compared == 1 ? "one pair of surfaces was"
                                          : fmt::format("{} pairs of surfaces were", list.compared));
}

void print_rest(const Context& context, const app::SuggestionList& list, const Options& options) {
    std::map<model::SuggestionState, std::size_t> counts;
    for (const model::Suggestion& s : list.suggestions) ++counts[s.state];
    const bool is_narrowed = options.questions || !options.day.empty();
    if (list.suggestions.empty()) {
        *context.out << (is_narrowed ? "nothing of that kind is proposed\n" : nothing_proposed(list));
    } else if (counts[model::SuggestionState::Open] == 0) {
        *context.out << "nothing is open\n";
    }
    const auto print_count = [&](model::SuggestionState state, std::string_view what) {
        if (counts[state] > 0) *context.out << fmt::format("{} {}\n", counts[state], what);
    };
    print_count(model::SuggestionState::Recorded, "agree with what the record says already");
    print_count(model::SuggestionState::Accepted, "were accepted");
    print_count(model::SuggestionState::Rejected, "were rejected");
    if (list.without_kind > 0) {
        *context.out << fmt::format("{} without a kind: say whether they are deposits, fills, structures (planum unit "
                                    "set --kind); more can be concluded then, on levels most of it\n",
                                    list.without_kind == 1 ? "one outlined unit is"
                                                           : fmt::format("{} outlined units are", list.without_kind));
    }
    for (const app::UnusedSurface& one : list.unused)
        *context.out << fmt::format("not judged: surface {}: {}\n", one.surface, one.why);
}

void decide(const Context& context, const Options& options) {
    app::Project project = context.open(OpenMode::ReadWrite);
    if (!options.accept.empty()) {
        app::accept_suggestions(project, options.accept, *context.progress);
        context.say(fmt::format("{} taken into the record", options.accept.size()));
    } else if (!options.reject.empty()) {
        app::reject_suggestions(project, options.reject, options.because, *context.progress);
        context.say(fmt::format("{} rejected", options.reject.size()));
    } else {
        const std::size_t count = app::compile_interpretation(project, options.into, *context.progress);
        context.say(
            fmt::format("interpretation {}: {}, all from surfaces", options.into, text::counted(count, "relation")));
    }
}

void run(const Context& context, const Options& options) {
    if (!options.accept.empty() || !options.reject.empty() || !options.into.empty()) return decide(context, options);
    if (!options.day.empty() && !is_day(options.day))
        throw Error(ErrorCode::Usage, fmt::format("“{}” is no day; write it as 2025-06-01", options.day));
    app::Project project = context.open(OpenMode::ReadOnly);
    app::SuggestionList list = app::list_suggestions(project, *context.progress);
    narrow(project.record(), options, list.suggestions);
    if (context.json) return context.print(to_json(project, list));
    print_open(context, project, list.suggestions, model::SuggestionType::Relation, options.most);
    print_open(context, project, list.suggestions, model::SuggestionType::Question, options.most);
    print_rest(context, list, options);
}

} // namespace

void add_suggest_commands(CLI::App& root, Context& context) {
    auto options = std::make_shared<Options>();
    CLI::App* suggest = add_command(root, context, "suggest", "relations and questions that the surfaces propose");
    CLI::Option* accept = suggest->add_option("--accept", options->accept, "take these relations into the record");
    CLI::Option* reject = suggest->add_option("--reject", options->reject, "keep these silent");
    CLI::Option* into =
        suggest->add_option("--into", options->into, "make an interpretation of that name from all proposed relations");
    accept->excludes(reject)->excludes(into);
    reject->excludes(into);
    suggest->add_option("--because", options->because, "the reason")->needs(reject);
    suggest->add_option("--day", options->day, "only what a surface of this day takes part in");
    suggest->add_flag("--questions", options->questions, "only questions");
    suggest->add_option("--limit,--most", options->most, "list at most so many relations, and so many questions")
        ->capture_default_str();
    suggest->callback([&context, options] { run(context, *options); });
}

} // namespace planum::cli
