// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "app/import/field_merge.hpp"
#include "app/import/merge.hpp"
#include "app/import/unit_table.hpp"

namespace planum::app {

/// A relation as a set sees it: two units and a kind.
using RelationTriple = std::tuple<model::UnitId, model::RelationKind, model::UnitId>;

/// What makes two statements the same one, so that they are counted and not repeated.
using StatementKey = std::tuple<model::RelationId, model::StatementSide, model::SourceId, std::string>;

/// Phases by period and number: phase numbers restart in each period.
[[nodiscard]] std::string phase_key(const std::string& period, const std::string& number);

/// One run of plan_merge(): merge.cpp holds units, their sheets and relations, merge_others.cpp all that belongs to
/// them.
class Merge {
  public:
    Merge(const model::Record& current, const MergeOptions& options, UuidSource& ids, const Clock& clock)
        : current_(current), options_(options), ids_(ids), clock_(clock), units_(current, options.numbers, ids) {}

    MergePlan run(const std::vector<ImportSet>& sets) {
        index_existing();
        for (const ImportSet& set : sets) merge_sources(set);
        for (const ImportSet& set : sets) merge_chronology(set);
        for (const ImportSet& set : sets) merge_sheets(set);
        for (const ImportSet& set : sets) merge_parents(set);
        for (const ImportSet& set : sets) merge_relations(set);
        for (const ImportSet& set : sets) merge_groups(set);
        for (const ImportSet& set : sets) merge_measured(set);
        for (const ImportSet& set : sets) merge_notes(set);
        judge_sides();
        collect();
        return std::move(plan_);
    }

  private:
    void index_existing();
    void merge_sources(const ImportSet& set);
    void merge_chronology(const ImportSet& set);
    void merge_sheets(const ImportSet& set);
    void merge_sheet(const strat::ImportedUnit& sheet);
    void merge_parents(const ImportSet& set);
    void merge_relations(const ImportSet& set);
    void merge_groups(const ImportSet& set);
    void merge_measured(const ImportSet& set);
    void merge_finds(const ImportSet& set);
    void merge_notes(const ImportSet& set);
    void judge_sides();
    void collect();

    model::SourceId source_id(const std::string& name) const;
    [[nodiscard]] std::string key_of(const strat::ImportedPhase& offered) const;
    [[nodiscard]] std::string number_of(model::PeriodId period) const;
    [[nodiscard]] model::PhaseId phase_of(const strat::ImportedUnit& sheet) const;
    model::PhysicalRelation& relation(const strat::StatedRelation& stated, std::size_t subject, std::size_t object);
    [[nodiscard]] model::UnitId unit_of(const strat::UnitName& name);

    // A value kept by natural key, remembering what happened to it.
    template<class T>
    struct Kept {
        T value;
        bool is_new = false;
        bool is_changed = false;
    };

    template<class T>
    using KeptByNumber = std::map<std::string, Kept<T>>;

    FieldMerge fields(const std::string& what, bool& changed) {
        return {what, options_.update, changed, plan_.conflicts};
    }

    // The number by which people know something, found by its id.
    template<class T>
    static auto name_in(const KeptByNumber<T>& things) {
        return [&things](decltype(T::id) id) {
            for (const auto& [key, kept] : things) {
                if (kept.value.id == id) return kept.value.number;
            }
            return std::string{};
        };
    }

    auto unit_name() {
        return [this](model::UnitId id) { return units_.display_of(id); };
    }

    template<class T>
    static void give(KeptByNumber<T>& from, std::vector<T>& fresh, std::vector<T>* changed) {
        for (auto& [number, kept] : from) {
            if (kept.is_new) {
                fresh.push_back(std::move(kept.value));
            } else if (kept.is_changed && changed != nullptr) {
                changed->push_back(std::move(kept.value));
            }
        }
    }

    const model::Record& current_;
    const MergeOptions& options_;
    UuidSource& ids_;
    const Clock& clock_;
    UnitTable units_;
    MergePlan plan_;

    KeptByNumber<model::Source> sources_;
    KeptByNumber<model::Period> periods_;
    KeptByNumber<model::Phase> phases_;
    KeptByNumber<model::UnitGroup> groups_;
    KeptByNumber<model::Find> finds_;
    std::map<RelationTriple, std::size_t> relation_at_;
    std::vector<Kept<model::PhysicalRelation>> relations_;
    std::map<StatementKey, std::int64_t> stated_before_;
    std::map<StatementKey, std::int64_t> stated_now_;
    // Sources on which a relation is stated from the subject's and the object's side.
    std::map<std::pair<model::SourceId, model::RelationId>, std::pair<bool, bool>> sides_;
};

} // namespace planum::app
