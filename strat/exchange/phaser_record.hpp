// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "strat/exchange/record_builder.hpp"

namespace planum::strat {

enum class PhaserClass { Period, Phase, Group, Subgroup, Context, Dating };

/// What PHASER calls something: its class and its id, which is unique within the class.
using PhaserKey = std::pair<PhaserClass, std::string>;

/// One row of a PHASER table or one node of its graph.
struct PhaserNode {
    PhaserClass kind = PhaserClass::Context;
    std::string id;
    std::string label; ///< shown name; empty: the id
    std::string site;
    std::string type;
    std::string cud;
    std::string description;
    std::string uri;
    std::string association;
    std::string from; ///< minYear as written
    std::string to;
    std::string tolerance;         ///< "±20 years", or empty
    std::vector<PhaserKey> within; ///< nearest first
    std::string file;
    std::int64_t line = 0;
};

struct PhaserEdge {
    std::string source; ///< ids of contexts
    std::string target;
    std::string relation;
    std::string file;
    std::int64_t line = 0;
};

/// Gathers nodes and edges in any order; makes one record of them in the end.
class PhaserRecord {
  public:
    explicit PhaserRecord(const ReadOptions& options) : builder_(options) {}

    [[nodiscard]] RecordBuilder& builder() noexcept { return builder_; }

    void add(PhaserNode node);

    void add(PhaserEdge edge) { edges_.push_back(std::move(edge)); }

    [[nodiscard]] const PhaserNode* find(const PhaserKey& key) const;
    [[nodiscard]] Imported<ImportedRecord> finish();

  private:
    struct Years {
        std::optional<model::Year> from;
        std::optional<model::Year> to;
    };

    [[nodiscard]] Years years_of(const PhaserNode& node);
    [[nodiscard]] const PhaserNode* container(const PhaserNode& node, PhaserClass kind) const;
    [[nodiscard]] std::string name_of(const PhaserNode& node);
    [[nodiscard]] UnitName unit_name(const std::string& context);
    void read(const PhaserNode& node);
    void read_context(const PhaserNode& node);
    void read_dating(const PhaserNode& node);
    void read(const PhaserEdge& edge);
    void note_sites();

    RecordBuilder builder_;
    std::vector<PhaserNode> nodes_;
    std::vector<PhaserEdge> edges_;
    std::map<PhaserKey, std::size_t> at_;
    std::map<PhaserKey, std::string> names_;
    std::set<std::pair<int, std::string>> used_names_; ///< by namespace: units, groups, phases, periods
};

} // namespace planum::strat
