// SPDX-License-Identifier: MIT
#pragma once

#include "strat/exchange/writer.hpp"

namespace planum::strat {

// Every writer stands in a file of its own; writers.cpp lists them.
[[nodiscard]] Written write_lst(const model::Record& record, const WriteOptions& options);
[[nodiscard]] Written write_hmcx(const model::Record& record, const WriteOptions& options);
[[nodiscard]] Written write_hmc_csv(const model::Record& record, const WriteOptions& options);
[[nodiscard]] Written write_hm_tables(const model::Record& record, const WriteOptions& options);
[[nodiscard]] Written write_graphml(const model::Record& record, const WriteOptions& options);
[[nodiscard]] Written write_dot(const model::Record& record, const WriteOptions& options);
[[nodiscard]] Written write_planum_csv(const model::Record& record, const WriteOptions& options);
[[nodiscard]] Written write_json(const model::Record& record, const WriteOptions& options);
[[nodiscard]] Written write_geojson(const model::Record& record, const WriteOptions& options);
[[nodiscard]] Written write_geojson_site(const model::Record& record, const WriteOptions& options);
[[nodiscard]] Written write_turtle(const model::Record& record, const WriteOptions& options);
[[nodiscard]] Written write_xlsx(const model::Record& record, const WriteOptions& options);
[[nodiscard]] Written write_dxf(const model::Record& record, const WriteOptions& options);
[[nodiscard]] Written write_oxcal(const model::Record& record, const WriteOptions& options);

} // namespace planum::strat
