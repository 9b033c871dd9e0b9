// SPDX-License-Identifier: MIT

// StratiGraph's .hmatrix.json: calls itself HMDP, but is one JSON file with contexts, observations, events and phases.

#include <array>
#include <map>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "strat/exchange/json_support.hpp"
#include "strat/exchange/readers.hpp"
#include "strat/exchange/record_builder.hpp"

namespace planum::strat {

namespace {

class HmatrixReader {
  public:
    HmatrixReader(RecordBuilder& builder, const InputFile& file) : builder_(builder), file_(file.name) {}

    void read(const Json& document) {
        if (list(document, "contexts") == nullptr) {
            throw Error(ErrorCode::BadInput, file_ + ": no list contexts, so no StratiGraph matrix");
        }
        each(document, "phases", &HmatrixReader::read_phase);
        each(document, "contexts", &HmatrixReader::read_context);
        each(document, "observations", &HmatrixReader::read_observation);
        each(document, "events", &HmatrixReader::read_event);
    }

  private:
    static const Json* list(const Json& document, const char* name) {
        const Json* values = json_member(document, name);
        return values != nullptr && values->is_array() ? values : nullptr;
    }

    void each(const Json& document, const char* name, void (HmatrixReader::*read_one)(const Json&)) {
        const Json* values = list(document, name);
        if (values == nullptr) return;
        for (const Json& value : *values) (this->*read_one)(value);
    }

    // Phases are named by their id in contexts; people know them by their label.
    void read_phase(const Json& phase) {
        const std::string id = json_text(phase, "id");
        std::string label = json_text(phase, "label");
        if (label.empty()) label = json_text(phase, "name");
        if (!id.empty()) phases_[id] = label.empty() ? id : label;
    }

    [[nodiscard]] std::string number_of(const Json& context) const {
        const std::string label = json_text(context, "label");
        return label.empty() ? json_text(context, "id") : label;
    }

    void read_context(const Json& context) {
        const std::string id = json_text(context, "id");
        const std::string number = number_of(context);
        if (id.empty() || text::trim(number).empty()) {
            builder_.note({file_, 0, number}, "unparsed", "a context without an id; left out");
            return;
        }
        const UnitName name = builder_.name(number);
        names_.emplace(id, name);
        ImportedUnit& unit = builder_.unit(name, {file_, 0, id});
        const std::string type = text::fold_case(json_text(context, "type"));
        if (type == "positive") unit.values.kind = model::UnitKind::Deposit;
        if (type == "negative") unit.values.kind = model::UnitKind::Cut;
        if (unit.values.description.empty()) unit.values.description = json_text(context, "description");
        const std::string phase = json_text(context, "phase");
        const auto known = phases_.find(phase);
        if (unit.phase.empty()) unit.phase = known == phases_.end() ? phase : known->second;
        if (!type.empty() && type != "positive" && type != "negative") {
            builder_.note({file_, 0, type}, "unknown-kind", fmt::format("{} is of an unknown type", number));
        }
        if (json_member(context, "spatial") != nullptr) ++places_;
    }

    [[nodiscard]] const UnitName* named(const std::string& id, const std::string& raw) {
        const auto it = names_.find(id);
        if (it != names_.end()) return &it->second;
        builder_.note({file_, 0, raw}, id.empty() ? "empty-target" : "unknown-target",
                      fmt::format("{} is no context here; left out", id.empty() ? "an end that is not named" : id));
        return nullptr;
    }

    void read_observation(const Json& observation) {
        const std::string source = json_text(observation, "source");
        const std::string target = json_text(observation, "target");
        const std::string word = json_text(observation, "relationshipType");
        const std::string raw = fmt::format("{} {} {}", source, word, target);
        const UnitName* subject = named(source, raw);
        const UnitName* object = subject == nullptr ? nullptr : named(target, raw);
        if (object == nullptr) return;
        const auto kind = model::relation_from_any_word(text::fold_case(word) == "equals" ? "same as" : word);
        if (!kind) {
            builder_.note({file_, 0, raw}, "unknown-relation", fmt::format("{} is no relation; left out", word));
            return;
        }
        (void)builder_.relate(*subject, *kind, *object, {file_, 0, raw});
    }

    // `rDate` is "age, error" in years before present.
    void read_event(const Json& event) {
        const std::string raw = json_text(event, "rDate");
        const UnitName* unit = named(json_text(event, "contextId"), raw);
        if (unit == nullptr) return;
        const auto parts = text::split(raw, ',');
        ImportedDating dating;
        dating.unit = *unit;
        dating.values.kind = model::DatingKind::Radiocarbon;
        dating.values.label = json_text(event, "label").empty() ? json_text(event, "id") : json_text(event, "label");
        if (!parts.empty()) dating.values.bp = text::parse_double(parts[0]);
        if (parts.size() > 1) dating.values.bp_error = text::parse_double(parts[1]);
        if (!dating.values.bp) {
            builder_.note({file_, 0, raw}, "unparsed", "a date that is no \"age, error\"; left out");
            return;
        }
        builder_.record.datings.push_back(std::move(dating));
    }

  public:
    std::size_t places_ = 0; ///< contexts with coordinates of a drawing, which are no levels

  private:
    RecordBuilder& builder_;
    std::string file_;
    std::map<std::string, UnitName, std::less<>> names_;
    std::map<std::string, std::string, std::less<>> phases_;
};

Recognition recognise(std::span<const InputFile> files) {
    Recognition out;
    for (std::size_t i = 0; i < files.size(); ++i) {
        if (files[i].is_database || !is_probably_text(files[i].bytes)) continue;
        const std::string_view head = text::trim(std::string_view(files[i].bytes).substr(0, 1U << 16U));
        const auto has = [&](std::string_view word) { return head.find(word) != std::string_view::npos; };
        if (!head.starts_with('{') || !has("\"contexts\"")) continue;
        if (!has("\"relationshipType\"") && !files[i].name.ends_with(".hmatrix.json")) continue;
        out.files.push_back(i);
        out.confidence = Confidence::Certain;
        out.why = "JSON with contexts and observations";
    }
    return out;
}

Imported<ImportedRecord> read(std::span<const InputFile* const> files, const ReadOptions& options, Progress& progress) {
    RecordBuilder builder(options);
    for (const InputFile* file : files) {
        progress.check();
        require_text(*file, "a StratiGraph matrix");
        DecodedText decoded = decode_text(file->bytes, file->name);
        builder.add_notes(std::move(decoded.notes));
        try {
            HmatrixReader reader(builder, *file);
            reader.read(parse_json(decoded.text));
            if (reader.places_ > 0) {
                builder.note({file->name, 0, {}}, "not-kept",
                             fmt::format("places of {} contexts: they say no height of a top or base", reader.places_));
            }
        } catch (Error& e) {
            if (!std::string_view(e.what()).starts_with(file->name)) e.add_context(file->name);
            throw;
        }
    }
    return builder.finish();
}

} // namespace

const Reader& hmatrix_json_reader() {
    static const Reader reader = {"hmatrix-json", "StratiGraph matrix (.hmatrix.json)", recognise, read};
    return reader;
}

} // namespace planum::strat
