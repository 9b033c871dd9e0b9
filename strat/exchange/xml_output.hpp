// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace planum::strat {

/// Text for XML, in element content and in attributes: the five characters escaped, line feeds and tabs
/// as references (attributes would lose them), characters that XML 1.0 cannot hold replaced.
[[nodiscard]] std::string xml_escape(std::string_view utf8);

} // namespace planum::strat
