// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "strat/exchange/delimited_table.hpp"
#include "strat/exchange/reader.hpp"

namespace planum::strat {

/// The tables of hm and HMDP.
enum class HmRole { Contexts, Observations, Inferences, Periods, Phases, Events, EventOrder };

struct HmRoleInfo {
    HmRole role;
    std::array<std::string_view, 3> words; ///< in the ini and in file names
    std::vector<std::string_view> columns; ///< in their order where a file has no header
};

[[nodiscard]] const HmRoleInfo& hm_role_info(HmRole role);

enum class HeaderLine { Unsaid, Yes, No };

/// What an ini or a data package says: which file is which table, and which tables have headings.
struct HmConfiguration {
    std::map<std::string, HmRole> files; ///< by name without folders
    std::map<HmRole, HeaderLine> headers;
    bool found = false;
};

/// Files that only say what the others are: an ini with `[Input files]`, a Frictionless
/// `datapackage.json`.
[[nodiscard]] bool is_hm_guide(const InputFile& file);
void read_hm_guide(const InputFile& file, HmConfiguration& configuration);

/// By the columns of the first row; periods and phases have the same, so the file's name decides.
[[nodiscard]] std::optional<HmRole> hm_role_from_header(const InputFile& file, const DelimitedTable& table);

struct HmAssigned {
    HmRole role;
    HeaderLine header = HeaderLine::Unsaid;
};

/// The guide's word first, then the columns, then the file's name for tables without a header.
[[nodiscard]] std::optional<HmAssigned> assign_hm_role(const InputFile& file, const DelimitedTable& table,
                                                       const HmConfiguration& configuration);

} // namespace planum::strat
