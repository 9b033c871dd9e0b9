// SPDX-License-Identifier: MIT
#include "core/store/row_visitors.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "core/geometry/gpb.hpp"

namespace planum::store {

void RowBinder::null() { statement_->bind_null(index_++); }

void RowBinder::text(std::string_view, const std::string& value) {
    if (value.empty()) {
        null();
    } else {
        statement_->bind_static(index_++, value);
    }
}

void RowBinder::integer(std::string_view, std::int64_t value) { statement_->bind(index_++, value); }

void RowBinder::integer(std::string_view, const std::optional<std::int64_t>& value) {
    if (value) {
        statement_->bind(index_++, *value);
    } else {
        null();
    }
}

void RowBinder::real(std::string_view column, double value) {
    if (!std::isfinite(value)) {
        throw Error(ErrorCode::BadInput, fmt::format("{} is not a finite number", column));
    }
    statement_->bind(index_++, value);
}

void RowBinder::real(std::string_view column, const std::optional<double>& value) {
    if (value) {
        real(column, *value);
    } else {
        null();
    }
}

void RowBinder::boolean(std::string_view, bool value) { statement_->bind(index_++, std::int64_t{value ? 1 : 0}); }

void RowBinder::uuid(const Uuid& id) {
    if (id.is_nil()) {
        null();
    } else if (ids_used_ < ids_.size()) {
        std::array<char, 36>& text = ids_[ids_used_++];
        const std::string said = id.to_string();
        std::copy(said.begin(), said.end(), text.begin());
        statement_->bind_static(index_++, std::string_view{text.data(), text.size()});
    } else {
        statement_->bind(index_++, std::string_view{id.to_string()});
    }
}

void RowBinder::position(const std::optional<double>& x, const std::optional<double>& y,
                         const std::optional<double>& z) {
    if (x && y) {
        const geometry::Geometry point{srs_id_, true, geometry::Point3{*x, *y, z.value_or(0.0)}};
        statement_->bind_blob(index_++, geometry::encode_gpb(point));
        null();
        null();
    } else {
        null();
        real("x", x);
        real("y", y);
    }
    real("z", z);
}

void RowBinder::line(const std::array<double, 2>& from, const std::array<double, 2>& to) {
    const geometry::Line3 points{{from[0], from[1], 0.0}, {to[0], to[1], 0.0}};
    statement_->bind_blob(index_++, geometry::encode_gpb({srs_id_, true, points}));
}

void RowBinder::outline(const std::vector<model::Polygon>& outline, bool has_heights) {
    if (outline.empty()) {
        null();
        return;
    }
    geometry::MultiPolygon polygons;
    polygons.reserve(outline.size());
    for (const model::Polygon& polygon : outline) {
        geometry::Rings& rings = polygons.emplace_back();
        rings.push_back(polygon.outer);
        rings.insert(rings.end(), polygon.holes.begin(), polygon.holes.end());
    }
    statement_->bind_blob(index_++, geometry::encode_gpb({srs_id_, has_heights, std::move(polygons)}));
}

void RowBinder::station(const std::array<double, 16>& site_from_scan) {
    const geometry::Point3 origin{site_from_scan[3], site_from_scan[7], site_from_scan[11]};
    statement_->bind_blob(index_++, geometry::encode_gpb({srs_id_, true, origin}));
}

void RowBinder::details(const model::UnitDetails& details) {
    std::size_t bound = 0;
    for (const model::UnitFieldInfo& field : model::kUnitFields) {
        const auto it = details.find(field.name);
        if (it == details.end()) {
            null();
        } else {
            text(field.name, it->second);
            ++bound;
        }
    }
    if (bound == details.size()) return;
    for (const auto& [name, value] : details) {
        const bool known = std::any_of(model::kUnitFields.begin(), model::kUnitFields.end(),
                                       [&](const model::UnitFieldInfo& field) { return field.name == name; });
        if (!known) throw Error(ErrorCode::BadInput, fmt::format("no field of a unit is called {}", name));
    }
}

void RowBinder::number_list(std::span<const double> values) {
    std::string list;
    for (const double value : values) {
        if (!std::isfinite(value)) throw Error(ErrorCode::BadInput, "a matrix holds a number that is not finite");
        if (!list.empty()) list += ' ';
        list += fmt::format("{}", value); // the shortest text that reads back as the same number
    }
    statement_->bind(index_++, std::string_view{list});
}

void RowReader::refuse(std::string_view column, std::string_view value) const {
    throw Error(ErrorCode::BadInput,
                fmt::format("table {}: {} cannot be '{}'", table_, column, text::clean_utf8(value.substr(0, 60)).text));
}

Uuid RowReader::uuid(std::string_view column) {
    const std::string_view said = row_->text(column_);
    if (said.empty()) {
        ++column_;
        return {};
    }
    const std::optional<Uuid> id = Uuid::parse(said);
    if (!id) refuse(column, said);
    ++column_;
    return *id;
}

void RowReader::position(std::optional<double>& x, std::optional<double>& y, std::optional<double>& z) {
    const auto blob = row_->blob(column_);
    x = row_->optional_real(column_ + 1);
    y = row_->optional_real(column_ + 2);
    z = row_->optional_real(column_ + 3);
    column_ += 4;
    if (blob.empty()) return;
    const geometry::Geometry geometry = geometry::decode_gpb(blob);
    const auto* point = std::get_if<geometry::Point3>(&geometry.shape);
    if (point == nullptr) return;
    x = (*point)[0];
    y = (*point)[1];
    // The column is what people see and type; a point drawn elsewhere may have only its own height. 0 is what a point
    // has in the geometry when nobody said a height, here as in QGIS.
    if (!z && geometry.has_z && (*point)[2] != 0.0) z = (*point)[2];
}

void RowReader::position(std::optional<double>& x, std::optional<double>& y, double& z) {
    std::optional<double> height;
    position(x, y, height);
    z = height.value_or(0.0);
}

void RowReader::line(std::array<double, 2>& from, std::array<double, 2>& to) {
    const auto blob = row_->blob(column_++);
    if (blob.empty()) return;
    const geometry::Geometry geometry = geometry::decode_gpb(blob);
    const auto* points = std::get_if<geometry::Line3>(&geometry.shape);
    if (points == nullptr || points->empty()) return;
    from = {points->front()[0], points->front()[1]};
    to = {points->back()[0], points->back()[1]};
}

void RowReader::outline(std::vector<model::Polygon>& outline, bool& has_heights) {
    const auto blob = row_->blob(column_++);
    outline.clear();
    if (blob.empty()) return;
    geometry::Geometry geometry = geometry::decode_gpb(blob);
    auto* polygons = std::get_if<geometry::MultiPolygon>(&geometry.shape);
    if (polygons == nullptr) return;
    has_heights = geometry.has_z;
    for (geometry::Rings& rings : *polygons) {
        if (rings.empty()) continue;
        model::Polygon& polygon = outline.emplace_back();
        polygon.outer = std::move(rings.front());
        polygon.holes.assign(std::make_move_iterator(rings.begin() + 1), std::make_move_iterator(rings.end()));
    }
}

void RowReader::details(model::UnitDetails& details) {
    for (const model::UnitFieldInfo& field : model::kUnitFields) {
        const std::string_view value = row_->text(column_++);
        if (!value.empty()) details.emplace_hint(details.end(), field.name, value);
    }
}

void RowReader::number_list(std::string_view column, std::span<double> values) {
    const std::string_view list = row_->text(column_++);
    if (list.empty()) return; // as it was made: all zero
    const char* at = list.data();
    const char* const end = at + list.size();
    for (double& value : values) {
        while (at != end && *at == ' ') ++at;
        const auto [after, failure] = std::from_chars(at, end, value);
        if (failure != std::errc{} || !std::isfinite(value)) refuse(column, list);
        at = after;
    }
    if (at != end) refuse(column, list);
}

} // namespace planum::store
