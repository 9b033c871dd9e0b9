// SPDX-License-Identifier: MIT
#pragma once

#include "strat/exchange/reader.hpp"

namespace planum::strat {

// Every reader stands in a file of its own and exports one function; readers.cpp lists them in the
// order in which they are asked. A new reader is one line here and one line there.
[[nodiscard]] const Reader& lst_reader();
[[nodiscard]] const Reader& planum_csv_reader();
[[nodiscard]] const Reader& hmcx_reader();
[[nodiscard]] const Reader& hmc_csv_reader();
[[nodiscard]] const Reader& hm_tables_reader();
[[nodiscard]] const Reader& arkmatrix_reader();
[[nodiscard]] const Reader& urkesh_reader();
[[nodiscard]] const Reader& json_reader();

[[nodiscard]] const Reader& pyarchinit_reader();
[[nodiscard]] const Reader& stratigraphr_reader();
[[nodiscard]] const Reader& stratify_csv_reader();
[[nodiscard]] const Reader& polychron_reader();
[[nodiscard]] const Reader& phaser_csv_reader();
[[nodiscard]] const Reader& phaser_json_reader();
[[nodiscard]] const Reader& idai_field_reader();
[[nodiscard]] const Reader& graphml_reader();
[[nodiscard]] const Reader& hmatrix_json_reader();

} // namespace planum::strat
