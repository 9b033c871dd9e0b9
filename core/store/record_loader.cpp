// SPDX-License-Identifier: MIT
#include "core/store/record_loader.hpp"
#include "core/model/zero_heights.hpp"

#include <algorithm>
#include <unordered_map>
#include <unordered_set>

#include <fmt/format.h>

#include "core/base/error.hpp"
#include "core/store/record_writer.hpp"

namespace planum::store {

namespace {

using Ids = std::unordered_set<Uuid>;

/// One reading transaction, so that all tables are of the same moment; none inside a change.
class ReadingScope {
  public:
    explicit ReadingScope(const sqlite::Database& database) : database_(&database), own_(!database.in_transaction()) {
        if (own_) database.execute("BEGIN");
    }

    ~ReadingScope() {
        if (!own_) return;
        try {
            database_->execute("ROLLBACK");
        } catch (const Error&) {
            // Nothing was written, so nothing is lost.
        }
    }

    ReadingScope(const ReadingScope&) = delete;
    ReadingScope& operator=(const ReadingScope&) = delete;

  private:
    const sqlite::Database* database_;
    bool own_;
};

template<class T>
std::vector<T> read_rows(const sqlite::Database& database, sqlite::Statement rows) {
    constexpr std::string_view kTable = TableOf<T>::name;
    std::vector<T> values;
    try {
        while (rows.step()) {
            T& value = values.emplace_back();
            RowReader reader(rows, 0, kTable);
            const Uuid id = reader.uuid("uuid");
            if constexpr (requires { value.id; }) value.id.value = id;
            describe_columns(reader, value);
        }
    } catch (Error& e) {
        if (!database.name().empty() && !std::string_view{e.what()}.starts_with(database.name())) {
            e.add_context(database.name());
        }
        throw;
    }
    return values;
}

template<class T>
std::vector<T> read_all(const sqlite::Database& database) {
    return read_rows<T>(database, database.prepare(fmt::format("SELECT uuid, {} FROM {} WHERE deleted_at IS NULL",
                                                               fmt::join(columns_of<T>(), ", "), TableOf<T>::name)));
}

template<class T>
std::vector<T> read_removed(const sqlite::Database& database, std::string_view since) {
    sqlite::Statement rows = database.prepare(fmt::format("SELECT uuid, {} FROM {} WHERE deleted_at >= :since",
                                                          fmt::join(columns_of<T>(), ", "), TableOf<T>::name));
    rows.bind(":since", since);
    return read_rows<T>(database, std::move(rows));
}

template<class T>
Ids ids_of(const std::vector<T>& values) {
    Ids ids;
    ids.reserve(values.size());
    for (const T& value : values) ids.insert(value.id.value);
    return ids;
}

/// Forgets a reference to a record that is not there.
template<class Tag>
void loosen(Id<Tag>& id, const Ids& living) {
    if (!id.is_nil() && !living.contains(id.value)) id = {};
}

template<class T, class Keep>
void keep_if(std::vector<T>& values, Keep keep) {
    std::erase_if(values, [&](const T& value) { return !keep(value); });
}

void read_members(const sqlite::Database& database, const Ids& units, std::vector<model::UnitGroup>& groups) {
    std::unordered_map<Uuid, std::size_t> place;
    for (std::size_t i = 0; i < groups.size(); ++i) place.emplace(groups[i].id.value, i);
    sqlite::Statement rows = database.prepare("SELECT unit_group, unit FROM group_member WHERE deleted_at IS NULL");
    while (rows.step()) {
        RowReader reader(rows, 0, "group_member");
        const Uuid group = reader.uuid("unit_group");
        const Uuid unit = reader.uuid("unit");
        const auto it = place.find(group);
        if (it != place.end() && units.contains(unit)) groups[it->second].members.push_back({unit});
    }
}

void read_readings(const sqlite::Database& database, const Ids& units, std::vector<model::Interpretation>& readings) {
    std::unordered_map<Uuid, std::size_t> place;
    for (std::size_t i = 0; i < readings.size(); ++i) place.emplace(readings[i].id.value, i);
    sqlite::Statement added = database.prepare(
        fmt::format("SELECT interpretation, uuid, {} FROM interpretation_added WHERE deleted_at IS NULL",
                    fmt::join(columns_of<model::PhysicalRelation>(), ", ")));
    while (added.step()) {
        RowReader reader(added, 0, "interpretation_added");
        const auto it = place.find(reader.uuid("interpretation"));
        model::PhysicalRelation relation;
        relation.id.value = reader.uuid("uuid");
        describe_columns(reader, relation);
        if (it == place.end() || !units.contains(relation.subject.value) || !units.contains(relation.object.value))
            continue;
        readings[it->second].added.push_back(relation);
    }
    sqlite::Statement dropped =
        database.prepare("SELECT interpretation, relation FROM interpretation_dropped WHERE deleted_at IS NULL");
    while (dropped.step()) {
        RowReader reader(dropped, 0, "interpretation_dropped");
        const auto it = place.find(reader.uuid("interpretation"));
        if (it != place.end()) readings[it->second].dropped.push_back({reader.uuid("relation")});
    }
    for (model::Interpretation& reading : readings) {
        std::sort(reading.added.begin(), reading.added.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
        std::sort(reading.dropped.begin(), reading.dropped.end());
    }
}

void read_tables(const sqlite::Database& database, model::Record& record) {
    record.settings = load_settings(database);
    record.areas = read_all<model::Area>(database);
    record.units = read_all<model::StratigraphicUnit>(database);
    record.relations = read_all<model::PhysicalRelation>(database);
    record.statements = read_all<model::RelationStatement>(database);
    record.sources = read_all<model::Source>(database);
    record.import_notes = read_all<model::ImportNote>(database);
    record.periods = read_all<model::Period>(database);
    record.phases = read_all<model::Phase>(database);
    record.groups = read_all<model::UnitGroup>(database);
    record.datings = read_all<model::Dating>(database);
    record.levels = read_all<model::Level>(database);
    record.finds = read_all<model::Find>(database);
    record.samples = read_all<model::Sample>(database);
    record.documents = read_all<model::Document>(database);
    record.surfaces = read_all<model::Surface>(database);
    record.sections = read_all<model::Section>(database);
    record.regions = read_all<model::Region>(database);
    record.scans = read_all<model::Scan>(database);
    record.poses = read_all<model::ScanPose>(database);
    record.runs = read_all<model::RegistrationRun>(database);
    record.decisions = read_all<model::Decision>(database);
    record.interpretations = read_all<model::Interpretation>(database);
}

void mend_units(model::Record& record, const Ids& units) {
    const Ids areas = ids_of(record.areas);
    const Ids periods = ids_of(record.periods);
    const Ids phases = ids_of(record.phases);
    for (model::Phase& phase : record.phases) loosen(phase.period, periods);
    for (model::StratigraphicUnit& unit : record.units) {
        loosen(unit.area, areas);
        loosen(unit.phase, phases);
        loosen(unit.period, periods);
        loosen(unit.parent, units);
    }
    for (model::Surface& surface : record.surfaces) loosen(surface.area, areas);
    for (model::Section& section : record.sections) loosen(section.area, areas);
}

void mend_relations(model::Record& record, const Ids& units) {
    const Ids sources = ids_of(record.sources);
    keep_if(record.relations, [&](const model::PhysicalRelation& r) {
        return units.contains(r.subject.value) && units.contains(r.object.value);
    });
    const Ids relations = ids_of(record.relations);
    keep_if(record.statements, [&](const model::RelationStatement& s) { return relations.contains(s.relation.value); });
    for (model::RelationStatement& statement : record.statements) loosen(statement.source, sources);
    for (model::ImportNote& note : record.import_notes) loosen(note.source, sources);
}

void mend_measured(model::Record& record, const Ids& units) {
    const Ids finds = ids_of(record.finds);
    keep_if(record.levels, [&](const model::Level& level) { return units.contains(level.unit.value); });
    for (model::Find& find : record.finds) loosen(find.unit, units);
    for (model::Dating& dating : record.datings) {
        loosen(dating.unit, units);
        loosen(dating.find, finds);
    }
    keep_if(record.datings, [](const model::Dating& d) { return !d.unit.is_nil() || !d.find.is_nil(); });
    for (model::Sample& sample : record.samples) loosen(sample.unit, units);
    for (model::Document& document : record.documents) loosen(document.unit, units);
}

void mend_places(model::Record& record, const Ids& units) {
    const Ids surfaces = ids_of(record.surfaces);
    const Ids sections = ids_of(record.sections);
    const Ids scans = ids_of(record.scans);
    const Ids runs = ids_of(record.runs);
    for (model::Region& region : record.regions) {
        loosen(region.surface, surfaces);
        loosen(region.section, sections);
        loosen(region.unit, units);
        loosen(region.seen_in, units);
    }
    for (model::Scan& scan : record.scans) loosen(scan.surface, surfaces);
    keep_if(record.poses, [&](const model::ScanPose& pose) { return scans.contains(pose.scan.value); });
    for (model::ScanPose& pose : record.poses) loosen(pose.run, runs);
}

} // namespace

model::ProjectSettings load_settings(const sqlite::Database& database) {
    const std::vector<model::ProjectSettings> all = read_all<model::ProjectSettings>(database);
    if (all.empty())
        throw Error(ErrorCode::BadInput, database.name() + ": the project has no settings: restore a backup");
    return all.front();
}

RemovedRecords load_removed(const sqlite::Database& database, std::string_view since) {
    const ReadingScope one_moment(database);
    return {read_removed<model::StratigraphicUnit>(database, since),
            read_removed<model::PhysicalRelation>(database, since)};
}

model::Record load_record(const sqlite::Database& database) {
    model::Record record;
    {
        const ReadingScope one_moment(database);
        read_tables(database, record);
        const Ids units = ids_of(record.units);
        mend_units(record, units);
        mend_relations(record, units);
        mend_measured(record, units);
        mend_places(record, units);
        const Ids groups = ids_of(record.groups);
        for (model::UnitGroup& group : record.groups) loosen(group.parent, groups);
        read_members(database, units, record.groups);
        const Ids readings = ids_of(record.interpretations);
        for (model::Interpretation& reading : record.interpretations) loosen(reading.parent, readings);
        read_readings(database, units, record.interpretations);
    }
    model::forget_zero_heights(record);
    model::sort_record(record);
    return record;
}

} // namespace planum::store
