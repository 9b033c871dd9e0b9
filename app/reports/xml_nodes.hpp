// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <pugixml.hpp>

#include "core/base/text.hpp"

/// The few ways in which the XML report writes a value.
namespace planum::app::xml {

/// XML 1.0 has no place for control characters; entering them is refused, but old files may hold some.
inline std::string clean(std::string_view text) { return text::clean_utf8(text).text; }

inline void required(pugi::xml_node node, const char* name, std::string_view value) {
    node.append_attribute(name).set_value(clean(value).c_str());
}

/// Left out when there is nothing to say.
inline void attribute(pugi::xml_node node, const char* name, std::string_view value) {
    if (!value.empty()) required(node, name, value);
}

/// The uuid of another record; left out when nil.
template<class Id>
void reference(pugi::xml_node node, const char* name, const Id& id) {
    if (!id.is_nil()) required(node, name, id.to_string());
}

template<class T>
void optional(pugi::xml_node node, const char* name, const std::optional<T>& value) {
    if (value) required(node, name, fmt::format("{}", *value));
}

inline void element(pugi::xml_node parent, const char* name, std::string_view text) {
    if (!text.empty()) parent.append_child(name).text().set(clean(text).c_str());
}

} // namespace planum::app::xml
