// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "app/evidence/evidence.hpp"
#include "core/model/record.hpp"

namespace planum::app {

/// `2025-06-03` as 3 June 2025; anything else as it is.
[[nodiscard]] std::string day_words(const std::string& day);

/// Why a relation is proposed, or what is asked, as a sentence with days, area and thickness.
[[nodiscard]] std::string reason_of(const model::Record& record, const model::RecordIndex& index,
                                    const AreaEvidence& area, const scans::Conclusion& conclusion);

} // namespace planum::app
