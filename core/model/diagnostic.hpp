// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/model/ids.hpp"
#include "core/model/relation.hpp"

namespace planum::model {

enum class Severity { Error, Warning, Info };

/// A relation as a diagnostic names it: `unit kind other`.
struct NamedRelation {
    RelationId relation; ///< nil for one that is derived
    UnitId unit;
    RelationKind kind = RelationKind::Covers;
    UnitId other;

    friend bool operator==(const NamedRelation&, const NamedRelation&) = default;
};

/// What to doubt: a relation; a same_as pair; a number that may be mistyped or used twice; a unit that
/// may be two.
struct SuspectRelation {
    NamedRelation relation;
    friend bool operator==(const SuspectRelation&, const SuspectRelation&) = default;
};

struct SuspectSameAs {
    NamedRelation same_as;
    friend bool operator==(const SuspectSameAs&, const SuspectSameAs&) = default;
};

struct SuspectNumber {
    NamedRelation relation; ///< in which it is written
    std::string written;    ///< the number as it stands there
    std::string probably;   ///< the number that would break the cycle
    friend bool operator==(const SuspectNumber&, const SuspectNumber&) = default;
};

struct SuspectUnit {
    UnitId unit;
    friend bool operator==(const SuspectUnit&, const SuspectUnit&) = default;
};

struct Suspect {
    std::variant<SuspectRelation, SuspectSameAs, SuspectNumber, SuspectUnit> what;
    double score = 0.0;               ///< share of suspicion within its diagnostic, 0…1
    std::vector<std::string> reasons; ///< sentences a digger understands

    friend bool operator==(const Suspect&, const Suspect&) = default;
};

using EvidenceValue = std::variant<std::int64_t, double, std::string>;

/// What a check says. The id is a hash of code, units and relations, so that it stays the same from day
/// to day; what it was concluded from is hashed apart.
struct Diagnostic {
    std::string id; ///< 12 hexadecimal digits, set by finish()
    Severity severity = Severity::Warning;
    std::string code;
    std::string message;
    std::vector<UnitId> units;
    std::vector<NamedRelation> relations;
    std::map<std::string, EvidenceValue> evidence;
    std::string evidence_hash;
    std::vector<Suspect> suspects;

    friend bool operator==(const Diagnostic&, const Diagnostic&) = default;
};

[[nodiscard]] std::string_view to_word(Severity severity) noexcept;

/// What levels, surfaces and sections say about one relation. `None`: it states no order.
enum class EvidenceVerdict : std::uint8_t { None, Confirmed, Contradicted, Untestable };

/// How much of the record could be judged at all.
struct Coverage {
    std::int64_t relations = 0; ///< relations that state an order
    std::int64_t confirmed = 0; ///< by surfaces, sections or levels
    std::int64_t contradicted = 0;
    std::map<std::string, std::int64_t> untestable; ///< reason → number

    friend bool operator==(const Coverage&, const Coverage&) = default;
};

} // namespace planum::model
