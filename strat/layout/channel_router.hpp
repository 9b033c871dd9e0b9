// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace planum::strat {

/// One connected piece of a net between two levels: verticals coming down to it and going down from it.
struct Wire {
    std::vector<double> tops;    ///< x of the ends at the upper level [pt]
    std::vector<double> bottoms; ///< x of the ends at the lower level [pt]
};

/// Where a wire's horizontal runs. A wire that would otherwise stand in a ring of wires each of which has
/// to be above the next gets two horizontals, joined by a vertical at `knee`.
struct WireRoute {
    std::int32_t track = -1; ///< from the top; −1: the wire is one straight vertical

    struct Knee {
        double x = 0.0;
        std::int32_t track = 0; ///< of the second horizontal, below the first
    };

    std::optional<Knee> knee;
};

struct ChannelRoute {
    std::vector<WireRoute> wires;
    std::int32_t tracks = 0;
};

/// Fourth phase, for the channel between two levels: gives every wire a track so that no two wires touch
/// but where a horizontal and a vertical cross, and few do. Ends at one level must be kTouching apart.
[[nodiscard]] ChannelRoute route_channel(const std::vector<Wire>& wires);

/// Verticals nearer than this would be read as one [pt].
inline constexpr double kTouching = 4.5;

} // namespace planum::strat
