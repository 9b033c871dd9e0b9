// SPDX-License-Identifier: MIT
#include <cstdio>
#include <cstdlib>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "app/import/merge.hpp"
#include "strat/checks/check.hpp"
#include "strat/exchange/reader.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/real_data.hpp"

// What the checks say about records of real digs, where these lie beside the repository.

namespace {

using namespace planum;

// Files of one import as a record, without a project file.
std::optional<model::Record> imported(const std::vector<std::string>& names) {
    std::vector<strat::InputFile> inputs;
    for (const std::string& name : names) {
        const auto path = test::real_data("matrix/" + name);
        if (!path) return std::nullopt;
        inputs.push_back(strat::load_input_file(*path));
    }
    std::vector<app::ImportSet> sets;
    for (const strat::Reading& reading : strat::plan_reading(inputs, {})) {
        std::vector<const strat::InputFile*> files;
        app::ImportSet set;
        for (const std::size_t at : reading.files) {
            files.push_back(&inputs[at]);
            model::Source source;
            source.name = inputs[at].name;
            source.format = reading.reader->format;
            set.sources.push_back(std::move(source));
        }
        auto read = reading.reader->read(files, {}, Progress::none());
        set.record = std::move(read.values);
        set.notes = std::move(read.diagnostics);
        set.main_source = files.front()->name;
        sets.push_back(std::move(set));
    }
    SeededUuids ids(1);
    const app::MergePlan plan = app::plan_merge({}, sets, {}, ids, FixedClock("2025-06-01T12:00:00.000Z"));
    model::Record record;
    record.areas = plan.new_areas;
    record.sources = plan.new_sources;
    record.periods = plan.new_periods;
    record.phases = plan.new_phases;
    record.units = plan.new_units;
    record.relations = plan.new_relations;
    record.statements = plan.new_statements;
    record.datings = plan.new_datings;
    record.levels = plan.new_levels;
    record.import_notes = plan.new_notes;
    model::sort_record(record);
    return record;
}

struct Checked {
    model::Record record;
    strat::CheckResult result;
    strat::MatrixStats stats;

    [[nodiscard]] std::vector<model::Diagnostic> said(std::string_view code) const {
        std::vector<model::Diagnostic> found;
        for (const model::Diagnostic& d : result.diagnostics) {
            if (d.code == code) found.push_back(d);
        }
        return found;
    }

    [[nodiscard]] std::set<std::string> units(const model::Diagnostic& d) const {
        const model::RecordIndex index(record);
        std::set<std::string> names;
        for (const model::UnitId id : d.units) names.insert(index.name(id));
        return names;
    }
};

std::optional<Checked> checked(const std::vector<std::string>& names) {
    auto record = imported(names);
    if (!record) return std::nullopt;
    Checked c;
    c.record = std::move(*record);
    const auto matrix = strat::HarrisMatrix::build(c.record);
    c.stats = matrix.stats();
    c.result = strat::check(c.record, matrix, {}, {}, Progress::none());
    if (std::getenv("PLANUM_SHOW") != nullptr) {
        for (const model::Diagnostic& d : c.result.diagnostics) {
            std::printf("%s %s: %s\n", std::string(model::to_word(d.severity)).c_str(), d.code.c_str(),
                        d.message.c_str());
            for (const model::Suspect& s : d.suspects)
                std::printf("      %.2f %s\n", s.score, s.reasons.front().c_str());
        }
        std::printf("coverage %lld confirmed %lld contradicted %lld\n",
                    static_cast<long long>(c.result.coverage.relations),
                    static_cast<long long>(c.result.coverage.confirmed),
                    static_cast<long long>(c.result.coverage.contradicted));
        for (const auto& [why, n] : c.result.coverage.untestable)
            std::printf("   %s %lld\n", why.c_str(), static_cast<long long>(n));
    }
    return c;
}

// How many relations the checks would take out to break all cycles.
std::int64_t removals(const Checked& c) {
    std::int64_t sum = 0;
    for (const model::Diagnostic& d : c.result.diagnostics) {
        const auto it = d.evidence.find("removals");
        if (it != d.evidence.end()) sum += std::get<std::int64_t>(it->second);
    }
    return sum;
}

} // namespace

TEST_CASE("The cycle list names 6 above itself, 3 and 5, and the group of five with at most two suspects to remove") {
    const auto c = checked({"arkmatrix/cycle.lst"});
    if (!c) return;
    REQUIRE(c->said("self-relation").size() == 1);
    CHECK(c->units(c->said("self-relation")[0]) == std::set<std::string>{"6"});
    REQUIRE(c->said("contradicting-pair").size() == 1);
    CHECK(c->units(c->said("contradicting-pair")[0]) == std::set<std::string>{"3", "5"});
    REQUIRE(c->said("cycle").size() == 1);
    CHECK(c->units(c->said("cycle")[0]) == std::set<std::string>{"1", "2", "3", "4", "5"});
    CHECK(removals(*c) <= 2);
}

TEST_CASE("Al-Khutm: cycle groups, those of same-as, 49 direct date contradictions, 17 empty targets, one line of "
          "reciprocals") {
    const auto c = checked({"pyarchinit/alkhutm_us_senza_periodo.csv", "pyarchinit/alkhutm_us_con_periodo_FINALE.csv"});
    if (!c) return;
    std::size_t groups = 0;
    for (const model::Diagnostic& d : c->result.diagnostics) groups += d.evidence.contains("removals") ? 1U : 0U;
    CHECK(groups == 6);
    CHECK(removals(*c) <= 7);
    std::size_t direct = 0;
    for (const model::Diagnostic& d : c->said("date-contradiction")) {
        const auto it = d.evidence.find("direct");
        direct += it != d.evidence.end() && std::get<std::int64_t>(it->second) == 1 ? 1U : 0U;
        CHECK((d.relations.empty() || !d.message.empty()));
    }
    CHECK(direct == 49);
    std::size_t empty_targets = 0;
    for (const model::Diagnostic& d : c->said("unparsed")) {
        if (std::get<std::string>(d.evidence.at("note")) == "empty-target") ++empty_targets;
    }
    CHECK(empty_targets == 17);
    CHECK(c->said("missing-reciprocal").size() <= 1);
    CHECK(c->said("contradicting-pair").size() == 2);
    CHECK(c->said("self-relation").size() == 1);
}

TEST_CASE("Urkesh: the five units whose base lies above their top, and nothing that numbers do not show") {
    const auto c = checked({"urkesh_transcription.csv"});
    if (!c) return;
    std::set<std::string> inverted;
    for (const model::Diagnostic& d : c->said("level-contradiction")) {
        if (d.units.size() == 1) {
            inverted.merge(c->units(d));
        } else {
            CHECK(std::get<double>(d.evidence.at("difference_m")) != 0.0);
        }
    }
    CHECK(inverted.size() == 5);
    const model::Coverage& coverage = c->result.coverage;
    CHECK(coverage.confirmed + coverage.contradicted < coverage.relations);
}

TEST_CASE("Records without cycles have no cycle diagnostics") {
    for (const std::vector<std::string>& files : {std::vector<std::string>{"hmc/Sector_D.matrix.xml"},
                                                  {"arkmatrix/bonn.lst"},
                                                  {"pyarchinit/pyarchinit_tutorial.db"}}) {
        const auto c = checked(files);
        if (!c) return;
        INFO(files.front());
        CHECK(c->said("cycle").empty());
        CHECK(c->said("cycle-by-same-as").empty());
        CHECK(c->said("contradicting-pair").empty());
    }
}
