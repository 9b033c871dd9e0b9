// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>

#include <fmt/format.h>

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "strat/exchange/json_support.hpp"
#include "strat/exchange/readers.hpp"
#include "strat/exchange/record_builder.hpp"

namespace planum::strat {

namespace {

constexpr std::string_view kFormat = "planum-record";
constexpr double kVersion = 1;
constexpr double kMaxWhole = 9.0e15; // beyond, doubles are no whole numbers

/// One object of an array, with the words for a note about it.
class Item {
  public:
    Item(const Json& value, std::string_view array, std::size_t index, RecordBuilder& builder, std::string_view file)
        : value_(value), where_(fmt::format("{}[{}]", array, index)), builder_(builder), file_(file) {}

    [[nodiscard]] std::string text(std::string_view key) const { return json_text(value_, key); }

    [[nodiscard]] std::optional<double> number(std::string_view key) const {
        const auto value = json_number(value_, key);
        if (!value && json_member(value_, key) != nullptr)
            note("unparsed", fmt::format("{} is no number; left out", key));
        return value;
    }

    [[nodiscard]] std::optional<std::int64_t> whole(std::string_view key) const {
        const auto value = number(key);
        if (!value) return std::nullopt;
        if (std::abs(*value) < kMaxWhole && std::floor(*value) == *value) return static_cast<std::int64_t>(*value);
        note("unparsed", fmt::format("{} is no whole number; left out", key));
        return std::nullopt;
    }

    [[nodiscard]] const Json& json() const { return value_; }

    [[nodiscard]] Place place() const { return {file_, 0, where_}; }

    void note(std::string_view code, std::string message) const { builder_.note(place(), code, std::move(message)); }

    /// A word of one of our lists; the default, with a note, when it is none.
    template<class Enum, class FromWord>
    [[nodiscard]] Enum word(std::string_view key, Enum otherwise, FromWord from_word) const {
        const std::string value = text(key);
        if (value.empty()) return otherwise;
        if (const auto known = from_word(value)) return *known;
        note("unparsed", fmt::format("{} is not known as {}", value, key));
        return otherwise;
    }

  private:
    const Json& value_;
    std::string where_;
    RecordBuilder& builder_;
    std::string_view file_;
};

class JsonRecordReader {
  public:
    JsonRecordReader(RecordBuilder& builder, std::string_view file) : builder_(builder), file_(file) {}

    void read(const Json& root) {
        if (const Json* project = json_member(root, "project")) {
            if (builder_.record.project_name.empty()) builder_.record.project_name = json_text(*project, "name");
        }
        // Names first: everything refers to units by them.
        each(root, "units", [&](const Item& item) {
            names_.emplace(item.text("name"), builder_.name(item.text("area"), item.text("number")));
        });
        each(root, "areas", [&](const Item& item) { read_area(item); });
        each(root, "periods", [&](const Item& item) { read_period(item); });
        each(root, "phases", [&](const Item& item) { read_phase(item); });
        each(root, "units", [&](const Item& item) { read_unit(item); });
        each(root, "groups", [&](const Item& item) { read_group(item); });
        each(root, "relations", [&](const Item& item) { read_relation(item); });
        each(root, "datings", [&](const Item& item) { read_dating(item); });
        each(root, "levels", [&](const Item& item) { read_level(item); });
        each(root, "finds", [&](const Item& item) { read_find(item); });
        each(root, "samples", [&](const Item& item) { read_sample(item); });
        each(root, "documents", [&](const Item& item) { read_document(item); });
    }

  private:
    template<class Read>
    void each(const Json& root, std::string_view array, Read read_item) {
        const Json* values = json_member(root, array);
        if (values == nullptr) return;
        if (!values->is_array()) {
            builder_.note({file_, 0, array}, "unparsed", fmt::format("{} is no list; left out", array));
            return;
        }
        std::size_t index = 0;
        for (const Json& value : *values) {
            const Item item(value, array, index++, builder_, file_);
            if (value.is_object()) {
                read_item(item);
            } else {
                item.note("unparsed", "no object; left out");
            }
        }
    }

    [[nodiscard]] UnitName unit(const std::string& name) const {
        const auto it = names_.find(name);
        return it == names_.end() ? builder_.name(name) : it->second;
    }

    [[nodiscard]] UnitName unit_of(const Item& item, std::string_view key = "unit") const {
        const std::string name = item.text(key);
        return name.empty() ? UnitName{} : unit(name);
    }

    void read_area(const Item& item) {
        model::Area area;
        area.name = item.text("name");
        area.title = item.text("title");
        area.method = item.word("method", model::DigMethod::Stratigraphic, model::dig_method_from_word);
        area.first_number = item.text("first_number");
        area.last_number = item.text("last_number");
        builder_.record.areas.push_back(std::move(area));
    }

    template<class Value>
    static void read_chronology(const Item& item, Value& value) {
        value.number = item.text("number");
        value.title = item.text("title");
        value.description = item.text("description");
        value.from = item.whole("from");
        value.to = item.whole("to");
        value.rank = item.whole("rank");
    }

    void read_period(const Item& item) {
        model::Period period;
        read_chronology(item, period);
        builder_.record.periods.push_back(std::move(period));
    }

    void read_phase(const Item& item) {
        ImportedPhase phase;
        read_chronology(item, phase.values);
        phase.period = item.text("period");
        builder_.record.phases.push_back(std::move(phase));
    }

    void read_unit(const Item& item) {
        const UnitName name = builder_.name(item.text("area"), item.text("number"));
        if (name.number.empty()) {
            item.note("unparsed", "a unit without a number was left out");
            return;
        }
        if (item.text("origin") == "mentioned") return; // relations name it
        ImportedUnit& unit = builder_.unit(name, item.place());
        model::StratigraphicUnit& values = unit.values;
        values.kind = item.word("kind", values.kind, model::from_word<model::UnitKind>);
        values.form = item.word("form", values.form, model::from_word<model::UnitForm>);
        values.status = item.word("status", values.status, model::from_word<model::UnitStatus>);
        values.title = item.text("title");
        values.description = item.text("description");
        values.interpretation = item.text("interpretation");
        values.excavated_from = item.text("excavated_from");
        values.excavated_on = item.text("excavated_on");
        values.recorded_by = item.text("recorded_by");
        values.recorded_on = item.text("recorded_on");
        unit.phase = item.text("phase");
        unit.period = item.text("period");
        unit.parent = unit_of(item, "parent");
        const Json* details = json_member(item.json(), "details");
        if (details == nullptr || !details->is_object()) return;
        for (const auto& [key, value] : details->items()) read_detail(item, values, key, json_scalar_text(value));
    }

    static void read_detail(const Item& item, model::StratigraphicUnit& unit, const std::string& key,
                            std::string text) {
        if (text.empty()) return;
        const bool known = std::any_of(model::kUnitFields.begin(), model::kUnitFields.end(),
                                       [&](const model::UnitFieldInfo& field) { return field.name == key; });
        if (known) {
            unit.details[key] = std::move(text);
            return;
        }
        item.note("unknown-column", fmt::format("the field {} is not known; kept among the free fields", key));
        std::string& custom = unit.details["custom"];
        custom += fmt::format("{}{}={}", custom.empty() ? "" : "\n", key, text);
    }

    void read_group(const Item& item) {
        const std::string number = item.text("number");
        model::UnitGroup& values = builder_.group(number).values;
        values.type = item.text("type");
        values.title = item.text("title");
        values.description = item.text("description");
        builder_.group(number).parent = item.text("parent");
        const Json* members = json_member(item.json(), "members");
        if (members == nullptr || !members->is_array()) return;
        for (const Json& member : *members) {
            const std::string name = json_scalar_text(member);
            if (!name.empty()) builder_.add_member(number, unit(name));
        }
    }

    void read_relation(const Item& item) {
        const auto kind = model::relation_kind_from_word(item.text("kind"));
        if (!kind) {
            item.note("unknown-relation", fmt::format("the relation {} is not known; left out", item.text("kind")));
            return;
        }
        const std::string raw = fmt::format("{} {} {}", item.text("unit"), item.text("kind"), item.text("other"));
        const auto add = [&](model::StatementSide side, const std::string& person) {
            StatedRelation* relation =
                builder_.relate(unit_of(item), {*kind, false}, unit_of(item, "other"), {file_, 0, raw});
            if (relation == nullptr) return;
            relation->certainty = item.word("certainty", model::Certainty::Certain, model::certainty_from_word);
            const Json* correlation = json_member(item.json(), "correlation");
            relation->correlation = correlation != nullptr && correlation->is_boolean() && correlation->get<bool>();
            relation->side = side;
            relation->person = person;
        };
        const Json* statements = json_member(item.json(), "statements");
        if (statements == nullptr || !statements->is_array() || statements->empty()) {
            return add(model::StatementSide::Neither, {});
        }
        for (const Json& statement : *statements) {
            add(model::side_from_word(json_text(statement, "side")).value_or(model::StatementSide::Neither),
                json_text(statement, "person"));
        }
    }

    void read_dating(const Item& item) {
        ImportedDating dating;
        dating.unit = unit_of(item);
        dating.find = item.text("find");
        dating.values.label = item.text("label");
        dating.values.kind = item.word("kind", model::DatingKind::Typed, model::dating_kind_from_word);
        dating.values.from = item.whole("from");
        dating.values.to = item.whole("to");
        dating.values.bp = item.number("bp");
        dating.values.bp_error = item.number("bp_error");
        dating.values.association = item.text("association");
        dating.values.notes = item.text("notes");
        builder_.record.datings.push_back(std::move(dating));
    }

    void read_level(const Item& item) {
        const auto z = item.number("z");
        if (!z) {
            item.note("unparsed", "a level without a height z was left out");
            return;
        }
        ImportedLevel level;
        level.unit = unit_of(item);
        level.values.x = item.number("x");
        level.values.y = item.number("y");
        level.values.z = *z;
        level.values.role = item.word("role", model::LevelRole::Top, model::level_role_from_word);
        level.values.label = item.text("label");
        builder_.record.levels.push_back(std::move(level));
    }

    void read_find(const Item& item) {
        ImportedFind find;
        find.unit = unit_of(item);
        find.values.number = item.text("number");
        find.values.x = item.number("x");
        find.values.y = item.number("y");
        find.values.z = item.number("z");
        find.values.type = item.text("type");
        find.values.material = item.text("material");
        find.values.count = item.whole("count");
        find.values.weight = item.number("weight");
        find.values.condition = item.text("condition");
        find.values.box = item.text("box");
        find.values.found_on = item.text("found_on");
        find.values.description = item.text("description");
        builder_.record.finds.push_back(std::move(find));
    }

    void read_sample(const Item& item) {
        ImportedSample sample;
        sample.unit = unit_of(item);
        sample.values.number = item.text("number");
        sample.values.type = item.text("type");
        sample.values.volume = item.number("volume");
        sample.values.weight = item.number("weight");
        sample.values.laboratory_number = item.text("laboratory_number");
        sample.values.state = item.text("state");
        sample.values.description = item.text("description");
        builder_.record.samples.push_back(std::move(sample));
    }

    void read_document(const Item& item) {
        ImportedDocument document;
        document.unit = unit_of(item);
        document.values.number = item.text("number");
        document.values.type = item.text("type");
        document.values.title = item.text("title");
        document.values.path = item.text("path");
        document.values.made_on = item.text("made_on");
        document.values.author = item.text("author");
        builder_.record.documents.push_back(std::move(document));
    }

    RecordBuilder& builder_;
    std::string_view file_;
    std::unordered_map<std::string, UnitName> names_;
};

Recognition recognise(std::span<const InputFile> files) {
    Recognition result;
    result.why = "JSON with \"format\": \"planum-record\"";
    for (std::size_t i = 0; i < files.size(); ++i) {
        const std::string_view head = text::trim(std::string_view{files[i].bytes}.substr(0, 4096));
        if (head.find('{') == std::string_view::npos || head.find(kFormat) == std::string_view::npos) continue;
        result.files.push_back(i);
        result.confidence = Confidence::Certain;
    }
    return result;
}

Imported<ImportedRecord> read(std::span<const InputFile* const> files, const ReadOptions& options, Progress& progress) {
    RecordBuilder builder(options);
    for (const InputFile* file : files) {
        progress.check();
        require_text(*file, "a record as JSON");
        DecodedText decoded = decode_text(file->bytes, file->name);
        builder.add_notes(std::move(decoded.notes));
        try {
            const Json root = parse_json(decoded.text);
            if (json_text(root, "format") != kFormat) {
                throw Error(ErrorCode::BadInput, fmt::format("no record of ours: `format` is not {}", kFormat));
            }
            const double version = json_number(root, "version").value_or(0.0);
            if (version > kVersion) {
                throw Error(ErrorCode::BadInput,
                            fmt::format("record version {}, this program knows up to {}", version, kVersion));
            }
            JsonRecordReader(builder, file->name).read(root);
        } catch (Error& error) {
            error.add_context(file->name);
            throw;
        }
    }
    return builder.finish();
}

} // namespace

const Reader& json_reader() {
    static const Reader reader{"json", "The whole record (.json)", recognise, read};
    return reader;
}

} // namespace planum::strat
