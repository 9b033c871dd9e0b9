// SPDX-License-Identifier: MIT
#include "strat/exchange/xml_output.hpp"

#include "core/base/text.hpp"

namespace planum::strat {

std::string xml_escape(std::string_view utf8) {
    const std::string clean = text::clean_utf8(utf8).text;
    std::string out;
    out.reserve(clean.size() + clean.size() / 8);
    for (const char c : clean) {
        switch (c) {
        case '&': out += "&amp;"; break;
        case '<': out += "&lt;"; break;
        case '>': out += "&gt;"; break;
        case '"': out += "&quot;"; break;
        case '\'': out += "&apos;"; break;
        case '\n': out += "&#10;"; break;
        case '\t': out += "&#9;"; break;
        default: out.push_back(c);
        }
    }
    // U+FFFE and U+FFFF are valid UTF-8 and no XML characters.
    out = text::replace_all(out, "\xEF\xBF\xBE", "\xEF\xBF\xBD");
    return text::replace_all(out, "\xEF\xBF\xBF", "\xEF\xBF\xBD");
}

} // namespace planum::strat
