// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "strat/exchange/json_support.hpp"
#include "strat/exchange/record_builder.hpp"

namespace planum::strat {

/// What a Field Desktop resource is to us.
enum class FieldRole { Unit, Find, Sample, Document, Place, Other };

/// One resource with where it stood.
struct FieldResource {
    Json json; ///< the object `resource`
    std::string id;
    std::string identifier;
    std::string category;
    FieldRole role = FieldRole::Other;
    std::string file;
    std::int64_t line = 0;
};

/// The role by category; a category of somebody's own that has relations of strata is a unit as well.
[[nodiscard]] FieldRole field_role(const Json& resource, std::string_view category);

/// The ids that a relation names.
[[nodiscard]] std::vector<std::string> field_targets(const Json& resource, std::string_view relation);

/// A text that may be one text, a list of texts, or a text in several languages (the first one that has any).
[[nodiscard]] std::string field_text(const Json& resource, std::string_view key);

/// `05.03.2021` or `05.03.2021 09:28` as `2021-03-05`; anything else as it stands.
[[nodiscard]] std::string field_date(const Json& resource, std::string_view key);

/// Fills the fields of a unit's sheet.
void read_field_unit(const FieldResource& resource, ImportedUnit& unit);

/// The datings of a resource, without unit and find.
[[nodiscard]] std::vector<model::Dating> read_field_datings(const Json& resource);

} // namespace planum::strat
