// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/model/ids.hpp"

namespace planum::model {

/// What was observed between two units, read from the subject: `1042 cuts 1017`. Later and
/// Contemporary are stated in time without a contact.
enum class RelationKind { Covers, Cuts, Fills, Abuts, BondsWith, SameAs, Borders, Later, Contemporary };

enum class Certainty { Certain, Uncertain };

/// What a kind says about time when read from the subject.
enum class TimeMeaning { SubjectLater, SameUnit, SameTime, None };

/// One observation, stored once whichever side it was written down from. For symmetric kinds
/// (bonds_with, same_as, borders, contemporary) the subject is the one whose number sorts first.
struct PhysicalRelation {
    RelationId id;
    UnitId subject;
    RelationKind kind = RelationKind::Covers;
    UnitId object;
    Certainty certainty = Certainty::Certain;
    bool correlation = false; ///< same_as across a gap (correlated) rather than identical

    friend bool operator==(const PhysicalRelation&, const PhysicalRelation&) = default;
};

/// From whose sheet a statement was made.
enum class StatementSide { Subject, Object, Neither };

/// Who said it. A relation has all its statements; reciprocity, duplicates and weights count them.
struct RelationStatement {
    StatementId id;
    RelationId relation;
    StatementSide side = StatementSide::Subject;
    SourceId source;       ///< file it was read from; nil when typed in
    std::int64_t line = 0; ///< in that file, from 1; 0 unknown
    std::string person;
    std::string raw_text;  ///< as it was written
    std::string stated_at; ///< ISO time

    friend bool operator==(const RelationStatement&, const RelationStatement&) = default;
};

[[nodiscard]] TimeMeaning time_meaning(RelationKind kind) noexcept;
[[nodiscard]] bool is_symmetric(RelationKind kind) noexcept;

/// `covers`, `cuts`, …, `contemporary`.
[[nodiscard]] std::string_view to_word(RelationKind kind) noexcept;
[[nodiscard]] std::string_view to_word(Certainty certainty) noexcept;
[[nodiscard]] std::string_view to_word(StatementSide side) noexcept;
[[nodiscard]] std::optional<RelationKind> relation_kind_from_word(std::string_view word) noexcept;
[[nodiscard]] std::optional<Certainty> certainty_from_word(std::string_view word) noexcept;
[[nodiscard]] std::optional<StatementSide> side_from_word(std::string_view word) noexcept;

/// The kind read from the object's side in English: `covered by`, `cut by`, ….
[[nodiscard]] std::string_view inverse_phrase(RelationKind kind) noexcept;
/// The kind as a verb in a sentence: `covers`, `bonds with`, `is later than`, ….
[[nodiscard]] std::string_view phrase(RelationKind kind) noexcept;

struct DirectedKind {
    RelationKind kind = RelationKind::Covers;
    bool inverse = false; ///< the word was said from the object's side ("covered by")

    friend bool operator==(const DirectedKind&, const DirectedKind&) = default;
};

/// What a relation word of any of the four languages means, without regard to case, blanks,
/// underscores or hyphens: `covers`, `covered_by`, `liegt über`, `Coperto da`, `>>`. nullopt when unknown.
[[nodiscard]] std::optional<DirectedKind> relation_from_any_word(std::string_view word);

} // namespace planum::model
