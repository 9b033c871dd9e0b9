// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "strat/layout/drawing.hpp"

namespace planum::strat {

/// The words of a drawing's own in its key and headings, UTF-8; what is made of the record is not among them. English
/// unless set otherwise.
struct DrawingWords {
    /// By BoxShape.
    std::array<std::string, 10> shapes = {"deposit",  "cut",     "structure", "interface",         "feature",
                                          "skeleton", "natural", "void",      "kind not recorded", "folded"};
    /// By Mark; the first is not shown.
    std::array<std::string, 5> marks = {"", "added", "removed", "changed", "problem"};
    std::array<std::string, 5> marked_orders = {"", "added order", "removed order", "changed order", ""};
    std::string mentioned_only = "named in relations only";
    std::string with_finds = "with finds";
    std::string inner_cycle = "contradiction that no line shows";
    std::string uncertain = "uncertain";
    std::string through = "by way of units not drawn";
    std::string in_cycle = "in a cycle";
    std::string against_bands = "against the strips";
    std::string isolated = "No order drawn ({})"; ///< true of a part of the matrix, too; `{}`: how many boxes
    std::string untitled = "Harris matrix";       ///< heading where the site has no name
    std::string one_unit = "1 unit";              ///< in a folded box
    std::string units = "{} units";
    std::string some_units = "{} of {} units"; ///< where the drawing leaves out the others

    // What is drawn, below the heading.
    std::string area = "area {}";
    std::string around = "around unit {}";
    std::string problems = "problems";
    std::string changed_since = "changed since {}"; ///< a day, YYYY-MM-DD
    std::string compared = "{}, compared with {}";  ///< two interpretations
    std::string record = "the field record";

    // The description for screen readers: units, boxes and orders with their numbers, then orders in cycles.
    std::string description = "Harris matrix of {} in {} with {}; later units stand above earlier ones.";
    std::string one_box = "1 box";
    std::string boxes = "{} boxes";
    std::string one_order = "1 immediate order";
    std::string orders = "{} immediate orders";
    std::string cycles = "{} of the orders stand in cycles.";

    // On paper.
    std::string scale = "scale {} %";
    std::string sheet = "sheet {}"; ///< of a poster: `B3`
    std::string page = "page {} of {}";
    std::string sheets = "Sheets";
    std::string map = "map of the sheets";
    std::string index = "index";
    std::string unit_and_sheet = "Unit and sheet";
};

[[nodiscard]] DrawingWords german_words();

/// Words of a language by its code (`en`, `de`); those of others are English.
[[nodiscard]] DrawingWords words_in(std::string_view language);

/// A word with a number, or another word, in the place of its first `{}`.
[[nodiscard]] std::string with_number(std::string_view word, std::size_t number);
[[nodiscard]] std::string with_word(std::string_view word, std::string_view inside);

} // namespace planum::strat
