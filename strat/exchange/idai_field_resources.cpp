// SPDX-License-Identifier: MIT
#include "strat/exchange/idai_field_resources.hpp"

#include <algorithm>

#include "core/base/text.hpp"
#include "strat/exchange/unit_fields.hpp"

namespace planum::strat {

namespace {

constexpr std::array<std::string_view, 24> kUnitCategories = {
    "feature",        "layer",    "architecture", "grave",       "burial",    "floor",        "pit",
    "posthole",       "cut",      "fill",         "floorlevel",  "surface",   "wall",         "drillcorelayer",
    "featuresegment", "roomwall", "roomfloor",    "roomceiling", "earthwork", "otherfeature", "stratigraphicunit",
    "planum",         "hearth",   "ditch"};
constexpr std::array<std::string_view, 17> kNothing = {
    "project",         "configuration", "type",    "typecatalog", "room",   "building", "survey",    "surveyunit",
    "buildingpart",    "surveyburial",  "profile", "place",       "trench", "area",     "operation", "storageplace",
    "valuablecategory"};
constexpr std::array<std::string_view, 5> kPlaces = {"trench", "survey", "area", "operation", "building"};
constexpr std::array<std::string_view, 5> kDocuments = {"photo", "drawing", "image", "plandrawing", "sectiondrawing"};
constexpr std::array<std::string_view, 13> kStrata = {"isAbove",       "isBelow",    "cuts",      "isCutBy",
                                                      "fills",         "isFilledBy", "abuts",     "isAbuttedBy",
                                                      "isAfter",       "isBefore",   "bordersOn", "isContemporaryWith",
                                                      "isEquivalentTo"};

struct FieldColumn {
    std::string_view key;
    std::string_view field;
};

constexpr std::array kDetails = {
    FieldColumn{"distinguishingCriteria", "criteria_of_distinction"},
    FieldColumn{"consistency", "consistency"},
    FieldColumn{"color", "colour"},
    FieldColumn{"soilType", "composition"},
    FieldColumn{"featureForm", "shape_in_plan"},
    FieldColumn{"featureBorders", "borders"},
    FieldColumn{"conditionAmount", "preservation"},
    FieldColumn{"condition", "preservation"},
    FieldColumn{"layerClassification", "formation"},
    FieldColumn{"diary", "observations"},
};
constexpr std::array<std::string_view, 4> kCustom = {"specificType", "graveType", "campaign", "hasDisturbance"};

template<class List>
bool contains(const List& list, std::string_view word) {
    return std::find(list.begin(), list.end(), word) != list.end();
}

// "range", "exact", "before", "after", "scientific" with years already counted from the era.
std::optional<model::Year> year_of(const Json& dating, std::string_view end) {
    const Json* point = json_member(dating, end);
    if (point == nullptr) return std::nullopt;
    if (const auto year = json_number(*point, "year")) return year_from_text(json_text(*point, "year"));
    const auto input = year_from_text(json_text(*point, "inputYear"));
    if (!input) return std::nullopt;
    const std::string era = json_text(*point, "inputType");
    if (era == "bce") return -*input;
    if (era == "bp") return 1950 - *input;
    return input;
}

} // namespace

std::vector<std::string> field_targets(const Json& resource, std::string_view relation) {
    std::vector<std::string> out;
    const Json* relations = json_member(resource, "relations");
    const Json* targets = relations == nullptr ? nullptr : json_member(*relations, relation);
    if (targets == nullptr || !targets->is_array()) return out;
    for (const Json& target : *targets) {
        // Newer exports give an object for each target.
        out.push_back(target.is_object() ? json_text(target, "id") : json_scalar_text(target));
    }
    return out;
}

FieldRole field_role(const Json& resource, std::string_view category) {
    // "Rtest:Layer": the part in front is the project's own.
    const std::size_t colon = category.rfind(':');
    std::string word = text::fold_case(colon == std::string_view::npos ? category : category.substr(colon + 1));
    std::erase(word, ' ');
    if (contains(kUnitCategories, word)) return FieldRole::Unit;
    if (contains(kDocuments, word)) return FieldRole::Document;
    if (contains(kPlaces, word)) return FieldRole::Place;
    if (word == "sample") return FieldRole::Sample;
    if (contains(kNothing, word)) return FieldRole::Other;
    const bool has_strata = std::any_of(kStrata.begin(), kStrata.end(), [&](std::string_view relation) {
        return !field_targets(resource, relation).empty();
    });
    if (has_strata) return FieldRole::Unit;
    return field_targets(resource, "isRecordedIn").empty() && field_targets(resource, "liesWithin").empty()
               ? FieldRole::Other
               : FieldRole::Find;
}

std::string field_text(const Json& resource, std::string_view key) {
    const Json* value = json_member(resource, key);
    if (value == nullptr) return {};
    if (value->is_object()) {
        if (std::string own = json_text(*value, "value"); !own.empty()) return own;
        for (const Json& language : *value) {
            if (std::string text = json_scalar_text(language); !text.empty()) return text;
        }
        return {};
    }
    if (!value->is_array()) return json_scalar_text(*value);
    std::string out;
    for (const Json& item : *value) {
        const std::string text = json_scalar_text(item);
        if (!text.empty()) out += (out.empty() ? "" : ", ") + text;
    }
    return out;
}

std::string field_date(const Json& resource, std::string_view key) {
    std::string date = field_text(resource, key);
    const bool german = date.size() >= 10 && date[2] == '.' && date[5] == '.';
    if (!german) return date;
    return date.substr(6, 4) + "-" + date.substr(3, 2) + "-" + date.substr(0, 2);
}

void read_field_unit(const FieldResource& resource, ImportedUnit& unit) {
    const Json& json = resource.json;
    const std::size_t colon = resource.category.rfind(':');
    set_kind(unit, colon == std::string::npos ? resource.category : resource.category.substr(colon + 1));
    if (json_text(json, "isNatural") == "true") unit.values.kind = model::UnitKind::Natural;
    if (std::string title = field_text(json, "shortDescription"); !title.empty()) unit.values.title = title;
    unit.values.description = field_text(json, "description");
    unit.values.interpretation = field_text(json, "interpretation");
    unit.values.recorded_by = field_text(json, "processor");
    unit.values.excavated_from = field_date(json, "beginningDate");
    unit.values.excavated_on = field_date(json, "endDate");
    unit.period = field_text(json, "period");
    for (const FieldColumn& column : kDetails) {
        const std::string text = field_text(json, column.key);
        if (text.empty()) continue;
        std::string& field = unit.values.details[std::string(column.field)];
        field += (field.empty() ? "" : "; ") + text;
    }
    for (const std::string_view key : kCustom) add_custom_field(unit, key, field_text(json, key));
}

std::vector<model::Dating> read_field_datings(const Json& resource) {
    std::vector<model::Dating> out;
    const Json* datings = json_member(resource, "dating");
    if (datings == nullptr || !datings->is_array()) return out;
    for (const Json& entry : *datings) {
        model::Dating dating;
        dating.kind = model::DatingKind::Typed;
        dating.label = json_text(entry, "type");
        dating.from = year_of(entry, "begin");
        dating.to = year_of(entry, "end");
        if (dating.label == "exact") {
            if (!dating.from) dating.from = dating.to;
            if (!dating.to) dating.to = dating.from;
        }
        dating.notes = json_text(entry, "source");
        if (dating.from && dating.to && *dating.to < *dating.from) std::swap(dating.from, dating.to);
        out.push_back(std::move(dating));
    }
    return out;
}

} // namespace planum::strat
