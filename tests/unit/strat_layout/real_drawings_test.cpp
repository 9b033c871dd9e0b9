// SPDX-License-Identifier: MIT
#include "tests/support/catch.hpp"
#include "tests/support/drawing_laws.hpp"
#include "tests/support/imported_records.hpp"
#include "tests/support/real_data.hpp"

using namespace planum;

TEST_CASE("Every real matrix, drawn and read back, is its reduced matrix") {
    for (const char* set : {"hm/bldg-1-5",
                            "hm/fig-12-chronology",
                            "hm/roskams-h",
                            "hm/roskams-jumps",
                            "hm/h-structure",
                            "hmc/Sector_D.matrix.xml",
                            "hmc/demo.matrix.xml",
                            "hmc/ulm-eggingen",
                            "arkmatrix/csv_format.csv",
                            "arkmatrix/bonn.lst",
                            "arkmatrix/stratify.lst",
                            "arkmatrix/cycle.lst",
                            "arkmatrix/reduce.lst",
                            "stratigraphr/shub1.csv",
                            "stratigraphr/harris12.csv",
                            "pyarchinit/alkhutm_us_con_periodo_FINALE.csv",
                            "pyarchinit/alkhutm_us_senza_periodo.csv",
                            "pyarchinit/pyarchinit_tutorial.db",
                            "phaser/CTD2021-phaser-with-Dating-test-data.json",
                            "urkesh_transcription.csv"}) {
        const auto path = test::real_data(std::string("matrix/") + set);
        if (!path) continue;
        INFO(set);
        const model::Record record = test::read_record(*path);
        CHECK(record.units.size() > 4);
        CHECK(test::broken_law(record, test::drawing_of(record)) == "");
    }
}
