// SPDX-License-Identifier: MIT
#include "app/survey/survey_import.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "app/import/import_service.hpp"
#include "app/regions/region_names.hpp"
#include "app/scans/days_surface.hpp"
#include "app/survey/code_table.hpp"
#include "app/survey/survey_csv.hpp"
#include "app/survey/survey_dxf.hpp"
#include "core/base/error.hpp"
#include "core/base/file.hpp"
#include "core/base/sha256.hpp"
#include "core/base/text.hpp"

namespace planum::app {

namespace {

constexpr std::uintmax_t kLargest = 256ULL << 20U;

model::LevelRole role_of(SurveyMeaning meaning) {
    switch (meaning) {
    case SurveyMeaning::Top: return model::LevelRole::Top;
    case SurveyMeaning::Base: return model::LevelRole::Base;
    case SurveyMeaning::Cut: return model::LevelRole::Cut;
    case SurveyMeaning::OtherLevel:
    case SurveyMeaning::Find:
    case SurveyMeaning::Ignored: return model::LevelRole::Other;
    }
    return model::LevelRole::Other;
}

// `1042.3` and `1042_3` are the third point of 1042.
std::string stem_of(const std::string& name) { return name.substr(0, name.find_first_of("./_")); }

class Translator {
  public:
    Translator(Project& project, const SurveyOptions& options, const CodeTable& codes, SurveyReport& report)
        : project_(project), options_(options), codes_(codes), report_(report) {}

    ImportSet set_of(const SurveyFile& file, const std::string& name, const std::string& format,
                     const std::string& sha256) {
        ImportSet set;
        model::Source source;
        source.name = name;
        source.format = format;
        source.sha256 = sha256;
        set.sources.push_back(source);
        set.main_source = name;
        set.notes = file.notes;
        levels_without_height_ = 0;
        for (const SurveyPoint& point : file.points) take(point, set);
        if (levels_without_height_ > 0) {
            set.notes.push_back(
                {name,
                 first_without_height_,
                 "no-height",
                 {},
                 levels_without_height_ == 1
                     ? std::string("a level without a height was left out")
                     : fmt::format("from here on, {} levels without a height were left out", levels_without_height_)});
        }
        return set;
    }

  private:
    void take(const SurveyPoint& point, ImportSet& set) {
        ++report_.points;
        auto code = codes_.read(point.code);
        if (const auto by_name = codes_.read(point.name); by_name && (!code || code->number.empty())) {
            // Drawings write code and number as one text; the layer then says nothing more. In a table B2 is a name.
            const bool is_code = !code && point.source != PointSource::Table;
            if (is_code || (code && by_name->meaning == code->meaning && !by_name->number.empty())) code = by_name;
        }
        const bool bare_text = point.source == PointSource::LoneText && (!code || code->number.empty());
        if (!code || bare_text || code->meaning == SurveyMeaning::Ignored) {
            if (!bare_text) ++report_.other_codes[point.code.empty() ? "(none)" : point.code];
            return;
        }
        if (code->meaning == SurveyMeaning::Find) {
            take_find(point, *code, set);
        } else {
            take_level(point, *code, set);
        }
    }

    void note(const SurveyPoint& point, ImportSet& set, const char* code, const std::string& message) {
        set.notes.push_back({set.main_source, point.line, code,
                             text::join({point.name, point.code, point.unit}, " ").substr(0, 200), message});
    }

    // The unit's name when it is known, or may be made; an empty number with a note otherwise.
    strat::UnitName unit_for(const std::string& number, const SurveyPoint& point, ImportSet& set, const char* thing) {
        const model::Record& record = project_.record();
        auto hits = project_.index().named(number);
        const auto area_name = [&](model::UnitIndex unit) {
            for (const model::Area& area : record.areas) {
                if (area.id == record.units[unit].area) return area.name;
            }
            return std::string{};
        };
        if (!options_.area.empty() && record.settings.numbers == model::NumberScope::Area) {
            std::erase_if(hits, [&](model::UnitIndex unit) { // another area's number
                return record.units[unit].number == number && !record.units[unit].area.is_nil() &&
                       area_name(unit) != options_.area;
            });
        }
        for (const model::UnitIndex unit : hits) {
            if (hits.size() == 1 || area_name(unit) == options_.area) {
                return {area_name(unit), record.units[unit].number};
            }
        }
        if (hits.size() > 1) {
            note(point, set, "ambiguous-unit", fmt::format("{} areas have a unit {}; say --area", hits.size(), number));
            return {};
        }
        if (options_.create_units) {
            auto& made = report_.new_units;
            if (std::find(made.begin(), made.end(), number) == made.end()) made.push_back(number);
            return {options_.area, number};
        }
        const auto near = proposed_numbers(record, number);
        const std::string hint = near.empty() ? "" : "; near it: " + text::join(near, ", ");
        note(point, set, "unknown-unit", fmt::format("{}: no unit {}{}", thing, number, hint));
        return {};
    }

    void take_level(const SurveyPoint& point, const ReadCode& code, ImportSet& set) {
        if (!point.z) {
            if (levels_without_height_++ == 0) first_without_height_ = point.line;
            return;
        }
        const std::string number = !point.unit.empty()    ? point.unit
                                   : !code.number.empty() ? code.number
                                                          : stem_of(point.name);
        if (number.empty()) return note(point, set, "unknown-unit", "a level without a unit was left out");
        strat::ImportedLevel level;
        level.unit = unit_for(number, point, set, "level");
        if (level.unit.number.empty()) return;
        level.values.x = point.x;
        level.values.y = point.y;
        level.values.z = *point.z;
        level.values.role = role_of(code.meaning);
        level.values.label = point.name;
        set.record.levels.push_back(std::move(level));
    }

    void take_find(const SurveyPoint& point, const ReadCode& code, ImportSet& set) {
        strat::ImportedFind find;
        find.values.number = !point.find.empty() ? point.find : !code.number.empty() ? code.number : point.name;
        if (find.values.number.empty()) return note(point, set, "unparsed", "a find without a number was left out");
        if (!point.unit.empty()) find.unit = unit_for(point.unit, point, set, "find");
        find.values.x = point.x;
        find.values.y = point.y;
        find.values.z = point.z;
        find.values.found_on = options_.day;
        find.values.description = point.text;
        set.record.finds.push_back(std::move(find));
    }

    Project& project_;
    const SurveyOptions& options_;
    const CodeTable& codes_;
    SurveyReport& report_;
    std::size_t levels_without_height_ = 0; ///< of the file at hand
    std::int64_t first_without_height_ = 0; ///< its line
};

} // namespace

SurveyReport import_survey(Project& project, const std::vector<std::filesystem::path>& files,
                           const SurveyOptions& options) {
    if (!options.day.empty()) require_day("--day", options.day);
    CodeTable codes;
    if (!options.codes.empty()) {
        codes.add_table(read_file(options.codes, kLargest), options.codes.filename().string());
    }
    SurveyReport report;
    Translator translator(project, options, codes, report);
    std::vector<ImportSet> sets;
    for (const std::filesystem::path& path : files) {
        const std::string name = path.filename().string();
        try {
            const std::string bytes = read_file(path, kLargest);
            const bool drawing = is_dxf(bytes);
            const SurveyFile file =
                drawing ? read_survey_dxf(bytes, name) : read_survey_csv(bytes, name, options.columns);
            sets.push_back(translator.set_of(file, name, drawing ? "dxf" : "survey-csv", sha256(bytes)));
        } catch (Error& e) {
            e.add_context(name);
            throw;
        }
    }
    MergeOptions merging;
    merging.numbers = project.record().settings.numbers;
    merging.update = options.update;
    const MergePlan plan = plan_merge(project.record(), sets, merging, project.uuids(), project.clock());
    report.new_levels = plan.new_levels.size();
    report.new_finds = plan.new_finds.size();
    report.changed_finds = plan.changed_finds.size();
    report.conflicts = plan.conflicts;
    for (const ImportSet& set : sets) report.notes.insert(report.notes.end(), set.notes.begin(), set.notes.end());
    report.changed = !plan.is_empty();
    if (!options.dry_run && report.changed) {
        apply_merge(project, plan, fmt::format("Import measured points of {}", files.front().filename().string()));
    }
    return report;
}

} // namespace planum::app
