// SPDX-License-Identifier: MIT
// DXF R12 in ASCII, the dialect that archives ask for: outlines, section lines, finds, levels and scan stations.
#include <algorithm>
#include <array>
#include <limits>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/base/text.hpp"
#include "strat/exchange/map_features.hpp"
#include "strat/exchange/writers.hpp"

namespace planum::strat {

namespace {

using Point = std::array<double, 3>;
using Shape = MapFeature::Shape;

constexpr double kTextHeight = 0.08; // [m]; 4 mm on a plan at 1:20

// R12 knows capitals, digits and - _ $, at most 31 of them.
std::string layer_name(const MapFeature& feature) {
    std::string wanted = feature.layer;
    if (feature.layer == "region" || feature.layer == "level") wanted += "_" + feature.kind;
    std::string out;
    for (const char c : wanted) {
        if (c >= 'a' && c <= 'z')
            out += static_cast<char>(c - 'a' + 'A');
        else if ((c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9'))
            out += c;
        else
            out += '_';
    }
    return out.substr(0, 31);
}

// AutoCAD's numbered colours, so that layers can be told apart on the screen.
int colour_of(std::string_view layer) {
    constexpr std::array<std::pair<std::string_view, int>, 6> kColours = {
        {{"REGION_CUT", 1}, {"REGION_MASONRY", 8}, {"REGION", 3}, {"FIND", 6}, {"LEVEL", 5}, {"SECTION", 2}}};
    for (const auto& [start, colour] : kColours) {
        if (layer.starts_with(start)) return colour;
    }
    return 7;
}

/// Letters beyond ASCII as \U+XXXX, those beyond the first plane as a question mark; one line.
std::string dxf_text(std::string_view utf8) {
    const std::string clean = text::clean_utf8(utf8).text;
    std::string out;
    for (std::size_t i = 0; i < clean.size();) {
        const auto byte = static_cast<unsigned char>(clean[i]);
        if (byte < 0x80) {
            out += byte < 0x20 ? ' ' : clean[i];
            ++i;
            continue;
        }
        const std::size_t length = byte >= 0xF0 ? 4 : byte >= 0xE0 ? 3 : 2;
        unsigned code = byte & (0xFFU >> (length + 1));
        for (std::size_t k = 1; k < length; ++k) code = code << 6U | (static_cast<unsigned char>(clean[i + k]) & 0x3FU);
        out += length == 4 ? "?" : fmt::format("\\U+{:04X}", code);
        i += length;
    }
    return out;
}

class DxfFile {
  public:
    void point(const std::string& layer, const Point& x_in_site) {
        entity("POINT", layer);
        place(x_in_site);
    }

    void label(const std::string& layer, const Point& x_in_site, std::string_view words) {
        if (words.empty()) return;
        entity("TEXT", layer);
        place(x_in_site);
        pair(40, fmt::format("{}", kTextHeight));
        pair(1, dxf_text(words));
    }

    /// A three-dimensional polyline.
    void line(const std::string& layer, const std::vector<Point>& points, bool closed) {
        entity("POLYLINE", layer);
        pair(66, "1");
        place({0.0, 0.0, 0.0}, false);
        pair(70, closed ? "9" : "8");
        for (const Point& point : points) {
            entity("VERTEX", layer);
            place(point);
            pair(70, "32");
        }
        entity("SEQEND", layer);
    }

    [[nodiscard]] std::string whole() const {
        DxfFile out;
        out.pair(0, "SECTION");
        out.pair(2, "HEADER");
        out.pair(9, "$ACADVER");
        out.pair(1, "AC1009");
        if (low_[0] <= high_[0]) {
            out.pair(9, "$EXTMIN");
            out.place(low_, false);
            out.pair(9, "$EXTMAX");
            out.place(high_, false);
        }
        out.pair(0, "ENDSEC");
        out.pair(0, "SECTION");
        out.pair(2, "TABLES");
        out.line_types();
        out.layers(layers_);
        out.pair(0, "ENDSEC");
        out.pair(0, "SECTION");
        out.pair(2, "ENTITIES");
        out.text_ += text_;
        out.pair(0, "ENDSEC");
        out.pair(0, "EOF");
        return std::move(out.text_);
    }

  private:
    void pair(int code, std::string_view value) { text_ += fmt::format("{:3}\n{}\n", code, value); }

    void entity(std::string_view type, const std::string& layer) {
        pair(0, type);
        pair(8, layer);
        layers_.insert(layer);
    }

    void place(const Point& point, bool counts = true) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            pair(static_cast<int>(10 * (axis + 1)), fmt::format("{:.4f}", point[axis]));
            if (!counts) continue;
            low_[axis] = std::min(low_[axis], point[axis]);
            high_[axis] = std::max(high_[axis], point[axis]);
        }
    }

    void line_types() {
        pair(0, "TABLE");
        pair(2, "LTYPE");
        pair(70, "1");
        pair(0, "LTYPE");
        pair(2, "CONTINUOUS");
        pair(70, "0");
        pair(3, "Solid line");
        pair(72, "65");
        pair(73, "0");
        pair(40, "0.0");
        pair(0, "ENDTAB");
    }

    void layers(const std::set<std::string>& names) {
        pair(0, "TABLE");
        pair(2, "LAYER");
        pair(70, fmt::format("{}", names.size()));
        for (const std::string& name : names) {
            pair(0, "LAYER");
            pair(2, name);
            pair(70, "0");
            pair(62, fmt::format("{}", colour_of(name)));
            pair(6, "CONTINUOUS");
        }
        pair(0, "ENDTAB");
    }

    static constexpr double kFar = std::numeric_limits<double>::max();
    std::string text_;
    std::set<std::string> layers_;
    Point low_{kFar, kFar, kFar};
    Point high_{-kFar, -kFar, -kFar};
};

void add_outline(DxfFile& file, const std::string& layer, const MapFeature& feature) {
    for (const model::Polygon& part : feature.outline) {
        if (part.outer.empty()) continue;
        file.line(layer, part.outer, true);
        for (const model::Ring& hole : part.holes) file.line(layer, hole, true);
        Point middle{};
        for (const Point& point : part.outer) {
            for (std::size_t axis = 0; axis < 3; ++axis) {
                middle[axis] += point[axis] / static_cast<double>(part.outer.size());
            }
        }
        file.label(layer, middle, feature.label);
    }
}

} // namespace

Written write_dxf(const model::Record& record, const WriteOptions& /*options*/) {
    const RecordNames names(record);
    MapFeatures map = map_features(names);
    DxfFile file;
    std::size_t flat = 0;
    for (const MapFeature& feature : map.features) {
        const std::string layer = layer_name(feature);
        if (!feature.has_height) ++flat;
        switch (feature.shape) {
        case Shape::Outline: add_outline(file, layer, feature); break;
        case Shape::Line:
            file.line(layer, feature.points, false);
            file.label(layer, feature.points.front(), feature.label);
            break;
        case Shape::Point:
            file.point(layer, feature.points.front());
            file.label(layer, feature.points.front(), feature.label);
            break;
        }
    }
    add_loss(map.lost, flat, "heights that are unknown or have no meaning, written as 0");
    map.lost.emplace_back("everything but places, kinds and numbers: DXF is a drawing");
    return {{{"", file.whole()}}, std::move(map.lost)};
}

} // namespace planum::strat
