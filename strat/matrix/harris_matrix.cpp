// SPDX-License-Identifier: MIT
#include "strat/matrix/harris_matrix.hpp"

#include <algorithm>
#include <unordered_map>
#include <utility>

#include "core/base/error.hpp"
#include "strat/matrix/adjacency.hpp"
#include "strat/matrix/condensation.hpp"

namespace planum::strat {

using model::RelationKind;
using model::TimeMeaning;

namespace {

// A relation between two units of the record, by their positions.
struct Link {
    std::uint32_t later = 0;
    std::uint32_t earlier = 0;
    RelationIndex relation = 0;

    friend auto operator<=>(const Link&, const Link&) = default;
};

struct Links {
    std::vector<Link> orders;
    std::vector<Link> same_as;
    std::vector<Link> contemporary;
};

Link smaller_first(Link link) {
    if (link.later > link.earlier) std::swap(link.later, link.earlier);
    return link;
}

Links collect_links(const model::Record& record, const MatrixOptions& options) {
    std::unordered_map<model::UnitId, std::uint32_t> place;
    place.reserve(record.units.size());
    for (std::size_t i = 0; i < record.units.size(); ++i) {
        place.emplace(record.units[i].id, static_cast<std::uint32_t>(i));
    }
    std::vector<bool> left_out(record.relations.size(), false);
    for (const RelationIndex relation : options.without) left_out.at(relation) = true;

    Links links;
    links.orders.reserve(record.relations.size());
    for (std::size_t i = 0; i < record.relations.size(); ++i) {
        const model::PhysicalRelation& relation = record.relations[i];
        const auto subject = place.find(relation.subject);
        const auto object = place.find(relation.object);
        const bool counts = options.use_uncertain || relation.certainty == model::Certainty::Certain;
        if (left_out[i] || !counts || subject == place.end() || object == place.end()) continue;
        const Link link{subject->second, object->second, static_cast<RelationIndex>(i)};
        switch (model::time_meaning(relation.kind)) {
        case TimeMeaning::SubjectLater: links.orders.push_back(link); break;
        case TimeMeaning::SameUnit: links.same_as.push_back(smaller_first(link)); break;
        case TimeMeaning::SameTime: links.contemporary.push_back(smaller_first(link)); break;
        case TimeMeaning::None: break;
        }
    }
    return links;
}

// Distinct pairs of different units.
std::vector<Order> distinct_pairs(const std::vector<Link>& links) {
    std::vector<Order> pairs;
    pairs.reserve(links.size());
    for (const Link& link : links) {
        if (link.later != link.earlier) pairs.push_back({link.later, link.earlier});
    }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return pairs;
}

// Union-find with path halving; the smallest unit leads, so that node order is unit order.
class Merger {
  public:
    explicit Merger(std::size_t count) : leader_(count) {
        for (std::size_t i = 0; i < count; ++i) leader_[i] = static_cast<std::uint32_t>(i);
    }

    std::uint32_t leader(std::uint32_t unit) {
        while (leader_[unit] != unit) {
            leader_[unit] = leader_[leader_[unit]];
            unit = leader_[unit];
        }
        return unit;
    }

    void merge(std::uint32_t a, std::uint32_t b) {
        a = leader(a);
        b = leader(b);
        leader_[std::max(a, b)] = std::min(a, b);
    }

  private:
    std::vector<std::uint32_t> leader_;
};

struct Nodes {
    std::vector<NodeIndex> of_unit;
    Adjacency members;
};

Nodes make_nodes(std::size_t unit_count, const std::vector<Link>& same_as) {
    Merger merger(unit_count);
    for (const Link& link : same_as) merger.merge(link.later, link.earlier);
    Nodes nodes;
    nodes.of_unit.resize(unit_count);
    NodeIndex next = 0;
    for (std::uint32_t unit = 0; unit < unit_count; ++unit) {
        const std::uint32_t leader = merger.leader(unit);
        nodes.of_unit[unit] = leader == unit ? next++ : nodes.of_unit[leader];
    }
    nodes.members = Adjacency::make(
        next, unit_count, [&](std::size_t unit) { return nodes.of_unit[unit]; }, [](std::size_t unit) { return unit; });
    return nodes;
}

std::int64_t count_mutual(const std::vector<Order>& sorted_pairs) {
    return std::count_if(sorted_pairs.begin(), sorted_pairs.end(), [&](const Order& pair) {
        return pair.later < pair.earlier &&
               std::binary_search(sorted_pairs.begin(), sorted_pairs.end(), Order{pair.earlier, pair.later});
    });
}

// The counts that are about units as stated, before anything is merged.
void count_stated(MatrixStats& stats, std::size_t unit_count, const Links& links) {
    const std::vector<Order> pairs = distinct_pairs(links.orders);
    stats.units = static_cast<std::int64_t>(unit_count);
    stats.orders = static_cast<std::int64_t>(pairs.size());
    stats.same_as = static_cast<std::int64_t>(distinct_pairs(links.same_as).size());
    stats.contemporary = static_cast<std::int64_t>(distinct_pairs(links.contemporary).size());
    stats.mutual = count_mutual(pairs);
    std::vector<bool> above_itself(unit_count, false);
    for (const Link& link : links.orders) {
        if (link.later == link.earlier) above_itself[link.later] = true;
    }
    stats.self = std::count(above_itself.begin(), above_itself.end(), true);
}

// Merged units in no order; a unit above itself is in none.
std::int64_t count_isolated(const Nodes& nodes, const Links& links) {
    std::vector<bool> ordered(nodes.members.rows(), false);
    for (const Link& link : links.orders) {
        if (link.later == link.earlier) continue;
        ordered[nodes.of_unit[link.later]] = true;
        ordered[nodes.of_unit[link.earlier]] = true;
    }
    return std::count(ordered.begin(), ordered.end(), false);
}

} // namespace

struct HarrisMatrix::Data {
    Nodes nodes;
    std::vector<Order> orders;
    Adjacency because;
    Adjacency below; ///< order positions by later node
    Adjacency above; ///< order positions by earlier node
    Condensation condensation;
    std::vector<std::uint32_t> cycle_groups;
    std::vector<Order> contemporaries;
    std::vector<std::uint32_t> reduced;
    MatrixStats stats;

    void make_orders(const Links& links);
    void make_contemporaries(const Links& links);
    void reduce();
};

void HarrisMatrix::Data::make_orders(const Links& links) {
    std::vector<Link> merged;
    merged.reserve(links.orders.size());
    for (const Link& link : links.orders) {
        const Link m{nodes.of_unit[link.later], nodes.of_unit[link.earlier], link.relation};
        if (m.later != m.earlier) merged.push_back(m);
    }
    std::sort(merged.begin(), merged.end());
    std::vector<std::uint32_t> order_of(merged.size());
    for (std::size_t i = 0; i < merged.size(); ++i) {
        const Order order{merged[i].later, merged[i].earlier};
        if (orders.empty() || orders.back() != order) orders.push_back(order);
        order_of[i] = static_cast<std::uint32_t>(orders.size() - 1);
    }
    because = Adjacency::make(
        orders.size(), merged.size(), [&](std::size_t i) { return order_of[i]; },
        [&](std::size_t i) { return merged[i].relation; });
    const auto position = [](std::size_t i) { return i; };
    const std::size_t node_count = nodes.members.rows();
    below = Adjacency::make(
        node_count, orders.size(), [&](std::size_t i) { return orders[i].later; }, position);
    above = Adjacency::make(
        node_count, orders.size(), [&](std::size_t i) { return orders[i].earlier; }, position);
}

void HarrisMatrix::Data::make_contemporaries(const Links& links) {
    std::vector<Link> merged;
    for (const Link& link : links.contemporary) {
        merged.push_back(smaller_first({nodes.of_unit[link.later], nodes.of_unit[link.earlier], link.relation}));
    }
    contemporaries = distinct_pairs(merged);
}

void HarrisMatrix::Data::reduce() {
    const Adjacency& pairs = condensation.below;
    const std::vector<bool> redundant = redundant_pairs(pairs);
    stats.reduced_from = static_cast<std::int64_t>(pairs.values.size());
    stats.redundant = std::count(redundant.begin(), redundant.end(), true);
    for (std::uint32_t i = 0; i < orders.size(); ++i) {
        const std::uint32_t from = condensation.component_of[orders[i].later];
        const std::uint32_t to = condensation.component_of[orders[i].earlier];
        if (from == to) {
            ++stats.orders_in_cycles;
            reduced.push_back(i);
            continue;
        }
        const auto row = pairs.row(from);
        const auto at = std::lower_bound(row.begin(), row.end(), to) - row.begin();
        if (!redundant[pairs.begin[from] + static_cast<std::uint32_t>(at)]) reduced.push_back(i);
    }
}

HarrisMatrix HarrisMatrix::build(const model::Record& record, const MatrixOptions& options) {
    auto data = std::make_unique<Data>();
    const Links links = collect_links(record, options);
    MatrixStats& stats = data->stats;
    count_stated(stats, record.units.size(), links);

    data->nodes = make_nodes(record.units.size(), options.merge_same_as ? links.same_as : std::vector<Link>{});
    const std::size_t node_count = data->nodes.members.rows();
    stats.merged = static_cast<std::int64_t>(record.units.size() - node_count);
    stats.isolated = count_isolated(data->nodes, links);
    data->make_orders(links);
    data->make_contemporaries(links);

    data->condensation = condense(node_count, data->orders);
    stats.depth = data->condensation.depth;
    for (std::uint32_t c = 0; c < data->condensation.members.rows(); ++c) {
        const std::size_t size = data->condensation.members.row(c).size();
        if (size < 2) continue;
        data->cycle_groups.push_back(c);
        stats.largest_cycle_group = std::max(stats.largest_cycle_group, static_cast<std::int64_t>(size));
    }
    const Adjacency& members = data->condensation.members;
    std::sort(data->cycle_groups.begin(), data->cycle_groups.end(),
              [&](std::uint32_t a, std::uint32_t b) { return members.row(a).front() < members.row(b).front(); });
    stats.cycle_groups = static_cast<std::int64_t>(data->cycle_groups.size());
    data->reduce();
    return HarrisMatrix(std::move(data));
}

HarrisMatrix::HarrisMatrix(std::unique_ptr<Data> data) noexcept : data_(std::move(data)) {}

HarrisMatrix::HarrisMatrix(HarrisMatrix&&) noexcept = default;
HarrisMatrix& HarrisMatrix::operator=(HarrisMatrix&&) noexcept = default;
HarrisMatrix::~HarrisMatrix() = default;

std::size_t HarrisMatrix::node_count() const noexcept { return data_->nodes.members.rows(); }

NodeIndex HarrisMatrix::node_of(UnitIndex unit) const { return data_->nodes.of_unit.at(unit); }

std::span<const UnitIndex> HarrisMatrix::members(NodeIndex node) const { return data_->nodes.members.row(node); }

std::span<const Order> HarrisMatrix::orders() const noexcept { return data_->orders; }

std::span<const RelationIndex> HarrisMatrix::because(std::size_t order) const { return data_->because.row(order); }

std::size_t HarrisMatrix::find_order(NodeIndex later, NodeIndex earlier) const noexcept {
    const Order wanted{later, earlier};
    const auto at = std::lower_bound(data_->orders.begin(), data_->orders.end(), wanted);
    if (at == data_->orders.end() || *at != wanted) return npos;
    return static_cast<std::size_t>(at - data_->orders.begin());
}

std::span<const std::uint32_t> HarrisMatrix::orders_below(NodeIndex node) const { return data_->below.row(node); }

std::span<const std::uint32_t> HarrisMatrix::orders_above(NodeIndex node) const { return data_->above.row(node); }

std::uint32_t HarrisMatrix::component_of(NodeIndex node) const { return data_->condensation.component_of.at(node); }

std::size_t HarrisMatrix::component_count() const noexcept { return data_->condensation.members.rows(); }

std::span<const NodeIndex> HarrisMatrix::component(std::uint32_t component) const {
    return data_->condensation.members.row(component);
}

std::span<const std::uint32_t> HarrisMatrix::cycle_groups() const noexcept { return data_->cycle_groups; }

std::span<const Order> HarrisMatrix::contemporaries() const noexcept { return data_->contemporaries; }

std::span<const std::uint32_t> HarrisMatrix::reduced() const noexcept { return data_->reduced; }

std::uint32_t HarrisMatrix::rank_from_top(std::uint32_t component) const {
    return data_->condensation.rank.at(component);
}

const MatrixStats& HarrisMatrix::stats() const noexcept { return data_->stats; }

bool HarrisMatrix::is_later(NodeIndex later, NodeIndex earlier) const {
    const Condensation& c = data_->condensation;
    const std::uint32_t from = c.component_of.at(later);
    const std::uint32_t to = c.component_of.at(earlier);
    if (from == to) return later != earlier || c.members.row(from).size() > 1;
    if (from > to) return false; // components are numbered from the top
    std::vector<bool> seen(to - from + 1, false);
    std::vector<std::uint32_t> open = {from};
    while (!open.empty()) {
        const std::uint32_t at = open.back();
        open.pop_back();
        for (const std::uint32_t next : c.below.row(at)) {
            if (next == to) return true;
            if (next > to) break;
            if (seen[next - from]) continue;
            seen[next - from] = true;
            open.push_back(next);
        }
    }
    return false;
}

std::vector<std::uint32_t> HarrisMatrix::shortest_path(NodeIndex later, NodeIndex earlier) const {
    const Condensation& c = data_->condensation;
    const std::uint32_t last = c.component_of.at(earlier);
    constexpr std::uint32_t kUnseen = static_cast<std::uint32_t>(-1);
    std::unordered_map<NodeIndex, std::uint32_t> came_by; // order position by which a node was reached
    std::vector<NodeIndex> open = {later};
    for (std::size_t at = 0; at < open.size(); ++at) {
        for (const std::uint32_t order : data_->below.row(open[at])) {
            const NodeIndex next = data_->orders[order].earlier;
            if (c.component_of[next] > last || !came_by.emplace(next, order).second) continue;
            if (next != earlier) {
                if (next != later) open.push_back(next);
                continue;
            }
            std::vector<std::uint32_t> path;
            for (NodeIndex node = earlier; path.empty() || node != later; node = data_->orders[path.back()].later) {
                const auto step = came_by.find(node);
                path.push_back(step == came_by.end() ? kUnseen : step->second);
            }
            std::reverse(path.begin(), path.end());
            return path;
        }
    }
    return {};
}

} // namespace planum::strat
