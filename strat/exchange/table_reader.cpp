// SPDX-License-Identifier: MIT
#include "strat/exchange/table_reader.hpp"

#include <utility>

namespace planum::strat {

Recognition recognise_tables(std::span<const InputFile> files, bool (*fits)(const DelimitedTable&), std::string why) {
    Recognition result;
    for (std::size_t i = 0; i < files.size(); ++i) {
        if (!fits(glimpse_table(files[i]))) continue;
        result.files.push_back(i);
        result.confidence = Confidence::Certain;
    }
    if (!result.files.empty()) result.why = std::move(why);
    return result;
}

Imported<ImportedRecord> read_tables(std::span<const InputFile* const> files, const ReadOptions& options,
                                     Progress& progress, std::string_view what,
                                     void (*read_table)(DelimitedTable&, const InputFile&, RecordBuilder&)) {
    RecordBuilder builder(options);
    for (const InputFile* file : files) {
        progress.check();
        require_text(*file, what);
        DelimitedTable table = parse_table(file->bytes, file->name);
        builder.add_notes(std::move(table.notes));
        read_table(table, *file, builder);
    }
    return builder.finish();
}

} // namespace planum::strat
