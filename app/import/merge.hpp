// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/clock.hpp"
#include "core/base/uuid.hpp"
#include "core/model/record.hpp"
#include "strat/exchange/imported_record.hpp"

namespace planum::app {

/// One set of files read by one reader, ready to be merged.
struct ImportSet {
    std::vector<model::Source> sources; ///< names, formats and hashes; ids nil
    strat::ImportedRecord record;
    std::vector<strat::ReadNote> notes;
    std::string main_source; ///< source that statements without a file of their own belong to
};

struct MergeOptions {
    model::NumberScope numbers = model::NumberScope::Site;
    bool update = false; ///< differing values of the file replace those of the project
};

/// A value that stands differently in the project and in the file.
struct MergeConflict {
    std::string what; ///< `unit 1042`
    std::string field;
    std::string kept;
    std::string offered;
    bool replaced = false; ///< with --update: `offered` now stands
};

/// What a merge would write: new and changed values with their ids set, ready for the project file.
struct MergePlan {
    std::vector<model::Area> new_areas;
    std::vector<model::Source> new_sources;
    std::vector<model::Source> changed_sources;
    std::vector<model::Period> new_periods;
    std::vector<model::Period> changed_periods;
    std::vector<model::Phase> new_phases;
    std::vector<model::Phase> changed_phases;
    std::vector<model::StratigraphicUnit> new_units;
    std::vector<model::StratigraphicUnit> changed_units;
    std::vector<model::UnitGroup> new_groups;
    std::vector<model::UnitGroup> changed_groups;
    std::vector<model::PhysicalRelation> new_relations;
    std::vector<model::PhysicalRelation> changed_relations;
    std::vector<model::RelationStatement> new_statements;
    std::vector<model::Dating> new_datings;
    std::vector<model::Level> new_levels;
    std::vector<model::Find> new_finds;
    std::vector<model::Find> changed_finds;
    std::vector<model::Sample> new_samples;
    std::vector<model::Document> new_documents;
    std::vector<model::ImportNote> new_notes;
    std::vector<model::ImportNoteId> gone_notes; ///< of a source read again that no longer says so
    std::vector<MergeConflict> conflicts;
    std::vector<std::string> warnings; ///< sentences: a number used in two areas, …

    [[nodiscard]] bool is_empty() const noexcept;
};

/// Merges what files say into a record: the same number (and area) is the same unit, empty fields are
/// filled, differing ones reported and kept unless `update`; relations are a set of statements, counted
/// per source and side, so that a second identical import adds nothing and the order of files does not
/// matter. Nothing is withdrawn. Pure: writes nothing.
[[nodiscard]] MergePlan plan_merge(const model::Record& current, const std::vector<ImportSet>& sets,
                                   const MergeOptions& options, UuidSource& ids, const Clock& clock);

} // namespace planum::app
