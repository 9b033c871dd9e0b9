// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/model/record.hpp"

namespace planum::strat {

using model::UnitIndex;

/// A node of the matrix: one unit, or several merged by same_as. Nodes are numbered by their first
/// member, so node order is natural unit order.
using NodeIndex = std::uint32_t;
inline constexpr NodeIndex kNoNode = static_cast<NodeIndex>(-1);

/// Position of a relation in Record::relations.
using RelationIndex = std::uint32_t;

/// A pair in time: `later` lies later than `earlier`, with the relations that justify it.
struct Order {
    NodeIndex later = kNoNode;
    NodeIndex earlier = kNoNode;

    friend auto operator<=>(const Order&, const Order&) = default;
};

/// What `matrix --stats` says; the words are defined in docs/matrix.md.
struct MatrixStats {
    std::int64_t units = 0;
    std::int64_t orders = 0;              ///< distinct later→earlier pairs of units as stated, before merging
    std::int64_t same_as = 0;             ///< distinct unordered pairs
    std::int64_t contemporary = 0;        ///< distinct unordered pairs, bonds_with included
    std::int64_t merged = 0;              ///< units that disappear when same_as is merged
    std::int64_t self = 0;                ///< distinct units stated above themselves
    std::int64_t mutual = 0;              ///< distinct pairs of units stated both ways
    std::int64_t cycle_groups = 0;        ///< strongly connected components of two or more nodes
    std::int64_t largest_cycle_group = 0; ///< in nodes
    std::int64_t orders_in_cycles = 0;    ///< distinct node pairs inside cycle groups
    std::int64_t redundant = 0;           ///< implied by longer paths …
    std::int64_t reduced_from = 0;        ///< … of the pairs of the condensed graph
    std::int64_t depth = 0;               ///< nodes on the longest chain of the condensed graph
    std::int64_t isolated = 0;            ///< nodes in no order

    friend bool operator==(const MatrixStats&, const MatrixStats&) = default;
};

struct MatrixOptions {
    bool merge_same_as = true;
    bool use_uncertain = true; ///< relations marked uncertain count too
    /// Relations left out, by position (an interpretation's dropped ones, a what-if). Empty: none.
    std::span<const RelationIndex> without;
};

/// The Harris matrix of a record: units merged by same_as, orders, cycle groups, reduction and ranks.
///
/// Immutable once built. Cycles are no error here: the condensed graph, in which each cycle group is one
/// component, is always acyclic, and reduction and ranks are those of the condensed graph.
/// Built in O(units + relations); the reduction costs O(components · orders / 64) time and works in
/// blocks so that memory stays below a few MB.
class HarrisMatrix {
  public:
    [[nodiscard]] static HarrisMatrix build(const model::Record& record, const MatrixOptions& options = {});

    HarrisMatrix(HarrisMatrix&&) noexcept;
    HarrisMatrix& operator=(HarrisMatrix&&) noexcept;
    ~HarrisMatrix();

    [[nodiscard]] std::size_t node_count() const noexcept;
    [[nodiscard]] NodeIndex node_of(UnitIndex unit) const;
    /// Units merged into the node, in natural order; never empty.
    [[nodiscard]] std::span<const UnitIndex> members(NodeIndex node) const;

    /// Distinct pairs between different nodes, sorted; cycles included.
    [[nodiscard]] std::span<const Order> orders() const noexcept;
    /// Relations that justify orders()[order], ascending.
    [[nodiscard]] std::span<const RelationIndex> because(std::size_t order) const;
    /// Position in orders() of a pair, or npos.
    [[nodiscard]] std::size_t find_order(NodeIndex later, NodeIndex earlier) const noexcept;
    static constexpr std::size_t npos = static_cast<std::size_t>(-1);

    /// Positions in orders() that leave (are later) or enter (are earlier) the node.
    [[nodiscard]] std::span<const std::uint32_t> orders_below(NodeIndex node) const;
    [[nodiscard]] std::span<const std::uint32_t> orders_above(NodeIndex node) const;

    /// Component of a node in the condensed graph. Components are numbered in topological order, later
    /// ones first; among those free to choose, by smallest node.
    [[nodiscard]] std::uint32_t component_of(NodeIndex node) const;
    [[nodiscard]] std::size_t component_count() const noexcept;
    [[nodiscard]] std::span<const NodeIndex> component(std::uint32_t component) const;
    /// Components with two or more nodes, by smallest node.
    [[nodiscard]] std::span<const std::uint32_t> cycle_groups() const noexcept;

    /// Contemporary and bonds_with pairs between different nodes (smaller first), sorted, distinct.
    [[nodiscard]] std::span<const Order> contemporaries() const noexcept;

    /// Harris's fourth law: only the immediate orders. Positions in orders(): every order between
    /// components that no longer path implies, and every order inside a cycle group (those are shown,
    /// not reduced). Of several orders between the same two components all stay.
    [[nodiscard]] std::span<const std::uint32_t> reduced() const noexcept;

    /// Whether `later` is later than `earlier` along the orders; false for a node and itself unless they
    /// are in a cycle.
    [[nodiscard]] bool is_later(NodeIndex later, NodeIndex earlier) const;

    /// A shortest path of orders from `later` down to `earlier` (positions in orders()), empty if none.
    [[nodiscard]] std::vector<std::uint32_t> shortest_path(NodeIndex later, NodeIndex earlier) const;

    /// Longest chain of components above a component: 0 for those with nothing above.
    [[nodiscard]] std::uint32_t rank_from_top(std::uint32_t component) const;

    [[nodiscard]] const MatrixStats& stats() const noexcept;

  private:
    struct Data;
    explicit HarrisMatrix(std::unique_ptr<Data> data) noexcept;
    std::unique_ptr<Data> data_;
};

} // namespace planum::strat
