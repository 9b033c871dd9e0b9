// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace planum::paint {

/// Puts a time (ISO, UTC; empty: 1970) in the place of the one that Qt wrote into a PDF, and `Z` in that of the
/// machine's time zone; objects behind it move, and the table of their places with them. Throws Internal where the
/// PDF is not of the form that QPdfWriter gives it.
void set_creation_date(std::string& pdf, std::string_view created_at);

} // namespace planum::paint
