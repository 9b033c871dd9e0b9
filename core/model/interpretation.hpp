// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/model/ids.hpp"
#include "core/model/relation.hpp"

namespace planum::model {

/// A reading of the record: its parent plus relations added and dropped. The field record is the root
/// and has no row of its own.
struct Interpretation {
    InterpretationId id;
    std::string name;
    InterpretationId parent; ///< nil: the field record
    std::string author;
    std::string made_at;
    std::vector<PhysicalRelation> added;
    std::vector<RelationId> dropped;

    friend bool operator==(const Interpretation&, const Interpretation&) = default;
};

/// A director's word on a diagnostic or a suggestion, with the reason.
struct Decision {
    DecisionId id;
    std::string subject_id; ///< id of the diagnostic or suggestion
    std::string kind;       ///< diagnostic, suggestion, sign-off
    std::string verdict;    ///< accepted, rejected, answered
    std::string because;
    std::string evidence_hash; ///< of what it was decided on; a change reopens it
    double area = 0.0;         ///< [m²] the evidence covered; half as much again reopens it
    std::string author;
    std::string made_at;

    friend bool operator==(const Decision&, const Decision&) = default;
};

} // namespace planum::model
