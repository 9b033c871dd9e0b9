// SPDX-License-Identifier: MIT
#include "strat/exchange/xml_input.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "strat/exchange/delimited_table.hpp"
#include "strat/exchange/record_builder.hpp"
#include "strat/exchange/text_limits.hpp"

namespace planum::strat {

namespace {

constexpr std::ptrdiff_t kMaxElements = 8'000'000; // about 1 GB in memory

std::vector<std::size_t> offsets_of_line_feeds(std::string_view text) {
    std::vector<std::size_t> offsets;
    for (std::size_t at = text.find('\n'); at != std::string_view::npos; at = text.find('\n', at + 1)) {
        offsets.push_back(at);
    }
    return offsets;
}

std::int64_t line_at(const std::vector<std::size_t>& line_ends, std::size_t offset) {
    return 1 + (std::lower_bound(line_ends.begin(), line_ends.end(), offset) - line_ends.begin());
}

} // namespace

XmlInput::XmlInput(std::string_view bytes, std::string_view file_name, std::string_view what) {
    if (text::trim(bytes).empty()) throw Error(ErrorCode::BadInput, fmt::format("{}: the file is empty", file_name));
    if (!is_probably_text(bytes)) {
        throw Error(ErrorCode::BadInput, fmt::format("{}: binary, not {}", file_name, what));
    }
    refuse_endless_text(bytes, file_name); // again: this may come out of an archive
    DecodedText decoded = decode_text(bytes, file_name);
    notes_ = std::move(decoded.notes);
    if (std::count(decoded.text.begin(), decoded.text.end(), '<') > kMaxElements) {
        throw Error(ErrorCode::BadInput, fmt::format("{}: more than {} XML elements", file_name, kMaxElements));
    }
    line_ends_ = offsets_of_line_feeds(decoded.text);
    // The text is UTF-8 by now, whatever its declaration says.
    const pugi::xml_parse_result result = document_.load_buffer(
        decoded.text.data(), decoded.text.size(), pugi::parse_default | pugi::parse_doctype, pugi::encoding_utf8);
    for (const pugi::xml_node node : document_.children()) {
        if (node.type() != pugi::node_doctype) continue;
        throw Error(ErrorCode::BadInput, fmt::format("{}: line {}: a DOCTYPE is not accepted; remove it from the file",
                                                     file_name, line_of(node)));
    }
    if (!result) {
        const auto offset = static_cast<std::size_t>(std::max<std::ptrdiff_t>(result.offset, 0));
        throw Error(ErrorCode::BadInput,
                    fmt::format("{}: line {}: no well-formed XML, so not {}: {}", file_name,
                                line_at(line_ends_, offset), what, text::fold_case(result.description())));
    }
}

std::int64_t XmlInput::line_of(pugi::xml_node node) const {
    const std::ptrdiff_t offset = node.offset_debug();
    return offset < 0 ? 0 : line_at(line_ends_, static_cast<std::size_t>(offset));
}

std::string_view local_name(pugi::xml_node node) {
    const std::string_view name = node.name();
    const std::size_t colon = name.find(':');
    return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

pugi::xml_node child_named(pugi::xml_node node, std::string_view name) {
    for (const pugi::xml_node child : node.children()) {
        if (local_name(child) == name) return child;
    }
    return {};
}

std::string attribute(pugi::xml_node node, const char* name) {
    return text::clean_utf8(node.attribute(name).value()).text;
}

std::string text_of(pugi::xml_node node) {
    std::string all;
    for (const pugi::xml_node child : node.children()) {
        if (child.type() == pugi::node_pcdata || child.type() == pugi::node_cdata) all += child.value();
    }
    return std::string{text::trim(text::clean_utf8(all).text)};
}

pugi::xml_node next_in_document(pugi::xml_node node, pugi::xml_node top) {
    if (const pugi::xml_node child = node.first_child()) return child;
    while (node && node != top) {
        if (const pugi::xml_node sibling = node.next_sibling()) return sibling;
        node = node.parent();
    }
    return {};
}

} // namespace planum::strat
