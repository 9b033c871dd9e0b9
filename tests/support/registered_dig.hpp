// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/demo/simulator.hpp"
#include "app/registration/register_scans.hpp"

namespace planum::test {

/// A simulated dig whose scans were put on the site grid, against the truth.
struct RegisteredDig {
    app::RegistrationReport report;
    std::size_t scans = 0;  ///< there are
    std::size_t placed = 0; ///< were placed
    /// Largest displacement of a point of the trench, one a scan but the first: relative to the first scan [m].
    std::vector<double> relative;
    std::vector<double> absolute;        ///< the same on the site grid, one a scan [m]
    std::vector<double> absolute_points; ///< of every point of a lattice in the trench, of every scan [m]
    /// eᵀ C⁻¹ e of the poses on the site grid, six expected.
    std::vector<double> absolute_chi;
    /// The same of the links: the alignments of pairs against their stated covariance.
    std::vector<double> link_chi;
    double seconds = 0.0; ///< of planum register
};

/// Writes the dig into the folder, brings all its scans into a new project with the markers of the first scan only
/// (or of all), and registers them. No pose is given.
[[nodiscard]] RegisteredDig register_dig(const std::filesystem::path& folder,
                                         const app::demo::SimulationOptions& options, bool all_markers = false);

/// The same for a dig that was written before.
[[nodiscard]] RegisteredDig register_written_dig(const std::filesystem::path& folder, bool all_markers = false);

[[nodiscard]] double median_of(std::vector<double> values);
[[nodiscard]] double largest_of(const std::vector<double>& values);

} // namespace planum::test
