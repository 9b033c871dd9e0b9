// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/model/record.hpp"

namespace planum::app {

/// What a generated record looks like. The defaults are meant to be ordinary: a team that fills in sheets
/// from both sides most of the time, levels two units in three, and notes when a unit was dug.
///
/// Assumptions, so that nobody reads more into measurements on these records than there is:
/// - Ground is simulated cell by cell (trench_history.hpp); relations are contacts that were really there.
/// - Trenches of about 120 units; each has a block of numbers, given in the order in which units were
///   noticed: that of digging, blurred. The default makes the upper unit the one with the lower number in
///   about 70 of 100 relations, as at Çatalhöyük; there are sites where it is 35 (Al-Khutm). Three numbers
///   in a hundred are never used.
/// - Digging takes what is free, at or near where it worked last two times in three; a few units a day.
///   Two dates in a hundred are wrong by up to ten days.
/// - All immediate contacts but one in twenty are recorded, and of those implied by others as many as make
///   the share asked for. Each stands on both sheets with probability `both_sheets`, else on one.
/// - Levels are taken on one to three spots of what is left of a unit, on top and (less often) at the base
///   or on the cut's bottom, with noise; one in a hundred and fifty is misread by a metre or a decimetre.
/// - Finds date "not earlier than" with residuals (older things lying about); two in a hundred are
///   intrusive. Phases are slices of time; two units in a hundred stand in a neighbouring one.
struct RecordOptions {
    std::uint64_t seed = 1;
    std::size_t units = 300;         ///< 50 … 20,000
    double relations_per_unit = 1.6; ///< 1.2 … 5
    double redundant = 0.3;          ///< share of relations that others imply
    double both_sheets = 0.8;        ///< share stated from both sides; 0: a list with one side only
    double levelled = 0.65;          ///< share of units with levels
    double positioned = 0.7;         ///< share of levels with x and y
    double level_noise = 0.02;       ///< σ [m]
    double number_blur = 20.0;       ///< σ of the order of numbers against that of digging [places]
    double dug_dates = 0.7;          ///< share of units that say when they were dug
    double dated = 0.12;             ///< share with finds that date
    double phased = 0.5;             ///< share with a phase
    double same_as = 0.01;           ///< share of layers that carry two numbers
    double uncertain = 0.02;         ///< share of relations marked so
    double unknown_kind = 0.05;      ///< share of units whose kind nobody wrote down
};

struct GeneratedRecord {
    model::Record record;
    /// Truth: when each of record.units formed, ascending in time; of two units of one trench the one with
    /// the larger number formed later, whatever the record says.
    std::vector<double> formed;
};

/// The same record for the same options. Throws Error{Usage} for options outside their ranges.
[[nodiscard]] GeneratedRecord generate_record(const RecordOptions& options);

} // namespace planum::app
