// SPDX-License-Identifier: MIT
#include "strat/checks/finish.hpp"

#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>

#include "core/base/sha256.hpp"

namespace planum::strat {

namespace {

constexpr std::size_t kIdDigits = 12;

std::string unit_text(const CheckContext& c, model::UnitId id) {
    const UnitIndex u = c.index.find(id);
    return u == model::kNoUnit ? std::string{"?"} : c.full_name(u);
}

std::vector<std::string> named_parts(const CheckContext& c, const model::Diagnostic& d) {
    std::vector<std::string> units;
    units.reserve(d.units.size() + d.relations.size());
    for (const model::UnitId id : d.units) units.push_back(unit_text(c, id));
    std::sort(units.begin(), units.end());
    std::vector<std::string> relations;
    relations.reserve(d.relations.size());
    for (const model::NamedRelation& r : d.relations) {
        relations.push_back(
            fmt::format("{}\t{}\t{}", unit_text(c, r.unit), model::to_word(r.kind), unit_text(c, r.other)));
    }
    std::sort(relations.begin(), relations.end());
    units.insert(units.end(), relations.begin(), relations.end());
    return units;
}

std::string short_hash(std::string_view code, const std::vector<std::string>& parts) {
    std::string text{code};
    for (const std::string& part : parts) {
        text += '\n';
        text += part;
    }
    return sha256(text).substr(0, kIdDigits);
}

// One of many: says how many and names a few; keeps all units.
model::Diagnostic bundle(const CheckContext& c, std::vector<model::Diagnostic> alike) {
    model::Diagnostic one = make_diagnostic(alike.front().severity, alike.front().code, {});
    std::vector<std::string> names;
    for (const model::Diagnostic& d : alike) {
        one.units.insert(one.units.end(), d.units.begin(), d.units.end());
        one.relations.insert(one.relations.end(), d.relations.begin(), d.relations.end());
        if (names.size() >= 5) continue;
        if (!d.units.empty()) {
            names.push_back(c.index.name(d.units.front()));
        } else if (const auto scan = d.evidence.find("scan"); scan != d.evidence.end()) {
            names.push_back(std::get<std::string>(scan->second));
        } else if (const auto surface = d.evidence.find("surface"); surface != d.evidence.end()) {
            names.push_back("one on " + std::get<std::string>(surface->second));
        } else if (const auto drawn = d.evidence.find("drawn_as"); drawn != d.evidence.end()) {
            const auto& number = std::get<std::string>(drawn->second);
            names.push_back(number.empty() ? "one without a number" : number);
        }
    }
    std::string what = one.code;
    if (one.code == "isolated-unit") what = "units stand in no order to any other unit";
    if (one.code == "unit-without-region") what = "units are outlined on no surface and in no section";
    if (one.code == "region-without-unit") what = "outlines belong to no unit of the project";
    if (one.code == "scan-unregistered") what = "scans are not on the site grid (planum register)";
    if (one.code == "scan-poorly-registered") what = "scans are placed poorly";
    if (one.code == "surface-changed-within") what = "patches of ground on which scans of one surface disagree";
    if (one.code == "surface-rose") what = "patches of ground rose";
    if (one.code == "dangling-unit") what = "units are named in relations but have no sheet of their own";
    one.message = fmt::format("{} {}, among them {}", alike.size(), what, list_names(names, names.size()));
    one.evidence["count"] = static_cast<std::int64_t>(alike.size());
    return one;
}

// Infos, and the one warning that a list without sheets would repeat for half of its units.
bool may_be_bundled(const model::Diagnostic& d) {
    return d.severity == model::Severity::Info || d.code == "dangling-unit";
}

void bundle_infos(const CheckContext& c, Findings& findings) {
    std::map<std::string, std::vector<model::Diagnostic>> infos;
    Findings rest;
    for (model::Diagnostic& d : findings) {
        if (may_be_bundled(d)) {
            infos[d.code].push_back(std::move(d));
        } else {
            rest.push_back(std::move(d));
        }
    }
    for (auto& [code, alike] : infos) {
        if (alike.size() > c.options.alike_become_one) {
            rest.push_back(bundle(c, std::move(alike)));
        } else {
            std::move(alike.begin(), alike.end(), std::back_inserter(rest));
        }
    }
    findings = std::move(rest);
}

} // namespace

std::string diagnostic_id(const CheckContext& context, const model::Diagnostic& d) {
    // One line for many stays the same problem while the many come and go.
    if (may_be_bundled(d) && d.evidence.contains("count")) return short_hash(d.code, {"all"});
    std::vector<std::string> parts;
    if (!d.units.empty()) {
        parts = named_parts(context, d);
    }
    // Two finds may lie outside one unit; a line without units has nothing but its text.
    const auto add_text = [&](const std::string& key) {
        const auto it = d.evidence.find(key);
        if (it == d.evidence.end()) return;
        if (const auto* text = std::get_if<std::string>(&it->second)) parts.push_back(key + "=" + *text);
    };
    for (const std::string key :
         {"find", "source", "file", "note", "text", "scan", "region", "other_region", "surface", "since"})
        add_text(key);
    return short_hash(d.code, parts);
}

std::string evidence_hash(const CheckContext& context, const model::Diagnostic& d) {
    std::vector<std::string> parts = named_parts(context, d);
    for (const auto& [key, value] : d.evidence) {
        // Which cycle is shown as proof, and how the suspects stand, may change without the problem doing so.
        if (key.starts_with("cycle_") || key == "exact" || key == "cannot_tell" || key == "removals" || key == "line")
            continue;

        struct Visitor {
            std::string operator()(std::int64_t number) const { return number < 0 ? "-" : number > 0 ? "+" : "0"; }

            std::string operator()(double number) const { return number < 0.0 ? "-" : number > 0.0 ? "+" : "0"; }

            std::string operator()(const std::string& text) const { return text; }
        };

        parts.push_back(key + "=" + std::visit(Visitor{}, value));
    }
    return short_hash(d.code, parts);
}

void finish(const CheckContext& context, Findings& findings) {
    bundle_infos(context, findings);
    std::map<std::string, int> seen;

    struct Keyed {
        model::Severity severity;
        std::string code;
        std::vector<UnitIndex> units;
        std::string message;
        std::size_t at;
    };

    std::vector<Keyed> order;
    for (std::size_t i = 0; i < findings.size(); ++i) {
        const model::Diagnostic& d = findings[i];
        Keyed key{d.severity, d.code, {}, d.message, i};
        // Three units tell any two apart in practice; the message settles the rest.
        for (std::size_t u = 0; u < std::min<std::size_t>(d.units.size(), 3); ++u)
            key.units.push_back(context.index.find(d.units[u]));
        order.push_back(std::move(key));
    }
    std::sort(order.begin(), order.end(), [](const Keyed& a, const Keyed& b) {
        return std::tie(a.severity, a.code, a.units, a.message, a.at) <
               std::tie(b.severity, b.code, b.units, b.message, b.at);
    });
    Findings sorted;
    sorted.reserve(findings.size());
    for (const Keyed& key : order) sorted.push_back(std::move(findings[key.at]));
    findings = std::move(sorted);
    for (model::Diagnostic& d : findings) {
        d.id = diagnostic_id(context, d);
        // The same line twice in one file: the second of them is a problem of its own.
        if (const int again = seen[d.id]++; again > 0) d.id = short_hash(d.id, {std::to_string(again)});
        d.evidence_hash = evidence_hash(context, d);
    }
}

} // namespace planum::strat
