// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "core/base/error.hpp"
#include "core/geometry/coordinate_system.hpp"
#include "core/geometry/gpb.hpp"
#include "core/store/schema.hpp"
#include "core/store/state.hpp"

namespace planum::store {

namespace {

constexpr std::string_view kHasSystem = "SELECT 1 FROM gpkg_spatial_ref_sys WHERE srs_id = :srs";
constexpr std::string_view kAddSystem =
    "INSERT INTO gpkg_spatial_ref_sys(srs_name, srs_id, organization, organization_coordsys_id, definition) "
    "VALUES (:name, :srs, 'EPSG', :srs, :wkt)";
constexpr std::string_view kProjectSystem = "SELECT srs_id FROM project LIMIT 1";
constexpr std::string_view kLayersOff =
    "SELECT count(*) FROM gpkg_geometry_columns WHERE srs_id <> (SELECT srs_id FROM project LIMIT 1) "
    "AND table_name IN ('region','find','level','section','scan_pose')";
constexpr std::string_view kSetContents =
    "UPDATE gpkg_contents SET srs_id = :srs WHERE table_name IN ('region','find','level','section','scan_pose')";
constexpr std::string_view kSetColumns = "UPDATE gpkg_geometry_columns SET srs_id = :srs WHERE table_name IN "
                                         "('region','find','level','section','scan_pose')";

// Geometries carry the number of their system; a changed project rewrites them, as a change like any other.
void rewrite_geometries(const sqlite::Database& database, std::string_view layer, std::int32_t srs_id) {
    sqlite::Statement rows = database.prepare(fmt::format("SELECT fid, geom FROM {} WHERE geom IS NOT NULL", layer));
    sqlite::Statement write = database.prepare(fmt::format("UPDATE {} SET geom = :geom WHERE fid = :fid", layer));
    std::vector<std::pair<std::int64_t, std::vector<std::byte>>> changed;
    while (rows.step()) {
        geometry::Geometry geometry = geometry::decode_gpb(rows.blob(1));
        if (geometry.srs_id == srs_id) continue;
        geometry.srs_id = srs_id;
        geometry.has_z = geometry.has_z || layer != "region"; // the layers of points hold points with height
        changed.emplace_back(rows.integer(0), geometry::encode_gpb(geometry));
    }
    for (const auto& [fid, blob] : changed) {
        write.bind_blob(":geom", blob).bind(":fid", fid).run();
    }
}

} // namespace

void add_spatial_reference(const sqlite::Database& database, std::int64_t srs_id) {
    sqlite::Statement known = database.prepare(kHasSystem);
    if (known.bind(":srs", srs_id).step()) return;
    const auto system = geometry::coordinate_system_of_epsg(srs_id);
    if (!system) {
        throw Error(ErrorCode::BadInput,
                    fmt::format("no coordinate system EPSG:{} is known; use -1 for a local grid", srs_id));
    }
    sqlite::Statement add = database.prepare(kAddSystem);
    add.bind(":name", std::string_view{system->name})
        .bind(":srs", srs_id)
        .bind(":wkt", std::string_view{system->wkt})
        .run();
}

void sync_spatial_reference(ProjectFile::State& state) {
    const sqlite::Database& database = state.database;
    const std::int64_t srs_id = database.integer(kProjectSystem);
    if (srs_id < -1 || srs_id > 999'999) {
        throw Error(ErrorCode::BadInput, fmt::format("{} is no EPSG code; use -1 for a local grid", srs_id));
    }
    state.srs_id = static_cast<std::int32_t>(srs_id);
    if (database.integer(kLayersOff) == 0) return;
    add_spatial_reference(database, srs_id);
    for (const std::string_view sql : {kSetContents, kSetColumns}) {
        sqlite::Statement set = database.prepare(sql);
        set.bind(":srs", srs_id).run();
    }
    for (const std::string_view layer : kFeatureTables) rewrite_geometries(database, layer, state.srs_id);
}

} // namespace planum::store
