// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <string>
#include <unordered_set>
#include <vector>

#include <fmt/format.h>

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "strat/exchange/hmc_nodes.hpp"
#include "strat/exchange/readers.hpp"
#include "strat/exchange/record_builder.hpp"
#include "strat/exchange/xml_input.hpp"
#include "strat/exchange/zip_archive.hpp"

namespace planum::strat {

namespace {

using model::DirectedKind;
using model::RelationKind;

constexpr std::string_view kWhat = "a Harris Matrix Composer project";

// The first element of that local name inside the data of a GraphML node or edge.
pugi::xml_node payload(pugi::xml_node element, std::string_view name) {
    for (const pugi::xml_node data : element.children()) {
        if (local_name(data) != "data") continue;
        if (const pugi::xml_node found = child_named(data, name)) return found;
    }
    return {};
}

// The group node around a node: node > graph > node.
pugi::xml_node enclosing_node(pugi::xml_node node) {
    const pugi::xml_node graph = node.parent();
    if (local_name(graph) != "graph" || local_name(graph.parent()) != "node") return {};
    return graph.parent();
}

std::string id_of(pugi::xml_node node) {
    const std::string own = attribute(payload(node, "hmcnode"), "id");
    return std::string{text::trim(own.empty() ? attribute(node, "id") : own)};
}

HmcNode read_node(pugi::xml_node element, const XmlInput& xml) {
    const pugi::xml_node data = payload(element, "hmcnode");
    HmcNode node;
    node.id = id_of(element);
    node.type = attribute(data, "type");
    node.name = attribute(data, "name");
    node.description = attribute(data, "description");
    node.valid = attribute(data, "valid") != "false";
    node.line = xml.line_of(element);
    if (const pugi::xml_node group = enclosing_node(element)) node.parent = id_of(group);
    return node;
}

void read_edge(pugi::xml_node edge, const Place& place, const std::unordered_set<std::string>& groups,
               RecordBuilder& builder) {
    const std::string source{text::trim(attribute(edge, "source"))};
    const std::string target{text::trim(attribute(edge, "target"))};
    const std::string type = attribute(payload(edge, "hmcedge"), "type");
    const std::string raw = fmt::format("{} {} {}", source, type, target);
    const Place here{place.file, place.line, raw};
    if (groups.contains(source) || groups.contains(target)) {
        builder.note(here, "group-relation", "an edge of a group was left out; only units have relations");
        return;
    }
    DirectedKind kind{RelationKind::Covers, false}; // ABOVE: the source is above the target
    if (type == "LATER") {
        kind.kind = RelationKind::Later;
    } else if (type == "CONTEMPORARY") {
        kind.kind = RelationKind::Contemporary;
    } else if (type != "ABOVE") {
        builder.note(here, "unknown-relation", fmt::format("the edge type {} is not known; left out", type));
        return;
    }
    StatedRelation* relation = builder.relate(builder.name(source), kind, builder.name(target), here);
    // A drawing says a relation once; no sheet of either unit stands behind it.
    if (relation != nullptr) relation->side = model::StatementSide::Neither;
}

void read_matrix(std::string_view bytes, std::string_view file, RecordBuilder& builder, Progress& progress) {
    const XmlInput xml(bytes, file, kWhat);
    builder.add_notes(xml.notes());
    const pugi::xml_node root = xml.root();
    std::vector<HmcNode> nodes;
    std::vector<pugi::xml_node> edges;
    std::size_t count = 0;
    for (pugi::xml_node at = root; at; at = next_in_document(at, root)) {
        if (++count % 65536 == 0) progress.check();
        const std::string_view name = local_name(at);
        if (name == "edge") edges.push_back(at);
        if (name != "node") continue;
        if (!payload(at, "hmcnode")) {
            builder.note({file, xml.line_of(at), attribute(at, "id")}, "unparsed",
                         "a node without HMC data was left out");
            continue;
        }
        nodes.push_back(read_node(at, xml));
    }
    if (nodes.empty()) {
        throw Error(ErrorCode::BadInput, fmt::format("{}: XML without any hmcnode, so not {}", file, kWhat));
    }
    add_hmc_nodes(builder, nodes, file);
    std::unordered_set<std::string> groups;
    for (const HmcNode& node : nodes) {
        if (is_hmc_group(node.type)) groups.insert(node.id);
    }
    for (const pugi::xml_node edge : edges) {
        read_edge(edge, {file, xml.line_of(edge), {}}, groups, builder);
    }
}

void read_properties(const std::string& bytes, const std::string& file, RecordBuilder& builder) {
    const XmlInput xml(bytes, file, kWhat);
    pugi::xml_node properties = xml.root();
    while (properties && local_name(properties) != "ProjectProperties") {
        properties = next_in_document(properties, xml.root());
    }
    if (builder.record.project_name.empty()) {
        builder.record.project_name = text::trim(attribute(properties, "Name"));
    }
}

Recognition recognise(std::span<const InputFile> files) {
    Recognition result;
    result.why = "HMC nodes in GraphML";
    for (std::size_t i = 0; i < files.size(); ++i) {
        const std::string_view bytes = files[i].bytes;
        const bool named = text::fold_case(files[i].path.extension().string()) == ".hmcx";
        Confidence confidence = Confidence::No;
        if (is_zip(bytes)) {
            const bool has_matrix = bytes.find("matrix.xml") != std::string_view::npos;
            if (named || has_matrix) confidence = named && has_matrix ? Confidence::Certain : Confidence::Likely;
        } else if (text::trim(bytes.substr(0, 4096)).find('<') != std::string_view::npos &&
                   bytes.find("hmcnode") != std::string_view::npos) {
            confidence = Confidence::Certain;
        }
        if (confidence == Confidence::No) continue;
        result.files.push_back(i);
        result.confidence = std::max(result.confidence, confidence);
    }
    return result;
}

void read_file(const InputFile& file, RecordBuilder& builder, Progress& progress) {
    if (file.is_database) {
        throw Error(ErrorCode::BadInput, fmt::format("{}: an SQLite database, not {}", file.name, kWhat));
    }
    if (!is_zip(file.bytes)) return read_matrix(file.bytes, file.name, builder, progress);
    constexpr std::array<std::string_view, 2> kMembers = {"matrix.xml", "project.xml"};
    const auto members = read_zip(file.bytes, file.name, kMembers, kMaxRecordFile);
    const auto matrix = members.find("matrix.xml");
    if (matrix == members.end()) {
        throw Error(ErrorCode::BadInput, fmt::format("{}: no matrix.xml in the archive, so not {}", file.name, kWhat));
    }
    read_matrix(matrix->second, file.name, builder, progress);
    const auto project = members.find("project.xml");
    if (project != members.end()) read_properties(project->second, file.name, builder);
}

Imported<ImportedRecord> read(std::span<const InputFile* const> files, const ReadOptions& options, Progress& progress) {
    RecordBuilder builder(options);
    for (const InputFile* file : files) {
        progress.check();
        read_file(*file, builder, progress);
    }
    return builder.finish();
}

} // namespace

const Reader& hmcx_reader() {
    static const Reader reader{"hmcx", "Harris Matrix Composer project (.hmcx, matrix.xml)", recognise, read};
    return reader;
}

} // namespace planum::strat
