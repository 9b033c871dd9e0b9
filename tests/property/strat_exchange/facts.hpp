// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/model/record.hpp"
#include "strat/exchange/imported_record.hpp"

namespace planum::test {

/// What a record says, one plain sentence each: `title 12: floor`, `covers 12 > 13`. The first word is
/// the tag by which a format's facts are chosen.
using Facts = std::set<std::string>;

/// Whether units are named with their areas always, or only where a number is used twice.
enum class Naming { Full, Short };

[[nodiscard]] Facts facts_of(const model::Record& record, Naming naming);
[[nodiscard]] Facts facts_of(const strat::ImportedRecord& record);

/// Only the facts with these tags.
[[nodiscard]] Facts only(const Facts& facts, const std::set<std::string, std::less<>>& tags);

/// The first facts that one has and the other has not, for messages.
[[nodiscard]] std::string difference(const Facts& a, const Facts& b);

} // namespace planum::test
