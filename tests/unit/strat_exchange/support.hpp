// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <initializer_list>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "strat/exchange/imported_record.hpp"
#include "strat/exchange/reader.hpp"

namespace planum::test {

/// A file in memory.
[[nodiscard]] strat::InputFile a_file(std::string_view name, std::string_view bytes);

using Files = std::initializer_list<std::pair<std::string_view, std::string_view>>;

/// Plans and reads; every reading of the plan goes into one record. `format` as for --format.
[[nodiscard]] strat::Imported<strat::ImportedRecord> read_all(const std::vector<strat::InputFile>& files,
                                                              std::string_view format = {});
[[nodiscard]] strat::Imported<strat::ImportedRecord> read_all(Files files, std::string_view format = {});

/// The format that the files are taken for.
[[nodiscard]] std::string format_of(const std::vector<strat::InputFile>& files);
[[nodiscard]] std::string format_of(Files files);

/// All ordinary files of a folder, by name; or the one file.
[[nodiscard]] std::vector<strat::InputFile> load_folder(const std::filesystem::path& path);

/// A sample of ours, a file or a folder, below tests/data/exchange.
[[nodiscard]] std::vector<strat::InputFile> sample(std::string_view name);

/// All samples: format (the folder's name) and files.
[[nodiscard]] std::map<std::string, std::vector<strat::InputFile>> all_samples();

/// `12 covers 13`, one a line, in the order of the record; uncertain ones end in `?`.
[[nodiscard]] std::vector<std::string> relations_of(const strat::ImportedRecord& record);

/// `file:line code`, in order.
[[nodiscard]] std::vector<std::string> notes_of(const std::vector<strat::ReadNote>& notes);

/// Plain counts by sets of names: too slow for large records, too simple to be wrong.
struct Counts {
    std::size_t units = 0; ///< with a sheet or named in a relation
    std::size_t orders = 0;
    std::size_t same_as = 0;
    std::size_t contemporary = 0;
    std::size_t self = 0;
    std::size_t mutual = 0;
    std::size_t isolated = 0; ///< in no order, what is the same counted once

    friend bool operator==(const Counts&, const Counts&) = default;
};

[[nodiscard]] Counts counts_of(const strat::ImportedRecord& record);
[[nodiscard]] std::string to_text(const Counts& counts);

} // namespace planum::test
