// SPDX-License-Identifier: MIT
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "strat/exchange/write_support.hpp"
#include "strat/exchange/writers.hpp"

namespace planum::strat {

namespace {

using Json = nlohmann::ordered_json;

// Empty values are left out: a record is mostly empty fields.
void put(Json& object, const char* key, std::string_view text) {
    if (!text.empty()) object[key] = text;
}

template<class Number>
void put(Json& object, const char* key, const std::optional<Number>& value) {
    if (value) object[key] = *value;
}

class JsonRecord {
  public:
    explicit JsonRecord(const RecordNames& names) : names_(names), record_(names.record()) {
        for (const model::Source& source : record_.sources) sources_.emplace(source.id, source.name);
        for (const model::RelationStatement& statement : record_.statements) {
            statements_[statement.relation].push_back(&statement);
        }
    }

    [[nodiscard]] Json write() const {
        Json root;
        root["format"] = "planum-record";
        root["version"] = 1;
        root["project"] = {{"name", record_.settings.name}};
        fill(root["areas"], record_.areas, &JsonRecord::area);
        fill(root["periods"], record_.periods, &JsonRecord::period);
        fill(root["phases"], record_.phases, &JsonRecord::phase);
        fill(root["groups"], record_.groups, &JsonRecord::group);
        fill(root["units"], record_.units, &JsonRecord::unit);
        root["relations"] = Json::array();
        for (const std::size_t i : complete_relations(names_))
            root["relations"].push_back(relation(record_.relations[i]));
        fill(root["datings"], record_.datings, &JsonRecord::dating);
        fill(root["levels"], record_.levels, &JsonRecord::level);
        fill(root["finds"], record_.finds, &JsonRecord::find);
        fill(root["samples"], record_.samples, &JsonRecord::sample);
        fill(root["documents"], record_.documents, &JsonRecord::document);
        return root;
    }

  private:
    template<class Values, class Make>
    void fill(Json& array, const Values& values, Make make) const {
        array = Json::array();
        for (const auto& value : values) array.push_back((this->*make)(value));
    }

    void put_unit(Json& object, const char* key, model::UnitId id) const {
        if (names_.has(id)) object[key] = names_.unit(id);
    }

    [[nodiscard]] Json area(const model::Area& value) const {
        Json object = {{"name", value.name}, {"method", model::to_word(value.method)}};
        put(object, "title", value.title);
        put(object, "first_number", value.first_number);
        put(object, "last_number", value.last_number);
        return object;
    }

    template<class Value>
    [[nodiscard]] static Json chronology(const Value& value, const std::string& number) {
        Json object = {{"number", number}};
        put(object, "title", value.title);
        put(object, "description", value.description);
        put(object, "from", value.from);
        put(object, "to", value.to);
        put(object, "rank", value.rank);
        return object;
    }

    [[nodiscard]] Json period(const model::Period& value) const { return chronology(value, value.number); }

    [[nodiscard]] Json phase(const model::Phase& value) const {
        Json object = chronology(value, names_.phase(value.id));
        put(object, "period", names_.period(value.period));
        return object;
    }

    [[nodiscard]] Json group(const model::UnitGroup& value) const {
        Json object = {{"number", value.number}};
        put(object, "type", value.type);
        put(object, "title", value.title);
        put(object, "description", value.description);
        put(object, "parent", names_.group(value.parent));
        object["members"] = Json::array();
        for (const model::UnitId member : value.members) {
            if (names_.has(member)) object["members"].push_back(names_.unit(member));
        }
        return object;
    }

    [[nodiscard]] Json unit(const model::StratigraphicUnit& value) const {
        Json object = {{"name", names_.unit(value.id)}, {"number", value.number}};
        put(object, "area", names_.area(value.area));
        object["uuid"] = value.id.to_string();
        object["kind"] = model::to_word(value.kind);
        put(object, "form", model::to_word(value.form));
        object["status"] = model::to_word(value.status);
        object["origin"] = model::to_word(value.origin);
        put(object, "title", value.title);
        put(object, "description", value.description);
        put(object, "interpretation", value.interpretation);
        put(object, "excavated_from", value.excavated_from);
        put(object, "excavated_on", value.excavated_on);
        put(object, "recorded_by", value.recorded_by);
        put(object, "recorded_on", value.recorded_on);
        put(object, "phase", names_.phase(value.phase));
        put(object, "period", names_.period(value.period));
        put_unit(object, "parent", value.parent);
        if (!value.details.empty()) object["details"] = value.details;
        return object;
    }

    [[nodiscard]] Json relation(const model::PhysicalRelation& value) const {
        Json object = {{"unit", names_.unit(value.subject)},
                       {"kind", model::to_word(value.kind)},
                       {"other", names_.unit(value.object)},
                       {"certainty", model::to_word(value.certainty)}};
        if (value.correlation) object["correlation"] = true;
        object["statements"] = Json::array();
        const auto said = statements_.find(value.id);
        if (said == statements_.end()) return object;
        for (const model::RelationStatement* statement : said->second) {
            Json entry = {{"side", model::to_word(statement->side)}};
            const auto source = sources_.find(statement->source);
            if (source != sources_.end()) put(entry, "file", source->second);
            if (statement->line > 0) entry["line"] = statement->line;
            put(entry, "person", statement->person);
            put(entry, "text", statement->raw_text);
            put(entry, "stated_at", statement->stated_at);
            object["statements"].push_back(std::move(entry));
        }
        return object;
    }

    [[nodiscard]] Json dating(const model::Dating& value) const {
        Json object = {{"label", value.label}, {"kind", model::to_word(value.kind)}};
        put_unit(object, "unit", value.unit);
        put(object, "find", names_.find(value.find));
        put(object, "from", value.from);
        put(object, "to", value.to);
        put(object, "bp", value.bp);
        put(object, "bp_error", value.bp_error);
        put(object, "association", value.association);
        put(object, "notes", value.notes);
        return object;
    }

    [[nodiscard]] Json level(const model::Level& value) const {
        Json object;
        put_unit(object, "unit", value.unit);
        object["z"] = value.z;
        object["role"] = model::to_word(value.role);
        put(object, "x", value.x);
        put(object, "y", value.y);
        put(object, "label", value.label);
        return object;
    }

    [[nodiscard]] Json find(const model::Find& value) const {
        Json object = {{"number", value.number}};
        put_unit(object, "unit", value.unit);
        put(object, "x", value.x);
        put(object, "y", value.y);
        put(object, "z", value.z);
        put(object, "type", value.type);
        put(object, "material", value.material);
        put(object, "count", value.count);
        put(object, "weight", value.weight);
        put(object, "condition", value.condition);
        put(object, "box", value.box);
        put(object, "found_on", value.found_on);
        put(object, "description", value.description);
        return object;
    }

    [[nodiscard]] Json sample(const model::Sample& value) const {
        Json object = {{"number", value.number}};
        put_unit(object, "unit", value.unit);
        put(object, "type", value.type);
        put(object, "volume", value.volume);
        put(object, "weight", value.weight);
        put(object, "laboratory_number", value.laboratory_number);
        put(object, "state", value.state);
        put(object, "description", value.description);
        return object;
    }

    [[nodiscard]] Json document(const model::Document& value) const {
        Json object = {{"number", value.number}};
        put_unit(object, "unit", value.unit);
        put(object, "type", value.type);
        put(object, "title", value.title);
        put(object, "path", value.path);
        put(object, "made_on", value.made_on);
        put(object, "author", value.author);
        return object;
    }

    const RecordNames& names_;
    const model::Record& record_;
    std::unordered_map<model::SourceId, std::string> sources_;
    std::unordered_map<model::RelationId, std::vector<const model::RelationStatement*>> statements_;
};

} // namespace

Written write_json(const model::Record& record, const WriteOptions& /*options*/) {
    Written written;
    written.lost = losses(record, carries_everything());
    const RecordNames names(record);
    const Json root = JsonRecord(names).write();
    written.files.push_back({{}, root.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"});
    return written;
}

} // namespace planum::strat
