// SPDX-License-Identifier: MIT

// iDAI.field / Field Desktop: a PouchDB dump or backup, one JSON a line, ids instead of names.

#include <map>
#include <set>

#include <fmt/format.h>

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "strat/exchange/idai_field_resources.hpp"
#include "strat/exchange/readers.hpp"

namespace planum::strat {

namespace {

struct FieldRelation {
    std::string_view name;
    model::DirectedKind kind;
};

constexpr std::array kRelations = {
    FieldRelation{"isAbove", {model::RelationKind::Covers, false}},
    FieldRelation{"isBelow", {model::RelationKind::Covers, true}},
    FieldRelation{"cuts", {model::RelationKind::Cuts, false}},
    FieldRelation{"isCutBy", {model::RelationKind::Cuts, true}},
    FieldRelation{"fills", {model::RelationKind::Fills, false}},
    FieldRelation{"isFilledBy", {model::RelationKind::Fills, true}},
    FieldRelation{"abuts", {model::RelationKind::Abuts, false}},
    FieldRelation{"isAbuttedBy", {model::RelationKind::Abuts, true}},
    FieldRelation{"bondsWith", {model::RelationKind::BondsWith, false}},
    FieldRelation{"isBondedWith", {model::RelationKind::BondsWith, false}},
    FieldRelation{"borders", {model::RelationKind::Borders, false}},
    FieldRelation{"bordersOn", {model::RelationKind::Borders, false}},
    FieldRelation{"isAfter", {model::RelationKind::Later, false}},
    FieldRelation{"isBefore", {model::RelationKind::Later, true}},
    FieldRelation{"isContemporaryWith", {model::RelationKind::Contemporary, false}},
    FieldRelation{"isEquivalentTo", {model::RelationKind::SameAs, false}},
};

class FieldReader {
  public:
    explicit FieldReader(const ReadOptions& options) : builder_(options) {}

    void read_file(const InputFile& file, Progress& progress) {
        require_text(file, "an iDAI.field export");
        DecodedText decoded = decode_text(file.bytes, file.name);
        builder_.add_notes(std::move(decoded.notes));
        const std::size_t before = resources_.size();
        std::string_view rest = decoded.text;
        std::int64_t line = 0;
        if (text::trim(rest).starts_with('[')) { // one list over all lines
            read_line(text::trim(rest), file.name, 1);
            rest = {};
        }
        while (!rest.empty()) {
            const std::size_t end = rest.find('\n');
            const std::string_view text = text::trim(rest.substr(0, end));
            rest = end == std::string_view::npos ? std::string_view{} : rest.substr(end + 1);
            ++line;
            progress.check();
            if (!text.empty()) read_line(text, file.name, line);
        }
        if (resources_.size() == before) {
            throw Error(ErrorCode::BadInput, file.name + ": no line with a resource, so no iDAI.field export");
        }
    }

    Imported<ImportedRecord> finish() {
        for (const FieldResource& resource : resources_) by_id_.emplace(resource.id, &resource);
        for (const FieldResource& resource : resources_) read(resource);
        for (const FieldResource& resource : resources_) {
            if (resource.role == FieldRole::Unit) read_relations(resource);
        }
        return builder_.finish();
    }

  private:
    void read_line(std::string_view text, const std::string& file, std::int64_t line) {
        Json json;
        try {
            json = parse_json(text);
        } catch (const Error& e) {
            builder_.note({file, line, text}, "unparsed", fmt::format("{}; the line was left out", e.what()));
            return;
        }
        if (Json* docs = json.is_object() && json.contains("docs") ? &json["docs"] : nullptr;
            docs != nullptr && docs->is_array()) {
            for (Json& doc : *docs) add(std::move(doc), file, line);
        } else if (json.is_array()) {
            for (Json& doc : json) add(std::move(doc), file, line);
        } else {
            add(std::move(json), file, line);
        }
    }

    void add(Json doc, const std::string& file, std::int64_t line) {
        if (!doc.is_object() || json_text(doc, "_deleted") == "true") return;
        FieldResource resource;
        const bool wrapped = doc.contains("resource") && doc["resource"].is_object();
        resource.json = wrapped ? std::move(doc["resource"]) : std::move(doc);
        resource.category = json_text(resource.json, "category");
        if (resource.category.empty()) resource.category = json_text(resource.json, "type");
        resource.id = json_text(resource.json, "id");
        resource.identifier = builder_.name({}, json_text(resource.json, "identifier")).number;
        resource.file = file;
        resource.line = line;
        // Header lines ("version", "seq") and bookkeeping documents have neither.
        if (resource.category.empty() || (resource.id.empty() && resource.identifier.empty())) return;
        if (resource.id.empty()) resource.id = resource.identifier;
        resource.role = field_role(resource.json, resource.category);
        if (resource.role == FieldRole::Unit && resource.identifier.empty()) {
            builder_.note({file, line, resource.id}, "unparsed", "a unit without identifier; named by its id");
            resource.identifier = resource.id;
        }
        resources_.push_back(std::move(resource));
    }

    [[nodiscard]] const FieldResource* find(const std::string& id) const {
        const auto found = by_id_.find(id);
        return found == by_id_.end() ? nullptr : found->second;
    }

    // The trench is the area.
    [[nodiscard]] UnitName name_of(const FieldResource& resource) const {
        for (const std::string& id : field_targets(resource.json, "isRecordedIn")) {
            const FieldResource* place = find(id);
            if (place != nullptr && place->role == FieldRole::Place)
                return builder_.name(place->identifier, resource.identifier);
        }
        return builder_.name({}, resource.identifier);
    }

    // The unit that something lies in, through finds and groups of finds.
    [[nodiscard]] const FieldResource* unit_around(const FieldResource& resource) const {
        const FieldResource* at = &resource;
        for (int depth = 0; depth < 16; ++depth) {
            const auto outer = field_targets(at->json, "liesWithin");
            at = outer.empty() ? nullptr : find(outer.front());
            if (at == nullptr || at->role == FieldRole::Unit) return at;
        }
        return nullptr;
    }

    void read(const FieldResource& resource) {
        switch (resource.role) {
        case FieldRole::Unit: read_unit(resource); return;
        case FieldRole::Find: read_find(resource); return;
        case FieldRole::Sample: read_sample(resource); return;
        case FieldRole::Document: read_document(resource); return;
        case FieldRole::Place: {
            model::Area& area = builder_.record.areas.emplace_back();
            area.name = resource.identifier;
            area.title = field_text(resource.json, "shortDescription");
            return;
        }
        case FieldRole::Other:
            if (resource.category == "Project") {
                builder_.record.project_name = field_text(resource.json, "shortDescription");
                if (builder_.record.project_name.empty()) builder_.record.project_name = resource.identifier;
            }
            return;
        }
    }

    void read_unit(const FieldResource& resource) {
        const UnitName name = name_of(resource);
        const Place place{resource.file, resource.line, resource.identifier};
        if (builder_.has_unit(name)) {
            builder_.note(place, "repeated-unit",
                          fmt::format("two resources are called {}; they are taken for one", name.number));
        }
        ImportedUnit& unit = builder_.unit(name, place);
        read_field_unit(resource, unit);
        const FieldResource* outer = unit_around(resource);
        if (outer != nullptr && name_of(*outer) != name) unit.parent = name_of(*outer);
        for (model::Dating& dating : read_field_datings(resource.json)) {
            builder_.record.datings.push_back({name, {}, std::move(dating)});
        }
    }

    void read_find(const FieldResource& resource) {
        if (resource.identifier.empty()) return note_nameless(resource);
        ImportedFind& find = builder_.record.finds.emplace_back();
        find.values.number = resource.identifier;
        find.values.type = resource.category;
        find.values.material = field_text(resource.json, "materialType");
        find.values.description = field_text(resource.json, "shortDescription");
        find.values.condition = field_text(resource.json, "condition");
        find.values.box = field_text(resource.json, "storagePlace");
        find.values.found_on = field_date(resource.json, "date").substr(0, 10);
        find.values.weight = json_number(resource.json, "weight");
        if (const auto count = text::parse_integer(json_text(resource.json, "amount"))) find.values.count = *count;
        read_point(resource.json, find.values);
        if (const FieldResource* unit = unit_around(resource)) find.unit = name_of(*unit);
        const UnitName unit = find.unit;
        for (model::Dating& dating : read_field_datings(resource.json)) {
            dating.kind = resource.category == "Coin" ? model::DatingKind::Coin : model::DatingKind::Find;
            builder_.record.datings.push_back({unit, resource.identifier, std::move(dating)});
        }
    }

    void note_nameless(const FieldResource& resource) {
        builder_.note({resource.file, resource.line, resource.id}, "unparsed",
                      fmt::format("a {} without identifier; left out", resource.category));
    }

    static void read_point(const Json& json, model::Find& find) {
        const Json* geometry = json_member(json, "geometry");
        if (geometry == nullptr || json_text(*geometry, "type") != "Point") return;
        const Json* point = json_member(*geometry, "coordinates");
        if (point == nullptr || !point->is_array() || point->size() < 2) return;
        const auto coordinate = [&](std::size_t i) {
            return i < point->size() && (*point)[i].is_number() ? std::optional((*point)[i].get<double>())
                                                                : std::nullopt;
        };
        find.x = coordinate(0);
        find.y = coordinate(1);
        find.z = coordinate(2);
    }

    void read_sample(const FieldResource& resource) {
        if (resource.identifier.empty()) return note_nameless(resource);
        ImportedSample& sample = builder_.record.samples.emplace_back();
        sample.values.number = resource.identifier;
        sample.values.type = field_text(resource.json, "sampleType");
        sample.values.description = field_text(resource.json, "shortDescription");
        sample.values.weight = json_number(resource.json, "weight");
        if (const FieldResource* unit = unit_around(resource)) sample.unit = name_of(*unit);
    }

    void read_document(const FieldResource& resource) {
        for (const std::string& id : field_targets(resource.json, "depicts")) {
            const FieldResource* shown = find(id);
            const FieldResource* unit =
                shown == nullptr || shown->role == FieldRole::Unit ? shown : unit_around(*shown);
            if (unit == nullptr) continue;
            ImportedDocument& document = builder_.record.documents.emplace_back();
            document.unit = name_of(*unit);
            document.values.number = resource.identifier;
            document.values.type = text::fold_case(resource.category);
            document.values.path = field_text(resource.json, "originalFilename");
            document.values.author = field_text(resource.json, "draughtsmen");
            document.values.made_on = field_date(resource.json, "date");
        }
    }

    void read_relations(const FieldResource& resource) {
        const UnitName name = name_of(resource);
        for (const FieldRelation& relation : kRelations) {
            for (const std::string& id : field_targets(resource.json, relation.name)) {
                const FieldResource* target = find(id);
                const std::string raw = fmt::format("{} {} {}", resource.identifier, relation.name,
                                                    target == nullptr ? id : target->identifier);
                const Place place{resource.file, resource.line, raw};
                if (target == nullptr || target->role != FieldRole::Unit) {
                    builder_.note(place, id.empty() ? "empty-target" : "unknown-target",
                                  fmt::format("unit {}: {} names what is no unit in this file; left out", name.number,
                                              relation.name));
                    continue;
                }
                builder_.relate(name, relation.kind, name_of(*target), place);
            }
        }
    }

    RecordBuilder builder_;
    std::vector<FieldResource> resources_;
    std::map<std::string, const FieldResource*, std::less<>> by_id_;
};

Recognition recognise(std::span<const InputFile> files) {
    Recognition out;
    for (std::size_t i = 0; i < files.size(); ++i) {
        if (files[i].is_database || !is_probably_text(files[i].bytes)) continue;
        const std::string_view head = text::trim(std::string_view(files[i].bytes).substr(0, 1U << 16U));
        const auto has = [&head](std::string_view word) { return head.find(word) != std::string_view::npos; };
        if (!head.starts_with('{') && !head.starts_with('[')) continue;
        const bool dump = has("\"resource\"") && has("\"identifier\"");
        const bool plain = has("\"identifier\"") && has("\"relations\"") && has("\"category\"");
        if (!dump && !plain) continue;
        out.files.push_back(i);
        out.confidence = Confidence::Certain;
        out.why = "JSON lines with resource and identifier";
    }
    return out;
}

Imported<ImportedRecord> read(std::span<const InputFile* const> files, const ReadOptions& options, Progress& progress) {
    FieldReader reader(options);
    for (const InputFile* file : files) reader.read_file(*file, progress);
    return reader.finish();
}

} // namespace

const Reader& idai_field_reader() {
    static const Reader reader = {"idai-field", "iDAI.field / Field Desktop export (.jsonl)", recognise, read};
    return reader;
}

} // namespace planum::strat
