// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

#include "app/demo/simulator.hpp"

namespace planum::test {

/// Why the surfaces of a dig cannot show in which order two units that touch lay; empty: they can. Judged from the
/// truth alone (exact ground, exact labels as the digger recognised them), by what docs/evidence.md says about what
/// surfaces prove, and by nothing that was concluded:
/// - `later` lay bare and `earlier` below it on the next surface, 2 cm lower, over 0.02 m² that are farther than 6 cm
///   (twice the error of a drawn line) from the outlines of either;
/// - on stratigraphic surfaces no emptied cut is concerned, but by what was in it;
/// - on levels both are deposits, the contact dips under 50° over 60 % of its area, and `earlier` was bare beside
///   `later` already or `later` is gone altogether: what first appears inside another unit may have been seen too late.
[[nodiscard]] std::string why_not_shown(const app::demo::DemoDig& dig, app::demo::UnitNo later,
                                        app::demo::UnitNo earlier);

} // namespace planum::test
