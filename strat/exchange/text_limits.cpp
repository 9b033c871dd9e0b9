// SPDX-License-Identifier: MIT
#include "strat/exchange/text_limits.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

#include <fmt/format.h>

#include "core/base/error.hpp"

namespace planum::strat {

namespace {

// The first character behind marks of the encoding and blanks; zeros stand between those of UTF-16.
bool begins_like_markup(std::string_view bytes) {
    constexpr std::string_view kBefore{"\xEF\xBB\xBF\xFF\xFE \t\r\n\0", 10};
    const std::size_t first = bytes.find_first_not_of(kBefore);
    return first != std::string_view::npos && std::string_view{"<{["}.find(bytes[first]) != std::string_view::npos;
}

} // namespace

void refuse_endless_text(std::string_view bytes, std::string_view file_name) {
    if (bytes.size() <= kMaxTextRun) return;
    const bool markup = begins_like_markup(bytes);
    std::array<bool, 256> ends{};
    for (const char c : std::string_view{markup ? "\n\r<>\"" : "\n\r"}) ends.at(static_cast<unsigned char>(c)) = true;
    std::size_t from = 0;
    for (std::size_t at = 0; at <= bytes.size(); ++at) {
        if (at < bytes.size() && !ends[static_cast<unsigned char>(bytes[at])]) continue;
        if (at - from > kMaxTextRun) {
            const auto line = 1 + std::count(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(from), '\n');
            throw Error(ErrorCode::BadInput,
                        fmt::format("{}: line {}: {} of {} MB, more than the {} MB that a record may have; "
                                    "look whether this is the right file, or mend that line",
                                    file_name, line, markup ? "a value" : "a line", (at - from) / 1000000,
                                    kMaxTextRun / 1000000));
        }
        from = at + 1;
    }
}

} // namespace planum::strat
