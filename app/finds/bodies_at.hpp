// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/model/record.hpp"

namespace planum::app {

/// A height as far as it is known: the true one lies between [m].
struct HeightRange {
    double low = 0.0;
    double high = 0.0;
};

/// What one surface shows at one place.
struct SeenThere {
    const model::Surface* surface = nullptr; ///< of the record
    const model::Region* region = nullptr;   ///< whose outline covers the place
    std::optional<HeightRange> face;         ///< of the ground there; unset: neither scan nor outline says it
};

/// A unit between the surface that first shows it at a place and the one that shows something else there.
struct BodyThere {
    model::UnitId unit; ///< nil: a region without unit
    const SeenThere* first = nullptr;
    const SeenThere* last = nullptr;
    const SeenThere* below = nullptr;  ///< first that shows something else; nullptr: none yet
    std::optional<HeightRange> top;    ///< unset: not known
    std::optional<HeightRange> bottom; ///< unset: not known
    bool is_cut = false;               ///< a cut has a face and no body
};

/// The bodies at one place from what the surfaces of one area show there, in the order of time. Where a region shows
/// the unit's own upper face, that is the boundary; of artificial levels it lies somewhere between the two levels;
/// below a cut the unit under it begins at the cut. Surfaces that show spoil or another category without unit there say
/// nothing. The bodies point into `seen`.
[[nodiscard]] std::vector<BodyThere> bodies_there(const model::Record& record, const std::vector<SeenThere>& seen);

} // namespace planum::app
