// SPDX-License-Identifier: MIT
#include "scans/surface/section_columns.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/support/catch.hpp"

using namespace planum;
using namespace planum::scans;
using Why = SectionVerdict::Why;

namespace {

SectionRegion box(UnitNumber unit, double x0, double z0, double x1, double z1) {
    return {unit, {{{{x0, z0, 0}, {x1, z0, 0}, {x1, z1, 0}, {x0, z1, 0}}}}, 0.01};
}

const SectionContact* contact_of(const std::vector<SectionContact>& all, UnitNumber upper, UnitNumber lower) {
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](const SectionContact& c) { return c.upper == upper && c.lower == lower; });
    return found == all.end() ? nullptr : &*found;
}

KnownUnit unit_of(model::UnitKind kind, model::UnitForm form = model::UnitForm::None) { return {{}, kind, form}; }

} // namespace

TEST_CASE("Layers in a section lie on what is next below them, as long as they touch") {
    // 0 natural, 1 over its western half, 2 over all.
    const std::vector regions = {box(0, 0, 0, 4, 1), box(1, 0, 1, 2, 1.3), box(2, 0, 1.3, 2, 1.6),
                                 box(2, 2, 1, 4, 1.6)};
    const auto contacts = section_contacts(regions);
    CHECK(contacts.size() == 3);
    for (const auto& [upper, lower] : {std::pair{1, 0}, {2, 1}, {2, 0}}) {
        const SectionContact* contact = contact_of(contacts, upper, lower);
        REQUIRE(contact != nullptr);
        CHECK(contact->length == Approx(2.0).margin(0.02));
        CHECK(contact->contrary == 0.0);
    }
    CHECK(contact_of(contacts, 2, 0)->from == Approx(2.0).margin(0.02));
}

TEST_CASE("The columns of a contact are those that make up its length, with both lines and how far both pieces reach") {
    const std::vector regions = {box(0, 0, 0, 4, 1), box(1, 1, 1.02, 2, 1.3), box(1, 3, 1, 3.5, 1.4)};
    const auto contacts = section_contacts(regions);
    const auto columns = contact_columns(regions, 1, 0);
    REQUIRE(contacts.size() == 1);
    CHECK(static_cast<double>(columns.size()) * 0.02 == Approx(contacts[0].length));
    for (const ContactColumn& column : columns) {
        const bool first = column.along < 2.0;
        CHECK(((column.along > 1.0 && first) || (column.along > 3.0 && column.along < 3.5)));
        CHECK(column.bottom == Approx(0.0).margin(1e-9));
        CHECK(column.lower == Approx(1.0));
        CHECK(column.upper == Approx(first ? 1.02 : 1.0));
        CHECK(column.top == Approx(first ? 1.3 : 1.4));
    }
    CHECK(
        std::is_sorted(columns.begin(), columns.end(), [](const auto& a, const auto& b) { return a.along < b.along; }));
    CHECK(contact_columns(regions, 0, 1).empty());
}

TEST_CASE("A gap wider than the lines allow is no contact, and side by side is none") {
    CHECK(section_contacts(std::vector{box(0, 0, 0, 1, 1), box(1, 0, 1.1, 1, 2)}).empty());
    CHECK(section_contacts(std::vector{box(0, 0, 0, 1, 1), box(1, 1, 0, 2, 1)}).empty());
    CHECK(section_contacts(std::vector{box(0, 0, 0, 1, 1), box(1, 0, 1.02, 1, 2)}).size() == 1);
    CHECK(section_contacts({}).empty());
}

TEST_CASE("Of layers laid one after the other no contact is inverted, whatever their waves") {
    for (std::uint32_t seed = 1; seed <= 100; ++seed) {
        INFO("seed " << seed);
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> thick(0.0, 0.3);
        const int layers = 6;
        const int points = 12;
        std::vector<double> top(points, 0.0);
        std::vector<SectionRegion> regions;
        for (int layer = 0; layer < layers; ++layer) {
            geometry::Line3 ring;
            for (int i = 0; i < points; ++i) ring.push_back({0.4 * i, top[static_cast<std::size_t>(i)], 0});
            for (int i = points; i-- > 0;) {
                double& z = top[static_cast<std::size_t>(i)];
                z += thick(random) + 0.03;
                ring.push_back({0.4 * i, z, 0});
            }
            regions.push_back({layer, {{ring}}, 0.005});
        }
        std::shuffle(regions.begin(), regions.end(), random);
        const auto contacts = section_contacts(regions);
        CHECK(contacts.size() == layers - 1);
        for (const SectionContact& contact : contacts) {
            CHECK(contact.upper == contact.lower + 1);
            CHECK(contact.contrary == 0.0);
        }
    }
}

TEST_CASE("The roof of an undercut pit is asked about, a layer that seals the pit is not") {
    const KnownUnit layer = unit_of(model::UnitKind::Deposit, model::UnitForm::Layer);
    const KnownUnit fill = unit_of(model::UnitKind::Deposit, model::UnitForm::Fill);
    // The fill (1) of a bell-shaped pit dug into the layer (0), whose roof hangs over it in the west; 2 seals both.
    const std::vector regions = {box(0, 0, 1, 1.5, 2), box(0, 0, 0, 1, 1), box(1, 1, 0, 3, 1), box(1, 1.5, 1, 3, 2),
                                 box(2, 0, 2, 3, 2.3)};
    const auto contacts = section_contacts(regions);
    const SectionContact* roof = contact_of(contacts, 0, 1);
    REQUIRE(roof != nullptr);
    CHECK(roof->upper_reaches_below);
    CHECK(judge_contact(*roof, layer, fill).why == Why::ReachesBelow);
    const SectionContact* seal = contact_of(contacts, 2, 1);
    REQUIRE(seal != nullptr);
    const SectionVerdict verdict = judge_contact(*seal, layer, fill);
    CHECK(verdict.why == Why::LiesOn);
    CHECK(verdict.kind == model::RelationKind::Covers);
    CHECK(verdict.direct);
}

TEST_CASE("A fill on the ground it was filled into is later only; short and two-way contacts prove nothing") {
    const KnownUnit layer = unit_of(model::UnitKind::Deposit, model::UnitForm::Layer);
    const KnownUnit fill = unit_of(model::UnitKind::Deposit, model::UnitForm::Fill);
    const SectionVerdict verdict = judge_contact({1, 0, 0.8, 0.0, 0, 1, false}, fill, layer);
    CHECK(verdict.kind == model::RelationKind::Later);
    CHECK_FALSE(verdict.direct);
    CHECK(judge_contact({1, 0, 0.08, 0.0, 0, 1, false}, layer, layer).why == Why::TooShort);
    CHECK(judge_contact({1, 0, 1.0, 0.5, 0, 1, false}, layer, layer).why == Why::BothWays);
    CHECK(judge_contact({1, 0, 1.0, 0.03, 0, 1, false}, layer, layer).why == Why::LiesOn);
}
