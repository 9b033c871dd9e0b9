// SPDX-License-Identifier: MIT
#include "gui/viewmodels/matrix_model.hpp"

#include <string>

#include "tests/support/catch.hpp"

using namespace planum;
using namespace planum::gui;
using model::EvidenceVerdict;

namespace {

// Boxes 1, 2 (two units merged) and 3 above one another, a line from each to the next and one that only skips.
struct Drawn {
    std::vector<model::UnitId> units;
    model::Record record;
    strat::MatrixDrawing drawing;

    Drawn() {
        for (int i = 1; i <= 4; ++i) {
            units.emplace_back(*Uuid::parse("00000000-0000-4000-8000-00000000000" + std::to_string(i)));
        }
        const auto box = [&](std::vector<model::UnitId> of, double y) {
            strat::DrawnBox made;
            made.units = std::move(of);
            made.rect = {0.0, y, 40.0, 20.0};
            drawing.boxes.push_back(made);
        };
        box({units[0]}, 0.0);
        box({units[1], units[2]}, 40.0);
        box({units[3]}, 80.0);
        const auto line = [&](std::size_t later, std::size_t earlier) {
            strat::DrawnLine made;
            made.later = later;
            made.earlier = earlier;
            drawing.lines.push_back(made);
        };
        line(0, 1);
        line(1, 2);
        line(0, 2);
        relate(0, 1);
        relate(0, 2);
        relate(1, 3);
        relate(2, 3);
    }

    void relate(std::size_t upper, std::size_t lower) {
        model::PhysicalRelation relation;
        relation.subject = units[upper];
        relation.object = units[lower];
        record.relations.push_back(relation);
    }

    [[nodiscard]] LineVerdicts verdicts(const std::vector<EvidenceVerdict>& of_relations) const {
        return line_verdicts(drawing, strat::DrawingIndex(drawing), record, of_relations);
    }
};

} // namespace

TEST_CASE("A line says what is known of its relations, a contradiction before a confirmation") {
    const Drawn drawn;
    using enum EvidenceVerdict;
    CHECK(drawn.verdicts({Confirmed, Untestable, Untestable, Untestable}) ==
          LineVerdicts{Confirmed, Untestable, Untestable});
    CHECK(drawn.verdicts({Confirmed, Contradicted, Untestable, Confirmed}) ==
          LineVerdicts{Contradicted, Confirmed, Untestable});
}

TEST_CASE("A relation that states no order, or came after the check, judges no line") {
    const Drawn drawn;
    using enum EvidenceVerdict;
    CHECK(drawn.verdicts({None, None, Contradicted}) == LineVerdicts{Untestable, Contradicted, Untestable});
    CHECK(drawn.verdicts({}) == LineVerdicts{Untestable, Untestable, Untestable});
}
