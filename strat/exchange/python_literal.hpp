// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace planum::strat {

/// What is inside a list that Python printed: a text (numbers, None, True as written) or again a list.
struct PythonValue {
    bool is_list = false;
    std::string text;
    std::vector<PythonValue> items;
};

/// Reads the printed form of a Python list or tuple: nested up to 16 deep, texts in single or double
/// quotes with their escapes, bare words and numbers. Reads data only, nothing is ever evaluated. nullopt
/// when the text is no such list, has something behind it, is nested deeper or has over 100,000 items.
[[nodiscard]] std::optional<PythonValue> read_python_list(std::string_view utf8);

} // namespace planum::strat
