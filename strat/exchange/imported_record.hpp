// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <cstdint>
#include <string>
#include <vector>

#include "core/model/record.hpp"

namespace planum::strat {

/// A unit as files name it. An empty area means that the file knows none.
struct UnitName {
    std::string area;
    std::string number;

    friend auto operator<=>(const UnitName&, const UnitName&) = default;
};

/// A unit's sheet as read: `values` holds what the file says (id, area, phase, period and parent stay
/// nil; names below say them). Empty values mean "the file does not say".
struct ImportedUnit {
    UnitName name;
    model::StratigraphicUnit values;
    std::string phase;  ///< number of an ImportedPhase, or of one the project has
    std::string period; ///< number of a Period
    UnitName parent;    ///< the feature it is part of; empty number: none
    std::int64_t line = 0;
    std::string file; ///< name of the file it stands in; empty: the first file of the set
};

/// One statement of one relation, already read from the younger side: `subject kind object`. The merge
/// turns statements of the same triple into one relation.
struct StatedRelation {
    UnitName subject;
    model::RelationKind kind = model::RelationKind::Covers;
    UnitName object;
    model::Certainty certainty = model::Certainty::Certain;
    bool correlation = false;
    model::StatementSide side = model::StatementSide::Subject; ///< on whose sheet it was written
    std::string person;
    std::string file;      ///< name of the file it stands in; empty: the first file of the set
    std::int64_t line = 0; ///< from 1; 0 unknown
    std::string raw_text;
};

struct ImportedPhase {
    model::Phase values; ///< period stays nil
    std::string period;
};

struct ImportedGroup {
    model::UnitGroup values; ///< parent and members stay empty
    std::string parent;
    std::vector<UnitName> members;
};

struct ImportedDating {
    UnitName unit; ///< empty number: belongs to the find only
    std::string find;
    model::Dating values;
};

struct ImportedLevel {
    UnitName unit;
    model::Level values;
};

struct ImportedFind {
    UnitName unit; ///< empty number: not assigned
    model::Find values;
};

struct ImportedSample {
    UnitName unit;
    model::Sample values;
};

struct ImportedDocument {
    UnitName unit;
    model::Document values;
};

/// What one set of files says, by names. Everything keeps the order of the files.
struct ImportedRecord {
    std::string project_name;
    std::vector<model::Area> areas; ///< ids nil
    std::vector<ImportedUnit> units;
    std::vector<StatedRelation> relations;
    std::vector<model::Period> periods; ///< ids nil
    std::vector<ImportedPhase> phases;
    std::vector<ImportedGroup> groups;
    std::vector<ImportedDating> datings;
    std::vector<ImportedLevel> levels;
    std::vector<ImportedFind> finds;
    std::vector<ImportedSample> samples;
    std::vector<ImportedDocument> documents;
};

/// Something a reader could not use or had to guess; nothing is dropped without one.
struct ReadNote {
    std::string file;      ///< name without folders
    std::int64_t line = 0; ///< from 1; 0: the whole file
    std::string code;      ///< unparsed, empty-target, unknown-relation, replaced-characters, …
    std::string raw_text;  ///< shortened to 200 characters
    std::string message;   ///< a plain sentence in lower case: what is wrong and what was done
};

/// Readers of dirty tables return both: what they understood, and all that they did not.
template<class T>
struct Imported {
    T values;
    std::vector<ReadNote> diagnostics;
};

} // namespace planum::strat
