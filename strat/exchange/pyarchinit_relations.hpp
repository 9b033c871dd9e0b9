// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/model/relation.hpp"

namespace planum::strat {

/// One relation of a pyArchInit sheet, read from the sheet's side.
struct PyarchinitRelation {
    model::DirectedKind kind;
    bool symbol = false;    ///< written `>`, `>>`, `<` or `<<`: a link of the Extended Matrix
    bool uncertain = false; ///< the target carries a question mark
    std::string target;
    std::string area; ///< empty: the sheet's own
    std::string site; ///< empty: the sheet's own
    std::string raw;
};

struct PyarchinitRelationProblem {
    std::string code; ///< empty-target, unknown-relation, unparsed
    std::string raw;
    std::string message;
};

struct PyarchinitRelations {
    std::vector<PyarchinitRelation> relations;
    std::vector<PyarchinitRelationProblem> problems;
};

/// Reads a cell `rapporti`: the text of a Python list (`[['Copre', '13', '1', 'Site'], …]`, items of two
/// to four fields, sometimes moved by one), or words (`Copre 2, Coperto da 7`, `Covers US 1001`). Each item
/// that is no relation is a problem with its raw text; blank template items are none.
[[nodiscard]] PyarchinitRelations read_rapporti(std::string_view cell);

} // namespace planum::strat
