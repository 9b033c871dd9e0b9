// SPDX-License-Identifier: MIT

// PHASER's own file: a Cytoscape graph as JSON.

#include <fmt/format.h>

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "strat/exchange/json_support.hpp"
#include "strat/exchange/phaser_record.hpp"
#include "strat/exchange/readers.hpp"

namespace planum::strat {

namespace {

std::optional<PhaserClass> class_of(std::string_view word) {
    if (word == "period") return PhaserClass::Period;
    if (word == "phase") return PhaserClass::Phase;
    if (word == "group") return PhaserClass::Group;
    if (word == "subgroup") return PhaserClass::Subgroup;
    if (word == "context") return PhaserClass::Context;
    if (word == "dating") return PhaserClass::Dating;
    return std::nullopt;
}

// "±20 years" of the two ends, where they are not nought.
std::string tolerance_of(const Json& dating) {
    std::string out;
    for (const auto& [end, word] : {std::pair{"minYear", "begin"}, std::pair{"maxYear", "end"}}) {
        const auto value = json_number(dating, std::string(end) + "TolValue");
        if (!value || *value == 0.0) continue;
        out += fmt::format("{}{} ±{} {}", out.empty() ? "" : ", ", word, *value,
                           json_text(dating, std::string(end) + "TolUnit"));
    }
    return out;
}

class PhaserJsonReader {
  public:
    PhaserJsonReader(PhaserRecord& record, const InputFile& file) : record_(record), file_(file.name) {}

    void read(const Json& document) {
        const Json* elements = json_member(document, "elements");
        const Json* nodes = elements == nullptr ? nullptr : json_member(*elements, "nodes");
        if (nodes == nullptr || !nodes->is_array()) {
            throw Error(ErrorCode::BadInput, file_ + ": no list elements.nodes, so no PHASER graph");
        }
        for (const Json& node : *nodes) remember_class(node);
        for (const Json& node : *nodes) read_node(node);
        const Json* edges = json_member(*elements, "edges");
        if (edges == nullptr || !edges->is_array()) return;
        for (const Json& edge : *edges) read_edge(edge);
    }

  private:
    void remember_class(const Json& node) {
        const Json* data = json_member(node, "data");
        if (data == nullptr) return;
        if (const auto kind = class_of(json_text(*data, "class"))) classes_.emplace(json_text(*data, "id"), *kind);
    }

    void read_node(const Json& element) {
        const Json* data = json_member(element, "data");
        const std::string id = data == nullptr ? std::string{} : json_text(*data, "id");
        const auto kind = data == nullptr ? std::nullopt : class_of(json_text(*data, "class"));
        if (id.empty() || !kind) {
            record_.builder().note({file_, 0, id}, "unparsed", "a node without id or of an unknown class; left out");
            return;
        }
        PhaserNode node;
        node.kind = *kind;
        node.id = id;
        node.label = json_text(*data, "label");
        node.site = json_text(*data, "siteCode");
        node.type = json_text(*data, "type");
        node.cud = json_text(*data, "cud");
        node.description = json_text(*data, "description");
        node.association = json_text(*data, "association");
        node.file = file_;
        if (const Json* dating = json_member(*data, "dating")) {
            node.from = json_text(*dating, "minYear");
            node.to = json_text(*dating, "maxYear");
            node.tolerance = tolerance_of(*dating);
        }
        // "included" says whether PHASER's own calculation uses it; the evidence stays evidence.
        if (json_text(*data, "included") == "false" || json_text(*data, "include") == "false") {
            node.description += node.description.empty() ? "left out in PHASER" : "; left out in PHASER";
        }
        const std::string parent = json_text(*data, "parent");
        if (const auto outer = classes_.find(parent); outer != classes_.end()) {
            node.within.emplace_back(outer->second, parent);
        } else if (!parent.empty()) {
            record_.builder().note({file_, 0, parent}, "unknown-target",
                                   fmt::format("{} lies in {}, which is not there", id, parent));
        }
        record_.add(std::move(node));
    }

    void read_edge(const Json& element) {
        const Json* data = json_member(element, "data");
        if (data == nullptr) data = &element;
        PhaserEdge edge;
        edge.source = json_text(*data, "source");
        edge.target = json_text(*data, "target");
        edge.relation = json_text(*data, "type");
        if (edge.relation.empty()) edge.relation = json_text(element, "type");
        edge.file = file_;
        for (const std::string* end : {&edge.source, &edge.target}) {
            const auto known = classes_.find(*end);
            if (known != classes_.end() && known->second == PhaserClass::Context) continue;
            const std::string raw = fmt::format("{} {} {}", edge.source, edge.relation, edge.target);
            record_.builder().note({file_, 0, raw}, "unknown-target",
                                   fmt::format("an edge ends at {}, which is no context here; left out", *end));
            return;
        }
        record_.add(std::move(edge));
    }

    PhaserRecord& record_;
    std::string file_;
    std::map<std::string, PhaserClass, std::less<>> classes_;
};

Recognition recognise(std::span<const InputFile> files) {
    Recognition out;
    for (std::size_t i = 0; i < files.size(); ++i) {
        if (files[i].is_database || !is_probably_text(files[i].bytes)) continue;
        const std::string_view head = text::trim(std::string_view(files[i].bytes).substr(0, 1U << 16U));
        const bool is_graph = head.starts_with('{') && head.find("\"elements\"") != std::string_view::npos &&
                              head.find("\"nodes\"") != std::string_view::npos;
        if (!is_graph) continue;
        out.files.push_back(i);
        out.confidence = Confidence::Certain;
        out.why = "JSON with elements.nodes";
    }
    return out;
}

Imported<ImportedRecord> read(std::span<const InputFile* const> files, const ReadOptions& options, Progress& progress) {
    PhaserRecord record(options);
    for (const InputFile* file : files) {
        progress.check();
        require_text(*file, "a PHASER graph");
        DecodedText decoded = decode_text(file->bytes, file->name);
        record.builder().add_notes(std::move(decoded.notes));
        try {
            PhaserJsonReader(record, *file).read(parse_json(decoded.text));
        } catch (Error& e) {
            if (!std::string_view(e.what()).starts_with(file->name)) e.add_context(file->name);
            throw;
        }
    }
    return record.finish();
}

} // namespace

const Reader& phaser_json_reader() {
    static const Reader reader = {"phaser-json", "PHASER graph (.json)", recognise, read};
    return reader;
}

} // namespace planum::strat
