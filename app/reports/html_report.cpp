// SPDX-License-Identifier: MIT
#include "app/reports/html_report.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <unordered_map>
#include <unordered_set>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "core/base/text.hpp"
#include "strat/layout/svg_writer.hpp"

namespace planum::app {

namespace {

using strat::xml_escaped;

constexpr std::string_view kStyle = R"(
body { font: 15px/1.45 "DejaVu Sans", "Segoe UI", sans-serif; color: #222; margin: 2em auto; max-width: 62em; padding: 0 1em; }
h1 { font-size: 1.7em; margin-bottom: 0; } h2 { margin-top: 2em; border-bottom: 1px solid #bbb; }
h3 { margin: 1.4em 0 .3em; } p.sub { color: #555; margin-top: .2em; }
table { border-collapse: collapse; } td, th { text-align: left; vertical-align: top; padding: .15em .9em .15em 0; }
th { font-weight: 600; color: #444; } .error { border-left: 5px solid #b3261e; } .warning { border-left: 5px solid #c77700; }
.info { border-left: 5px solid #5b7fa6; } .problem { padding: .3em .8em; margin: .7em 0; background: #faf9f7; }
.problem ol { margin: .3em 0; } .code { font-family: monospace; color: #666; font-size: .85em; }
.matrix { overflow: auto; border: 1px solid #ccc; max-height: 90vh; } .matrix svg { max-width: none; }
a { color: #1c4f82; text-decoration: none; } a:hover { text-decoration: underline; }
section.unit { break-inside: avoid; } @media print { .matrix { max-height: none; border: 0; } }
)";

constexpr std::string_view kPaperStyle = R"(
h1 { font-size: 20px; margin-bottom: 0px; } h2 { font-size: 14px; margin-top: 16px; margin-bottom: 4px; }
h3 { font-size: 10px; margin-top: 9px; margin-bottom: 1px; } p.sub { color: #555555; margin-top: 2px; }
td, th { padding-right: 8px; text-align: left; } th { color: #444444; font-weight: 400; } .code { color: #666666; font-size: 7px; }
ol { margin-top: 2px; margin-bottom: 2px; } a { color: #222222; text-decoration: none; }
)";

std::string_view colour_of(model::Severity severity) {
    switch (severity) {
    case model::Severity::Error: return "#b3261e";
    case model::Severity::Warning: return "#c77700";
    case model::Severity::Info: return "#5b7fa6";
    }
    return "#5b7fa6";
}

class Page {
  public:
    Page(const ReportInput& input, HtmlFor medium)
        : input_(input), record_(*input.record), index_(record_), on_paper_(medium == HtmlFor::Paper) {
        for (const model::PhysicalRelation& relation : record_.relations) {
            of_unit_[relation.subject].push_back(&relation);
            if (relation.object != relation.subject) of_unit_[relation.object].push_back(&relation);
        }
        for (const model::Level& level : record_.levels) levels_[level.unit].push_back(&level);
        for (const model::Find& find : record_.finds) finds_[find.unit].push_back(&find);
    }

    std::string write() {
        head();
        if (!input_.day.empty()) the_day();
        problems();
        coverage();
        if (!input_.drawing_svg.empty()) {
            out_ += "<h2 id=\"matrix\">Harris matrix</h2>\n<div class=\"matrix\">\n";
            out_ += svg_without_declaration();
            out_ += "</div>\n";
        }
        units();
        out_ += "</body>\n</html>\n";
        return std::move(out_);
    }

  private:
    void head() {
        const model::ProjectSettings& settings = record_.settings;
        out_ += "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n<title>" +
                xml_escaped(settings.name) + "</title>\n<style>" + std::string(on_paper_ ? kPaperStyle : kStyle) +
                "</style>\n</head>\n<body>\n";
        const std::string size = input_.day.empty() ? text::counted(record_.units.size(), "unit") + ", " +
                                                          text::counted(record_.relations.size(), "relation")
                                                    : fmt::format("{} of the day, {} beside them",
                                                                  text::counted(input_.of_day.size(), "unit"),
                                                                  record_.units.size() - input_.of_day.size());
        out_ +=
            fmt::format("<h1>{}{}</h1>\n<p class=\"sub\">{}. {} by {}, planum {}{}</p>\n", xml_escaped(settings.name),
                        input_.day.empty() ? "" : ", " + input_.day, size, xml_escaped(input_.made_at.substr(0, 10)),
                        xml_escaped(input_.made_by), PLANUM_VERSION,
                        input_.interpretation.empty() ? "" : "; interpretation " + xml_escaped(input_.interpretation));
        if (on_paper_) return;
        out_ += "<p><a href=\"#problems\">Problems</a> · <a href=\"#matrix\">Matrix</a> · <a "
                "href=\"#units\">Units</a></p>\n";
    }

    // A line of units that answer to a question about the day; none, no line.
    template<class Wanted>
    void day_row(std::string_view name, const Wanted& wanted) {
        std::vector<std::string> links;
        for (const model::StratigraphicUnit& unit : record_.units) {
            if (input_.of_day.contains(unit.id) && wanted(unit)) links.push_back(link(unit.id));
        }
        if (links.empty()) return;
        out_ += fmt::format("<tr><th>{} ({})</th><td>{}</td></tr>\n", name, links.size(), text::join(links, ", "));
    }

    void the_day() {
        const std::string& day = input_.day;
        out_ += "<h2>The day</h2>\n<table>\n";
        day_row("begun", [&](const auto& unit) { return unit.excavated_from == day; });
        day_row("finished", [&](const auto& unit) { return unit.excavated_on == day; });
        day_row("in work", [&](const auto& unit) {
            return !unit.excavated_from.empty() && unit.excavated_from < day && unit.excavated_on > day;
        });
        day_row("recorded", [&](const auto& unit) { return unit.recorded_on == day; });
        std::unordered_set<model::UnitId> outlined;
        for (const model::Region& region : record_.regions) {
            if (!region.surface.is_nil()) outlined.insert(region.unit);
        }
        day_row("outlined", [&](const auto& unit) { return outlined.contains(unit.id); });
        std::vector<std::string> finds;
        for (const model::Find& find : record_.finds) {
            if (find.found_on != day) continue;
            const std::string of = find.unit.is_nil() ? "no unit" : link(find.unit);
            finds.push_back(fmt::format("{} {} ({})", xml_escaped(find.number), xml_escaped(find.type), of));
        }
        if (!finds.empty()) {
            out_ += fmt::format("<tr><th>found ({})</th><td>{}</td></tr>\n", finds.size(), text::join(finds, ", "));
        }
        for (const model::Scan& scan : record_.scans) {
            const model::ScanPose* pose = pose_in_force(record_, scan.id);
            row("scan " + scan.name, pose == nullptr ? "not on the site grid"
                                                     : fmt::format("placed, {:.0f} % overlap, rms {:.1f} mm",
                                                                   pose->overlap * 100, pose->rms * 1000));
        }
        out_ += "</table>\n";
    }

    [[nodiscard]] std::string link(model::UnitId unit) const {
        return fmt::format("<a href=\"#u-{}\">{}</a>", unit.to_string(), xml_escaped(index_.name(unit)));
    }

    [[nodiscard]] std::string sentence(const model::NamedRelation& named) const {
        return fmt::format("{} {} {}", link(named.unit), xml_escaped(phrase(named.kind)), link(named.other));
    }

    [[nodiscard]] std::string suspect(const model::Suspect& suspect) const {
        struct Words {
            const Page& page;

            std::string operator()(const model::SuspectRelation& s) const { return page.sentence(s.relation); }

            std::string operator()(const model::SuspectSameAs& s) const { return page.sentence(s.same_as); }

            std::string operator()(const model::SuspectNumber& s) const {
                return fmt::format("the number {} in “{}”, probably {}", xml_escaped(s.written),
                                   page.sentence(s.relation), xml_escaped(s.probably));
            }

            std::string operator()(const model::SuspectUnit& s) const { return "unit " + page.link(s.unit); }
        };

        return std::visit(Words{*this}, suspect.what);
    }

    void open_problem(model::Severity severity) {
        out_ += on_paper_ ? fmt::format("<table width=\"100%\" cellspacing=\"0\" cellpadding=\"4\" "
                                        "style=\"margin-top: 4px\"><tr><td width=\"2\" bgcolor=\"{}\"></td>"
                                        "<td bgcolor=\"#f6f4f0\">",
                                        colour_of(severity))
                          : fmt::format("<div class=\"problem {}\">", to_word(severity));
    }

    void problem(const model::Diagnostic& d) {
        open_problem(d.severity);
        out_ += fmt::format("<span class=\"code\">{0} · {1} · {2}</span><br/>{3}", to_word(d.severity),
                            xml_escaped(d.code), xml_escaped(d.id), xml_escaped(d.message));
        if (!d.suspects.empty()) out_ += "\n<ol>\n";
        for (const model::Suspect& s : d.suspects) {
            std::vector<std::string> reasons;
            for (const std::string& reason : s.reasons) reasons.push_back(xml_escaped(reason));
            out_ +=
                fmt::format("<li>{}{}{}</li>\n", suspect(s), reasons.empty() ? "" : ": ", text::join(reasons, "; "));
        }
        if (!d.suspects.empty()) out_ += "</ol>\n";
        out_ += on_paper_ ? "</td></tr></table>\n" : "</div>\n";
    }

    // What nobody has to act upon stands behind what somebody has to, in one list.
    void problems() {
        const auto& all = input_.diagnostics;
        const auto is_remark = [](const model::Diagnostic& d) { return d.severity == model::Severity::Info; };
        const auto remarks = std::count_if(all.begin(), all.end(), is_remark);
        out_ +=
            fmt::format("<h2 id=\"problems\">Problems ({})</h2>\n", static_cast<std::ptrdiff_t>(all.size()) - remarks);
        if (static_cast<std::ptrdiff_t>(all.size()) == remarks) out_ += "<p>No error and no warning is open.</p>\n";
        for (const model::Diagnostic& d : all) {
            if (!is_remark(d)) problem(d);
        }
        if (remarks > 0) out_ += fmt::format("<h3>Remarks ({})</h3>\n<ul>\n", remarks);
        for (const model::Diagnostic& d : all) {
            if (is_remark(d)) out_ += fmt::format("<li>{}</li>\n", xml_escaped(d.message));
        }
        if (remarks > 0) out_ += "</ul>\n";
        if (!input_.accepted.empty()) out_ += fmt::format("<h3>Accepted ({})</h3>\n", input_.accepted.size());
        for (const model::Diagnostic& d : input_.accepted) {
            std::string because;
            for (const model::Decision& decision : record_.decisions) {
                if (decision.subject_id == d.id && decision.kind != "sign-off") because = decision.because;
            }
            out_ += fmt::format("<p>{} <em>Accepted: {}</em></p>\n", xml_escaped(d.message), xml_escaped(because));
        }
    }

    void coverage() {
        const model::Coverage& c = input_.coverage;
        out_ += fmt::format(
            "<h2>What could be judged{}</h2>\n<table>\n<tr><th>relations that state an order</th><td>{}</td></tr>\n"
            "<tr><th>confirmed by levels or surfaces</th><td>{}</td></tr>\n"
            "<tr><th>contradicted</th><td>{}</td></tr>\n",
            input_.day.empty() ? "" : " of the whole record", c.relations, c.confirmed, c.contradicted);
        for (const auto& [reason, count] : c.untestable) {
            out_ += fmt::format("<tr><th>not testable: {}</th><td>{}</td></tr>\n", xml_escaped(reason), count);
        }
        out_ += "</table>\n";
    }

    // Inside a page the XML declaration is out of place.
    [[nodiscard]] std::string svg_without_declaration() const {
        const std::size_t at = input_.drawing_svg.find("<svg");
        return at == std::string::npos ? std::string{} : input_.drawing_svg.substr(at);
    }

    void row(std::string_view name, std::string_view value) {
        if (value.empty()) return;
        out_ += fmt::format("<tr><th>{}</th><td>{}</td></tr>\n", xml_escaped(name), xml_escaped(value));
    }

    void relation_rows(const model::StratigraphicUnit& unit) {
        const auto it = of_unit_.find(unit.id);
        if (it == of_unit_.end()) return;
        std::map<std::string_view, std::vector<std::string>> by_phrase;
        for (const model::PhysicalRelation* relation : it->second) {
            const bool from_subject = relation->subject == unit.id;
            by_phrase[from_subject ? phrase(relation->kind) : inverse_phrase(relation->kind)].push_back(
                link(from_subject ? relation->object : relation->subject) +
                (relation->certainty == model::Certainty::Uncertain ? "?" : ""));
        }
        for (const auto& [words, others] : by_phrase) {
            out_ += fmt::format("<tr><th>{}</th><td>{}</td></tr>\n", xml_escaped(words), text::join(others, ", "));
        }
    }

    void units() {
        std::unordered_map<model::PhaseId, std::string> phases;
        for (const model::Phase& phase : record_.phases) {
            phases.emplace(phase.id, phase.title.empty() ? phase.number : phase.number + " " + phase.title);
        }
        out_ += "<h2 id=\"units\">Units</h2>\n";
        for (const model::StratigraphicUnit& unit : record_.units) {
            if (!input_.day.empty() && !input_.of_day.contains(unit.id)) continue;
            const bool mentioned = unit.origin == model::UnitOrigin::Mentioned;
            out_ += fmt::format("<section class=\"unit\"><h3 id=\"u-{}\">{} {}</h3>\n<table>\n", unit.id.to_string(),
                                xml_escaped(index_.name(unit.id)), xml_escaped(unit.title));
            row("kind", fmt::format("{} {}", to_word(unit.kind), to_word(unit.form)));
            row("status", mentioned ? "only mentioned, no sheet" : to_word(unit.status));
            const auto phase = phases.find(unit.phase);
            if (phase != phases.end()) row("phase", phase->second);
            row("description", unit.description);
            row("interpretation", unit.interpretation);
            row("excavated", unit.excavated_on);
            row("recorded by", unit.recorded_by);
            for (const auto& [name, value] : unit.details) row(name, value);
            relation_rows(unit);
            for (const model::Level* level : levels_[unit.id]) {
                row(fmt::format("level, {}", to_word(level->role)), fmt::format("{} m", level->z));
            }
            for (const model::Find* find : finds_[unit.id]) {
                row("find " + find->number, fmt::format("{} {}", find->type, find->description));
            }
            out_ += "</table></section>\n";
        }
        if (!input_.day.empty()) neighbours();
    }

    // What the day's units touch, in a line each: their sheets belong to other days.
    void neighbours() {
        if (record_.units.size() == input_.of_day.size()) return;
        out_ += "<h2>Beside them</h2>\n<table>\n";
        for (const model::StratigraphicUnit& unit : record_.units) {
            if (input_.of_day.contains(unit.id)) continue;
            out_ += fmt::format("<tr><th id=\"u-{}\">{}</th><td>{}</td><td>{}</td></tr>\n", unit.id.to_string(),
                                xml_escaped(index_.name(unit.id)),
                                xml_escaped(fmt::format("{} {}", to_word(unit.kind), to_word(unit.form))),
                                xml_escaped(unit.title));
        }
        out_ += "</table>\n";
    }

    const ReportInput& input_;
    const model::Record& record_;
    model::RecordIndex index_;
    bool on_paper_ = false;
    std::unordered_map<model::UnitId, std::vector<const model::PhysicalRelation*>> of_unit_;
    std::unordered_map<model::UnitId, std::vector<const model::Level*>> levels_;
    std::unordered_map<model::UnitId, std::vector<const model::Find*>> finds_;
    std::string out_;
};

} // namespace

std::string write_html_report(const ReportInput& input, HtmlFor medium) { return Page(input, medium).write(); }

} // namespace planum::app
