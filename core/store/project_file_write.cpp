// SPDX-License-Identifier: MIT
#include <algorithm>
#include <set>

#include "core/store/record_writer.hpp"

namespace planum::store {

namespace {

template<class T>
auto insert_with_id(ProjectFile::State& state, const T& value) {
    auto id = value.id;
    if (id.is_nil()) id.value = state.new_uuid();
    insert_record(state, value, id.value);
    return id;
}

/// Uuids of the living rows of a small side table that belong to one owner, with the value of one column.
std::vector<std::pair<Uuid, Uuid>> rows_of(const ProjectFile::State& state, std::string_view table,
                                           std::string_view owner_column, std::string_view value_column,
                                           const Uuid& owner) {
    sqlite::Statement rows = state.database.prepare(fmt::format(
        "SELECT uuid, {} FROM {} WHERE {} = :owner AND deleted_at IS NULL", value_column, table, owner_column));
    rows.bind(":owner", std::string_view{owner.to_string()});
    std::vector<std::pair<Uuid, Uuid>> found;
    while (rows.step()) {
        found.emplace_back(Uuid::parse(rows.text(0)).value_or(Uuid{}), Uuid::parse(rows.text(1)).value_or(Uuid{}));
    }
    return found;
}

/// Makes the rows of a side table equal to `wanted`: marks what is gone, adds what is new.
template<class Tag>
void replace_rows(ProjectFile::State& state, std::string_view table, std::string_view owner_column,
                  std::string_view value_column, const Uuid& owner, const std::vector<Id<Tag>>& wanted) {
    std::set<Uuid> missing;
    for (const Id<Tag>& id : wanted) missing.insert(id.value);
    for (const auto& [row, value] : rows_of(state, table, owner_column, value_column, owner)) {
        if (missing.erase(value) == 0) remove_record(state, table, table, row);
    }
    if (missing.empty()) return;
    state.require_change(table);
    sqlite::Statement insert = state.database.prepare(insert_sql(table, {owner_column, value_column}));
    for (const Id<Tag>& id : wanted) {
        if (missing.erase(id.value) == 0) continue; // there already, or named twice
        RowBinder binder(insert, 1, state.srs_id);
        binder.uuid(state.new_uuid());
        binder.uuid(owner);
        binder.uuid(id.value);
        insert.run();
        state.note_insert(table);
    }
}

void replace_members(ProjectFile::State& state, const model::UnitGroup& group, model::GroupId id) {
    try {
        replace_rows(state, "group_member", "unit_group", "unit", id.value, group.members);
    } catch (const Error& e) {
        throw explain(state, e, "filling", "group", group.number, {});
    }
}

void insert_added(ProjectFile::State& state, const model::PhysicalRelation& relation, const Uuid& owner) {
    constexpr std::string_view kTable = "interpretation_added";
    state.require_change(kTable);
    sqlite::Statement& insert = state.statements[std::string{kTable}].insert;
    std::vector<std::string_view> columns{"interpretation"};
    const auto& of_relation = columns_of<model::PhysicalRelation>();
    columns.insert(columns.end(), of_relation.begin(), of_relation.end());
    if (!insert) insert = state.database.prepare(insert_sql(kTable, columns));
    RowBinder binder(insert, 1, state.srs_id);
    binder.uuid(relation.id.is_nil() ? state.new_uuid() : relation.id.value);
    binder.uuid(owner);
    describe_columns(binder, relation);
    insert.run();
    state.note_insert(kTable);
}

void update_added(ProjectFile::State& state, const model::PhysicalRelation& relation) {
    constexpr std::string_view kTable = "interpretation_added";
    state.require_change(kTable);
    state.log_inserts();
    sqlite::Statement& update = state.statements[std::string{kTable}].update;
    if (!update) update = state.database.prepare(update_sql(kTable, columns_of<model::PhysicalRelation>()));
    RowBinder binder(update, 1, state.srs_id);
    describe_columns(binder, relation);
    binder.uuid(relation.id.value);
    update.run();
}

void replace_readings(ProjectFile::State& state, const model::Interpretation& value, model::InterpretationId id) {
    try {
        std::set<Uuid> there;
        for (const auto& [row, owner] : rows_of(state, "interpretation_added", "interpretation", "uuid", id.value)) {
            const auto kept = std::any_of(value.added.begin(), value.added.end(),
                                          [&](const model::PhysicalRelation& r) { return r.id.value == row; });
            if (kept)
                there.insert(row);
            else
                remove_record(state, "interpretation_added", "added relation", row);
        }
        for (const model::PhysicalRelation& relation : value.added) {
            if (there.contains(relation.id.value))
                update_added(state, relation);
            else
                insert_added(state, relation, id.value);
        }
        replace_rows(state, "interpretation_dropped", "interpretation", "relation", id.value, value.dropped);
    } catch (const Error& e) {
        throw explain(state, e, "filling", "interpretation", value.name, {});
    }
}

/// Uuid of the pose a run gave a scan, nil when there is none yet.
Uuid pose_row(const ProjectFile::State& state, const model::ScanPose& pose) {
    sqlite::Statement row = state.database.prepare(
        "SELECT uuid FROM scan_pose WHERE scan = :scan AND coalesce(run, '') = :run AND deleted_at IS NULL");
    const std::string run = pose.run.is_nil() ? std::string{} : pose.run.to_string();
    row.bind(":scan", std::string_view{pose.scan.to_string()}).bind(":run", std::string_view{run});
    return row.step() ? Uuid::parse(row.text(0)).value_or(Uuid{}) : Uuid{};
}

} // namespace

#define PLANUM_STORE_INSERT(Type, IdType)                                                                              \
    model::IdType ProjectFile::insert(const model::Type& value) { return insert_with_id(*state_, value); }
#define PLANUM_STORE_UPDATE(Type)                                                                                      \
    void ProjectFile::update(const model::Type& value) { update_record(*state_, value, value.id.value); }
#define PLANUM_STORE_REMOVE(Type, IdType)                                                                              \
    void ProjectFile::remove(model::IdType id) {                                                                       \
        remove_record(*state_, TableOf<model::Type>::name, TableOf<model::Type>::noun, id.value);                      \
    }

PLANUM_STORE_INSERT(Area, AreaId)
PLANUM_STORE_INSERT(StratigraphicUnit, UnitId)
PLANUM_STORE_INSERT(PhysicalRelation, RelationId)
PLANUM_STORE_INSERT(RelationStatement, StatementId)
PLANUM_STORE_INSERT(Source, SourceId)
PLANUM_STORE_INSERT(ImportNote, ImportNoteId)
PLANUM_STORE_INSERT(Period, PeriodId)
PLANUM_STORE_INSERT(Phase, PhaseId)
PLANUM_STORE_INSERT(Dating, DatingId)
PLANUM_STORE_INSERT(Level, LevelId)
PLANUM_STORE_INSERT(Find, FindId)
PLANUM_STORE_INSERT(Sample, SampleId)
PLANUM_STORE_INSERT(Document, DocumentId)
PLANUM_STORE_INSERT(Surface, SurfaceId)
PLANUM_STORE_INSERT(Section, SectionId)
PLANUM_STORE_INSERT(Region, RegionId)
PLANUM_STORE_INSERT(Scan, ScanId)
PLANUM_STORE_INSERT(RegistrationRun, RegistrationRunId)
PLANUM_STORE_INSERT(Decision, DecisionId)

PLANUM_STORE_UPDATE(Area)
PLANUM_STORE_UPDATE(StratigraphicUnit)
PLANUM_STORE_UPDATE(PhysicalRelation)
PLANUM_STORE_UPDATE(Source)
PLANUM_STORE_UPDATE(Period)
PLANUM_STORE_UPDATE(Phase)
PLANUM_STORE_UPDATE(Dating)
PLANUM_STORE_UPDATE(Level)
PLANUM_STORE_UPDATE(Find)
PLANUM_STORE_UPDATE(Sample)
PLANUM_STORE_UPDATE(Document)
PLANUM_STORE_UPDATE(Surface)
PLANUM_STORE_UPDATE(Section)
PLANUM_STORE_UPDATE(Region)
PLANUM_STORE_UPDATE(Scan)
PLANUM_STORE_UPDATE(RegistrationRun)

// What belongs to a removed record is marked by the triggers of the schema.
PLANUM_STORE_REMOVE(Area, AreaId)
PLANUM_STORE_REMOVE(StratigraphicUnit, UnitId)
PLANUM_STORE_REMOVE(PhysicalRelation, RelationId)
PLANUM_STORE_REMOVE(RelationStatement, StatementId)
PLANUM_STORE_REMOVE(ImportNote, ImportNoteId)
PLANUM_STORE_REMOVE(Period, PeriodId)
PLANUM_STORE_REMOVE(Phase, PhaseId)
PLANUM_STORE_REMOVE(UnitGroup, GroupId)
PLANUM_STORE_REMOVE(Dating, DatingId)
PLANUM_STORE_REMOVE(Level, LevelId)
PLANUM_STORE_REMOVE(Find, FindId)
PLANUM_STORE_REMOVE(Sample, SampleId)
PLANUM_STORE_REMOVE(Document, DocumentId)
PLANUM_STORE_REMOVE(Surface, SurfaceId)
PLANUM_STORE_REMOVE(Section, SectionId)
PLANUM_STORE_REMOVE(Region, RegionId)
PLANUM_STORE_REMOVE(Scan, ScanId)
PLANUM_STORE_REMOVE(Decision, DecisionId)
PLANUM_STORE_REMOVE(Interpretation, InterpretationId)

#undef PLANUM_STORE_INSERT
#undef PLANUM_STORE_UPDATE
#undef PLANUM_STORE_REMOVE

model::GroupId ProjectFile::insert(const model::UnitGroup& value) {
    const model::GroupId id = insert_with_id(*state_, value);
    replace_members(*state_, value, id);
    return id;
}

void ProjectFile::update(const model::UnitGroup& value) {
    update_record(*state_, value, value.id.value);
    replace_members(*state_, value, value.id);
}

model::InterpretationId ProjectFile::insert(const model::Interpretation& value) {
    const model::InterpretationId id = insert_with_id(*state_, value);
    replace_readings(*state_, value, id);
    return id;
}

void ProjectFile::update(const model::Interpretation& value) {
    update_record(*state_, value, value.id.value);
    replace_readings(*state_, value, value.id);
}

void ProjectFile::insert(const model::ScanPose& value) {
    const Uuid there = pose_row(*state_, value);
    if (there.is_nil()) {
        insert_record(*state_, value, state_->new_uuid());
    } else {
        update_record(*state_, value, there);
    }
}

void ProjectFile::update(const model::ProjectSettings& value) {
    const std::string uuid = state_->database.text("SELECT uuid FROM project LIMIT 1");
    update_record(*state_, value, Uuid::parse(uuid).value_or(Uuid{}));
    sync_spatial_reference(*state_);
}

} // namespace planum::store
