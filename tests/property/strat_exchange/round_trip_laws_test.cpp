// SPDX-License-Identifier: MIT
// read(write(x)) = x for what the format can hold, over generated records. rapidcheck prints the seed.
#include <algorithm>

#include <rapidcheck.h>

#include "strat/exchange/reader.hpp"
#include "strat/exchange/writer.hpp"
#include "tests/property/strat_exchange/facts.hpp"
#include "tests/property/strat_exchange/generated_record.hpp"
#include "tests/support/catch.hpp"

using namespace planum;
using namespace planum::strat;

namespace planum::model {

// A record is shown by its facts.
void showValue(const Record& record, std::ostream& os) {
    for (const std::string& fact : test::facts_of(record, test::Naming::Full)) os << fact << '\n';
}

} // namespace planum::model

namespace {

using Tags = std::set<std::string, std::less<>>;

const Tags kEverything = {"area",        "unit",     "kind",   "form",  "status", "title",    "description", "field",
                          "inphase",     "inperiod", "parent", "exact", "said",   "period",   "phase",       "group",
                          "groupparent", "member",   "level",  "find",  "sample", "document", "dating"};

// A comma in the number of a unit without a sheet: the one thing that our tables say they lose.
bool has_list_like_mention(const model::Record& record) {
    return std::any_of(record.units.begin(), record.units.end(), [](const model::StratigraphicUnit& unit) {
        return unit.origin == model::UnitOrigin::Mentioned && unit.number.find_first_of(",;") != std::string::npos;
    });
}

std::vector<InputFile> as_input(const Written& written, std::string_view extension) {
    std::vector<InputFile> files;
    for (const WrittenFile& file : written.files) {
        InputFile input;
        input.name = file.name.empty() ? "record." + std::string{extension} : file.name;
        input.path = input.name;
        input.bytes = file.bytes;
        files.push_back(std::move(input));
    }
    return files;
}

Imported<ImportedRecord> read_back(const Writer& writer, const Written& written) {
    const std::vector<InputFile> files = as_input(written, writer.extension);
    Imported<ImportedRecord> all;
    const std::vector<Reading> plan = plan_reading(files, {});
    RC_ASSERT(plan.size() == 1U);
    RC_ASSERT(plan.front().reader->format == writer.format);
    std::vector<const InputFile*> chosen;
    for (const std::size_t i : plan.front().files) chosen.push_back(&files.at(i));
    RC_ASSERT(chosen.size() == files.size());
    return plan.front().reader->read(chosen, {}, Progress::none());
}

void check_round_trip(std::string_view format, const model::Record& record, test::Naming naming, const Tags& tags,
                      const WriteOptions& options = {}) {
    const Writer& writer = writer_for(format);
    const Written written = writer.write(record, options);
    RC_ASSERT(writer.write(record, options).files.front().bytes == written.files.front().bytes);
    const auto read = read_back(writer, written);
    const test::Facts before = test::only(test::facts_of(record, naming), tags);
    const test::Facts after = test::only(test::facts_of(read.values), tags);
    if (before != after) RC_FAIL(test::difference(before, after));
}

} // namespace

TEST_CASE("Our own tables hold the whole record") {
    CHECK(rc::check("read(write(x)) = x", [] {
        const auto record = *test::generated_record({});
        RC_PRE(!record.units.empty() && !has_list_like_mention(record));
        WriteOptions options;
        options.delimiter = *rc::gen::element(',', ';', '\t');
        options.byte_order_mark = *rc::gen::arbitrary<bool>();
        check_round_trip("planum-csv", record, test::Naming::Full, kEverything, options);
    }));
}

TEST_CASE("JSON holds the whole record") {
    CHECK(rc::check("read(write(x)) = x", [] {
        const auto record = *test::generated_record({});
        check_round_trip("json", record, test::Naming::Full, kEverything);
    }));
}

TEST_CASE("A .lst holds units, titles, order, same, contemporary and groups") {
    CHECK(rc::check("read(write(x)) = x", [] {
        const auto record = *test::generated_record({true, true, true, true});
        RC_PRE(!record.units.empty());
        check_round_trip("lst", record, test::Naming::Short,
                         {"anyunit", "anytitle", "order", "same_as", "sametime", "member", "groupparent", "project"});
    }));
}

TEST_CASE("An .hmcx holds units, kinds it knows, phases, periods, order with and without contact") {
    CHECK(rc::check("read(write(x)) = x", [] {
        const auto record = *test::generated_record({});
        RC_PRE(!record.units.empty());
        check_round_trip("hmcx", record, test::Naming::Short,
                         {"anyunit", "anytitle", "above", "after", "sametime", "inphase", "inperiod", "natural",
                          "periodtitle", "phasetitle", "phaseperiod", "project"});
    }));
}

TEST_CASE("An HMC table holds what an .hmcx holds") {
    CHECK(rc::check("read(write(x)) = x", [] {
        const auto record = *test::generated_record({false, true, false, false});
        RC_PRE(!record.units.empty());
        check_round_trip("hmc-csv", record, test::Naming::Short,
                         {"anyunit", "anytitle", "above", "after", "sametime", "inphase", "inperiod", "natural",
                          "periodtitle", "phasetitle", "phaseperiod", "project"});
    }));
}

TEST_CASE("hm tables hold units, phases, periods, order and same") {
    CHECK(rc::check("read(write(x)) = x", [] {
        const auto record = *test::generated_record({});
        RC_PRE(!record.units.empty());
        check_round_trip("hm", record, test::Naming::Short,
                         {"anyunit", "order", "same_as", "inphase", "inperiod", "periodtitle", "phasetitle"});
    }));
}

TEST_CASE("GraphML holds units with their fields, phases, groups, and relations as they were seen") {
    CHECK(rc::check("read(write(x)) = x", [] {
        const auto record = *test::generated_record({false, false, false, true});
        RC_PRE(!record.units.empty());
        check_round_trip("graphml", record, test::Naming::Full,
                         {"anyunit",    "anytitle", "kind",     "form",   "title",        "description",
                          "inphase",    "inperiod", "covers",   "cuts",   "fills",        "abuts",
                          "bonds_with", "same_as",  "borders",  "later",  "contemporary", "order",
                          "above",      "after",    "sametime", "member", "groupparent"});
    }));
}

TEST_CASE("Every writer writes every record, the same bytes each time") {
    CHECK(rc::check("write is total and stable", [] {
        const auto record = *test::generated_record({});
        for (const Writer& writer : all_writers()) {
            const Written once = writer.write(record, {});
            const Written again = writer.write(record, {});
            RC_ASSERT(once.files.size() == again.files.size());
            for (std::size_t i = 0; i < once.files.size(); ++i) RC_ASSERT(once.files[i].bytes == again.files[i].bytes);
        }
    }));
}
