// SPDX-License-Identifier: MIT
#include "strat/layout/part_packing.hpp"

#include <random>

#include "strat/layout/drawing_style.hpp"
#include "tests/support/catch.hpp"

using namespace planum::strat;

TEST_CASE("A part goes into the bay that a larger one leaves") {
    // The first is wide on its two lowest levels only: a small one fits above, right of its narrow top.
    MatrixPart wide{{{0, 40}, {0, 40}, {0, 40}, {0, 300}, {0, 300}}, 0.0, 0};
    MatrixPart small{{{0, 40}, {0, 40}}, 0.0, 0};
    std::vector<MatrixPart> parts = {wide, small};
    pack_parts(parts, true);
    CHECK(parts[1].level == 0);
    CHECK(parts[1].x == 40.0 + style::kComponentGap);
    parts = {wide, small};
    parts[1].levels.resize(3, {0, 40}); // would end on the level above the wide one: bars run there
    pack_parts(parts, true);
    CHECK(parts[1].x >= 300.0 + style::kComponentGap);
}

TEST_CASE("Parts keep apart on their levels and those next to them, whatever their outlines") {
    const auto seed = Catch::rngSeed();
    INFO("seed " << seed);
    std::mt19937 random(seed);
    const auto upto = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
    std::size_t compared = 0;
    for (int run = 0; run < 200; ++run) {
        const bool free_levels = run % 2 == 0;
        std::vector<MatrixPart> parts(static_cast<std::size_t>(2 + upto(6)));
        for (MatrixPart& part : parts) {
            part.levels.resize(static_cast<std::size_t>(1 + upto(9)));
            for (MatrixPart::Level& level : part.levels) {
                level.left = upto(100);
                level.right = level.left + 1 + upto(200);
            }
        }
        pack_parts(parts, free_levels);
        for (std::size_t b = 1; b < parts.size(); ++b) {
            if (!free_levels) CHECK(parts[b].level == 0);
            for (std::size_t a = 0; a < b; ++a) {
                for (std::size_t i = 0; i < parts[a].levels.size(); ++i) {
                    for (std::size_t k = 0; k < parts[b].levels.size(); ++k) {
                        const int apart = parts[a].level + static_cast<int>(i) - parts[b].level - static_cast<int>(k);
                        if (apart < -1 || apart > 1) continue;
                        ++compared;
                        CHECK(parts[b].x + parts[b].levels[k].left >=
                              parts[a].x + parts[a].levels[i].right + style::kComponentGap);
                    }
                }
            }
        }
    }
    CHECK(compared > 0);
}
