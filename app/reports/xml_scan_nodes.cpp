// SPDX-License-Identifier: MIT
#include "app/reports/xml_scan_nodes.hpp"

#include <string>
#include <unordered_map>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/reports/xml_nodes.hpp"

namespace planum::app::xml {

namespace {

using pugi::xml_node;

// Tenths of a millimetre: outlines are drawn to centimetres.
std::string ring_text(const model::Ring& ring) {
    std::string text;
    for (const auto& point : ring) {
        text += fmt::format("{}{:.4f} {:.4f} {:.4f}", text.empty() ? "" : " ", point[0], point[1], point[2]);
    }
    return text;
}

void write_sections(xml_node root, const model::Record& record) {
    xml_node sections = root.append_child("sections");
    for (const model::Section& section : record.sections) {
        xml_node node = sections.append_child("section");
        required(node, "id", section.id.to_string());
        reference(node, "area", section.area);
        required(node, "name", section.name);
        required(node, "from", fmt::format("{}", fmt::join(section.from_in_site, " ")));
        required(node, "to", fmt::format("{}", fmt::join(section.to_in_site, " ")));
        attribute(node, "day", section.day);
    }
}

void write_regions(xml_node root, const model::Record& record) {
    xml_node regions = root.append_child("regions");
    for (const model::Region& region : record.regions) {
        xml_node node = regions.append_child("region");
        required(node, "id", region.id.to_string());
        reference(node, "surface", region.surface);
        reference(node, "section", region.section);
        reference(node, "unit", region.unit);
        attribute(node, "unit-as-drawn", region.unit_as_drawn);
        required(node, "part", fmt::format("{}", region.part));
        required(node, "category", to_word(region.category));
        required(node, "shows", to_word(region.shows));
        required(node, "sigma", fmt::format("{}", region.sigma));
        attribute(node, "drawn-on", region.drawn_on);
        if (!region.has_heights) required(node, "heights", "unknown");
        reference(node, "seen-in", region.seen_in);
        for (const model::Polygon& polygon : region.outline) {
            xml_node shape = node.append_child("polygon");
            element(shape, "outer", ring_text(polygon.outer));
            for (const model::Ring& hole : polygon.holes) element(shape, "hole", ring_text(hole));
        }
        element(node, "notes", region.notes);
    }
}

void write_scans(xml_node root, const model::Record& record) {
    std::unordered_map<model::RegistrationRunId, const model::RegistrationRun*> runs;
    for (const model::RegistrationRun& run : record.runs) runs.emplace(run.id, &run);
    xml_node scans = root.append_child("scans");
    for (const model::Scan& scan : record.scans) {
        xml_node node = scans.append_child("scan");
        required(node, "id", scan.id.to_string());
        required(node, "name", scan.name);
        attribute(node, "day", scan.day);
        reference(node, "surface", scan.surface);
        attribute(node, "path", scan.path);
        attribute(node, "sha256", scan.sha256);
        attribute(node, "format", scan.format);
        required(node, "cloud", fmt::format("{}", scan.cloud));
        required(node, "points", fmt::format("{}", scan.points));
        attribute(node, "sensor", scan.sensor);
        attribute(node, "acquired-at", scan.acquired_at);
        const model::ScanPose* pose = model::pose_in_force(record, scan.id);
        if (pose == nullptr) continue;
        xml_node placed = node.append_child("pose");
        if (const auto run = runs.find(pose->run); run != runs.end()) {
            attribute(placed, "run", run->second->name);
            attribute(placed, "method", run->second->method);
        }
        required(placed, "rms", fmt::format("{}", pose->rms));
        required(placed, "overlap", fmt::format("{}", pose->overlap));
        attribute(placed, "verdict", pose->verdict);
        element(placed, "site-from-scan", fmt::format("{}", fmt::join(pose->site_from_scan, " ")));
        element(placed, "covariance", fmt::format("{}", fmt::join(pose->covariance, " ")));
    }
}

} // namespace

void write_places_of_units(xml_node root, const model::Record& record) {
    write_sections(root, record);
    write_regions(root, record);
    write_scans(root, record);
}

void write_interpretations(xml_node root, const model::Record& record) {
    xml_node interpretations = root.append_child("interpretations");
    for (const model::Interpretation& reading : record.interpretations) {
        xml_node node = interpretations.append_child("interpretation");
        required(node, "id", reading.id.to_string());
        required(node, "name", reading.name);
        reference(node, "parent", reading.parent);
        attribute(node, "author", reading.author);
        attribute(node, "made-at", reading.made_at);
        for (const model::PhysicalRelation& relation : reading.added) {
            xml_node added = node.append_child("added");
            required(added, "subject", relation.subject.to_string());
            required(added, "kind", to_word(relation.kind));
            required(added, "object", relation.object.to_string());
            required(added, "certainty", to_word(relation.certainty));
        }
        for (const model::RelationId relation : reading.dropped) {
            required(node.append_child("dropped"), "relation", relation.to_string());
        }
    }
}

} // namespace planum::app::xml
