// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "app/demo/record_generator.hpp"

namespace planum::app {

/// Mistakes as people make them, each on one sheet: where the other sheet states the relation too, it
/// still states it right.
enum class MistakeKind {
    Reversed,        ///< above and below exchanged
    Transposed,      ///< two neighbouring digits of the other unit's number exchanged
    Mistyped,        ///< one digit of the other unit's number wrong
    WrongSameAs,     ///< two units taken for one
    NumberUsedTwice, ///< one number given to two units
    SwappedLevels,   ///< the levels of two neighbouring units exchanged
};

struct MistakeOptions {
    std::uint64_t seed = 1;
    /// Relations of the shortest cycle that the mistake closes, at least; 0: any mistake will do, also one
    /// that closes none. A reversal whose other sheet is right closes a cycle of two.
    std::size_t least_cycle = 6;
    std::size_t tries = 20'000;
};

struct Mistake {
    MistakeKind kind = MistakeKind::Reversed;
    model::RelationId relation; ///< the wrong one (same_as too); nil for numbers used twice and levels
    model::UnitId unit;         ///< whose number or levels are wrong; nil for relations
    std::size_t cycle = 0;      ///< relations in the shortest cycle through it; 0: none
    std::string what;           ///< in words, for messages of tests
};

/// Makes one mistake that closes a cycle as asked; nullopt when none was found. The record stays sorted;
/// same_as is not followed when cycles are measured.
[[nodiscard]] std::optional<Mistake> seed_mistake(GeneratedRecord& generated, MistakeKind kind,
                                                  const MistakeOptions& options);

} // namespace planum::app
