// SPDX-License-Identifier: MIT
#include "strat/exchange/writers.hpp"

#include <array>

#include <fmt/format.h>

#include "core/base/error.hpp"

namespace planum::strat {

std::span<const Writer> all_writers() {
    static constexpr std::array writers = {
        Writer{"planum-csv", "Tables of units, relations, levels, finds, … (.csv)", "", write_planum_csv},
        Writer{"json", "The whole record (.json)", "json", write_json},
        Writer{"lst", "BASP, ArchEd, Stratify dataset (.lst)", "lst", write_lst},
        Writer{"hmcx", "Harris Matrix Composer project (.hmcx)", "hmcx", write_hmcx},
        Writer{"hmc-csv", "Harris Matrix Composer table (.csv)", "csv", write_hmc_csv},
        Writer{"hm", "hm tables (contexts, observations, …)", "", write_hm_tables},
        Writer{"graphml", "yEd GraphML (.graphml)", "graphml", write_graphml},
        Writer{"dot", "Graphviz (.dot)", "dot", write_dot},
        Writer{"geojson", "Regions, finds, levels, stations; longitude and latitude (.geojson)", "geojson",
               write_geojson},
        Writer{"geojson-site", "The same in the site grid", "", write_geojson_site},
        Writer{"turtle", "RDF in CIDOC CRM and CRMarchaeo (.ttl)", "ttl", write_turtle},
        Writer{"xlsx", "A spreadsheet, one sheet a kind (.xlsx)", "xlsx", write_xlsx},
        Writer{"dxf", "DXF R12: outlines, levels, finds (.dxf)", "dxf", write_dxf},
        Writer{"oxcal", "OxCal model: dates, phases, orders (.oxcal)", "oxcal", write_oxcal},
    };
    return writers;
}

const Writer& writer_for(std::string_view format) {
    std::string known;
    for (const Writer& writer : all_writers()) {
        if (writer.format == format) return writer;
        known += fmt::format("{}{}", known.empty() ? "" : ", ", writer.format);
    }
    throw Error(ErrorCode::Usage, fmt::format("no format {} to write; there are {}", format, known));
}

} // namespace planum::strat
