// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "app/drawing/draw_matrix.hpp"

namespace CLI {
class App;
}

namespace planum::cli {

/// What `planum matrix` was asked for.
struct MatrixOptions {
    app::DrawRequest draw;
    std::string output; ///< `-`: standard output
    std::string paper = "fit";
    std::string paging = "page";
    std::string format;
    double dpi = 150.0;
    bool stats = false;
};

/// What comes out.
enum class MatrixKind { Stats, Svg, Pdf, Png, Export };

/// By --stats, --format or the ending of the file. Throws Usage where none says it.
[[nodiscard]] MatrixKind kind_of(const MatrixOptions& options);

void add_matrix_options(CLI::App& command, MatrixOptions& options);

/// Throws Usage for an option that would be left aside without a word: one that says nothing about `kind`, or only
/// something together with another. A whole site sent off for a part would not be noticed.
void refuse_useless_options(const CLI::App& command, const MatrixOptions& options, MatrixKind kind);

} // namespace planum::cli
