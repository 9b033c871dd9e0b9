// SPDX-License-Identifier: MIT
#include "tests/unit/core_store/filled_project.hpp"

#include <algorithm>
#include <vector>

#include "core/sqlite/database.hpp"

namespace planum::test {

using namespace planum::model;
using store::ProjectFile;

namespace {

PhysicalRelation relation(UnitId subject, RelationKind kind, UnitId object) {
    PhysicalRelation r;
    r.subject = subject;
    r.kind = kind;
    r.object = object;
    return r;
}

struct Made {
    AreaId area;
    std::vector<UnitId> units;
    std::vector<RelationId> relations;
    SourceId source;
};

Made fill_units(ProjectFile& project) {
    Made made;
    made.area = project.insert(Area{{}, "A", "Trench A", DigMethod::Mixed, "1", "999"});
    const PeriodId period = project.insert(Period{{}, "II", "Bronze Age", "", -2200, -800, 2});
    const PhaseId phase = project.insert(Phase{{}, "IIa", "Early", "first houses", period, -2200, std::nullopt, 1});
    for (const char* number : {"1", "2", "3", "10", "B. 36"}) {
        StratigraphicUnit unit = a_unit(number, made.area);
        unit.phase = phase;
        unit.period = period;
        made.units.push_back(project.insert(unit));
    }
    StratigraphicUnit part = a_unit("3a", made.area);
    part.parent = made.units[2];
    part.kind = UnitKind::Deposit;
    part.form = UnitForm::Fill;
    part.details = {{"colour", "grey"}, {"munsell", "10YR 5/2"}, {"custom", "a=1\nb=2"}};
    part.description = "line one\nline two, ümlaut";
    made.units.push_back(project.insert(part));
    return made;
}

void fill_relations(ProjectFile& project, Made& made) {
    Source source{{}, "sheets.csv", "csv", std::string(64, 'a'), "2025-05-31T10:00:00.000Z", true};
    made.source = project.insert(source);
    made.relations.push_back(project.insert(relation(made.units[0], RelationKind::Covers, made.units[1])));
    made.relations.push_back(project.insert(relation(made.units[1], RelationKind::Cuts, made.units[2])));
    PhysicalRelation same = relation(made.units[3], RelationKind::SameAs, made.units[4]);
    same.certainty = Certainty::Uncertain;
    same.correlation = true;
    made.relations.push_back(project.insert(same));
    for (const RelationId id : made.relations) {
        project.insert(RelationStatement{{}, id, StatementSide::Subject, made.source, 12, "", "1 above 2", ""});
    }
    project.insert(RelationStatement{{}, made.relations[0], StatementSide::Object, {}, 0, "Bea", "", "2025-06-01"});
    project.insert(ImportNote{{}, made.source, 40, "unparsed", "???", "not understood"});
}

void fill_measured(ProjectFile& project, const Made& made) {
    project.insert(Level{{}, made.units[0], 10.5, 20.25, 103.75, LevelRole::Top, "L1"});
    project.insert(Level{{}, made.units[1], std::nullopt, std::nullopt, 103.5, LevelRole::Base, ""});
    project.insert(Level{{}, made.units[1], 11.0, std::nullopt, 103.25, LevelRole::Other, "half a place"});
    const FindId find = project.insert(Find{
        {}, "F1", made.units[0], 10.0, 20.0, 103.6, "coin", "bronze", 1, 3.25, "worn", "box 4", "2025-06-01", "as"});
    project.insert(Find{{}, "F2", {}, {}, {}, {}, "sherds", "", 12, {}, "", "", "", ""});
    project.insert(
        Dating{{}, "coin F1", made.units[0], find, DatingKind::Coin, -50, std::nullopt, {}, {}, "direct", ""});
    project.insert(Dating{{}, "Lab-1", made.units[1], {}, DatingKind::Radiocarbon, {}, {}, 3200.0, 30.0, "", "n"});
    project.insert(Sample{{}, "S1", made.units[1], "C14", 0.5, 12.0, "Lab-1", "submitted", "charcoal"});
    project.insert(Document{{}, "P1", "photo", "from the north", made.units[0], "photos/p1.jpg", "2025-06-01", "Ada"});
    project.insert(UnitGroup{{}, "G1", "house", "House 1", "", {}, {made.units[0], made.units[3]}});
}

void fill_places(ProjectFile& project, const Made& made) {
    const SurfaceId surface =
        project.insert(Surface{{}, made.area, "Planum 1", DigMethod::Planum, "2025-06-01", "2025-06-02", 1});
    const SectionId section = project.insert(Section{{}, made.area, "S 1", {0, 0}, {5.5, 1.25}, "2025-06-02"});
    Region region;
    region.surface = surface;
    region.unit = made.units[0];
    region.shows = RegionShows::Level;
    region.outline = {
        Polygon{{{0, 0, 103}, {4, 0, 103}, {4, 4, 103.5}, {0, 4, 103}}, {{{1, 1, 103}, {1, 2, 103}, {2, 2, 103}}}}};
    project.insert(region);
    Region unnamed;
    unnamed.section = section;
    unnamed.unit_as_drawn = "99?";
    unnamed.category = RegionCategory::Spoil;
    unnamed.seen_in = made.units[1];
    unnamed.outline = {Polygon{{{0, 0, 103}, {0, 0, 104}, {1, 0, 104}}, {}}};
    project.insert(unnamed);
    Scan scan{{},
              "2025-06-01/station1",
              "2025-06-01",
              surface,
              "scans/station1.ptx",
              std::string(64, 'b'),
              "ptx",
              0,
              1000,
              10,
              100,
              "scanner",
              "2025-06-01T08:00:00Z",
              std::nullopt};
    scan.header_pose = std::array<double, 16>{1, 0, 0, 0.1, 0, 1, 0, 0.2, 0, 0, 1, 1.0 / 3.0, 0, 0, 0, 1};
    const ScanId scan_id = project.insert(scan);
    const RegistrationRunId run =
        project.insert(RegistrationRun{{}, "first", "2025-06-01T12:00:00.000Z", "auto", "accepted", "{}"});
    ScanPose pose;
    pose.scan = scan_id;
    pose.run = run;
    pose.site_from_scan = *scan.header_pose;
    pose.covariance[0] = 1e-6;
    pose.rms = 0.004;
    pose.overlap = 0.6;
    pose.verdict = "good";
    project.insert(pose);
}

} // namespace

ProjectSettings some_settings() {
    ProjectSettings settings;
    settings.name = "Test dig";
    settings.numbers = NumberScope::Area;
    return settings;
}

StratigraphicUnit a_unit(std::string number, AreaId area) {
    StratigraphicUnit unit;
    unit.number = std::move(number);
    unit.area = area;
    unit.kind = UnitKind::Deposit;
    unit.form = UnitForm::Layer;
    unit.title = "a layer";
    return unit;
}

ProjectFile fill_project(const std::filesystem::path& file, TestEnvironment& environment) {
    ProjectFile project = ProjectFile::create(file, some_settings(), environment.get());
    Made made;
    project.change("Import sheets.csv", [&] {
        made = fill_units(project);
        fill_relations(project, made);
    });
    project.change("A day's work", [&] {
        fill_measured(project, made);
        fill_places(project, made);
        project.insert(
            Decision{{}, "abcdef123456", "diagnostic", "accepted", "seen in section", "99", 0.5, "Ada", "t"});
        Interpretation reading;
        reading.name = "Second reading";
        reading.author = "Bea";
        reading.added = {relation(made.units[0], RelationKind::Later, made.units[3])};
        reading.dropped = {made.relations[1]};
        project.insert(reading);
    });
    return project;
}

std::string raw_rows(const std::filesystem::path& file) {
    const sqlite::Database database = sqlite::Database::open(file, sqlite::Access::ReadOnly);
    std::vector<std::string> tables;
    sqlite::Statement names = database.prepare("SELECT name FROM sqlite_schema WHERE type = 'table' ORDER BY name");
    while (names.step()) tables.emplace_back(names.text(0));
    std::string all;
    for (const std::string& table : tables) {
        const std::vector<std::string> columns = database.columns(table);
        if (std::find(columns.begin(), columns.end(), "uuid") == columns.end()) continue;
        sqlite::Statement rows = database.prepare("SELECT * FROM " + table + " ORDER BY fid");
        while (rows.step()) {
            all += table;
            for (int i = 0; i < rows.column_count(); ++i) {
                all += rows.is_null(i) ? "|-" : "|" + std::string{rows.text(i)};
            }
            all += '\n';
        }
    }
    return all;
}

} // namespace planum::test
