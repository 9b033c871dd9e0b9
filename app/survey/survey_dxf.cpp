// SPDX-License-Identifier: MIT
#include "app/survey/survey_dxf.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "strat/exchange/delimited_table.hpp"

namespace planum::app {

namespace {

constexpr double kLabelReach = 0.25; ///< [m]
constexpr double kFarthest = 1e8;    ///< [m]

// Group codes of the DXF reference (Autodesk, AutoCAD 2012): 0 entity, 1 text, 2 block or tag, 8 layer, 10/20/30 place.
struct Entity {
    std::string type;
    std::string layer;
    std::string text;
    std::string name; ///< block of an INSERT, tag of an ATTRIB
    double x = 0.0;
    double y = 0.0;
    std::optional<double> z;
    bool placed = false;
    std::int64_t line = 0;
    std::vector<std::pair<std::string, std::string>> attributes;
};

// Pairs of lines: a group code and its value.
class GroupReader {
  public:
    explicit GroupReader(std::string_view text) : text_(text) {}

    [[nodiscard]] bool next() {
        std::string_view code;
        if (!take_line(code) || !take_line(value_)) return false;
        const auto number = text::parse_integer(text::trim(code));
        if (!number || *number < -5 || *number > 1071) {
            throw Error(ErrorCode::BadInput, fmt::format("line {}: no group code of a DXF drawing", line_ - 1));
        }
        code_ = static_cast<int>(*number);
        value_ = text::trim(value_);
        return true;
    }

    [[nodiscard]] int code() const { return code_; }

    [[nodiscard]] std::string_view value() const { return value_; }

    [[nodiscard]] std::int64_t line() const { return line_; }

  private:
    bool take_line(std::string_view& line) {
        if (at_ >= text_.size()) return false;
        const std::size_t end = std::min(text_.find('\n', at_), text_.size());
        line = text_.substr(at_, end - at_);
        if (line.ends_with('\r')) line.remove_suffix(1);
        at_ = end + 1;
        ++line_;
        return true;
    }

    std::string_view text_;
    std::string_view value_;
    std::size_t at_ = 0;
    std::int64_t line_ = 0;
    int code_ = 0;
};

void set(Entity& entity, int code, std::string_view value) {
    const auto number = [&](double& target) {
        const auto read = text::parse_double(value);
        if (!read || !(std::abs(*read) < kFarthest)) return false;
        target = *read;
        return true;
    };
    switch (code) {
    case 1: entity.text += value; break;
    case 2: entity.name = value; break;
    case 3: entity.text += value; break; // MTEXT in pieces
    case 8: entity.layer = value; break;
    case 10: entity.placed = number(entity.x); break;
    case 20: entity.placed = number(entity.y) && entity.placed; break;
    case 30:
        if (double z = 0.0; number(z)) entity.z = z;
        break;
    default: break;
    }
}

bool is_wanted(std::string_view type) {
    return type == "POINT" || type == "TEXT" || type == "MTEXT" || type == "INSERT" || type == "ATTRIB";
}

// The entities of the ENTITIES section that may be measured points; attributes go to their INSERT.
std::vector<Entity> entities_of(std::string_view text) {
    std::vector<Entity> entities;
    GroupReader groups(text);
    bool inside = false;
    bool section = false;
    Entity open;
    const auto close = [&] {
        if (open.type == "ATTRIB") {
            if (!entities.empty() && entities.back().type == "INSERT") {
                entities.back().attributes.emplace_back(text::fold_case(open.name), open.text);
            }
        } else if (is_wanted(open.type)) {
            entities.push_back(std::move(open));
        }
        open = {};
    };
    while (groups.next()) {
        if (groups.code() == 0) {
            close();
            section = groups.value() == "SECTION";
            if (groups.value() == "ENDSEC") inside = false;
            if (inside) {
                open.type = groups.value();
                open.line = groups.line();
            }
            continue;
        }
        if (section && groups.code() == 2) {
            inside = groups.value() == "ENTITIES";
            section = false;
            continue;
        }
        if (inside) set(open, groups.code(), groups.value());
    }
    close();
    return entities;
}

SurveyPoint point_of(const Entity& entity) {
    SurveyPoint point;
    point.code = entity.layer;
    point.x = entity.x;
    point.y = entity.y;
    point.z = entity.z;
    point.line = entity.line;
    point.source = PointSource::Drawing;
    return point;
}

bool is_one_of(std::string_view word, std::initializer_list<std::string_view> names) {
    return std::find(names.begin(), names.end(), word) != names.end();
}

SurveyPoint inserted_point(const Entity& entity) {
    SurveyPoint point = point_of(entity);
    if (!entity.name.empty()) point.code = entity.name;
    for (const auto& [tag, value] : entity.attributes) {
        if (is_one_of(tag, {"unit", "us", "context", "befund", "ue", "stelle"})) point.unit = value;
        if (is_one_of(tag, {"find", "fund", "fundnr", "reperto", "sf"})) point.find = value;
        if (is_one_of(tag, {"code", "kode", "codice"})) point.code = value;
        if (is_one_of(tag, {"nr", "no", "number", "name", "pt", "punktnr", "point"})) point.name = value;
        if (is_one_of(tag, {"z", "h", "height", "hoehe", "höhe", "quota", "elev"})) {
            if (const auto z = text::parse_double(text::trim(value))) point.z = *z;
        }
        if (is_one_of(tag, {"text", "description", "remark", "bemerkung"})) point.text = value;
    }
    return point;
}

bool is_text(const Entity& entity) { return entity.type == "TEXT" || entity.type == "MTEXT"; }

// Takes the nearest unused text of the layer; positions into `texts`.
void label(SurveyPoint& point, const std::string& layer, const std::vector<const Entity*>& texts,
           std::vector<bool>& used) {
    std::size_t nearest = texts.size();
    double best = kLabelReach;
    for (std::size_t i = 0; i < texts.size(); ++i) {
        if (used[i] || texts[i]->layer != layer) continue;
        const double distance = std::hypot(texts[i]->x - point.x, texts[i]->y - point.y);
        if (distance > best) continue;
        best = distance;
        nearest = i;
    }
    if (nearest == texts.size()) return;
    used[nearest] = true;
    point.name = texts[nearest]->text;
}

// Nobody measured a height of 0 there.
void note_flat_points(SurveyFile& file, std::string_view file_name) {
    std::size_t flat = 0;
    std::int64_t first = 0;
    for (const SurveyPoint& point : file.points) {
        if (point.z) continue;
        if (flat++ == 0) first = point.line;
    }
    if (flat == 0) return;
    file.notes.push_back(
        {std::string(file_name),
         first,
         "no-height",
         {},
         fmt::format("{} of {} points of the drawing have no height (group 30)", flat, file.points.size())});
}

} // namespace

bool is_dxf(std::string_view bytes) noexcept {
    if (bytes.starts_with("AutoCAD Binary DXF")) return true;
    const std::string_view head = text::trim(bytes.substr(0, 4000));
    return (head.starts_with("0\n") || head.starts_with("0\r\n") || head.starts_with("999")) &&
           bytes.substr(0, 4000).find("SECTION") != std::string_view::npos;
}

SurveyFile read_survey_dxf(std::string_view bytes, std::string_view file_name) {
    if (bytes.starts_with("AutoCAD Binary DXF")) {
        throw Error(ErrorCode::BadInput, "it is a binary drawing; save it as ASCII DXF");
    }
    strat::DecodedText decoded = strat::decode_text(bytes, file_name);
    SurveyFile file;
    file.notes = std::move(decoded.notes);
    const std::vector<Entity> entities = entities_of(decoded.text);
    std::vector<const Entity*> texts;
    for (const Entity& entity : entities) {
        if (is_text(entity) && entity.placed) texts.push_back(&entity);
    }
    std::vector<bool> used(texts.size(), false);
    for (const Entity& entity : entities) {
        if (is_text(entity)) continue;
        if (!entity.placed) {
            file.notes.push_back({std::string(file_name), entity.line, "unparsed", entity.type,
                                  fmt::format("a {} without coordinates was left out", entity.type)});
            continue;
        }
        file.points.push_back(entity.type == "INSERT" ? inserted_point(entity) : point_of(entity));
        if (file.points.back().name.empty()) label(file.points.back(), entity.layer, texts, used);
    }
    for (std::size_t i = 0; i < texts.size(); ++i) {
        if (used[i]) continue;
        file.points.push_back(point_of(*texts[i]));
        file.points.back().name = texts[i]->text;
        file.points.back().source = PointSource::LoneText;
    }
    if (file.points.empty()) throw Error(ErrorCode::BadInput, "it holds no POINT, INSERT or TEXT");
    note_flat_points(file, file_name);
    return file;
}

} // namespace planum::app
