// SPDX-License-Identifier: MIT
#include "app/project/snapshot.hpp"

#include <utility>

#include "app/project/project.hpp"

namespace planum::app {

Snapshot::Snapshot(model::Record record)
    : record_(std::move(record)), index_(record_), matrix_(strat::HarrisMatrix::build(record_)) {
    relations_of_.resize(record_.units.size());
    for (std::uint32_t r = 0; r < record_.relations.size(); ++r) {
        const model::UnitIndex subject = index_.find(record_.relations[r].subject);
        const model::UnitIndex object = index_.find(record_.relations[r].object);
        if (subject != model::kNoUnit) relations_of_[subject].push_back(r);
        if (object != model::kNoUnit && object != subject) relations_of_[object].push_back(r);
    }
    // Statements stand in the order of the relations.
    statements_begin_.reserve(record_.relations.size() + 1);
    std::uint32_t at = 0;
    for (const model::PhysicalRelation& relation : record_.relations) {
        statements_begin_.push_back(at);
        while (at < record_.statements.size() && record_.statements[at].relation == relation.id) ++at;
    }
    statements_begin_.push_back(at);
}

std::shared_ptr<const Snapshot> take_snapshot(Project& project) {
    constexpr std::size_t kMost = 500;
    auto snapshot = std::make_shared<Snapshot>(project.record());
    snapshot->changes = project.file().history(kMost);
    return snapshot;
}

} // namespace planum::app
