// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/model/diagnostic.hpp"
#include "strat/layout/drawing.hpp"
#include "strat/layout/text_measure.hpp"

namespace planum::strat {

/// What the three kinds of lines are called in the key of a drawing.
struct EvidenceWords {
    std::string confirmed = "confirmed";
    std::string contradicted = "contradicted";
    std::string untestable = "not testable";
};

/// Has the lines of a drawing say what the evidence says of them, one verdict a line, and adds a row to its key for
/// those that occur. Verdicts of another number than lines change nothing.
void show_evidence(MatrixDrawing& drawing, const std::vector<model::EvidenceVerdict>& verdicts,
                   const EvidenceWords& words, const TextMeasure& text);

} // namespace planum::strat
