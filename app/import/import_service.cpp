// SPDX-License-Identifier: MIT
#include "app/import/import_service.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <system_error>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "app/import/project_input.hpp"
#include "core/base/error.hpp"
#include "core/base/sha256.hpp"
#include "core/base/text.hpp"
#include "strat/exchange/reader.hpp"

namespace planum::app {

namespace {

/// A file to read, and whether it was named itself or lay in a folder that was.
struct Given {
    std::filesystem::path path;
    bool found = false;
};

std::vector<Given> expand(const std::vector<std::filesystem::path>& given) {
    std::vector<Given> files;
    for (const std::filesystem::path& path : given) {
        if (!std::filesystem::is_directory(path)) {
            files.push_back({path, false});
            continue;
        }
        for (const auto& entry : std::filesystem::directory_iterator(path)) {
            // Hidden files are the notes of file managers and editors.
            const bool hidden = entry.path().filename().string().starts_with('.');
            if (entry.is_regular_file() && !hidden) files.push_back({entry.path(), true});
        }
    }
    // Of a file that is named and found, the named one comes first and stays.
    std::sort(files.begin(), files.end(), [](const Given& a, const Given& b) {
        const auto order = text::natural_order(a.path.string(), b.path.string());
        return order != 0 ? order < 0 : a.found < b.found;
    });
    const auto same = [](const Given& a, const Given& b) { return a.path == b.path; };
    files.erase(std::unique(files.begin(), files.end(), same), files.end());
    if (files.empty()) throw Error(ErrorCode::Usage, "no file to import");
    return files;
}

// File names, with the folder in front where two files of one import have the same name.
void name_apart(std::vector<strat::InputFile>& inputs) {
    std::map<std::string, int> used;
    for (const strat::InputFile& input : inputs) ++used[input.name];
    for (strat::InputFile& input : inputs) {
        if (used[input.name] > 1) input.name = input.path.parent_path().filename().string() + "/" + input.name;
    }
}

std::string hash_of(const strat::InputFile& input) {
    return input.is_database ? sha256_of_file(input.path) : sha256(input.bytes);
}

ImportSet read_set(const std::vector<strat::InputFile>& inputs, const strat::Reading& reading,
                   const ImportOptions& options, Progress& progress) {
    std::vector<const strat::InputFile*> files;
    ImportSet set;
    for (const std::size_t at : reading.files) {
        files.push_back(&inputs[at]);
        model::Source source;
        source.name = inputs[at].name;
        source.format = reading.reader->format;
        source.sha256 = hash_of(inputs[at]);
        set.sources.push_back(std::move(source));
    }
    progress.step("reading " + files.front()->name);
    strat::ReadOptions read_options;
    read_options.area = options.area;
    read_options.site = options.site;
    auto imported = reading.reader->read(files, read_options, progress);
    set.record = std::move(imported.values);
    set.notes = std::move(imported.diagnostics);
    set.main_source = files.front()->name;
    return set;
}

// Files of a folder that no reader took: said, not refused, as photos and notes lie beside the lists.
void note_left_out(const std::vector<strat::InputFile>& inputs, const std::vector<strat::Reading>& plan,
                   std::vector<strat::ReadNote>& notes) {
    std::vector<bool> taken(inputs.size(), false);
    for (const strat::Reading& reading : plan) {
        for (const std::size_t at : reading.files) taken[at] = true;
    }
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        if (taken[i]) continue;
        notes.push_back({inputs[i].name, 0, "left-out", {}, "left out: no record that Planum knows"});
    }
}

bool holds_nothing(const strat::ImportedRecord& record) {
    return record.units.empty() && record.relations.empty() && record.periods.empty() && record.phases.empty() &&
           record.groups.empty() && record.datings.empty() && record.levels.empty() && record.finds.empty() &&
           record.samples.empty() && record.documents.empty() && record.areas.empty();
}

// One line for a source that states some relations from both sheets, but under half: the check does not ask it for the
// other side (`missing-reciprocal`), and whoever wrote it should know how far it goes.
std::string reciprocity_of(const strat::ImportedRecord& record) {
    std::vector<const strat::StatedRelation*> stated;
    for (const strat::StatedRelation& one : record.relations) {
        if (one.side != model::StatementSide::Neither) stated.push_back(&one);
    }
    const auto key = [](const strat::StatedRelation* s) { return std::tie(s->subject, s->kind, s->object); };
    std::sort(stated.begin(), stated.end(), [&](const auto* a, const auto* b) {
        return std::tuple_cat(key(a), std::tie(a->side)) < std::tuple_cat(key(b), std::tie(b->side));
    });
    std::size_t relations = 0;
    std::size_t both = 0;
    for (std::size_t from = 0, to = 0; from < stated.size(); from = to, ++relations) {
        while (to < stated.size() && key(stated[to]) == key(stated[from])) ++to;
        if (stated[from]->side != stated[to - 1]->side) ++both;
    }
    // Of a handful, and where hardly any is on both, there is nothing to know.
    constexpr std::size_t kHandful = 20;
    if (relations < kHandful || 10 * both < relations || 2 * both >= relations) return {};
    return fmt::format("{} of {} relations stand on both sheets, the rest on one; the other side is derived", both,
                       relations);
}

std::string joined(const std::string& a, const std::string& b) { return a.empty() || b.empty() ? a + b : a + "; " + b; }

template<class T>
void insert_all(store::ProjectFile& file, const std::vector<T>& values) {
    for (const T& value : values) file.insert(value);
}

template<class T>
void update_all(store::ProjectFile& file, const std::vector<T>& values) {
    for (const T& value : values) file.update(value);
}

// Parents before children; a ring of parents (which no reader should make) goes in as it comes.
template<class T>
void insert_parents_first(store::ProjectFile& file, const std::vector<T>& values) {
    std::set<decltype(T::id)> waiting;
    for (const T& value : values) waiting.insert(value.id);
    std::vector<const T*> rest;
    rest.reserve(values.size());
    for (const T& value : values) rest.push_back(&value);
    while (!rest.empty()) {
        std::vector<const T*> later;
        for (const T* value : rest) {
            if (!value->parent.is_nil() && value->parent != value->id && waiting.contains(value->parent)) {
                later.push_back(value);
                continue;
            }
            file.insert(*value);
            waiting.erase(value->id);
        }
        if (later.size() == rest.size()) {
            for (const T* value : later) file.insert(*value);
            return;
        }
        rest = std::move(later);
    }
}

ImportReport report_of(const MergePlan& plan) {
    ImportReport report;
    const auto count = [](const auto& values) { return static_cast<std::int64_t>(values.size()); };
    report.new_units = count(plan.new_units);
    report.filled_units = count(plan.changed_units);
    report.new_relations = count(plan.new_relations);
    report.new_statements = count(plan.new_statements);
    report.new_others = count(plan.new_areas) + count(plan.new_periods) + count(plan.new_phases) +
                        count(plan.new_groups) + count(plan.new_datings) + count(plan.new_levels) +
                        count(plan.new_finds) + count(plan.new_samples) + count(plan.new_documents);
    report.mentioned_units =
        std::count_if(plan.new_units.begin(), plan.new_units.end(),
                      [](const model::StratigraphicUnit& unit) { return unit.origin == model::UnitOrigin::Mentioned; });
    report.conflicts = plan.conflicts;
    report.warnings = plan.warnings;
    report.changed = !plan.is_empty();
    return report;
}

std::string label_of(const std::vector<strat::InputFile>& inputs) {
    if (inputs.size() == 1) return "Import " + inputs.front().name;
    return fmt::format("Import {} and {} more", inputs.front().name, inputs.size() - 1);
}

} // namespace

namespace {

// Inside a change.
void write_plan(store::ProjectFile& file, const MergePlan& plan) {
    insert_all(file, plan.new_areas);
    insert_all(file, plan.new_sources);
    update_all(file, plan.changed_sources);
    insert_all(file, plan.new_periods);
    update_all(file, plan.changed_periods);
    insert_all(file, plan.new_phases);
    update_all(file, plan.changed_phases);
    insert_parents_first(file, plan.new_units);
    update_all(file, plan.changed_units);
    insert_parents_first(file, plan.new_groups);
    update_all(file, plan.changed_groups);
    insert_all(file, plan.new_relations);
    update_all(file, plan.changed_relations);
    insert_all(file, plan.new_statements);
    insert_all(file, plan.new_finds);
    update_all(file, plan.changed_finds);
    insert_all(file, plan.new_datings);
    insert_all(file, plan.new_levels);
    insert_all(file, plan.new_samples);
    insert_all(file, plan.new_documents);
    for (const model::ImportNoteId note : plan.gone_notes) file.remove(note);
    insert_all(file, plan.new_notes);
}

} // namespace

void apply_merge(Project& project, const MergePlan& plan, std::string_view label) {
    project.change(label, [&] { write_plan(project.file(), plan); });
}

ImportReport import_files(Project& project, const std::vector<std::filesystem::path>& files,
                          const ImportOptions& options, Progress& progress) {
    std::vector<strat::InputFile> inputs;
    std::vector<strat::ReadNote> left_behind;
    for (const Given& file : expand(files)) {
        progress.check();
        progress.step("reading " + file.path.filename().string());
        std::error_code gone; // meanwhile: reading says it
        const std::uintmax_t size = file.found ? std::filesystem::file_size(file.path, gone) : 0;
        if (!gone && size > strat::kMaxRecordFile) {
            left_behind.push_back({file.path.filename().string(),
                                   0,
                                   "left-out",
                                   {},
                                   "left out: too large for a record; scans are added with planum scan add"});
            continue;
        }
        inputs.push_back(strat::load_input_file(file.path));
        inputs.back().found = file.found;
        for (auto& note : read_as_project(inputs.back(), {&project.clock(), &project.uuids(), {}})) {
            left_behind.push_back(std::move(note));
        }
    }
    name_apart(inputs);
    const std::vector<strat::Reading> plan_of_reading = strat::plan_reading(inputs, options.format);

    note_left_out(inputs, plan_of_reading, left_behind);

    std::vector<ImportSet> sets;
    std::vector<ImportedFiles> readings;
    for (const strat::Reading& reading : plan_of_reading) {
        progress.check();
        sets.push_back(read_set(inputs, reading, options, progress));
        ImportedFiles taken{std::string(reading.reader->format),
                            std::string(reading.reader->title),
                            {},
                            joined(reading.note, reciprocity_of(sets.back().record))};
        if (holds_nothing(sets.back().record)) taken.note = joined(taken.note, "nothing in it but headings");
        for (const std::size_t at : reading.files) taken.files.push_back(inputs[at].name);
        readings.push_back(std::move(taken));
    }

    progress.step("merging");
    MergeOptions merge_options;
    merge_options.numbers = options.numbers.value_or(project.record().settings.numbers);
    merge_options.update = options.update;
    const MergePlan plan = plan_merge(project.record(), sets, merge_options, project.uuids(), project.clock());
    ImportReport report = report_of(plan);
    report.readings = std::move(readings);
    report.notes = std::move(left_behind);
    for (ImportSet& set : sets) {
        report.notes.insert(report.notes.end(), set.notes.begin(), set.notes.end());
    }
    progress.check();
    const bool scope_changes = merge_options.numbers != project.record().settings.numbers;
    if (options.dry_run) return report;
    if (report.changed || scope_changes) {
        progress.step("writing");
        model::ProjectSettings settings = project.record().settings;
        settings.numbers = merge_options.numbers;
        project.change(label_of(inputs), [&] {
            if (scope_changes) project.file().update(settings);
            write_plan(project.file(), plan);
        });
    }
    return report;
}

} // namespace planum::app
