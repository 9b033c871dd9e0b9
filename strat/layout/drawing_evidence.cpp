// SPDX-License-Identifier: MIT
#include "strat/layout/drawing_evidence.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "strat/layout/drawing_style.hpp"

namespace planum::strat {

void show_evidence(MatrixDrawing& drawing, const std::vector<model::EvidenceVerdict>& verdicts,
                   const EvidenceWords& words, const TextMeasure& text) {
    using model::EvidenceVerdict;
    if (verdicts.size() != drawing.lines.size()) return;
    for (std::size_t i = 0; i < verdicts.size(); ++i) drawing.lines[i].verdict = verdicts[i];
    constexpr double kSample = 26.0; // as the other rows of the key
    constexpr double kHeight = 13.0;
    double x = style::kPageMargin;
    const double y = drawing.height - style::kPageMargin + 8.0;
    bool any = false;
    for (const auto& [verdict, said] : {std::pair{EvidenceVerdict::Confirmed, &words.confirmed},
                                        std::pair{EvidenceVerdict::Contradicted, &words.contradicted},
                                        std::pair{EvidenceVerdict::Untestable, &words.untestable}}) {
        if (std::find(verdicts.begin(), verdicts.end(), verdict) == verdicts.end()) continue;
        LegendSample sample;
        sample.kind = LegendSample::Kind::Line;
        sample.line.verdict = verdict;
        sample.line.points = {{x, y + kHeight / 2.0}, {x + kSample, y + kHeight / 2.0}};
        drawing.legend.push_back(std::move(sample));
        DrawnText words_beside;
        words_beside.role = "legend";
        words_beside.text = *said;
        words_beside.at = {x + kSample + 6.0, y + 9.8};
        words_beside.size = style::kTextSize;
        words_beside.width = text.width(*said, style::kTextSize, FontWeight::Regular);
        x = words_beside.at.x + words_beside.width;
        drawing.texts.push_back(std::move(words_beside));
        drawing.width = std::max(drawing.width, std::ceil(x + style::kPageMargin));
        x += 20.0;
        any = true;
    }
    if (any) drawing.height = std::ceil(y + kHeight + style::kPageMargin);
}

} // namespace planum::strat
