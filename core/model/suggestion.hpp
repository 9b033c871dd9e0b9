// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/model/evidence.hpp"
#include "core/model/ids.hpp"
#include "core/model/relation.hpp"

namespace planum::model {

enum class SuggestionType { Relation, Question };

/// Open; decided by the director; or the record says as much already.
enum class SuggestionState { Open, Accepted, Rejected, Recorded };

/// A relation, or a question, that surfaces propose. The id is a hash of type, units and kind, so that it stays the
/// same from day to day.
struct Suggestion {
    std::string id; ///< 12 hexadecimal digits
    SuggestionType type = SuggestionType::Relation;
    UnitId unit; ///< the later one; of a question, the one seen first
    RelationKind kind = RelationKind::Covers;
    UnitId other;
    bool direct = false; ///< they touched, as far as surfaces can tell
    EvidenceSource source = EvidenceSource::StratigraphicSurfaces;
    double confidence = 0.0; ///< 0…1
    double area = 0.0;       ///< [m²]
    double thickness = 0.0;  ///< [m]
    std::vector<SurfaceId> surfaces;
    std::string reason; ///< a sentence
    SuggestionState state = SuggestionState::Open;

    friend bool operator==(const Suggestion&, const Suggestion&) = default;
};

} // namespace planum::model
