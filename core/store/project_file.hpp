// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/clock.hpp"
#include "core/base/progress.hpp"
#include "core/base/uuid.hpp"
#include "core/model/record.hpp"
#include "core/store/removed_records.hpp"

namespace planum::store {

/// Newest schema this program writes; older ones are migrated when opened for writing.
inline constexpr std::int64_t kSchemaVersion = 4;

enum class OpenMode { ReadOnly, ReadWrite };

/// Who works, when, and where new ids come from. Clock and ids must outlive the file.
struct Environment {
    const Clock* clock = nullptr;
    UuidSource* uuids = nullptr;
    std::string author;
};

/// What opening found and did; every line is a sentence for the user.
struct OpenReport {
    std::vector<std::string> notes; ///< WAL set back, R-trees dropped, migrated from 1 to 2, …
    bool import_only = false;       ///< foreign triggers or views: nothing may be written
    std::vector<std::string> import_only_because;
};

/// One line of `planum history`.
struct ChangeEntry {
    std::int64_t number = 0; ///< ascending; 0: another program's work, no undo step
    std::string label;       ///< "Add unit 1042"
    std::string author;
    std::string made_at;
    bool undone = false;
    bool dropped = false; ///< undone, and something else was done since: redo cannot bring it back
};

/// One logged row: an inserted record, or one changed field.
struct LogEntry {
    std::string made_at;
    std::string author;
    std::string action; ///< insert, update, delete, undo, redo
    std::string table;
    std::string uuid;
    std::string field;
    std::string old_value;
    std::string new_value;
    std::int64_t change = 0; ///< ChangeEntry::number; 0: made by another program
};

struct VerifyProblem {
    std::string where; ///< table, row or page
    std::string what;  ///< a sentence
};

/// The project file: one GeoPackage that holds the whole record, safe to open and safe to kill.
///
/// Invariant: an open file has passed the checks of the README's "Opening files one does not trust"; every
/// write happens inside change(), which is one transaction and one undo step. Not thread-safe; a second
/// process may hold the same file, busy waits last at most ten seconds.
class ProjectFile {
  public:
    struct State; ///< known inside core/store only

    /// Makes a new file. Throws Conflict when it exists already, Usage when the name does not end in .gpkg.
    static ProjectFile create(const std::filesystem::path& file, const model::ProjectSettings& settings,
                              const Environment& environment);

    /// Throws NotFound, Io or BadInput (damaged, not a project, a newer schema; with what to do about it).
    static ProjectFile open(const std::filesystem::path& file, OpenMode mode, const Environment& environment);

    ProjectFile(ProjectFile&&) noexcept;
    ProjectFile& operator=(ProjectFile&&) noexcept;
    ~ProjectFile();

    [[nodiscard]] const std::filesystem::path& path() const noexcept;
    [[nodiscard]] const OpenReport& open_report() const noexcept;
    [[nodiscard]] std::int64_t schema_version() const noexcept;

    /// The living record, sorted (model::sort_record).
    [[nodiscard]] model::Record load() const;

    /// What was deleted since a moment (ISO, or its beginning: a day).
    [[nodiscard]] RemovedRecords load_removed(std::string_view since) const;

    /// The settings alone, for `info` and for opening a window.
    [[nodiscard]] model::ProjectSettings settings() const;

    /// Runs `work` as one transaction and one undo step. When `work` throws, the file is as it was and
    /// the exception goes on. A change that changes nothing leaves no undo step. Returns its number, or 0.
    std::int64_t change(std::string_view label, const std::function<void()>& work);

    // Inside change() only. Insert fills a nil id and returns it; update writes every field of the living
    // row with that id (NotFound otherwise); remove marks it deleted. Errors name the thing: "unit 1042:
    // number already used in area A".
    model::AreaId insert(const model::Area& value);
    model::UnitId insert(const model::StratigraphicUnit& value);
    model::RelationId insert(const model::PhysicalRelation& value);
    model::StatementId insert(const model::RelationStatement& value);
    model::SourceId insert(const model::Source& value);
    model::ImportNoteId insert(const model::ImportNote& value);
    model::PeriodId insert(const model::Period& value);
    model::PhaseId insert(const model::Phase& value);
    model::GroupId insert(const model::UnitGroup& value);
    model::DatingId insert(const model::Dating& value);
    model::LevelId insert(const model::Level& value);
    model::FindId insert(const model::Find& value);
    model::SampleId insert(const model::Sample& value);
    model::DocumentId insert(const model::Document& value);
    model::SurfaceId insert(const model::Surface& value);
    model::SectionId insert(const model::Section& value);
    model::RegionId insert(const model::Region& value);
    model::ScanId insert(const model::Scan& value);
    model::RegistrationRunId insert(const model::RegistrationRun& value);
    void insert(const model::ScanPose& value);
    model::DecisionId insert(const model::Decision& value);
    model::InterpretationId insert(const model::Interpretation& value);

    void update(const model::ProjectSettings& value);
    void update(const model::Area& value);
    void update(const model::StratigraphicUnit& value);
    void update(const model::PhysicalRelation& value);
    void update(const model::Source& value);
    void update(const model::Period& value);
    void update(const model::Phase& value);
    void update(const model::UnitGroup& value);
    void update(const model::Dating& value);
    void update(const model::Level& value);
    void update(const model::Find& value);
    void update(const model::Sample& value);
    void update(const model::Document& value);
    void update(const model::Surface& value);
    void update(const model::Section& value);
    void update(const model::Region& value);
    void update(const model::Scan& value);
    void update(const model::RegistrationRun& value);
    void update(const model::Interpretation& value);

    void remove(model::AreaId id);
    void remove(model::UnitId id);
    /// With all its statements.
    void remove(model::RelationId id);
    void remove(model::StatementId id);
    void remove(model::ImportNoteId id);
    void remove(model::PeriodId id);
    void remove(model::PhaseId id);
    void remove(model::GroupId id);
    void remove(model::DatingId id);
    void remove(model::LevelId id);
    void remove(model::FindId id);
    void remove(model::SampleId id);
    void remove(model::DocumentId id);
    void remove(model::SurfaceId id);
    void remove(model::SectionId id);
    void remove(model::RegionId id);
    void remove(model::ScanId id);
    void remove(model::DecisionId id);
    void remove(model::InterpretationId id);

    /// Takes the newest change back, or makes the last one taken back again; returns it. Throws Conflict
    /// with a sentence when there is none, or when the rows were changed since by another program.
    ChangeEntry undo();
    ChangeEntry redo();
    [[nodiscard]] std::vector<ChangeEntry> history(std::size_t most) const;
    /// Drops what undo needs of the changes made before `day` (ISO date or time); the changes themselves, their line in
    /// the history and the log stay. Returns how many can no longer be taken back. Undo steps are never dropped
    /// unasked.
    std::size_t forget_changes(std::string_view day);
    /// Gives the space of deleted pages back to the disk. Needs room for a second copy meanwhile.
    void compact();
    /// Log of one record (by uuid), or of all; newest first.
    [[nodiscard]] std::vector<LogEntry> log(std::optional<Uuid> record, std::size_t most) const;

    /// integrity_check, foreign_key_check, our own rules (every uuid there, every relation between living
    /// units, every changeset readable), GeoPackage tables.
    [[nodiscard]] std::vector<VerifyProblem> verify(Progress& progress) const;

    /// SQLite's backup API into a temporary file, checked, then renamed.
    void backup(const std::filesystem::path& target, Progress& progress) const;

    /// Every living row of every record table as text, ordered by content, without uuid, times and logs:
    /// two projects are equal exactly when their dumps are.
    [[nodiscard]] std::string canonical_dump() const;

  private:
    explicit ProjectFile(std::unique_ptr<State> state) noexcept;
    std::unique_ptr<State> state_;
};

} // namespace planum::store
