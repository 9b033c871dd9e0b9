// SPDX-License-Identifier: MIT
#pragma once

#include <pugixml.hpp>

#include "core/model/record.hpp"

namespace planum::app::xml {

/// Appends `sections`, `regions` and `scans`: where the units lay and where the scans stood, in site coordinates [m].
void write_places_of_units(pugi::xml_node root, const model::Record& record);

/// Appends `interpretations`: the readings beside the record, by the relations they add and leave out.
void write_interpretations(pugi::xml_node root, const model::Record& record);

} // namespace planum::app::xml
