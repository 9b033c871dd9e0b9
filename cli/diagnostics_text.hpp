// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "core/model/diagnostic.hpp"
#include "core/model/record.hpp"

namespace planum::cli {

/// A diagnostic with the keys that DESIGN 9 fixes.
[[nodiscard]] nlohmann::ordered_json to_json(const model::Diagnostic& diagnostic, const model::RecordIndex& index);

[[nodiscard]] nlohmann::ordered_json to_json(const model::Coverage& coverage);

/// What a suspect is, in a few words: `17 covers 12`, `number 1042, probably 1024`, ….
[[nodiscard]] std::string describe(const model::Suspect& suspect, const model::RecordIndex& index);

} // namespace planum::cli
