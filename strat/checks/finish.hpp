// SPDX-License-Identifier: MIT
#pragma once

#include "strat/checks/check_context.hpp"

namespace planum::strat {

/// Makes more than `alike_become_one` infos (or dangling units) of one code one, sets ids and evidence hashes, sorts:
/// errors first, then by code, then by the units in record order.
void finish(const CheckContext& context, Findings& findings);

/// First 12 hexadecimal digits of the SHA-256 over code, sorted unit names and relations. Where a
/// diagnostic names no unit (a line that was not understood), the texts of its evidence stand in.
[[nodiscard]] std::string diagnostic_id(const CheckContext& context, const model::Diagnostic& diagnostic);

/// Hash over what must not change for a decision to hold: units, relations, texts, and the *signs* of
/// numbers. Sizes may grow; see decisions.hpp for areas.
[[nodiscard]] std::string evidence_hash(const CheckContext& context, const model::Diagnostic& diagnostic);

} // namespace planum::strat
