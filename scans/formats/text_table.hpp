// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "core/base/progress.hpp"
#include "scans/formats/byte_source.hpp"
#include "scans/formats/cloud_header.hpp"
#include "scans/formats/line_reader.hpp"
#include "scans/formats/point_plan.hpp"
#include "scans/formats/scan_reader.hpp"

namespace planum::scans {

/// A table of points in a text file: where it stands, how its lines are cut, what its columns mean.
struct TextTable {
    std::uint64_t offset = 0; ///< [byte]
    std::uint64_t first_line = 1;
    char separator = ' '; ///< ' ' stands for any number of blanks and tabs
    char decimal = '.';
    std::vector<Role> roles; ///< one a column
    PointPlan plan;
    Eigen::Matrix3d scan_from_file = Eigen::Matrix3d::Identity();
    bool turned = false; ///< scan_from_file is not the identity
};

/// Neither empty nor a comment (# or //).
[[nodiscard]] bool is_data_line(std::string_view line) noexcept;

/// The fields of a line, without quotes and blanks around them.
[[nodiscard]] std::vector<std::string_view> split_line(std::string_view line, char separator);

/// What a line of numbers is cut by: ';' or a tab if there is one, a comma if it does not look like the
/// decimal sign, else blanks.
[[nodiscard]] char guess_separator(std::string_view line) noexcept;

/// Reads the columns that have a role into `values` (one a column); throws BadInput with the line.
void read_row(const LineReader& lines, const TextTable& table, std::vector<double>& values);

/// Gives the columns that hold a number on the first line their meaning by how many they are and their values: 3: x y
/// z; 4: + intensity; 6: + colour where the values are whole and small; 7: both, in either order. Looks at the first
/// thousands of lines.
[[nodiscard]] std::vector<Role> guess_roles(const ByteSource& source, const TextTable& table, std::size_t columns);

/// Makes the plan from the roles and the ranges in the first thousands of lines, and fills what
/// `header` has of it.
void plan_table(const ByteSource& source, TextTable& table, CloudHeader& header);

/// Reads header.records data lines.
ReadSummary read_table(const ByteSource& source, const TextTable& table, const CloudHeader& header,
                       const PointSink& sink, const ReadOptions& options, Progress& progress);

/// "x y z intensity - red green blue"
[[nodiscard]] std::string roles_as_text(const std::vector<Role>& roles);

} // namespace planum::scans
