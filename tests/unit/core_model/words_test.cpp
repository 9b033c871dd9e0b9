// SPDX-License-Identifier: MIT
#include "core/model/record.hpp"
#include "core/model/relation.hpp"
#include "core/model/unit.hpp"

#include "tests/support/catch.hpp"

using namespace planum::model;

TEST_CASE("Relation words of four languages mean the same kinds") {
    for (const char* word : {"covers", "Above", "liegt über", "COPRE", "sopra a", "sur"}) {
        INFO(word);
        CHECK(relation_from_any_word(word) == DirectedKind{RelationKind::Covers, false});
    }
    for (const char* word : {"cut by", "cut_by", "wird geschnitten von", "Tagliato da", "coupée par"}) {
        INFO(word);
        CHECK(relation_from_any_word(word) == DirectedKind{RelationKind::Cuts, true});
    }
    CHECK(relation_from_any_word("überdeckt") == DirectedKind{RelationKind::Covers, false});
    CHECK(relation_from_any_word("Wird bedeckt von") == DirectedKind{RelationKind::Covers, true});
    CHECK(relation_from_any_word("Gli si appoggia") == DirectedKind{RelationKind::Abuts, true});
    CHECK(relation_from_any_word("> >") == DirectedKind{RelationKind::Later, false});
    CHECK(relation_from_any_word("<<") == DirectedKind{RelationKind::Later, true});
    CHECK_FALSE(relation_from_any_word("dances with").has_value());
}

TEST_CASE("Kind words mean kind plus form") {
    CHECK(kind_from_any_word("Verfüllung") == KindAndForm{UnitKind::Deposit, UnitForm::Fill});
    CHECK(kind_from_any_word("masonry") == KindAndForm{UnitKind::Structure, UnitForm::Masonry});
    CHECK(kind_from_any_word("TAGLIO") == KindAndForm{UnitKind::Cut, UnitForm::None});
    CHECK_FALSE(kind_from_any_word("mystery").has_value());
}

TEST_CASE("Every word reads back as the value it was written for") {
    for (int i = 0; i <= static_cast<int>(UnitKind::Void); ++i) {
        const auto kind = static_cast<UnitKind>(i);
        CHECK(from_word<UnitKind>(to_word(kind)) == kind);
    }
    for (int i = 0; i <= static_cast<int>(RelationKind::Contemporary); ++i) {
        const auto kind = static_cast<RelationKind>(i);
        CHECK(relation_kind_from_word(to_word(kind)) == kind);
        CHECK(relation_from_any_word(to_word(kind)) == DirectedKind{kind, false});
    }
}

TEST_CASE("What Planum says of a relation, from either side, it understands when a list says it") {
    for (int i = 0; i <= static_cast<int>(RelationKind::Contemporary); ++i) {
        const auto kind = static_cast<RelationKind>(i);
        INFO(phrase(kind) << ", " << inverse_phrase(kind));
        CHECK(relation_from_any_word(phrase(kind)) == DirectedKind{kind, false});
        CHECK(relation_from_any_word(inverse_phrase(kind)) == DirectedKind{kind, !is_symmetric(kind)});
    }
}

TEST_CASE("A number used in two areas is named with its area, any other without") {
    Record record;
    record.areas = {{AreaId{{0, 1}}, "A", "", DigMethod::Stratigraphic, "", ""},
                    {AreaId{{0, 2}}, "B", "", DigMethod::Stratigraphic, "", ""}};
    for (const auto& [number, area, id] :
         {std::tuple{"2", 2U, 3U}, std::tuple{"10", 1U, 1U}, std::tuple{"2", 1U, 2U}}) {
        StratigraphicUnit unit;
        unit.id = UnitId{{0, id}};
        unit.number = number;
        unit.area = AreaId{{0, area}};
        record.units.push_back(unit);
    }
    sort_record(record);
    const RecordIndex index(record);
    CHECK(index.name(0) == "A::2");
    CHECK(index.name(1) == "10");
    CHECK(index.name(2) == "B::2");
    CHECK(index.named("2").size() == 2);
    CHECK(index.named("B::2") == std::vector<UnitIndex>{2});
    CHECK(index.named("C::2").empty());
}
