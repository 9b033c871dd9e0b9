// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "app/project/project.hpp"
#include "app/registration/registration_report.hpp"
#include "core/base/progress.hpp"

namespace planum::app {

enum class RegisterMethod {
    Auto,     ///< markers where there are any, features, fine alignment
    Markers,  ///< markers alone
    Features, ///< markers for the grid, features between scans; no fine alignment
    Icp,      ///< fine alignment from where markers, accepted poses or the files' own poses say
};

[[nodiscard]] std::string_view to_word(RegisterMethod method) noexcept;
[[nodiscard]] std::optional<RegisterMethod> register_method_from_word(std::string_view word) noexcept;

/// Whether a run that leaves no doubt holds at once.
enum class Acceptance { WhenGood, Never };

struct RegisterOptions {
    RegisterMethod method = RegisterMethod::Auto;
    std::string day;    ///< only scans of this day, placed before or not; empty: all that have no accepted pose
    bool again = false; ///< all scans anew, accepted ones too
    std::string origin; ///< a scan whose own frame is the site grid, where there are no markers
    Acceptance acceptance = Acceptance::WhenGood;
    std::size_t links_per_scan = 6;
    std::uint64_t seed = 1;
};

/// Places scans on the site grid and reports it; keeps nothing, so that a connection that only reads will do and what
/// takes minutes holds nobody up (keep_run keeps it). Without scans in the report there was nothing to do. Throws as
/// register_scans does.
[[nodiscard]] RegistrationReport compute_registration(Project& project, const RegisterOptions& options,
                                                      Progress& progress);

/// Places scans on the site grid and keeps the result as a run, as one undo step. Earlier accepted scans that are not
/// asked for stay where they are. Scans that cannot be placed are reported as failed with the reason. A run is
/// accepted at once if asked for and no scan is placed poorly; else it stays proposed. Throws Usage or NotFound for
/// days, scans and methods that are none, BadInput if there is nothing to place.
[[nodiscard]] RegistrationReport register_scans(Project& project, const RegisterOptions& options, Progress& progress);

} // namespace planum::app
