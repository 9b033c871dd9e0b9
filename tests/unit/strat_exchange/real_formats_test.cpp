// SPDX-License-Identifier: MIT
// Real files are taken for what they are without being told, alone and beside each other.
#include "tests/support/catch.hpp"
#include "tests/support/real_data.hpp"
#include "tests/unit/strat_exchange/support.hpp"

using namespace planum;
using namespace planum::strat;

namespace {

struct RealFiles {
    std::string_view format;
    std::vector<std::string_view> paths;
};

const std::vector<RealFiles> kRealFiles = {
    {"pyarchinit", {"pyarchinit/alkhutm_us_senza_periodo.csv", "pyarchinit/alkhutm_us_con_periodo_FINALE.csv"}},
    {"pyarchinit", {"pyarchinit/alkhutm_us_con_periodo.csv"}},
    {"pyarchinit", {"pyarchinit/pyarchinit_tutorial.db"}},
    {"stratigraphr", {"stratigraphr/shub1.csv"}},
    {"stratigraphr", {"stratigraphr/harris12.csv"}},
    {"phaser-json", {"phaser/CTD2021-phaser-with-Dating-test-data.json"}},
    {"idai-field", {"idaifield/rtest.jsonl"}},
    {"graphml", {"hmc/demo.yed.graphml"}},
    {"hmcx", {"hmc/demo.matrix.xml"}},
    {"polychron", {"polychron/demo/1-strat.csv"}},
    {"polychron",
     {"polychron/demo/1-strat.csv", "polychron/demo/2-dates.csv", "polychron/demo/3-context-grouping.csv",
      "polychron/demo/4-group-ordering.csv", "polychron/demo/5-context-equality.csv"}},
};

} // namespace

TEST_CASE("Real files are taken for their format without being told") {
    for (const RealFiles& set : kRealFiles) {
        INFO(set.paths.front());
        std::vector<InputFile> files;
        for (const std::string_view path : set.paths) {
            if (const auto file = test::real_data("matrix/" + std::string(path)))
                files.push_back(load_input_file(*file));
        }
        if (files.size() != set.paths.size()) continue;
        const auto plan = plan_reading(files, {});
        REQUIRE(plan.size() == 1);
        CHECK(plan.front().reader->format == set.format);
        CHECK(plan.front().files.size() == files.size());
        CHECK(plan.front().note.empty());
    }
}
