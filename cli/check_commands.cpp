// SPDX-License-Identifier: MIT
#include "cli/context.hpp"

#include <filesystem>
#include <map>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/checks/contradiction_sheet.hpp"
#include "app/checks/daily_check.hpp"
#include "app/checks/today.hpp"
#include "cli/diagnostics_text.hpp"
#include "core/base/error.hpp"
#include "core/base/file.hpp"
#include "core/base/text.hpp"
#include "paint/sheet_group_painter.hpp"

namespace planum::cli {

using nlohmann::ordered_json;
using store::OpenMode;

namespace {

struct Options {
    std::string interpretation;
    std::string accept;
    std::string because;
    std::size_t most = 15;
    bool sign_off = false;
    std::string show;
    std::string file;
    double dpi = 200.0;
};

ordered_json to_json(const app::DailyCheck& check, const model::RecordIndex& index) {
    ordered_json json;
    json["problems"] = ordered_json::array();
    for (const model::Diagnostic& problem : check.problems) {
        ordered_json entry = cli::to_json(problem, index);
        entry["new"] = check.new_ids.contains(problem.id);
        json["problems"].push_back(std::move(entry));
    }
    json["counts"] = {{"error", check.count(model::Severity::Error)},
                      {"warning", check.count(model::Severity::Warning)},
                      {"info", check.count(model::Severity::Info)}};
    json["coverage"] = cli::to_json(check.coverage);
    json["accepted"] = ordered_json::array();
    for (const model::Diagnostic& problem : check.accepted) json["accepted"].push_back(cli::to_json(problem, index));
    json["signed_off"] = nullptr;
    if (!check.signed_off_at.empty()) json["signed_off"] = {{"at", check.signed_off_at}, {"by", check.signed_off_by}};
    return json;
}

void print_problem(const Context& context, const model::Diagnostic& problem, const model::RecordIndex& index,
                   bool is_new) {
    *context.out << fmt::format("  {} {}{}\n", problem.id, is_new ? "new: " : "", problem.message);
    constexpr std::size_t kSuspects = 5;
    for (std::size_t i = 0; i < problem.suspects.size() && i < kSuspects; ++i) {
        const model::Suspect& suspect = problem.suspects[i];
        *context.out << fmt::format("      {}. {}\n", i + 1, describe(suspect, index));
        for (const std::string& reason : suspect.reasons) *context.out << "         - " << reason << '\n';
    }
    if (problem.suspects.size() > kSuspects) {
        *context.out << fmt::format("      … and {}; --json shows all\n",
                                    text::counted(problem.suspects.size() - kSuspects, "more suspect"));
    }
}

// Grouped by cause, errors first; the checks come in that order already.
void print_problems(const Context& context, const app::DailyCheck& check, const model::RecordIndex& index,
                    std::size_t most) {
    std::map<std::string, std::size_t> total;
    for (const model::Diagnostic& problem : check.problems) ++total[problem.code];
    std::vector<std::string> order;
    for (const model::Diagnostic& problem : check.problems) {
        if (std::find(order.begin(), order.end(), problem.code) == order.end()) order.push_back(problem.code);
    }
    for (const std::string& code : order) {
        std::size_t shown = 0;
        for (const model::Diagnostic& problem : check.problems) {
            if (problem.code != code) continue;
            if (shown == 0) *context.out << fmt::format("{} ({}, {})\n", code, to_word(problem.severity), total[code]);
            if (shown == most && !context.verbose) {
                *context.out << fmt::format("  … and {} more; --verbose shows all\n", total[code] - most);
                break;
            }
            print_problem(context, problem, index, check.new_ids.contains(problem.id));
            ++shown;
        }
    }
}

void print_coverage(const Context& context, const model::Coverage& coverage) {
    *context.out << fmt::format("of {} an order: {} confirmed by levels or surfaces, {} contradicted\n",
                                text::counted(coverage.relations, "relation that states", "relations that state"),
                                coverage.confirmed, coverage.contradicted);
    for (const auto& [reason, count] : coverage.untestable) {
        *context.out << fmt::format("  {} could not be judged: {}\n", count, reason);
    }
}

void write_group(const Context& context, const geometry::SheetGroup& group, const Options& options) {
    const std::filesystem::path file(options.file);
    const std::string ending = text::fold_case(file.extension().string());
    if (ending == ".png") {
        write_file_atomically(file, paint::render_sheet_group_png(group, options.dpi));
    } else {
        write_file_atomically(file, paint::render_sheet_group_pdf(group, *context.progress));
    }
}

void run_show(const Context& context, const Options& options) {
    const std::string ending = text::fold_case(std::filesystem::path(options.file).extension().string());
    if (options.file.empty()) throw Error(ErrorCode::Usage, "a problem is shown in a file: -o F.png or F.pdf");
    if (ending != ".png" && ending != ".pdf")
        throw Error(ErrorCode::Usage, fmt::format("{}: problems are shown as .png or .pdf", options.file));
    app::Project project = context.open(OpenMode::ReadOnly);
    const app::ContradictionSheet made =
        app::contradiction_sheet(project, options.show, options.interpretation, *context.progress);
    write_group(context, made.group, options);
    if (context.json) {
        ordered_json json = {
            {"file", options.file}, {"id", options.show}, {"upper", made.upper}, {"lower", made.lower}};
        if (made.section.empty()) {
            json["surfaces"] = {made.before, made.after};
            json["area_m2"] = made.area;
        } else {
            json["section"] = made.section;
            json["length_m"] = made.length;
        }
        json["x"] = made.x;
        json["y"] = made.y;
        json["z_upper"] = made.z_upper;
        json["z_lower"] = made.z_lower;
        return context.print(json);
    }
    if (!made.section.empty()) {
        *context.out << fmt::format("{}: {} on {} along {:.2f} m in section {}, most clearly at {:.2f} {:.2f}\n",
                                    options.file, made.upper, made.lower, made.length, made.section, made.x, made.y);
        return;
    }
    *context.out << fmt::format("{}: {} above {}, at most {:.2f} m, at {:.2f} {:.2f}\n", options.file, made.upper,
                                made.lower, made.z_upper - made.z_lower, made.x, made.y);
}

void run_check(Context& context, const Options& options) {
    if (!options.show.empty()) return run_show(context, options);
    if (!options.accept.empty() || options.sign_off) {
        app::Project project = context.open(OpenMode::ReadWrite);
        if (!options.accept.empty()) app::accept_problem(project, options.accept, options.because, *context.progress);
        if (options.sign_off) app::sign_off(project, *context.progress);
        context.say(options.sign_off ? "signed off by " + project.author() : "accepted " + options.accept);
        return;
    }
    app::Project project = context.open(OpenMode::ReadOnly);
    const app::DailyCheck check = app::check_project(project, options.interpretation, *context.progress);
    if (check.count(model::Severity::Error) > 0) context.status = 1;
    if (context.json) return context.print(to_json(check, project.index()));
    print_problems(context, check, project.index(), options.most);
    *context.out << fmt::format("{}, {}, {}; {} accepted\n",
                                text::counted(check.count(model::Severity::Error), "error"),
                                text::counted(check.count(model::Severity::Warning), "warning"),
                                text::counted(check.count(model::Severity::Info), "remark"), check.accepted.size());
    if (!check.signed_off_at.empty()) {
        *context.out << fmt::format("last signed off {} by {}\n", check.signed_off_at, check.signed_off_by);
    }
    print_coverage(context, check.coverage);
}

void print_list(const Context& context, std::string_view heading, const std::vector<std::string>& units) {
    *context.out << fmt::format("{} ({})\n", heading, units.size());
    if (!units.empty()) *context.out << "  " << text::join(units, ", ") << '\n';
}

void run_today(const Context& context) {
    app::Project project = context.open(OpenMode::ReadOnly);
    const app::TodayList today = app::today_of(project);
    if (context.json) {
        ordered_json sheets = ordered_json::array();
        for (const auto& sheet : today.incomplete_sheets) {
            sheets.push_back({{"unit", sheet.unit}, {"missing", sheet.missing}});
        }
        return context.print(
            {{"open", today.open}, {"may_be_dug_next", today.may_be_dug_next}, {"incomplete_sheets", sheets}});
    }
    print_list(context, "open units", today.open);
    print_list(context, "may be dug next: nothing recorded above them is still there", today.may_be_dug_next);
    *context.out << fmt::format("sheets that lack something ({})\n", today.incomplete_sheets.size());
    for (const auto& sheet : today.incomplete_sheets) {
        *context.out << fmt::format("  {}: {}\n", sheet.unit, text::join(sheet.missing, ", "));
    }
}

} // namespace

void add_check_commands(CLI::App& root, Context& context) {
    auto options = std::make_shared<Options>();
    CLI::App* check = add_command(root, context, "check", "what contradicts what, and which statement to suspect");
    check->add_option("--interpretation", options->interpretation, "check this reading instead of the field record");
    CLI::Option* accept = check->add_option("--accept", options->accept, "keep the problem with this id silent");
    check->add_option("--because", options->because, "the reason")->needs(accept);
    check->add_flag("--sign-off", options->sign_off, "sign the day off: what stands now is not new tomorrow");
    check->add_option("--most", options->most, "at most so many problems of one kind")->capture_default_str();
    CLI::Option* show =
        check->add_option("--show", options->show, "draw the height contradiction with this id: both faces, a section");
    check->add_option("-o,--output", options->file, "F.png or F.pdf")->needs(show);
    check->add_option("--dpi", options->dpi, "of a PNG")->check(CLI::Range(20.0, 1200.0))->capture_default_str();
    show->excludes(accept);
    check->callback([&context, options] { run_check(context, *options); });

    add_command(root, context, "today", "open units, what may be dug next, sheets that lack something")
        ->callback([&context] { run_today(context); });
}

} // namespace planum::cli
