// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "scans/surface/conclusions.hpp"

namespace planum::scans {

/// An order that somebody knows without the surfaces.
struct KnownOrder {
    UnitNumber later = kNobody;
    UnitNumber earlier = kNobody;

    friend bool operator==(const KnownOrder&, const KnownOrder&) = default;
};

/// Leaves of the questions those whose answer neither the proposals nor `known` nor both together imply, and of these
/// the most useful: at most one for each relation proposed from levels, one for five from stratigraphic surfaces.
/// Useful is what settles many orders and most likely is a contact at all; of two that are equally so the smaller
/// contact, since large ones are on the sheets anyway. Of fewer than eight proposals nothing can be settled: then the
/// largest contacts. The order of `all` stays; `units` is the number of units they speak of.
void keep_useful_questions(std::vector<Conclusion>& all, std::size_t units, std::span<const KnownOrder> known = {});

} // namespace planum::scans
