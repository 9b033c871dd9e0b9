// SPDX-License-Identifier: MIT
#pragma once

#include <span>

namespace planum::gui::services {

// What the services below the window say, in the order of their folders; `%1` stands where they put something in.
// Context of the translations: `services`.

[[nodiscard]] std::span<const char* const> file_sentences();
[[nodiscard]] std::span<const char* const> record_sentences();
[[nodiscard]] std::span<const char* const> scan_sentences();
[[nodiscard]] std::span<const char* const> import_sentences();

/// A sentence that sends people to the command line, and what the window says instead, with the same places.
struct Reworded {
    const char* said;
    const char* here;
};

[[nodiscard]] std::span<const Reworded> command_hints();

} // namespace planum::gui::services
