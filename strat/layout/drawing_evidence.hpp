// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/model/diagnostic.hpp"
#include "core/model/record.hpp"
#include "strat/layout/drawing.hpp"
#include "strat/layout/drawing_index.hpp"
#include "strat/layout/text_measure.hpp"

namespace planum::strat {

/// What the three kinds of lines are called in the key of a drawing.
struct EvidenceWords {
    std::string confirmed = "confirmed";
    std::string contradicted = "contradicted";
    std::string untestable = "not testable";
};

[[nodiscard]] EvidenceWords german_evidence_words();

/// What the evidence says about each line of a drawing, by position, from what it says of the record's relations by
/// theirs. A line that stands for several is contradicted where one of them is, confirmed where one is and none
/// contradicted, else untestable.
[[nodiscard]] std::vector<model::EvidenceVerdict>
line_verdicts(const MatrixDrawing& drawing, const DrawingIndex& index, const model::Record& record,
              const std::vector<model::EvidenceVerdict>& of_relations);

/// Has the lines of a drawing say what the evidence says of them, one verdict a line, and adds a row to its key for
/// those that occur. Verdicts of another number than lines change nothing.
void show_evidence(MatrixDrawing& drawing, const std::vector<model::EvidenceVerdict>& verdicts,
                   const EvidenceWords& words, const TextMeasure& text);

} // namespace planum::strat
