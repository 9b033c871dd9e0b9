// SPDX-License-Identifier: MIT
#include "cli/matrix_options.hpp"

#include <array>
#include <filesystem>
#include <string_view>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "core/base/error.hpp"
#include "core/base/text.hpp"

namespace planum::cli {

namespace {

bool is_drawing(MatrixKind kind) {
    return kind == MatrixKind::Svg || kind == MatrixKind::Pdf || kind == MatrixKind::Png;
}

std::string_view medium_of(MatrixKind kind) {
    switch (kind) {
    case MatrixKind::Stats: return "counts";
    case MatrixKind::Svg: return "SVG";
    case MatrixKind::Pdf: return "PDF";
    case MatrixKind::Png: return "PNG";
    case MatrixKind::Export: return "a file for other programs";
    }
    return {};
}

// Options by what they say something about; those not here are good for all.
constexpr std::array kParts = {"area", "around", "steps", "fold", "since", "compare", "problems"};
constexpr std::array kLooks = {"engine", "evidence", "bands", "frames", "titles", "language", "keep-places"};

struct OneMedium {
    std::string_view option;
    MatrixKind kind;
};

constexpr std::array kMedia = {
    OneMedium{"link", MatrixKind::Svg},
    OneMedium{"paper", MatrixKind::Pdf},
    OneMedium{"paging", MatrixKind::Pdf},
    OneMedium{"dpi", MatrixKind::Png},
};

[[noreturn]] void refuse(const std::string& sentence) { throw Error(ErrorCode::Usage, "matrix: " + sentence); }

void refuse_lonely_options(const CLI::App& command, const MatrixOptions& options) {
    const auto given = [&](const char* name) { return command.count(name) > 0; };
    const app::DrawRequest& draw = options.draw;
    if (given("--steps") && !given("--around")) refuse("steps says how far --around UNIT goes, which is not given");
    if (options.paging == "poster" && text::fold_case(options.paper) == "fit") {
        refuse("a poster needs paper to be cut to; say --paper A4, A3, A2, A1 or A0");
    }
    if (given("--bands") && given("--fold") && draw.bands != "none") refuse("folded drawings have no bands");
    // A folded box can hold units of several groups and of none; a frame around it would say otherwise.
    if (draw.frames && !draw.fold.empty()) refuse("folded drawings have no frames");
    if (draw.evidence && (given("--since") || given("--compare"))) {
        refuse("evidence and comparisons both colour the lines; take one of them");
    }
    if (draw.problems_only && (given("--since") || given("--compare"))) {
        refuse("problems, since and compare each choose what is drawn; take one of them");
    }
}

} // namespace

MatrixKind kind_of(const MatrixOptions& options) {
    if (options.stats) return MatrixKind::Stats;
    if (options.output == "-" && options.format.empty()) {
        refuse("-o - is standard output; say --format svg, pdf, png, dot, … with it");
    }
    const std::string word = options.format.empty()
                                 ? text::fold_case(std::filesystem::path(options.output).extension().string())
                                 : "." + text::fold_case(options.format);
    if (word == ".svg") return MatrixKind::Svg;
    if (word == ".pdf") return MatrixKind::Pdf;
    if (word == ".png") return MatrixKind::Png;
    return MatrixKind::Export;
}

void add_matrix_options(CLI::App& command, MatrixOptions& options) {
    app::DrawRequest& draw = options.draw;
    const auto not_empty = [](const std::string& text) {
        return text::trim(text).empty() ? std::string("an empty text names nothing") : std::string{};
    };
    CLI::Option* output =
        command
            .add_option("-o,--output", options.output,
                        "file to write (- : standard output): .svg .pdf .png are drawings; .dot .graphml .lst .hmcx "
                        ".csv .json are for other programs")
            ->check(not_empty, "");
    command
        .add_option("--format", options.format,
                    "format of the file, where its ending does not say (svg, hmc-csv, hm, …)")
        ->check(not_empty, "");
    command.add_flag("--stats", options.stats, "print counts instead")->excludes(output);
    command.add_option("--engine", draw.engine, "layout engine: planum or graphviz")->check(not_empty, "");
    command.add_option("--interpretation", draw.interpretation, "this reading instead of the field record")
        ->check(not_empty, "");
    command.add_option("--area", draw.area, "only this area")->check(not_empty, "");
    command.add_option("--around", draw.around, "only the neighbourhood of this unit")->check(not_empty, "");
    command.add_option("--steps", draw.around_steps, "how far around it")
        ->capture_default_str()
        ->check(CLI::Range(0, 100'000));
    command.add_option("--fold", draw.fold, "phases, periods or groups: one box each")->check(not_empty, "");
    command.add_option("--bands", draw.bands, "phases, periods or none; unasked where most units have a phase")
        ->check(not_empty, "");
    command.add_flag("--frames", draw.frames, "a frame around the units of each group");
    command.add_option("--since", draw.since, "only what was added, removed or changed since this day (YYYY-MM-DD)")
        ->check(not_empty, "");
    command
        .add_option("--compare", draw.compared_with,
                    "only where the interpretation differs from this one (record: from the field record)")
        ->check(not_empty, "");
    command.add_flag("--problems", draw.problems_only, "only what problems are about");
    command.add_flag("--evidence", draw.evidence,
                     "lines as what the evidence says of them: confirmed, contradicted, not testable");
    command.add_flag("--titles", draw.titles, "short definitions below the numbers");
    command.add_option("--language", draw.language, "of the key and headings: en or de")
        ->check(CLI::IsMember({"en", "de"}));
    command
        .add_option("--keep-places", draw.keep_places,
                    "an earlier drawing (.svg): what stands in it stays where it is, as far as it can")
        ->check(not_empty, "");
    command
        .add_option("--link", draw.unit_link,
                    "SVG: where a unit leads to when clicked, {unit} being its number (units.html#{unit})")
        ->check(not_empty, "");
    command.add_option("--paper", options.paper, "PDF: fit, A4, A3, A2, A1 or A0")
        ->capture_default_str()
        ->check(CLI::IsMember({"fit", "a4", "a3", "a2", "a1", "a0"}, CLI::ignore_case));
    command.add_option("--paging", options.paging, "PDF: shrink to one page, or a poster of many sheets")
        ->capture_default_str()
        ->check(CLI::IsMember({"page", "poster"}));
    command.add_option("--dpi", options.dpi, "PNG: pixels per inch")
        ->capture_default_str()
        ->check(CLI::Range(20.0, 1200.0))
        ->check(
            [](const std::string& text) {
                // The range takes what is not a number for one inside it.
                return text::fold_case(text).find("nan") == std::string::npos ? std::string{} : "no number";
            },
            "");
}

void refuse_useless_options(const CLI::App& command, const MatrixOptions& options, MatrixKind kind) {
    const auto given = [&](std::string_view name) { return command.count("--" + std::string(name)) > 0; };
    for (const std::string_view name : kParts) {
        if (is_drawing(kind) || !given(name)) continue;
        refuse(kind == MatrixKind::Stats
                   ? fmt::format("stats counts the whole site; {} makes a part of a drawing only", name)
                   : fmt::format("a file for other programs holds the whole site; {} makes a part of a drawing only "
                                 "(.svg, .pdf, .png)",
                                 name));
    }
    for (const std::string_view name : kLooks) {
        if (!is_drawing(kind) && given(name)) {
            refuse(fmt::format("{} is for drawings (.svg, .pdf, .png), not for {}", name, medium_of(kind)));
        }
    }
    for (const OneMedium& one : kMedia) {
        if (kind != one.kind && given(one.option)) {
            refuse(fmt::format("{} is for {}, not for {}", one.option, medium_of(one.kind), medium_of(kind)));
        }
    }
    if (kind == MatrixKind::Stats && given("format")) refuse("stats are printed; --json gives them for programs");
    refuse_lonely_options(command, options);
}

} // namespace planum::cli
