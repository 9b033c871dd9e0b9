// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <filesystem>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "core/model/record.hpp"
#include "strat/exchange/reader.hpp"

namespace planum::test {

/// A record of the units, phases and relations that files state, as the project's import would merge them,
/// for tests that need no project.
inline model::Record record_of(const strat::ImportedRecord& imported) {
    SeededUuids ids(7);
    model::Record record;
    record.settings.name = imported.project_name;
    std::map<strat::UnitName, model::UnitId> units;
    std::map<std::string, model::PhaseId> phases;
    for (const strat::ImportedPhase& p : imported.phases) {
        model::Phase phase = p.values;
        phase.id = {ids.next()};
        if (phases.emplace(phase.number, phase.id).second) record.phases.push_back(phase);
    }
    const auto unit_of = [&](const strat::UnitName& name) {
        const auto [at, fresh] = units.emplace(name, model::UnitId{});
        if (fresh) {
            at->second = {ids.next()};
            model::StratigraphicUnit unit;
            unit.id = at->second;
            unit.number = name.number;
            unit.origin = model::UnitOrigin::Mentioned;
            record.units.push_back(unit);
        }
        return at->second;
    };
    for (const strat::ImportedUnit& u : imported.units) {
        const model::UnitId id = unit_of(u.name);
        for (model::StratigraphicUnit& unit : record.units) {
            if (unit.id != id) continue;
            unit.kind = u.values.kind;
            unit.form = u.values.form;
            unit.title = u.values.title;
            unit.origin = model::UnitOrigin::Recorded;
            const auto phase = phases.find(u.phase);
            if (phase != phases.end()) unit.phase = phase->second;
        }
    }
    std::map<std::tuple<model::UnitId, model::RelationKind, model::UnitId>, bool> stated;
    for (const strat::StatedRelation& r : imported.relations) {
        model::PhysicalRelation relation;
        relation.id = {ids.next()};
        relation.subject = unit_of(r.subject);
        relation.object = unit_of(r.object);
        relation.kind = r.kind;
        relation.certainty = r.certainty;
        if (stated.emplace(std::tuple{relation.subject, relation.kind, relation.object}, true).second) {
            record.relations.push_back(relation);
        }
    }
    model::sort_record(record);
    return record;
}

/// All files of a folder, or one file, through the reader that knows them.
inline model::Record read_record(const std::filesystem::path& path) {
    std::vector<std::filesystem::path> paths;
    if (std::filesystem::is_directory(path)) {
        for (const auto& entry : std::filesystem::directory_iterator(path)) {
            if (entry.is_regular_file()) paths.push_back(entry.path());
        }
        std::sort(paths.begin(), paths.end());
    } else {
        paths.push_back(path);
    }
    std::vector<strat::InputFile> files;
    for (const auto& p : paths) files.push_back(strat::load_input_file(p));
    strat::ImportedRecord all;
    for (const strat::Reading& reading : strat::plan_reading(files, "")) {
        std::vector<const strat::InputFile*> chosen;
        for (const std::size_t f : reading.files) chosen.push_back(&files[f]);
        const auto part = reading.reader->read(chosen, {}, Progress::none());
        all.units.insert(all.units.end(), part.values.units.begin(), part.values.units.end());
        all.relations.insert(all.relations.end(), part.values.relations.begin(), part.values.relations.end());
        all.phases.insert(all.phases.end(), part.values.phases.begin(), part.values.phases.end());
    }
    return record_of(all);
}

} // namespace planum::test
