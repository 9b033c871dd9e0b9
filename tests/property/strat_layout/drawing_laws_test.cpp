// SPDX-License-Identifier: MIT
// Laws: a drawing, read back from its strokes, states exactly the reduced matrix; boxes do not overlap; no
// line runs through a box; nothing is no number.
#include <rapidcheck.h>

#include "tests/support/catch.hpp"
#include "tests/support/drawing_laws.hpp"
#include "tests/support/layout_records.hpp"

using namespace planum;

namespace {

rc::Gen<test::RandomMatrixOptions> any_matrix() {
    return rc::gen::map(rc::gen::tuple(rc::gen::inRange<std::size_t>(1, 45), rc::gen::inRange<std::size_t>(0, 4),
                                       rc::gen::arbitrary<std::uint32_t>(), rc::gen::inRange(0, 32)),
                        [](const auto& t) {
                            test::RandomMatrixOptions options;
                            options.units = std::get<0>(t);
                            options.relations = options.units * (1 + std::get<1>(t));
                            options.seed = std::get<2>(t);
                            const int flags = std::get<3>(t);
                            options.cycles = (flags & 1) != 0;
                            options.contemporaries = (flags & 2) != 0;
                            options.same_as = (flags & 4) != 0;
                            options.uncertain = (flags & 8) != 0;
                            options.phases = (flags & 16) != 0 ? 4 : 0;
                            return options;
                        });
}

} // namespace

TEST_CASE("Any matrix, drawn and read back, is the reduced matrix") {
    CHECK(rc::check("drawing", [] {
        const test::RandomMatrixOptions options = *any_matrix();
        const model::Record record = test::a_random_record(options);
        const std::string law = test::broken_law(record, test::drawing_of(record));
        if (!law.empty()) {
            RC_FAIL("seed " + std::to_string(options.seed) + ", " + std::to_string(options.units) + " units, " +
                    std::to_string(options.relations) + " relations, flags " + std::to_string(options.cycles) +
                    std::to_string(options.contemporaries) + std::to_string(options.same_as) +
                    std::to_string(options.uncertain) + " phases " + std::to_string(options.phases) + ": " + law);
        }
    }));
}

TEST_CASE("Any trench, drawn and read back, is the reduced matrix") {
    CHECK(rc::check("trench", [] {
        test::TrenchOptions options;
        options.units = *rc::gen::inRange<std::size_t>(2, 150);
        options.seed = *rc::gen::arbitrary<std::uint32_t>();
        options.width = *rc::gen::inRange<std::size_t>(1, 40);
        options.layer_reach = *rc::gen::inRange<std::size_t>(1, 12);
        const model::Record record = test::a_trench(options);
        const std::string law = test::broken_law(record, test::drawing_of(record));
        if (!law.empty()) RC_FAIL("seed " + std::to_string(options.seed) + ": " + law);
    }));
}

TEST_CASE("Any groups get frames that hold their own boxes and nobody else's, and the orders stay as they are") {
    CHECK(rc::check("frames", [] {
        test::RandomMatrixOptions options = *any_matrix();
        options.groups = *rc::gen::inRange<std::size_t>(1, 7);
        const model::Record record = test::a_random_record(options);
        strat::DrawingOptions drawing_options;
        drawing_options.frames = strat::Frames::Groups;
        const strat::MatrixDrawing drawing = test::drawing_of(record, drawing_options);
        std::string law = test::broken_law(record, drawing);
        if (law.empty()) law = test::broken_frame(record, drawing);
        if (!law.empty()) {
            RC_FAIL("seed " + std::to_string(options.seed) + ", " + std::to_string(options.units) + " units, " +
                    std::to_string(options.relations) + " relations, " + std::to_string(options.groups) +
                    " groups, flags " + std::to_string(options.cycles) + std::to_string(options.contemporaries) +
                    std::to_string(options.same_as) + std::to_string(options.uncertain) + " phases " +
                    std::to_string(options.phases) + ": " + law);
        }
    }));
}
