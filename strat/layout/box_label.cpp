// SPDX-License-Identifier: MIT
#include "strat/layout/box_label.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "core/base/text.hpp"
#include "strat/layout/drawing_style.hpp"
#include "strat/layout/wrapped_text.hpp"

namespace planum::strat {

using model::UnitKind;

namespace {

bool is_letter_or_digit(char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

} // namespace

BoxShape shape_of(const model::StratigraphicUnit& unit) {
    switch (unit.kind) {
    case UnitKind::Unknown: return BoxShape::Unknown;
    case UnitKind::Deposit: return BoxShape::Deposit;
    case UnitKind::Cut: return BoxShape::Cut;
    case UnitKind::Feature: return BoxShape::Feature;
    case UnitKind::Structure: return BoxShape::Structure;
    case UnitKind::Interface: return BoxShape::Interface;
    case UnitKind::Skeleton: return BoxShape::Skeleton;
    case UnitKind::Natural: return BoxShape::Natural;
    case UnitKind::Void: return BoxShape::Void;
    }
    return BoxShape::Unknown;
}

bool names_topsoil(const model::StratigraphicUnit& unit) {
    constexpr std::array<std::string_view, 8> kWords = {"topsoil",    "turf",      "oberboden",      "mutterboden",
                                                        "ackerkrume", "humus sup", "terre végétale", "plough soil"};
    const std::string title = text::fold_case(unit.title);
    return std::any_of(kWords.begin(), kWords.end(),
                       [&](std::string_view word) { return title.find(word) != std::string::npos; });
}

std::vector<std::string> broken_title(const std::string& title, const TextMeasure& measure) {
    constexpr std::size_t kMaxLines = 3;
    return wrapped(title, style::kBoxMaxLabel, kMaxLines, {style::kTextSize, FontWeight::Regular}, measure);
}

std::vector<std::string> joined_names(const std::vector<std::string>& names, const std::vector<bool>& doubtful,
                                      const TextMeasure& measure) {
    constexpr TextLook kLook{style::kTextSize, FontWeight::Regular};
    const auto width = [&](const std::string& words) { return measure.width(words, kLook.size, kLook.weight); };
    std::vector<std::string> lines;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const std::string next = (i == 0 ? "" : doubtful[i] ? "=? " : "= ") + names[i];
        if (i > 0 && width(lines.back() + " " + next) <= style::kBoxMaxLabel) {
            lines.back() += " " + next;
            continue;
        }
        // A name is never cut off; a very long one makes a box three times as wide as high.
        const double whole = width(next);
        const double widest = std::max(style::kBoxMaxLabel, std::sqrt(whole * style::kLineHeight * 3.0));
        for (std::string& line : broken_anywhere(next, widest, kLook, measure)) lines.push_back(std::move(line));
    }
    return lines;
}

void size_box(DrawnBox& box, const TextMeasure& measure) {
    double widest = 0.0;
    box.line_widths.clear();
    for (const std::string& line : box.lines) {
        box.line_widths.push_back(measure.width(line, box.text_size, FontWeight::Regular));
        widest = std::max(widest, box.line_widths.back());
    }
    // Whole points: two boxes side by side can then both be reached from above the middle between them.
    box.rect.width = std::ceil(std::max(style::kBoxMinWidth, widest + 2.0 * style::kBoxPadding) +
                               (box.inner_cycle ? 2.0 * style::kInnerMark : 0.0));
    box.rect.height = style::kBoxHeight + style::kLineHeight * static_cast<double>(box.lines.size() - 1);
}

std::string xml_id(std::string_view prefix, std::string_view name) {
    std::string id(prefix);
    for (std::size_t i = 0; i < name.size(); ++i) {
        const char c = name[i];
        const bool joins = c == '-' && (id.ends_with('-') || i + 1 == name.size());
        if ((is_letter_or_digit(c) || c == '-' || c == '.') && !joins) {
            id += c;
        } else {
            id += fmt::format("_x{:02x}", static_cast<unsigned char>(c));
        }
    }
    return id;
}

std::string unit_link_of(std::string_view pattern, std::string_view name, const model::UnitId& id) {
    std::string encoded;
    for (const char c : name) {
        if (is_letter_or_digit(c) || c == '-' || c == '.' || c == '_' || c == '~') {
            encoded += c;
        } else {
            encoded += fmt::format("%{:02X}", static_cast<unsigned char>(c));
        }
    }
    // The id first: a name has no braces left that could be taken for one.
    return text::replace_all(text::replace_all(pattern, "{uuid}", id.to_string()), "{unit}", encoded);
}

} // namespace planum::strat
