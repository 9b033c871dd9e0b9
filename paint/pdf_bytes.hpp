// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace planum::paint {

/// Puts a time (ISO, UTC; empty: 1970) in the place of the one that Qt wrote into a PDF. The field has a fixed length,
/// so no offset moves.
void set_creation_date(std::string& pdf, std::string_view created_at);

} // namespace planum::paint
