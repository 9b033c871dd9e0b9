// SPDX-License-Identifier: MIT
#include "app/regions/outline_text.hpp"

#include <cctype>
#include <cstddef>

#include <fmt/format.h>

#include "core/base/error.hpp"
#include "core/base/text.hpp"

namespace planum::app {

namespace {

// WKT of a polygon is brackets three deep around lists of points; a bare list has none.
class OutlineParser {
  public:
    explicit OutlineParser(std::string_view text) : text_(text) {}

    geometry::MultiPolygon parse() {
        const std::string word = text::fold_case(keyword());
        if (word.empty()) {
            shape_ = {{{}}};
            points(shape_[0][0]);
        } else if (word == "polygon") {
            shape_.push_back(polygon());
        } else if (word == "multipolygon") {
            list([&] { shape_.push_back(polygon()); });
        } else {
            fail(word);
        }
        skip_blanks();
        if (at_ < text_.size()) fail(text_.substr(at_, 20));
        return std::move(shape_);
    }

  private:
    [[noreturn]] static void fail(std::string_view at) {
        throw Error(ErrorCode::BadInput,
                    fmt::format("outline: cannot read “{}”; write x y z, x y z, … or POLYGON((…))", at));
    }

    void skip_blanks() {
        while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
    }

    std::string_view keyword() {
        skip_blanks();
        const std::size_t from = at_;
        while (at_ < text_.size() && std::isalpha(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
        const std::string_view word = text_.substr(from, at_ - from);
        skip_blanks();
        if (at_ < text_.size() && (text_[at_] == 'Z' || text_[at_] == 'z')) ++at_;
        return word;
    }

    [[nodiscard]] bool take(char wanted) {
        skip_blanks();
        if (at_ >= text_.size() || text_[at_] != wanted) return false;
        ++at_;
        return true;
    }

    template<class Item>
    void list(Item item) {
        if (!take('(')) fail(text_.substr(at_, 20));
        do {
            item();
        } while (take(','));
        if (!take(')')) fail(text_.substr(at_, 20));
    }

    geometry::Rings polygon() {
        geometry::Rings rings;
        list([&] {
            if (!take('(')) fail(text_.substr(at_, 20));
            points(rings.emplace_back());
            if (!take(')')) fail(text_.substr(at_, 20));
        });
        return rings;
    }

    void points(geometry::Line3& ring) {
        do {
            geometry::Point3 p{};
            std::size_t n = 0;
            while (n < 3) {
                skip_blanks();
                const std::size_t from = at_;
                while (at_ < text_.size() && text_[at_] != ',' && text_[at_] != ')' &&
                       std::isspace(static_cast<unsigned char>(text_[at_])) == 0) {
                    ++at_;
                }
                if (at_ == from) break;
                const auto value = text::parse_double(text_.substr(from, at_ - from));
                if (!value) fail(text_.substr(from, at_ - from));
                p[n++] = *value;
            }
            if (n < 2) fail(text_.substr(at_, 20));
            ring.push_back(p);
        } while (take(','));
        const bool closed = ring.size() > 1 && ring.front()[0] == ring.back()[0] && ring.front()[1] == ring.back()[1];
        if (closed) ring.pop_back();
    }

    std::string_view text_;
    std::size_t at_ = 0;
    geometry::MultiPolygon shape_;
};

} // namespace

geometry::MultiPolygon parse_outline(std::string_view text) { return OutlineParser(text).parse(); }

std::string outline_text(const geometry::MultiPolygon& shape) {
    std::vector<std::string> polygons;
    for (const geometry::Rings& rings : shape) {
        std::vector<std::string> lines;
        for (const geometry::Line3& ring : rings) {
            std::vector<std::string> points;
            for (std::size_t i = 0; i <= ring.size() && !ring.empty(); ++i) {
                const geometry::Point3& p = ring[i % ring.size()];
                points.push_back(fmt::format("{:.3f} {:.3f} {:.3f}", p[0], p[1], p[2]));
            }
            lines.push_back("(" + text::join(points, ", ") + ")");
        }
        polygons.push_back("(" + text::join(lines, ", ") + ")");
    }
    if (polygons.size() == 1) return "POLYGON Z " + polygons.front();
    return "MULTIPOLYGON Z (" + text::join(polygons, ", ") + ")";
}

} // namespace planum::app
