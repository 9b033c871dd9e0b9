// SPDX-License-Identifier: MIT
#include "app/regions/outline_text.hpp"

#include <array>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <limits>

#include <fmt/format.h>

#include "core/base/error.hpp"
#include "core/base/text.hpp"

namespace planum::app {

namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

// WKT of a polygon is brackets three deep around lists of points; a bare list has none.
class OutlineParser {
  public:
    explicit OutlineParser(std::string_view text) : text_(text) {}

    geometry::MultiPolygon parse() {
        const std::string_view written = keyword();
        const std::string word = geometry_word(written);
        if (word.empty()) {
            shape_ = {{{}}};
            points(shape_[0][0]);
        } else if (word == "polygon") {
            shape_.push_back(polygon());
        } else if (word == "multipolygon") {
            list([&] { shape_.push_back(polygon()); });
        } else {
            fail(written);
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
        return text_.substr(from, at_ - from);
    }

    // `POLYGON Z`, `PolygonZ`, `POLYGONZM`: what coordinates stand behind x and y is a word of its own or not.
    std::string geometry_word(std::string_view written) {
        std::string word = text::fold_case(written);
        std::string dimensions;
        for (const std::string_view name : {"multipolygon", "polygon"}) {
            if (!word.starts_with(name)) continue;
            dimensions = word.substr(name.size());
            word = name;
        }
        if (!word.empty() && dimensions.empty()) dimensions = text::fold_case(keyword());
        if (dimensions != "" && dimensions != "z" && dimensions != "m" && dimensions != "zm") fail(written);
        has_measure_ = dimensions == "m" || dimensions == "zm";
        most_ = has_measure_ ? dimensions.size() + 2 : 3;
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
            std::array<double, 4> p = {0.0, 0.0, kUnknown, kUnknown};
            std::size_t n = 0;
            while (n < most_) {
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
            if (has_measure_) p[most_ - 1] = kUnknown; // it is no height
            ring.push_back({p[0], p[1], p[2]});
        } while (take(','));
        const bool closed = ring.size() > 1 && ring.front()[0] == ring.back()[0] && ring.front()[1] == ring.back()[1];
        if (closed) ring.pop_back();
    }

    std::string_view text_;
    std::size_t at_ = 0;
    std::size_t most_ = 3;     ///< numbers of a point
    bool has_measure_ = false; ///< the last of them is a measure
    geometry::MultiPolygon shape_;
};

} // namespace

geometry::MultiPolygon parse_outline(std::string_view text) { return OutlineParser(text).parse(); }

std::string outline_text(const geometry::MultiPolygon& shape) {
    std::vector<std::string> polygons;
    bool flat = false;
    for (const geometry::Rings& rings : shape) {
        std::vector<std::string> lines;
        for (const geometry::Line3& ring : rings) {
            std::vector<std::string> points;
            for (std::size_t i = 0; i <= ring.size() && !ring.empty(); ++i) {
                const geometry::Point3& p = ring[i % ring.size()];
                flat = flat || std::isnan(p[2]);
                points.push_back(std::isnan(p[2]) ? fmt::format("{:.3f} {:.3f}", p[0], p[1])
                                                  : fmt::format("{:.3f} {:.3f} {:.3f}", p[0], p[1], p[2]));
            }
            lines.push_back("(" + text::join(points, ", ") + ")");
        }
        polygons.push_back("(" + text::join(lines, ", ") + ")");
    }
    const std::string dimensions = flat ? " " : " Z ";
    if (polygons.size() == 1) return "POLYGON" + dimensions + polygons.front();
    return "MULTIPOLYGON" + dimensions + "(" + text::join(polygons, ", ") + ")";
}

} // namespace planum::app
