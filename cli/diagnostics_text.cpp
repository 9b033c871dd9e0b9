// SPDX-License-Identifier: MIT
#include "cli/diagnostics_text.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace planum::cli {

using nlohmann::ordered_json;

namespace {

ordered_json relation_json(const model::NamedRelation& named, const model::RecordIndex& index) {
    return {{"unit", index.name(named.unit)}, {"kind", to_word(named.kind)}, {"other", index.name(named.other)}};
}

struct SuspectJson {
    const model::RecordIndex& index;
    ordered_json& json;

    void operator()(const model::SuspectRelation& s) const { json["relation"] = relation_json(s.relation, index); }

    void operator()(const model::SuspectSameAs& s) const {
        json["same_as"] = {index.name(s.same_as.unit), index.name(s.same_as.other)};
    }

    void operator()(const model::SuspectNumber& s) const {
        json["number"] = s.written;
        json["probably"] = s.probably;
        json["relation"] = relation_json(s.relation, index);
    }

    void operator()(const model::SuspectUnit& s) const { json["unit"] = index.name(s.unit); }
};

struct SuspectWords {
    const model::RecordIndex& index;

    [[nodiscard]] std::string sentence(const model::NamedRelation& named) const {
        return fmt::format("{} {} {}", index.name(named.unit), phrase(named.kind), index.name(named.other));
    }

    std::string operator()(const model::SuspectRelation& s) const { return sentence(s.relation); }

    std::string operator()(const model::SuspectSameAs& s) const { return sentence(s.same_as); }

    std::string operator()(const model::SuspectNumber& s) const {
        return fmt::format("the number {} in “{}”, probably {}", s.written, sentence(s.relation), s.probably);
    }

    std::string operator()(const model::SuspectUnit& s) const { return "unit " + index.name(s.unit); }
};

} // namespace

ordered_json to_json(const model::Diagnostic& diagnostic, const model::RecordIndex& index) {
    ordered_json json;
    json["id"] = diagnostic.id;
    json["code"] = diagnostic.code;
    json["severity"] = to_word(diagnostic.severity);
    json["units"] = ordered_json::array();
    for (const model::UnitId unit : diagnostic.units) json["units"].push_back(index.name(unit));
    json["relations"] = ordered_json::array();
    for (const model::NamedRelation& named : diagnostic.relations) {
        json["relations"].push_back(relation_json(named, index));
    }
    json["message"] = diagnostic.message;
    json["evidence"] = ordered_json::object();
    for (const auto& [name, value] : diagnostic.evidence) {
        std::visit([&](const auto& v) { json["evidence"][name] = v; }, value);
    }
    json["suspects"] = ordered_json::array();
    for (const model::Suspect& suspect : diagnostic.suspects) {
        ordered_json entry;
        std::visit(SuspectJson{index, entry}, suspect.what);
        entry["score"] = suspect.score;
        entry["reasons"] = suspect.reasons;
        json["suspects"].push_back(std::move(entry));
    }
    return json;
}

ordered_json to_json(const model::Coverage& coverage) {
    ordered_json untestable = ordered_json::object();
    for (const auto& [reason, count] : coverage.untestable) untestable[reason] = count;
    return {{"relations", coverage.relations},
            {"confirmed", coverage.confirmed},
            {"contradicted", coverage.contradicted},
            {"untestable", untestable}};
}

std::string describe(const model::Suspect& suspect, const model::RecordIndex& index) {
    return std::visit(SuspectWords{index}, suspect.what);
}

} // namespace planum::cli
