// SPDX-License-Identifier: MIT
#include "app/finds/assign_finds.hpp"

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "app/regions/outline_text.hpp"
#include "app/regions/region_import.hpp"
#include "core/base/error.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/placed_scan.hpp"
#include "tests/support/temporary.hpp"

using namespace planum;

namespace {

// A trench of 4 × 4 m, one unit bare on each day, level at the height said.
struct Trench {
    test::TemporaryFolder folder;
    app::Project project;

    explicit Trench(model::DigMethod method = model::DigMethod::Stratigraphic)
        : project([&] {
              model::ProjectSettings settings;
              settings.method = method;
              return app::Project::create(folder / "site.gpkg", settings, {});
          }()) {}

    void bare(int day, const std::string& unit, double z, std::optional<model::RegionShows> shows = {}) {
        app::DrawnOutline outline;
        outline.unit = unit;
        outline.day = fmt::format("2025-06-{:02}", day);
        outline.shape = app::parse_outline(fmt::format("0 0 {0}, 4 0 {0}, 4 4 {0}, 0 4 {0}", z));
        outline.shows = shows;
        app::RegionImportOptions options;
        options.create_units = true;
        (void)app::import_outlines(project, {{outline}, {}}, options);
    }

    void find(const std::string& number, std::optional<double> z, int day = 0, double x = 1.0) {
        model::Find find;
        find.number = number;
        find.x = x;
        find.y = 1.0;
        find.z = z;
        if (day > 0) find.found_on = fmt::format("2025-06-{:02}", day);
        project.change("find", [&] { project.file().insert(find); });
    }

    app::FindAssignment assign(bool apply = false) { return app::assign_finds(project, {"", apply}, Progress::none()); }

    app::FindProposal only() {
        const auto all = assign().proposals;
        REQUIRE(all.size() == 1);
        return all.front();
    }
};

struct PitBelowTwoLayers : Trench {
    PitBelowTwoLayers() {
        bare(1, "1", 10.0);
        bare(2, "2", 9.7);
        bare(3, "3", 9.5, model::RegionShows::Cut);
        bare(4, "4", 9.3);
    }
};

} // namespace

TEST_CASE("A find belongs to the unit between whose faces it lies, and the reason says which these are") {
    PitBelowTwoLayers trench;
    trench.find("F1", 9.85, 1);
    const auto proposal = trench.only();
    CHECK(proposal.unit == "1");
    CHECK(proposal.reason == "at 9.85 m it lies between 1 at 10.00 m on 2025-06-01 and 2 at 9.70 m on 2025-06-02");
    CHECK_FALSE(proposal.z);
}

TEST_CASE("A find on the face between two units is ambiguous and gets none") {
    PitBelowTwoLayers trench;
    trench.find("F1", 9.71, 2);
    const auto proposal = trench.only();
    CHECK(proposal.unit.empty());
    CHECK(proposal.candidates == std::vector<std::string>{"1", "2"});
}

TEST_CASE(
    "A cut holds no find: what lies above it is the unit it was cut into view from, what lies below is unproven") {
    PitBelowTwoLayers trench;
    trench.find("above", 9.6, 2);
    trench.find("below", 9.4, 4, 2.0);
    const auto all = trench.assign().proposals;
    REQUIRE(all.size() == 2);
    CHECK(all[0].unit == "2");
    CHECK(all[1].unit.empty());
    CHECK_THAT(all[1].reason, Catch::Contains("4 or below") && Catch::Contains("no later surface"));
}

TEST_CASE("Units that were gone before the day of the find, or not yet bare after it, are not meant") {
    PitBelowTwoLayers trench;
    trench.find("late", 9.85, 4);
    const auto late = trench.only();
    CHECK(late.unit.empty());
    CHECK(late.candidates.empty());
    PitBelowTwoLayers early;
    early.find("early", 9.4, 1);
    CHECK(early.only().candidates.empty());
}

TEST_CASE("A unit dug on other days, or another that was dug unseen, is no proof: none is proposed") {
    PitBelowTwoLayers trench;
    trench.find("F1", 9.85, 1);
    const auto dug = [&](const std::string& number, const std::string& day) {
        for (model::StratigraphicUnit unit : trench.project.record().units) {
            if (unit.number != number) continue;
            unit.excavated_from = unit.excavated_on = day;
            trench.project.change("dug", [&] { trench.project.file().update(unit); });
            return;
        }
    };
    dug("1", "2025-06-01");
    CHECK(trench.only().unit == "1");
    model::StratigraphicUnit unseen;
    unseen.number = "9";
    unseen.excavated_from = unseen.excavated_on = "2025-06-01";
    trench.project.change("unit", [&] { unseen.id = trench.project.file().insert(unseen); });
    CHECK(trench.only().unit == "1"); // nothing says that the two touch
    model::PhysicalRelation covers;
    for (const model::StratigraphicUnit& unit : trench.project.record().units) {
        if (unit.number == "1") covers.subject = unit.id;
    }
    covers.kind = model::RelationKind::Covers;
    covers.object = unseen.id;
    trench.project.change("relation", [&] { trench.project.file().insert(covers); });
    CHECK(trench.only().unit.empty());
    CHECK(trench.only().candidates == std::vector<std::string>{"1", "9"});
    dug("9", "2025-06-05");
    CHECK(trench.only().unit == "1");
    dug("1", "2025-06-02");
    CHECK(trench.only().unit.empty());
    CHECK(trench.only().candidates.empty());
}

TEST_CASE("Between artificial levels the face lies somewhere: a find there may belong to either") {
    Trench trench(model::DigMethod::Planum);
    trench.bare(1, "1", 10.0);
    trench.bare(2, "1", 9.8);
    trench.bare(3, "2", 9.6);
    trench.find("inside", 9.9, 1);
    trench.find("between", 9.7, 2, 2.0);
    const auto all = trench.assign().proposals;
    REQUIRE(all.size() == 2);
    CHECK(all[0].find == "between");
    CHECK(all[0].unit.empty());
    CHECK(all[0].candidates.size() == 2);
    CHECK(all[1].unit == "1");
}

TEST_CASE("On artificial levels a unit that no level shows may hold the find, whatever it touches") {
    Trench trench(model::DigMethod::Planum);
    trench.bare(1, "1", 10.0);
    trench.bare(2, "1", 9.8);
    trench.bare(3, "2", 9.6);
    trench.find("inside", 9.9, 1);
    CHECK(trench.only().unit == "1");
    model::StratigraphicUnit unseen;
    unseen.number = "9";
    unseen.excavated_on = "2025-06-01";
    trench.project.change("unit", [&] { trench.project.file().insert(unseen); });
    CHECK(trench.only().unit.empty());
    CHECK(trench.only().candidates == std::vector<std::string>{"1", "9"});
}

TEST_CASE("A find without height gets that of the surface of its day, and a unit where the surfaces agree") {
    Trench trench;
    trench.bare(1, "1", 10.0);
    trench.bare(2, "1", 9.9);
    trench.bare(3, "1", 9.8);
    trench.bare(4, "2", 9.6);
    trench.find("agreed", {}, 2);
    trench.find("either", {}, 4, 2.0);
    const auto all = trench.assign(true);
    REQUIRE(all.proposals.size() == 2);
    CHECK(all.proposals[0].unit == "1");
    CHECK(*all.proposals[0].z == Approx(9.9));
    CHECK(all.proposals[1].unit.empty());
    CHECK(all.proposals[1].candidates.size() == 2);
    CHECK(all.applied == 2);
    const auto& finds = trench.project.record().finds;
    CHECK(std::count_if(finds.begin(), finds.end(), [](const model::Find& find) { return find.z.has_value(); }) == 2);
    CHECK(std::count_if(finds.begin(), finds.end(), [](const model::Find& find) { return !find.unit.is_nil(); }) == 1);
    trench.project.undo();
    CHECK(trench.assign().proposals.size() == 2);
}

TEST_CASE("A find without place or beside all outlines is said, and a day that is none is refused") {
    PitBelowTwoLayers trench;
    trench.find("beside", 9.8, 1, 50.0);
    model::Find nowhere;
    nowhere.number = "nowhere";
    trench.project.change("find", [&] { trench.project.file().insert(nowhere); });
    const auto all = trench.assign().proposals;
    REQUIRE(all.size() == 2);
    CHECK_THAT(all[0].reason, Catch::Contains("no region of a unit covers"));
    CHECK_THAT(all[1].reason, Catch::Contains("x and y are missing"));
    CHECK_THROWS_AS(app::assign_finds(trench.project, {"June", false}, Progress::none()), Error);
}

TEST_CASE("Heights come from the scans where there are any, and a lost scan is said") {
    const test::TemporaryFolder folder;
    std::string field;
    for (int x = -40; x <= 40; ++x) {
        for (int y = -40; y <= 40; ++y) field += fmt::format("{} {} 2\n", 0.05 * x + 0.01, 0.05 * y + 0.01);
    }
    app::Project project = test::project_with_scan(folder, field);
    test::place_scans(project, test::turned_pose(8.0));
    app::DrawnOutline outline;
    outline.unit = "1";
    outline.day = "2025-06-01";
    outline.shape = app::parse_outline("99 199, 101 199, 101 201, 99 201");
    app::RegionImportOptions options;
    options.create_units = true;
    (void)app::import_outlines(project, {{outline}, {}}, options);
    model::Find find;
    find.number = "F";
    find.x = 100.2;
    find.y = 199.7;
    find.found_on = "2025-06-01";
    project.change("find", [&] { project.file().insert(find); });
    const auto proposal = app::assign_finds(project, {}, Progress::none()).proposals.at(0);
    CHECK(proposal.unit == "1");
    CHECK(*proposal.z == Approx(10.0));
    std::filesystem::remove_all(folder / "site.scans");
    std::filesystem::remove_all(folder / "2025-06-01");
    const auto without = app::assign_finds(project, {}, Progress::none());
    CHECK(without.problems.size() == 1);
    CHECK(without.proposals.at(0).unit.empty());
    CHECK_FALSE(without.proposals.at(0).z);
}

TEST_CASE("In a heap of layers a find gets its own layer or none, and its own whenever it is clear of the faces") {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> thick(0.06, 0.4);
    Trench trench;
    std::vector<double> tops;
    double z = 10.0;
    for (int layer = 0; layer < 6; ++layer) {
        tops.push_back(z);
        trench.bare(layer + 1, std::to_string(layer + 1), z);
        z -= thick(random);
    }
    std::uniform_real_distribution<double> height(tops.back() - 0.1, 10.1);
    std::vector<double> heights;
    trench.project.change("finds", [&] {
        for (int i = 0; i < 200; ++i) {
            heights.push_back(height(random));
            model::Find find;
            find.number = std::to_string(i);
            find.x = 0.01 * i + 0.5;
            find.y = 2.0;
            find.z = heights.back();
            trench.project.file().insert(find);
        }
    });
    for (const app::FindProposal& proposal : trench.assign().proposals) {
        const double at = heights.at(static_cast<std::size_t>(std::stoi(proposal.find)));
        std::string truth; // nothing is known above the first, so it reaches up to its tolerance
        double clear = 1e9;
        for (std::size_t i = 0; i < tops.size(); ++i) {
            if (at <= tops[i] + (i == 0 ? 0.02 : 0.0) && i + 1 < tops.size() && at > tops[i + 1])
                truth = std::to_string(i + 1);
            clear = std::min(clear, std::abs(at - tops[i]));
        }
        INFO(proposal.find << " at " << at << ": " << proposal.reason);
        if (!proposal.unit.empty()) CHECK(proposal.unit == truth);
        if (clear > 0.021) CHECK(proposal.unit == truth);
    }
}
