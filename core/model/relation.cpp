// SPDX-License-Identifier: MIT
#include "core/model/relation.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "core/base/text.hpp"
#include "core/model/words.hpp"

namespace planum::model {

namespace {

constexpr std::array kKindWords = {
    std::pair{RelationKind::Covers, std::string_view{"covers"}},
    std::pair{RelationKind::Cuts, std::string_view{"cuts"}},
    std::pair{RelationKind::Fills, std::string_view{"fills"}},
    std::pair{RelationKind::Abuts, std::string_view{"abuts"}},
    std::pair{RelationKind::BondsWith, std::string_view{"bonds_with"}},
    std::pair{RelationKind::SameAs, std::string_view{"same_as"}},
    std::pair{RelationKind::Borders, std::string_view{"borders"}},
    std::pair{RelationKind::Later, std::string_view{"later"}},
    std::pair{RelationKind::Contemporary, std::string_view{"contemporary"}},
};

constexpr std::array kCertaintyWords = {
    std::pair{Certainty::Certain, std::string_view{"certain"}},
    std::pair{Certainty::Uncertain, std::string_view{"uncertain"}},
};

constexpr std::array kSideWords = {
    std::pair{StatementSide::Subject, std::string_view{"subject"}},
    std::pair{StatementSide::Object, std::string_view{"object"}},
    std::pair{StatementSide::Neither, std::string_view{"neither"}},
};

struct RelationWord {
    std::string_view word; ///< folded, blanks for underscores and hyphens
    DirectedKind meaning;
};

constexpr DirectedKind forward(RelationKind kind) { return {kind, false}; }

constexpr DirectedKind backward(RelationKind kind) { return {kind, true}; }

constexpr std::array kAnyWords = {
    // English
    RelationWord{"covers", forward(RelationKind::Covers)},
    RelationWord{"above", forward(RelationKind::Covers)},
    RelationWord{"overlies", forward(RelationKind::Covers)},
    RelationWord{"over", forward(RelationKind::Covers)},
    RelationWord{"seals", forward(RelationKind::Covers)},
    RelationWord{"covered by", backward(RelationKind::Covers)},
    RelationWord{"is covered by", backward(RelationKind::Covers)},
    RelationWord{"below", backward(RelationKind::Covers)},
    RelationWord{"under", backward(RelationKind::Covers)},
    RelationWord{"underlies", backward(RelationKind::Covers)},
    RelationWord{"sealed by", backward(RelationKind::Covers)},
    RelationWord{"cuts", forward(RelationKind::Cuts)},
    RelationWord{"cut by", backward(RelationKind::Cuts)},
    RelationWord{"is cut by", backward(RelationKind::Cuts)},
    RelationWord{"fills", forward(RelationKind::Fills)},
    RelationWord{"fill of", forward(RelationKind::Fills)},
    RelationWord{"filled by", backward(RelationKind::Fills)},
    RelationWord{"is filled by", backward(RelationKind::Fills)},
    RelationWord{"abuts", forward(RelationKind::Abuts)},
    RelationWord{"abutted by", backward(RelationKind::Abuts)},
    RelationWord{"is abutted by", backward(RelationKind::Abuts)},
    RelationWord{"supports", backward(RelationKind::Abuts)},
    RelationWord{"bonds with", forward(RelationKind::BondsWith)},
    RelationWord{"bonded with", forward(RelationKind::BondsWith)},
    RelationWord{"bonded to", forward(RelationKind::BondsWith)},
    RelationWord{"connected to", forward(RelationKind::BondsWith)},
    RelationWord{"same as", forward(RelationKind::SameAs)},
    RelationWord{"is the same as", forward(RelationKind::SameAs)},
    RelationWord{"same", forward(RelationKind::SameAs)},
    RelationWord{"equal to", forward(RelationKind::SameAs)},
    RelationWord{"equals", forward(RelationKind::SameAs)},
    RelationWord{"equal", forward(RelationKind::SameAs)},
    RelationWord{"identical to", forward(RelationKind::SameAs)},
    RelationWord{"borders", forward(RelationKind::Borders)},
    RelationWord{"adjacent to", forward(RelationKind::Borders)},
    RelationWord{"later", forward(RelationKind::Later)},
    RelationWord{"later than", forward(RelationKind::Later)},
    RelationWord{"is later than", forward(RelationKind::Later)},
    RelationWord{"after", forward(RelationKind::Later)},
    RelationWord{"earlier", backward(RelationKind::Later)},
    RelationWord{"earlier than", backward(RelationKind::Later)},
    RelationWord{"is earlier than", backward(RelationKind::Later)},
    RelationWord{"before", backward(RelationKind::Later)},
    RelationWord{"contemporary", forward(RelationKind::Contemporary)},
    RelationWord{"contemporary with", forward(RelationKind::Contemporary)},
    RelationWord{"is contemporary with", forward(RelationKind::Contemporary)},
    RelationWord{"same time as", forward(RelationKind::Contemporary)},
    // German
    RelationWord{"liegt über", forward(RelationKind::Covers)},
    RelationWord{"über", forward(RelationKind::Covers)},
    RelationWord{"überlagert", forward(RelationKind::Covers)},
    RelationWord{"liegt unter", backward(RelationKind::Covers)},
    RelationWord{"unter", backward(RelationKind::Covers)},
    RelationWord{"überlagert von", backward(RelationKind::Covers)},
    RelationWord{"wird überlagert von", backward(RelationKind::Covers)},
    RelationWord{"überdeckt", forward(RelationKind::Covers)},
    RelationWord{"überdeckt von", backward(RelationKind::Covers)},
    RelationWord{"wird überdeckt von", backward(RelationKind::Covers)},
    RelationWord{"bedeckt", forward(RelationKind::Covers)},
    RelationWord{"bedeckt von", backward(RelationKind::Covers)},
    RelationWord{"wird bedeckt von", backward(RelationKind::Covers)},
    RelationWord{"schneidet", forward(RelationKind::Cuts)},
    RelationWord{"wird geschnitten von", backward(RelationKind::Cuts)},
    RelationWord{"geschnitten von", backward(RelationKind::Cuts)},
    RelationWord{"verfüllt", forward(RelationKind::Fills)},
    RelationWord{"verfüllung von", forward(RelationKind::Fills)},
    RelationWord{"verfüllt von", backward(RelationKind::Fills)},
    RelationWord{"wird verfüllt von", backward(RelationKind::Fills)},
    RelationWord{"stößt an", forward(RelationKind::Abuts)},
    RelationWord{"wird angestoßen von", backward(RelationKind::Abuts)},
    RelationWord{"angestoßen von", backward(RelationKind::Abuts)},
    RelationWord{"bindet ein", forward(RelationKind::BondsWith)},
    RelationWord{"im verband mit", forward(RelationKind::BondsWith)},
    RelationWord{"identisch mit", forward(RelationKind::SameAs)},
    RelationWord{"gleich", forward(RelationKind::SameAs)},
    RelationWord{"grenzt an", forward(RelationKind::Borders)},
    RelationWord{"zeitlich nach", forward(RelationKind::Later)},
    RelationWord{"jünger als", forward(RelationKind::Later)},
    RelationWord{"nach", forward(RelationKind::Later)},
    RelationWord{"zeitlich vor", backward(RelationKind::Later)},
    RelationWord{"älter als", backward(RelationKind::Later)},
    RelationWord{"vor", backward(RelationKind::Later)},
    RelationWord{"zeitgleich mit", forward(RelationKind::Contemporary)},
    RelationWord{"zeitgleich", forward(RelationKind::Contemporary)},
    // Italian
    RelationWord{"copre", forward(RelationKind::Covers)},
    RelationWord{"sopra a", forward(RelationKind::Covers)},
    RelationWord{"coperto da", backward(RelationKind::Covers)},
    RelationWord{"coperta da", backward(RelationKind::Covers)},
    RelationWord{"sotto a", backward(RelationKind::Covers)},
    RelationWord{"taglia", forward(RelationKind::Cuts)},
    RelationWord{"tagliato da", backward(RelationKind::Cuts)},
    RelationWord{"tagliata da", backward(RelationKind::Cuts)},
    RelationWord{"riempie", forward(RelationKind::Fills)},
    RelationWord{"riempito da", backward(RelationKind::Fills)},
    RelationWord{"riempita da", backward(RelationKind::Fills)},
    RelationWord{"si appoggia a", forward(RelationKind::Abuts)},
    RelationWord{"si appoggia", forward(RelationKind::Abuts)},
    RelationWord{"gli si appoggia", backward(RelationKind::Abuts)},
    RelationWord{"le si appoggia", backward(RelationKind::Abuts)},
    RelationWord{"si lega a", forward(RelationKind::BondsWith)},
    RelationWord{"uguale a", forward(RelationKind::SameAs)},
    RelationWord{"confina con", forward(RelationKind::Borders)},
    RelationWord{"posteriore a", forward(RelationKind::Later)},
    RelationWord{"anteriore a", backward(RelationKind::Later)},
    RelationWord{"contemporaneo a", forward(RelationKind::Contemporary)},
    RelationWord{"contemporanea a", forward(RelationKind::Contemporary)},
    // French
    RelationWord{"sur", forward(RelationKind::Covers)},
    RelationWord{"couvre", forward(RelationKind::Covers)},
    RelationWord{"recouvre", forward(RelationKind::Covers)},
    RelationWord{"sous", backward(RelationKind::Covers)},
    RelationWord{"couvert par", backward(RelationKind::Covers)},
    RelationWord{"couverte par", backward(RelationKind::Covers)},
    RelationWord{"coupe", forward(RelationKind::Cuts)},
    RelationWord{"coupée par", backward(RelationKind::Cuts)},
    RelationWord{"coupé par", backward(RelationKind::Cuts)},
    RelationWord{"remplit", forward(RelationKind::Fills)},
    RelationWord{"remplie par", backward(RelationKind::Fills)},
    RelationWord{"rempli par", backward(RelationKind::Fills)},
    RelationWord{"bute contre", forward(RelationKind::Abuts)},
    RelationWord{"s'appuie sur", forward(RelationKind::Abuts)},
    RelationWord{"identique à", forward(RelationKind::SameAs)},
    RelationWord{"équivalent à", forward(RelationKind::SameAs)},
    RelationWord{"adjacente à", forward(RelationKind::Borders)},
    RelationWord{"adjacent à", forward(RelationKind::Borders)},
    RelationWord{"postérieure à", forward(RelationKind::Later)},
    RelationWord{"postérieur à", forward(RelationKind::Later)},
    RelationWord{"antérieure à", backward(RelationKind::Later)},
    RelationWord{"antérieur à", backward(RelationKind::Later)},
    RelationWord{"contemporaine à", forward(RelationKind::Contemporary)},
    RelationWord{"contemporain de", forward(RelationKind::Contemporary)},
    // Extended Matrix and pyArchInit symbols
    RelationWord{">>", forward(RelationKind::Later)},
    RelationWord{">", forward(RelationKind::Later)},
    RelationWord{"<<", backward(RelationKind::Later)},
    RelationWord{"<", backward(RelationKind::Later)},
};

} // namespace

TimeMeaning time_meaning(RelationKind kind) noexcept {
    switch (kind) {
    case RelationKind::Covers:
    case RelationKind::Cuts:
    case RelationKind::Fills:
    case RelationKind::Abuts:
    case RelationKind::Later: return TimeMeaning::SubjectLater;
    case RelationKind::SameAs: return TimeMeaning::SameUnit;
    case RelationKind::BondsWith:
    case RelationKind::Contemporary: return TimeMeaning::SameTime;
    case RelationKind::Borders: return TimeMeaning::None;
    }
    return TimeMeaning::None;
}

bool is_symmetric(RelationKind kind) noexcept { return time_meaning(kind) != TimeMeaning::SubjectLater; }

std::string_view to_word(RelationKind kind) noexcept { return detail::word_of(kKindWords, kind); }

std::string_view to_word(Certainty certainty) noexcept { return detail::word_of(kCertaintyWords, certainty); }

std::string_view to_word(StatementSide side) noexcept { return detail::word_of(kSideWords, side); }

std::optional<RelationKind> relation_kind_from_word(std::string_view word) noexcept {
    return detail::value_of(kKindWords, word);
}

std::optional<Certainty> certainty_from_word(std::string_view word) noexcept {
    return detail::value_of(kCertaintyWords, word);
}

std::optional<StatementSide> side_from_word(std::string_view word) noexcept {
    return detail::value_of(kSideWords, word);
}

std::string_view inverse_phrase(RelationKind kind) noexcept {
    switch (kind) {
    case RelationKind::Covers: return "is covered by";
    case RelationKind::Cuts: return "is cut by";
    case RelationKind::Fills: return "is filled by";
    case RelationKind::Abuts: return "is abutted by";
    case RelationKind::Later: return "is earlier than";
    case RelationKind::BondsWith:
    case RelationKind::SameAs:
    case RelationKind::Borders:
    case RelationKind::Contemporary: return phrase(kind);
    }
    return {};
}

std::string_view phrase(RelationKind kind) noexcept {
    switch (kind) {
    case RelationKind::Covers: return "covers";
    case RelationKind::Cuts: return "cuts";
    case RelationKind::Fills: return "fills";
    case RelationKind::Abuts: return "abuts";
    case RelationKind::BondsWith: return "bonds with";
    case RelationKind::SameAs: return "is the same as";
    case RelationKind::Borders: return "borders";
    case RelationKind::Later: return "is later than";
    case RelationKind::Contemporary: return "is contemporary with";
    }
    return {};
}

std::optional<DirectedKind> relation_from_any_word(std::string_view word) {
    std::string folded = text::fold_case(text::trim(word));
    std::replace(folded.begin(), folded.end(), '_', ' ');
    std::replace(folded.begin(), folded.end(), '-', ' ');
    // "covered   by", "> >": blanks count as one, and not at all between signs.
    std::string squeezed;
    for (const char c : folded) {
        if (c == ' ' && (squeezed.empty() || squeezed.back() == ' ')) continue;
        squeezed.push_back(c);
    }
    if (squeezed == "> >") squeezed = ">>";
    if (squeezed == "< <") squeezed = "<<";
    for (const RelationWord& entry : kAnyWords) {
        if (entry.word == squeezed) return entry.meaning;
    }
    return std::nullopt;
}

} // namespace planum::model
