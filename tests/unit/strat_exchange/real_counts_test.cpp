// SPDX-License-Identifier: MIT
// Reads the real matrices and counts what came out with sets of names, against the counts that an
// independent program made of the same files.
#include <map>
#include <set>

#include "tests/support/catch.hpp"
#include "tests/support/real_data.hpp"
#include "tests/unit/strat_exchange/support.hpp"

using namespace planum;
using test::Counts;

namespace {

struct RealSet {
    std::string_view path;
    std::string_view format;
    Counts counts; ///< units, orders, same-as, contemporary, self, mutual, isolated
};

// From the table in the README beside the data.
const RealSet kRealSets[] = {
    {"arkmatrix/bonn.lst", "lst", {19, 26, 0, 0, 0, 0, 0}},
    {"arkmatrix/stratify.lst", "lst", {17, 17, 0, 0, 0, 0, 0}},
    {"arkmatrix/cycle.lst", "lst", {7, 10, 0, 0, 1, 1, 0}},
    {"arkmatrix/reduce.lst", "lst", {6, 7, 0, 0, 0, 0, 0}},
    {"arkmatrix/csv_format.csv", "arkmatrix", {7, 6, 1, 1, 0, 0, 1}},
    {"hm/bldg-1-5", "hm", {705, 852, 0, 0, 0, 0, 15}},
    {"hm/fig-12-chronology", "hm", {19, 26, 3, 0, 0, 0, 0}},
    {"hm/roskams-h", "hm", {5, 7, 0, 0, 0, 0, 0}},
    {"hm/roskams-jumps", "hm", {7, 9, 0, 0, 0, 0, 0}},
    {"hm/h-structure", "hm", {9, 11, 0, 0, 0, 0, 0}},
    {"hmc/Sector_D.matrix.xml", "hmcx", {234, 304, 0, 7, 0, 0, 0}},
    {"hmc/demo.matrix.xml", "hmcx", {16, 20, 0, 2, 0, 0, 0}},
    {"hmc/ulm-eggingen", "hmc-csv", {110, 192, 0, 26, 0, 0, 0}},
};

} // namespace

TEST_CASE("Real matrices are read with the counts of an independent program") {
    for (const RealSet& set : kRealSets) {
        INFO(set.path);
        const auto path = test::real_data("matrix/" + std::string{set.path});
        if (!path) continue;
        const auto files = test::load_folder(*path);
        CHECK(test::format_of(files) == set.format);
        CHECK(test::to_text(test::counts_of(test::read_all(files).values)) == test::to_text(set.counts));
    }
}

TEST_CASE("The transcribed books give 75 units and the five whose base lies above their top") {
    const auto path = test::real_data("matrix/urkesh_transcription.csv");
    if (!path) return;
    const auto read = test::read_all(test::load_folder(*path));
    // The 75 are those with a page or in a relation; what `equals` names comes on top.
    auto without_equals = read.values;
    std::erase_if(without_equals.relations, [](const auto& r) { return r.kind == model::RelationKind::SameAs; });
    CHECK(test::counts_of(without_equals).units == 75);
    std::map<strat::UnitName, double> tops;
    std::set<std::string> contradicted;
    for (const auto& level : read.values.levels) {
        if (level.values.role == model::LevelRole::Top) tops[level.unit] = level.values.z;
    }
    for (const auto& level : read.values.levels) {
        const auto top = tops.find(level.unit);
        if (level.values.role != model::LevelRole::Base || top == tops.end()) continue;
        if (level.values.z > top->second) contradicted.insert(level.unit.area + "::" + level.unit.number);
    }
    CHECK(contradicted == std::set<std::string>{"J1::f153", "J2::f117", "J3::f162", "J3::f218", "J3::f52"});
}
