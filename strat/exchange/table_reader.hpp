// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "strat/exchange/delimited_table.hpp"
#include "strat/exchange/reader.hpp"
#include "strat/exchange/record_builder.hpp"

namespace planum::strat {

/// Certain for the files whose first rows `fits` accepts; `why` is said then.
[[nodiscard]] Recognition recognise_tables(std::span<const InputFile> files, bool (*fits)(const DelimitedTable& table),
                                           std::string why);

/// For formats in which every file is one table that stands for itself: parses each, notes what had to be mended and
/// hands it to `read_table`, which may take it apart. Throws BadInput for a file that is no text: it is not `what`.
[[nodiscard]] Imported<ImportedRecord> read_tables(std::span<const InputFile* const> files, const ReadOptions& options,
                                                   Progress& progress, std::string_view what,
                                                   void (*read_table)(DelimitedTable& table, const InputFile& file,
                                                                      RecordBuilder& builder));

} // namespace planum::strat
