// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "app/demo/simulator.hpp"
#include "app/registration/register_scans.hpp"
#include "tests/support/dug_tally.hpp"
#include "tests/support/evidence_tally.hpp"

namespace planum::test {

/// A simulated dig that went through the program, from files to proposals, against its truth.
struct EvidenceDig {
    std::size_t scans = 0;
    std::size_t placed = 0;
    std::size_t surfaces = 0;
    EvidenceTally tally;
    std::vector<std::string> false_contradictions; ///< height-contradictions of the true record, as messages
    std::size_t visible_mistakes = 0;              ///< relations put the wrong way round that surfaces can show
    std::vector<std::string> hidden_mistakes;      ///< that they cannot, with why not, by why_not_shown()
    std::size_t found_mistakes = 0;                ///< of these named by a height-contradiction
    std::vector<std::string> missed_mistakes;
    double register_seconds = 0.0;
    double first_seconds = 0.0; ///< grids, evidence and conclusions
    double again_seconds = 0.0; ///< the same from what was kept
    DugVolumesTold volumes;     ///< where they were asked for
    double volume_seconds = 0.0;
};

struct EvidenceWanted {
    bool loud = false; ///< says on stdout what is inverted, missed, no contact
    bool volumes = false;
};

/// Writes the dig into the folder, imports its sheets, scans, markers and outlines into a project, registers, and
/// gathers evidence.
[[nodiscard]] EvidenceDig evidence_of_dig(const std::filesystem::path& folder,
                                          const app::demo::SimulationOptions& options, app::RegisterMethod method,
                                          const EvidenceWanted& wanted = {});

} // namespace planum::test
