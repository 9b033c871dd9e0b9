// SPDX-License-Identifier: MIT
#pragma once

#include "app/import/merge.hpp"

namespace planum::test {

/// The record after a merge plan, without a project file.
[[nodiscard]] inline model::Record applied(model::Record record, const app::MergePlan& plan) {
    const auto add = [](auto& all, const auto& fresh) { all.insert(all.end(), fresh.begin(), fresh.end()); };
    const auto replace = [](auto& all, const auto& changed) {
        for (const auto& value : changed) {
            for (auto& old : all) {
                if (old.id == value.id) old = value;
            }
        }
    };
    add(record.areas, plan.new_areas);
    add(record.sources, plan.new_sources);
    replace(record.sources, plan.changed_sources);
    add(record.periods, plan.new_periods);
    replace(record.periods, plan.changed_periods);
    add(record.phases, plan.new_phases);
    replace(record.phases, plan.changed_phases);
    add(record.units, plan.new_units);
    replace(record.units, plan.changed_units);
    add(record.groups, plan.new_groups);
    replace(record.groups, plan.changed_groups);
    add(record.relations, plan.new_relations);
    add(record.statements, plan.new_statements);
    add(record.datings, plan.new_datings);
    add(record.levels, plan.new_levels);
    add(record.finds, plan.new_finds);
    replace(record.finds, plan.changed_finds);
    add(record.samples, plan.new_samples);
    add(record.documents, plan.new_documents);
    for (const auto gone : plan.gone_notes) {
        std::erase_if(record.import_notes, [&](const auto& note) { return note.id == gone; });
    }
    add(record.import_notes, plan.new_notes);
    model::sort_record(record);
    return record;
}

} // namespace planum::test
