// SPDX-License-Identifier: MIT
#include "strat/exchange/python_literal.hpp"

#include <cstdint>

#include "core/base/text.hpp"
#include "core/base/utf8.hpp"

namespace planum::strat {

namespace {

constexpr int kMaxDepth = 16;
constexpr std::size_t kMaxItems = 100'000; // in all lists together; a sheet has some dozens

bool is_blank(char c) noexcept { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

int hex_digit(char c) noexcept {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

class LiteralReader {
  public:
    explicit LiteralReader(std::string_view s) : s_(s) {}

    std::optional<PythonValue> whole() {
        skip_blanks();
        PythonValue value;
        if (at_end() || (s_[at_] != '[' && s_[at_] != '(')) return std::nullopt;
        if (!list(value, 1)) return std::nullopt;
        skip_blanks();
        if (!at_end()) return std::nullopt;
        return value;
    }

  private:
    [[nodiscard]] bool at_end() const noexcept { return at_ >= s_.size(); }

    void skip_blanks() noexcept {
        while (!at_end() && is_blank(s_[at_])) ++at_;
    }

    bool list(PythonValue& out, int depth) {
        if (depth > kMaxDepth) return false;
        const char close = s_[at_] == '[' ? ']' : ')';
        ++at_;
        out.is_list = true;
        while (true) {
            skip_blanks();
            if (at_end()) return false;
            if (s_[at_] == close) {
                ++at_;
                return true;
            }
            if (++items_ > kMaxItems || !value(out.items.emplace_back(), depth)) return false;
            skip_blanks();
            if (at_end()) return false;
            if (s_[at_] == ',') {
                ++at_;
            } else if (s_[at_] != close) {
                return false;
            }
        }
    }

    bool value(PythonValue& out, int depth) {
        const char c = s_[at_];
        if (c == '[' || c == '(') return list(out, depth + 1);
        if (c == '\'' || c == '"') return quoted(out.text);
        // u'...' and b'...', as Python 2 printed them.
        const bool prefixed = (c == 'u' || c == 'U' || c == 'b' || c == 'B' || c == 'r' || c == 'R') &&
                              at_ + 1 < s_.size() && (s_[at_ + 1] == '\'' || s_[at_ + 1] == '"');
        if (prefixed) {
            ++at_;
            return quoted(out.text);
        }
        const std::size_t begin = at_;
        while (!at_end() && s_[at_] != ',' && s_[at_] != ']' && s_[at_] != ')' && s_[at_] != '[' && s_[at_] != '(' &&
               s_[at_] != '\'' && s_[at_] != '"') {
            ++at_;
        }
        out.text = text::trim(s_.substr(begin, at_ - begin));
        if (out.text == "None") out.text.clear();
        return at_ > begin;
    }

    bool quoted(std::string& out) {
        const char quote = s_[at_++];
        while (!at_end()) {
            const char c = s_[at_++];
            if (c == quote) return true;
            if (c != '\\') {
                out.push_back(c);
            } else if (!escape(out)) {
                return false;
            }
        }
        return false;
    }

    bool escape(std::string& out) {
        if (at_end()) return false;
        const char c = s_[at_++];
        switch (c) {
        case 'n': out.push_back('\n'); return true;
        case 't': out.push_back('\t'); return true;
        case 'r': out.push_back('\r'); return true;
        case '\\':
        case '\'':
        case '"': out.push_back(c); return true;
        case 'x': return code_point(out, 2);
        case 'u': return code_point(out, 4);
        case 'U': return code_point(out, 8);
        default: // Python keeps an unknown escape as it stands
            out.push_back('\\');
            out.push_back(c);
            return true;
        }
    }

    bool code_point(std::string& out, std::size_t digits) {
        if (s_.size() - at_ < digits) return false;
        std::uint32_t code = 0;
        for (std::size_t i = 0; i < digits; ++i) {
            const int digit = hex_digit(s_[at_++]);
            if (digit < 0) return false;
            code = (code << 4U) | static_cast<std::uint32_t>(digit);
        }
        const bool is_character = code <= 0x10FFFFU && (code < 0xD800U || code > 0xDFFFU);
        text::append_utf8(out, is_character ? code : 0xFFFDU);
        return true;
    }

    std::string_view s_;
    std::size_t at_ = 0;
    std::size_t items_ = 0;
};

} // namespace

std::optional<PythonValue> read_python_list(std::string_view utf8) { return LiteralReader(utf8).whole(); }

} // namespace planum::strat
