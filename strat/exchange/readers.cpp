// SPDX-License-Identifier: MIT
#include "strat/exchange/readers.hpp"

#include <array>

namespace planum::strat {

std::span<const Reader> all_readers() {
    // clang-format off: one line each
    static const std::array readers = {
        pyarchinit_reader(), stratigraphr_reader(), stratify_csv_reader(), phaser_csv_reader(), phaser_json_reader(),
        idai_field_reader(), graphml_reader(),      polychron_reader(),    planum_csv_reader(), lst_reader(),
        hmcx_reader(),       hmc_csv_reader(),      hm_tables_reader(),    arkmatrix_reader(),  urkesh_reader(),
        json_reader(),       hmatrix_json_reader(),
    };
    // clang-format on
    return readers;
}

} // namespace planum::strat
