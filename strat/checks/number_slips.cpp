// SPDX-License-Identifier: MIT
#include <algorithm>

#include <fmt/format.h>

#include "strat/checks/relation_weights.hpp"

namespace planum::strat {

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

} // namespace

bool one_slip_apart(std::string_view a, std::string_view b) noexcept {
    if (a.size() != b.size() || a.size() < 2) return false; // every digit is one slip from every other
    std::size_t differ = 0;
    std::size_t first = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (a[i] == b[i]) continue;
        if (!is_digit(a[i]) || !is_digit(b[i])) return false;
        if (differ == 0) first = i;
        if (++differ > 2) return false;
    }
    if (differ == 1) return true;
    return differ == 2 && a[first] == b[first + 1] && a[first + 1] == b[first];
}

std::vector<std::string> one_slip_away(std::string_view number) {
    std::vector<std::string> texts;
    std::string text{number};
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (!is_digit(text[i])) continue;
        const char was = text[i];
        for (char digit = '0'; digit <= '9'; ++digit) {
            if (digit == was) continue;
            text[i] = digit;
            texts.push_back(text);
        }
        text[i] = was;
        if (i + 1 < text.size() && is_digit(text[i + 1]) && text[i + 1] != was) {
            std::swap(text[i], text[i + 1]);
            texts.push_back(text);
            std::swap(text[i], text[i + 1]);
        }
    }
    return texts;
}

// Whether `meant` lies where a relation with the other end could be: not the other end itself, not void.
bool RelationWeights::fits_as_meant(RelationIndex relation, UnitIndex meant, UnitIndex written) const {
    const UnitIndex other = c_.subject[relation] == written ? c_.object[relation] : c_.subject[relation];
    return meant != other && meant != written && !c_.is_void(meant);
}

std::optional<RelationWeights::Slip> RelationWeights::reciprocal_slip(RelationIndex relation) const {
    const StatedSides& stated = c_.stated[relation];
    if (!stated.only_subject() && !stated.only_object()) return std::nullopt;
    // The sheet's own number is printed or at least familiar; the slip is in the other one.
    const bool on_subjects_sheet = stated.only_subject();
    const UnitIndex fixed = on_subjects_sheet ? c_.subject[relation] : c_.object[relation];
    const UnitIndex written = on_subjects_sheet ? c_.object[relation] : c_.subject[relation];
    constexpr std::size_t kLookedAt = 64; // a unit with more contacts than this is topsoil
    const auto around = c_.relations_of(fixed);
    for (std::size_t i = 0; i < std::min(around.size(), kLookedAt); ++i) {
        const RelationIndex r = around[i];
        if (r == relation || !c_.states_order(r)) continue;
        const bool same_side = on_subjects_sheet ? c_.subject[r] == fixed : c_.object[r] == fixed;
        const bool other_sheet_only = on_subjects_sheet ? c_.stated[r].only_object() : c_.stated[r].only_subject();
        if (!same_side || !other_sheet_only || c_.record.relations[r].kind != c_.record.relations[relation].kind)
            continue;
        const UnitIndex meant = on_subjects_sheet ? c_.object[r] : c_.subject[r];
        const std::string& a = c_.unit(written).number;
        const std::string& b = c_.unit(meant).number;
        if (!fits_as_meant(relation, meant, written) || (a != b && !one_slip_apart(a, b))) continue;
        // Among two-digit numbers a chance neighbour is a slip away all too often.
        Slip slip{written, meant, true, a.size() > 2 ? 3.0 : 1.5, {}};
        slip.why = fmt::format("the sheet of {} states this relation with {}, whose own sheet names {} instead",
                               c_.name(meant), c_.name(fixed), c_.name(written));
        return slip;
    }
    return std::nullopt;
}

std::optional<RelationWeights::Slip> RelationWeights::best_slip(RelationIndex relation) const {
    if (auto slip = reciprocal_slip(relation)) return slip;
    const StatedSides& stated = c_.stated[relation];
    if (stated.both()) return std::nullopt;
    const std::uint32_t group = c_.matrix.component_of(c_.matrix.node_of(c_.subject[relation]));
    std::optional<Slip> best;
    const auto consider = [&](UnitIndex fixed, UnitIndex written) {
        std::vector<std::string> texts = one_slip_away(c_.unit(written).number);
        texts.push_back(c_.unit(written).number); // the same number in another area
        for (const std::string& text : texts) {
            for (const UnitIndex meant : c_.index.named(text)) {
                if (!fits_as_meant(relation, meant, written)) continue;
                if (text != c_.unit(written).number && c_.unit(meant).area != c_.unit(written).area) continue;
                if (c_.matrix.component_of(c_.matrix.node_of(meant)) == group) continue;
                const auto near = plan_distance(fixed, meant);
                const auto far = plan_distance(fixed, written);
                Slip slip{written, meant, false, 0.0, {}};
                if (near && far) slip.fit += *near < 0.5 * *far ? 1.0 : -1.0;
                if (c_.unit(meant).area == c_.unit(fixed).area) slip.fit += 0.5;
                if (c_.unit(meant).kind != c_.unit(written).kind) slip.fit -= 1.0;
                if (slip.fit < 1.0 || (best && slip.fit <= best->fit)) continue;
                const bool meant_earlier = fixed == c_.subject[relation];
                const NodeIndex later = c_.matrix.node_of(meant_earlier ? fixed : meant);
                const NodeIndex earlier = c_.matrix.node_of(meant_earlier ? meant : fixed);
                if (c_.matrix.is_later(earlier, later)) continue;
                slip.why = fmt::format("{}, one slip of the pen away, lies nearer to {} and would close no circle",
                                       c_.name(meant), c_.name(fixed));
                best = slip;
            }
        }
    };
    if (!stated.only_object()) consider(c_.subject[relation], c_.object[relation]);
    if (!stated.only_subject()) consider(c_.object[relation], c_.subject[relation]);
    return best;
}

} // namespace planum::strat
