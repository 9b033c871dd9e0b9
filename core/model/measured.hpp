// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/model/ids.hpp"

namespace planum::model {

/// What a measured height stands for.
enum class LevelRole { Top, Base, Cut, Other };

/// One measured height of a unit, in the site grid [m]; x and y may be unknown on old sheets.
struct Level {
    LevelId id;
    UnitId unit;
    std::optional<double> x;
    std::optional<double> y;
    double z = 0.0;
    LevelRole role = LevelRole::Top;
    std::string label;

    friend bool operator==(const Level&, const Level&) = default;
};

/// A found thing, or a bag of them.
struct Find {
    FindId id;
    std::string number;
    UnitId unit; ///< nil: not assigned yet
    std::optional<double> x;
    std::optional<double> y;
    std::optional<double> z;
    std::string type;
    std::string material;
    std::optional<std::int64_t> count;
    std::optional<double> weight; ///< [g]
    std::string condition;
    std::string box;
    std::string found_on; ///< ISO date
    std::string description;

    friend bool operator==(const Find&, const Find&) = default;
};

struct Sample {
    SampleId id;
    std::string number;
    UnitId unit;
    std::string type;             ///< soil, C14, charcoal, dendro, pollen, micromorphology, mortar, …
    std::optional<double> volume; ///< [l]
    std::optional<double> weight; ///< [g]
    std::string laboratory_number;
    std::string state; ///< stored, submitted, analysed, discarded
    std::string description;

    friend bool operator==(const Sample&, const Sample&) = default;
};

/// A photo, drawing, sheet or other paper that shows units. The file itself stays where it is.
struct Document {
    DocumentId id;
    std::string number;
    std::string type; ///< photo, drawing, sheet, …
    std::string title;
    UnitId unit;
    std::string path; ///< relative to the project file
    std::string made_on;
    std::string author;

    friend bool operator==(const Document&, const Document&) = default;
};

[[nodiscard]] std::string_view to_word(LevelRole role) noexcept;
[[nodiscard]] std::optional<LevelRole> level_role_from_word(std::string_view word) noexcept;

} // namespace planum::model
