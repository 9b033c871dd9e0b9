// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/project/project.hpp"
#include "core/base/progress.hpp"
#include "core/model/diagnostic.hpp"
#include "core/model/relation.hpp"

namespace planum::app {

/// Which of the two readings says something.
enum class Reading { First, Second };

/// A relation that one reading has and the other has not.
struct DifferingRelation {
    Reading in = Reading::First;
    std::string unit;
    model::RelationKind kind = model::RelationKind::Covers;
    std::string other;
    bool contradicted = false; ///< the other reading orders the two the other way round
};

/// An immediate order of one reading that the other does not have, not even along a path.
struct DifferingOrder {
    Reading in = Reading::First;
    std::string later;
    std::string earlier;
    bool reversed = false; ///< the other reading has the opposite
};

/// An error or a warning that only one reading has.
struct DifferingProblem {
    Reading in = Reading::First;
    model::Diagnostic problem;
};

struct InterpretationDiff {
    std::vector<DifferingRelation> relations; ///< by units, naturally
    std::vector<DifferingOrder> orders;       ///< reversed ones in `First` only
    std::vector<DifferingProblem> problems;   ///< what each contradicts and the other does not
};

/// Compares two interpretations by name; `record` is the field record unless an interpretation is called so.
/// Never writes. Throws NotFound.
[[nodiscard]] InterpretationDiff diff_interpretations(Project& project, const std::string& first,
                                                      const std::string& second, Progress& progress);

} // namespace planum::app
