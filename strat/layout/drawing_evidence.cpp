// SPDX-License-Identifier: MIT
#include "strat/layout/drawing_evidence.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "strat/layout/drawing_style.hpp"

namespace planum::strat {

EvidenceWords german_evidence_words() { return {"bestätigt", "widersprochen", "nicht prüfbar"}; }

std::vector<model::EvidenceVerdict> line_verdicts(const MatrixDrawing& drawing, const DrawingIndex& index,
                                                  const model::Record& record,
                                                  const std::vector<model::EvidenceVerdict>& of_relations) {
    using model::EvidenceVerdict;
    // What of several counts: a contradiction before a confirmation before nothing known.
    const auto weight = [](EvidenceVerdict v) {
        return v == EvidenceVerdict::Contradicted ? 3 : v == EvidenceVerdict::Confirmed ? 2 : 1;
    };
    std::map<std::pair<std::size_t, std::size_t>, EvidenceVerdict> by_boxes;
    const std::size_t judged = std::min(of_relations.size(), record.relations.size());
    for (std::size_t r = 0; r < judged; ++r) {
        if (of_relations[r] == EvidenceVerdict::None) continue;
        const auto later = index.box_of(record.relations[r].subject);
        const auto earlier = index.box_of(record.relations[r].object);
        if (!later || !earlier || *later == *earlier) continue;
        EvidenceVerdict& there = by_boxes.try_emplace({*later, *earlier}, EvidenceVerdict::None).first->second;
        if (there == EvidenceVerdict::None || weight(of_relations[r]) > weight(there)) there = of_relations[r];
    }
    std::vector<EvidenceVerdict> verdicts;
    verdicts.reserve(drawing.lines.size());
    for (const DrawnLine& line : drawing.lines) {
        const auto found = by_boxes.find({line.later, line.earlier});
        verdicts.push_back(found == by_boxes.end() ? EvidenceVerdict::Untestable : found->second);
    }
    return verdicts;
}

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
