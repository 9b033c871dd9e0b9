// SPDX-License-Identifier: MIT
#pragma once

#include <rapidcheck.h>

#include "core/model/record.hpp"

namespace planum::test {

/// How wild the texts of a generated record are.
struct RecordShape {
    bool plain_names = false;  ///< numbers without blanks, commas, colons; Latin-1 only
    bool comma_free = false;   ///< numbers without commas
    bool plain_titles = false; ///< titles of one short line in Latin-1
    bool one_group_each = false;
};

/// A record with everything a record can have, small, with awkward names and texts.
[[nodiscard]] rc::Gen<model::Record> generated_record(const RecordShape& shape);

} // namespace planum::test
