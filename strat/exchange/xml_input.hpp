// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <pugixml.hpp>

#include "strat/exchange/reader.hpp"

namespace planum::strat {

/// An XML file that came from somewhere: refuses every DOCTYPE (so no entity is ever declared), and more
/// elements than memory should hold. Names are matched without their prefix, as programs disagree on
/// namespaces.
class XmlInput {
  public:
    /// Throws BadInput with file and line when the bytes are no well-formed XML. `what` names the format
    /// that was looked for.
    XmlInput(std::string_view bytes, std::string_view file_name, std::string_view what);

    [[nodiscard]] pugi::xml_node root() const { return document_.document_element(); }

    /// The line a node begins on, from 1.
    [[nodiscard]] std::int64_t line_of(pugi::xml_node node) const;

    /// What had to be replaced in the text.
    [[nodiscard]] const std::vector<ReadNote>& notes() const noexcept { return notes_; }

  private:
    pugi::xml_document document_;
    std::vector<std::size_t> line_ends_; ///< offsets of the line feeds
    std::vector<ReadNote> notes_;
};

/// The name without its prefix: `y:ShapeNode` is `ShapeNode`.
[[nodiscard]] std::string_view local_name(pugi::xml_node node);

/// The first child element of that local name; a null node if there is none.
[[nodiscard]] pugi::xml_node child_named(pugi::xml_node node, std::string_view name);

/// The attribute as clean UTF-8, or empty.
[[nodiscard]] std::string attribute(pugi::xml_node node, const char* name);

/// All text directly inside the element, as clean UTF-8, trimmed.
[[nodiscard]] std::string text_of(pugi::xml_node node);

/// The next node of a walk over everything below `top` in document order, without recursion, since
/// nesting may be as deep as a file is long; a null node at the end.
[[nodiscard]] pugi::xml_node next_in_document(pugi::xml_node node, pugi::xml_node top);

} // namespace planum::strat
