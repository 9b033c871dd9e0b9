// SPDX-License-Identifier: MIT
#include "strat/layout/layered_matrix.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>

#include "strat/layout/coordinate_phase.hpp"
#include "strat/layout/drawing_style.hpp"
#include "strat/layout/group_order.hpp"
#include "strat/layout/level_switcher.hpp"
#include "strat/layout/order_phase.hpp"
#include "strat/layout/part_packing.hpp"

namespace planum::strat {

namespace {

constexpr std::uint32_t kNoBox = LayeredMatrix::kNoBox;

// Lines of one net that stand side by side become one, so they are ordered one by one for as long as that
// is affordable; beyond, each net has one line a level from the beginning.
constexpr std::int64_t kMostLineNodes = 60'000;

using Edge = std::pair<std::uint32_t, std::uint32_t>;

// One component while it is laid out.
struct Component {
    std::vector<std::uint32_t> nodes;
    std::vector<std::uint32_t> nets;
    double width = 0.0;
    std::int32_t levels = 0;
    double x = 0.0; // where it is put
    std::int32_t level = 0;
};

class Layerer {
  public:
    Layerer(const DrawnGraph& graph, const Ranking& ranking, const std::vector<Net>& nets, Progress& progress)
        : graph_(graph), ranking_(ranking), nets_(nets), progress_(progress) {}

    LayeredMatrix make() {
        out_.band_begin = ranking_.band_begin;
        for (std::uint32_t b = 0; b < graph_.boxes.size(); ++b) {
            out_.nodes.push_back({ranking_.rank[b], b, 0, 0.0, graph_.boxes[b].group, 0.0});
        }
        out_.paths.resize(graph_.orders.size());
        const bool share = line_nodes() > kMostLineNodes;
        for (std::uint32_t n = 0; n < nets_.size(); ++n) {
            if (nets_[n].upwards) {
                add_upward(n);
            } else {
                add_downward(n, share || (nets_[n].later.size() > 1 && nets_[n].earlier.size() > 1));
            }
        }
        add_frames();
        split_components();
        merged_.resize(out_.nodes.size());
        std::iota(merged_.begin(), merged_.end(), 0U);
        beyond_.assign(out_.nodes.size(), kNoBox);
        local_.resize(out_.nodes.size());
        for (Component& component : components_) lay_out(component);
        pack();
        collect_levels();
        collect_pieces();
        collect_frames();
        return std::move(out_);
    }

  private:
    [[nodiscard]] std::int64_t line_nodes() const {
        std::int64_t sum = 0;
        for (const GraphOrder& o : graph_.orders) sum += std::abs(ranking_.rank[o.earlier] - ranking_.rank[o.later]);
        return sum;
    }

    std::uint32_t add_line_node(std::int32_t level, std::uint32_t net) {
        out_.nodes.push_back({level, kNoBox, net, 0.0, group_of_net(net), 0.0});
        return static_cast<std::uint32_t>(out_.nodes.size() - 1);
    }

    void add_downward(std::uint32_t n, bool share) {
        std::map<std::int32_t, std::uint32_t> shared; // line node of the net by level
        for (const std::uint32_t i : nets_[n].orders) {
            LayeredMatrix::Path& path = out_.paths[i];
            path.net = n;
            const GraphOrder& order = graph_.orders[i];
            path.nodes.push_back(order.later);
            for (std::int32_t l = ranking_.rank[order.later] + 1; l < ranking_.rank[order.earlier]; ++l) {
                const auto known = share ? shared.find(l) : shared.end();
                const std::uint32_t node = known != shared.end() ? known->second : add_line_node(l, n);
                if (share) shared.emplace(l, node);
                path.nodes.push_back(node);
            }
            path.nodes.push_back(order.earlier);
        }
    }

    void add_upward(std::uint32_t n) {
        const std::uint32_t i = nets_[n].orders.front();
        LayeredMatrix::Path& path = out_.paths[i];
        path.net = n;
        const GraphOrder& order = graph_.orders[i];
        path.upwards = ranking_.rank[order.later] >= ranking_.rank[order.earlier];
        if (!path.upwards) { // other bonds already put it the right way round
            add_downward(n, false);
            return;
        }
        path.nodes.push_back(order.later);
        for (std::int32_t l = ranking_.rank[order.later]; l >= ranking_.rank[order.earlier]; --l) {
            path.nodes.push_back(add_line_node(l, n));
        }
        path.nodes.push_back(order.earlier);
    }

    // A line belongs into a frame if all boxes that it joins do.
    [[nodiscard]] std::int32_t group_of_net(std::uint32_t net) const {
        const std::int32_t group = graph_.boxes[nets_[net].later.front()].group;
        for (const auto* side : {&nets_[net].later, &nets_[net].earlier}) {
            for (const std::uint32_t b : *side) {
                if (graph_.boxes[b].group != group) return kNoBand;
            }
        }
        return group;
    }

    // Each frame gets its heading beside its first row of boxes, and on every level that it passes empty
    // something that keeps its place.
    void add_frames() {
        if (graph_.groups.empty()) return;
        std::vector<std::vector<std::int32_t>> levels(graph_.groups.size()); // of each group's nodes
        box_of_group_.assign(graph_.groups.size(), kNoBox);
        for (std::uint32_t v = 0; v < out_.nodes.size(); ++v) {
            const LayeredMatrix::Node& node = out_.nodes[v];
            if (node.group < 0 || (node.box != kNoBox && graph_.boxes[node.box].box.isolated)) continue;
            levels[static_cast<std::size_t>(node.group)].push_back(node.level);
            if (node.box != kNoBox) box_of_group_[static_cast<std::size_t>(node.group)] = node.box;
        }
        for (std::size_t group = 0; group < levels.size(); ++group) {
            std::vector<std::int32_t>& used = levels[group];
            if (used.empty()) continue;
            std::sort(used.begin(), used.end());
            const auto number = static_cast<std::int32_t>(group);
            out_.nodes.push_back(
                {used.front(), kNoBox, LayeredMatrix::kNoNet, 0.0, number, graph_.groups[group].width});
            for (std::int32_t l = used.front(); l <= used.back(); ++l) {
                if (std::binary_search(used.begin(), used.end(), l)) continue;
                out_.nodes.push_back({l, kNoBox, LayeredMatrix::kNoNet, 0.0, number, 0.0});
            }
        }
    }

    [[nodiscard]] bool is_line(const LayeredMatrix::Node& node) const {
        return node.box == kNoBox && node.net != LayeredMatrix::kNoNet;
    }

    void split_components() {
        std::vector<std::uint32_t> number(ranking_.component_count, kNoBox);
        const auto component_at = [&](std::uint32_t box) -> Component& {
            std::uint32_t& at = number[ranking_.component[box]];
            if (at == kNoBox) {
                at = static_cast<std::uint32_t>(components_.size());
                components_.emplace_back();
            }
            return components_[at];
        };
        for (std::uint32_t b = 0; b < graph_.boxes.size(); ++b) {
            if (!graph_.boxes[b].box.isolated) component_at(b).nodes.push_back(b);
        }
        for (std::uint32_t v = static_cast<std::uint32_t>(graph_.boxes.size()); v < out_.nodes.size(); ++v) {
            const LayeredMatrix::Node& node = out_.nodes[v];
            const std::uint32_t box =
                is_line(node) ? nets_[node.net].later.front() : box_of_group_[static_cast<std::size_t>(node.group)];
            component_at(box).nodes.push_back(v);
        }
        paths_of_.resize(components_.size());
        for (std::uint32_t i = 0; i < out_.paths.size(); ++i) {
            paths_of_[number[ranking_.component[graph_.orders[i].later]]].push_back(i);
        }
    }

    void lay_out(Component& component) {
        const auto index = static_cast<std::size_t>(&component - components_.data());
        progress_.check();
        order_component(component, index);
        merge_lines(component, index);
        place_component(component, index);
    }

    // Edges of a component's paths between the nodes' places in it, distinct. `for_order` adds what keeps an
    // upward line near its boxes.
    std::vector<Edge> edges_of(std::size_t index, bool for_order) const {
        std::vector<Edge> edges;
        for (const std::uint32_t i : paths_of_[index]) {
            const LayeredMatrix::Path& path = out_.paths[i];
            const std::size_t last = path.nodes.size() - 1;
            for (std::size_t k = 0; k < last; ++k) {
                if (!path.upwards) {
                    edges.push_back({path.nodes[k], path.nodes[k + 1]});
                } else if (k > 0 && k + 1 < last) {
                    edges.push_back({path.nodes[k + 1], path.nodes[k]});
                }
            }
        }
        if (for_order) add_leanings(index, edges);
        std::sort(edges.begin(), edges.end());
        edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
        return edges;
    }

    // The ends of an upward line lean on the neighbours of the boxes they go around: where there are none beyond a
    // box, on those on the other side of it.
    void add_leanings(std::size_t index, std::vector<Edge>& edges) const {
        const std::size_t ordinary = edges.size();
        for (const std::uint32_t i : paths_of_[index]) {
            const LayeredMatrix::Path& path = out_.paths[i];
            if (!path.upwards) continue;
            const std::uint32_t later = path.nodes.front();
            const std::uint32_t earlier = path.nodes.back();
            const std::uint32_t low = path.nodes[1]; // on the level of `later`, which stands below
            const std::uint32_t high = path.nodes[path.nodes.size() - 2];
            const std::size_t before = edges.size();
            lean(edges, ordinary, later, low, true);
            if (edges.size() == before) lean(edges, ordinary, later, low, false);
            const std::size_t between = edges.size();
            lean(edges, ordinary, earlier, high, false);
            if (edges.size() == between) lean(edges, ordinary, earlier, high, true);
        }
    }

    // Gives the line node the neighbours below or above the box.
    static void lean(std::vector<Edge>& edges, std::size_t ordinary, std::uint32_t box, std::uint32_t line,
                     bool below) {
        for (std::size_t e = 0; e < ordinary; ++e) {
            if (below && edges[e].first == box) edges.push_back({line, edges[e].second});
            if (!below && edges[e].second == box) edges.push_back({edges[e].first, line});
        }
    }

    LayeredGraph layered(const Component& component, std::size_t index, bool for_order) {
        LayeredGraph g;
        g.nodes = static_cast<std::uint32_t>(component.nodes.size());
        for (std::uint32_t i = 0; i < component.nodes.size(); ++i) local_[component.nodes[i]] = i;
        for (const Edge& e : edges_of(index, for_order)) g.edges.push_back({local_[e.first], local_[e.second]});
        return g;
    }

    void order_component(Component& component, std::size_t index) {
        LayeredGraph g = layered(component, index, true);
        std::int32_t deepest = 0;
        for (const std::uint32_t v : component.nodes) deepest = std::max(deepest, out_.nodes[v].level);
        component.levels = deepest + 1;
        g.layers.resize(static_cast<std::size_t>(component.levels));
        for (std::uint32_t i = 0; i < component.nodes.size(); ++i) {
            g.layers[static_cast<std::size_t>(out_.nodes[component.nodes[i]].level)].push_back(i);
        }
        OrderOptions options;
        options.held = sort_as_before(component, index, g);
        options.keep_given = !options.held.empty();
        order_layers(g, options, progress_);
        draw_in_upward_ends(g, index);
        draw_contemporaries_together(component, g);
        if (!graph_.groups.empty()) order_groups(g, groups_in(component), progress_);
        // From here on the component's nodes stand level by level, left to right.
        std::vector<std::uint32_t> nodes;
        nodes.reserve(component.nodes.size());
        for (const std::vector<std::uint32_t>& layer : g.layers) {
            for (const std::uint32_t i : layer) nodes.push_back(component.nodes[i]);
        }
        component.nodes = std::move(nodes);
    }

    // The ends of upward lines go as near to their boxes as they can without crossing more: nothing else holds them
    // there, since they join nothing on the levels above and below.
    void draw_in_upward_ends(LayeredGraph& g, std::size_t index) const {
        const auto upwards = [&](std::uint32_t i) { return out_.paths[i].upwards; };
        if (std::none_of(paths_of_[index].begin(), paths_of_[index].end(), upwards)) return;
        LevelSwitcher switcher(g);
        for (const std::uint32_t i : paths_of_[index]) {
            const LayeredMatrix::Path& path = out_.paths[i];
            if (!path.upwards) continue;
            const std::size_t last = path.nodes.size() - 1;
            for (const std::size_t end : {std::size_t{1}, last - 1}) {
                const std::uint32_t box = path.nodes[end == 1 ? 0 : last];
                const auto level = static_cast<std::size_t>(out_.nodes[box].level);
                switcher.draw_near(level, local_[path.nodes[end]], local_[box]);
            }
        }
    }

    // What is contemporary and in no order has nothing else to hold it.
    void draw_contemporaries_together(const Component& component, LayeredGraph& g) const {
        std::vector<Edge> pairs;
        const std::uint32_t number = ranking_.component[out_.nodes[component.nodes.front()].box];
        for (const Order& pair : graph_.contemporaries) {
            if (ranking_.component[pair.later] == number) pairs.push_back({local_[pair.later], local_[pair.earlier]});
        }
        if (!pairs.empty()) draw_together(g, pairs);
    }

    [[nodiscard]] NodeGroups groups_in(const Component& component) const {
        NodeGroups groups;
        groups.count = static_cast<std::int32_t>(graph_.groups.size());
        for (const std::uint32_t v : component.nodes) {
            groups.group.push_back(out_.nodes[v].group);
            groups.leads.push_back(out_.nodes[v].width > 0.0);
        }
        return groups;
    }

    // Begins where the earlier drawing left off: known boxes and lines by their x, the others by the mean of their
    // neighbours. Says of each node whether it was known; of none where less than half of the boxes were.
    std::vector<bool> sort_as_before(const Component& component, std::size_t index, LayeredGraph& g) const {
        std::vector<double> x(g.nodes, 0.0);
        std::vector<bool> known(g.nodes, false);
        std::size_t boxes = 0;
        std::size_t remembered = 0;
        for (std::uint32_t i = 0; i < g.nodes; ++i) {
            const std::uint32_t box = out_.nodes[component.nodes[i]].box;
            if (box == kNoBox) continue;
            ++boxes;
            if (!graph_.boxes[box].has_previous) continue;
            ++remembered;
            x[i] = graph_.boxes[box].previous.x;
            known[i] = true;
        }
        if (boxes == 0 || remembered * 2 < boxes) return {};
        const std::vector<double> heights = former_heights(component);
        for (const std::uint32_t p : paths_of_[index]) {
            const std::vector<DrawPoint>& line = graph_.orders[p].previous;
            for (const std::uint32_t v : out_.paths[p].nodes) {
                if (out_.nodes[v].box != kNoBox) continue;
                const auto here = upright_at(line, heights[static_cast<std::size_t>(out_.nodes[v].level)]);
                if (!here) continue;
                x[local_[v]] = *here;
                known[local_[v]] = true;
            }
        }
        std::vector<std::vector<std::uint32_t>> beside(g.nodes);
        for (const Edge& e : g.edges) {
            beside[e.first].push_back(e.second);
            beside[e.second].push_back(e.first);
        }
        constexpr int kRounds = 60; // long lines take their x step by step from both ends
        for (int round = 0; round < kRounds; ++round) {
            for (std::uint32_t i = 0; i < g.nodes; ++i) {
                if (known[i] || beside[i].empty()) continue;
                double sum = 0.0;
                for (const std::uint32_t j : beside[i]) sum += x[j];
                x[i] = sum / static_cast<double>(beside[i].size());
            }
        }
        for (std::vector<std::uint32_t>& layer : g.layers) {
            std::stable_sort(layer.begin(), layer.end(), [&](std::uint32_t a, std::uint32_t b) { return x[a] < x[b]; });
        }
        return known;
    }

    // Where the levels of a component were in the earlier drawing, by the boxes on them; what has none known lies
    // between the levels beside it.
    [[nodiscard]] std::vector<double> former_heights(const Component& component) const {
        std::vector<std::vector<double>> on(static_cast<std::size_t>(component.levels));
        for (const std::uint32_t v : component.nodes) {
            const std::uint32_t box = out_.nodes[v].box;
            if (box != kNoBox && graph_.boxes[box].has_previous)
                on[static_cast<std::size_t>(out_.nodes[v].level)].push_back(graph_.boxes[box].previous.y);
        }
        std::vector<double> heights(on.size(), std::numeric_limits<double>::quiet_NaN());
        std::optional<std::size_t> last;
        for (std::size_t l = 0; l < on.size(); ++l) {
            if (on[l].empty()) continue;
            std::nth_element(on[l].begin(), on[l].begin() + std::ssize(on[l]) / 2, on[l].end());
            heights[l] = on[l][on[l].size() / 2];
            for (std::size_t between = last ? *last + 1 : l; between < l; ++between) {
                const double share = static_cast<double>(between - *last) / static_cast<double>(l - *last);
                heights[between] = heights[*last] + share * (heights[l] - heights[*last]);
            }
            last = l;
        }
        return heights;
    }

    // The x of the upright stroke of a line at that height; none where it has none.
    static std::optional<double> upright_at(const std::vector<DrawPoint>& line, double y) {
        for (std::size_t k = 1; k < line.size(); ++k) {
            const auto [low, high] = std::minmax(line[k - 1].y, line[k].y);
            if (line[k - 1].x == line[k].x && low <= y && y <= high) return line[k].x;
        }
        return std::nullopt;
    }

    // Neighbouring lines of one net that begin in the same node (seen from above) or end in the same node (from
    // below) are one line from there on.
    void merge_lines(Component& component, std::size_t index) {
        for (const bool from_top : {true, false}) {
            look_along(index, from_top);
            const std::size_t n = component.nodes.size();
            std::uint32_t last = kNoBox;
            // Level by level from the shared end, so that a merged node is one when its successors are compared.
            std::vector<std::uint32_t> order = component.nodes;
            if (!from_top) std::reverse(order.begin(), order.end());
            for (std::size_t k = 0; k < n; ++k) {
                const std::uint32_t v = order[k];
                if (merged_[v] != v) continue;
                const bool line = is_line(out_.nodes[v]) && !nets_[out_.nodes[v].net].upwards;
                const bool joins = line && last != kNoBox && out_.nodes[last].box == kNoBox &&
                                   out_.nodes[last].level == out_.nodes[v].level &&
                                   out_.nodes[last].net == out_.nodes[v].net && beyond_[v] != kNoBox &&
                                   beyond_[last] != kNoBox && merged_root(beyond_[last]) == merged_root(beyond_[v]);
                if (joins) {
                    merged_[v] = last;
                } else {
                    last = v;
                }
            }
        }
        for (const std::uint32_t i : paths_of_[index]) {
            for (std::uint32_t& v : out_.paths[i].nodes) v = merged_root(v);
        }
        std::erase_if(component.nodes, [&](std::uint32_t v) { return merged_[v] != v; });
    }

    [[nodiscard]] std::uint32_t merged_root(std::uint32_t v) const {
        while (merged_[v] != v) v = merged_[v];
        return v;
    }

    // For each line node the node before (from_top) or after it on its path.
    void look_along(std::size_t index, bool from_top) {
        for (const std::uint32_t i : paths_of_[index]) {
            const std::vector<std::uint32_t>& nodes = out_.paths[i].nodes;
            for (std::size_t k = 1; k + 1 < nodes.size(); ++k) beyond_[nodes[k]] = nodes[from_top ? k - 1 : k + 1];
        }
    }

    void place_component(Component& component, std::size_t index) {
        LayeredGraph g = layered(component, index, false);
        g.layers.resize(static_cast<std::size_t>(component.levels));
        std::vector<NodeExtent> extents(g.nodes);
        for (std::uint32_t i = 0; i < component.nodes.size(); ++i) {
            const LayeredMatrix::Node& node = out_.nodes[component.nodes[i]];
            g.layers[static_cast<std::size_t>(node.level)].push_back(i);
            const bool box = node.box != kNoBox;
            extents[i].is_line = is_line(node);
            extents[i].width = box ? graph_.boxes[node.box].box.rect.width : node.width;
            extents[i].gap = box ? style::kBoxGap : style::kLineGap;
            extents[i].group = node.group;
        }
        const std::vector<double> x = place_nodes(g, extents);
        double left = 0.0;
        double right = 0.0;
        for (std::uint32_t i = 0; i < component.nodes.size(); ++i) {
            const double rounded = std::round(x[i] * 2.0) / 2.0; // all x are halves, so that equal means equal
            out_.nodes[component.nodes[i]].x = rounded;
            const double side = extents[i].width / 2.0 + (extents[i].group >= 0 ? style::kFramePad : 0.0);
            left = std::min(left, rounded - side);
            right = std::max(right, rounded + side);
        }
        left = std::floor(left * 2.0) / 2.0;
        for (const std::uint32_t v : component.nodes) out_.nodes[v].x -= left;
        component.width = std::ceil((right - left) * 2.0) / 2.0;
    }

    // Largest first, smaller ones where they leave room. Bands keep all on their levels, frames are rectangles to
    // themselves.
    void pack() {
        std::vector<std::size_t> order(components_.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
            return components_[a].nodes.size() > components_[b].nodes.size();
        });
        std::vector<MatrixPart> parts;
        for (const std::size_t i : order) parts.push_back(outline_of(components_[i]));
        pack_parts(parts, graph_.bands.empty());
        for (std::size_t k = 0; k < order.size(); ++k) {
            Component& c = components_[order[k]];
            c.x = parts[k].x;
            c.level = parts[k].level;
            for (const std::uint32_t v : c.nodes) {
                out_.nodes[v].x += c.x;
                out_.nodes[v].level += c.level;
            }
        }
    }

    [[nodiscard]] MatrixPart outline_of(const Component& component) const {
        MatrixPart part;
        const auto levels = static_cast<std::size_t>(component.levels);
        if (!graph_.groups.empty()) {
            part.levels.assign(levels, {0.0, component.width});
            return part;
        }
        part.levels.assign(levels, {component.width, 0.0});
        for (const std::uint32_t v : component.nodes) {
            const LayeredMatrix::Node& node = out_.nodes[v];
            const double half = (node.box == kNoBox ? node.width : graph_.boxes[node.box].box.rect.width) / 2.0;
            MatrixPart::Level& level = part.levels[static_cast<std::size_t>(node.level)];
            level.left = std::min(level.left, node.x - half);
            level.right = std::max(level.right, node.x + half);
        }
        return part;
    }

    void collect_levels() {
        std::int32_t count = 0;
        for (const Component& c : components_) count = std::max(count, c.level + c.levels);
        out_.levels.resize(static_cast<std::size_t>(count));
        for (const Component& c : components_) {
            for (const std::uint32_t v : c.nodes)
                out_.levels[static_cast<std::size_t>(out_.nodes[v].level)].push_back(v);
        }
        for (std::vector<std::uint32_t>& level : out_.levels) {
            std::stable_sort(level.begin(), level.end(),
                             [&](std::uint32_t a, std::uint32_t b) { return out_.nodes[a].x < out_.nodes[b].x; });
        }
    }

    void collect_pieces() {
        for (const LayeredMatrix::Path& path : out_.paths) {
            const std::size_t last = path.nodes.size() - 1;
            for (std::size_t k = 0; k < last; ++k) {
                if (!path.upwards) {
                    out_.pieces.push_back({path.nodes[k], path.nodes[k + 1], path.net});
                } else if (k > 0 && k + 1 < last) {
                    out_.pieces.push_back({path.nodes[k + 1], path.nodes[k], path.net});
                }
            }
        }
        std::sort(out_.pieces.begin(), out_.pieces.end());
        out_.pieces.erase(std::unique(out_.pieces.begin(), out_.pieces.end()), out_.pieces.end());
    }

    void collect_frames() {
        std::vector<LayeredMatrix::Frame> frames(graph_.groups.size());
        std::vector<bool> used(frames.size(), false);
        for (const std::vector<std::uint32_t>& level : out_.levels) {
            for (const std::uint32_t v : level) {
                const LayeredMatrix::Node& node = out_.nodes[v];
                if (node.group < 0) continue;
                const auto group = static_cast<std::size_t>(node.group);
                const double width = node.box == kNoBox ? node.width : graph_.boxes[node.box].box.rect.width;
                const double side = width / 2.0 + style::kFramePad;
                LayeredMatrix::Frame& f = frames[group];
                if (!used[group]) f = {node.group, node.x - side, node.x + side, node.level, node.level};
                used[group] = true;
                f.left = std::min(f.left, node.x - side);
                f.right = std::max(f.right, node.x + side);
                f.first_level = std::min(f.first_level, node.level);
                f.last_level = std::max(f.last_level, node.level);
            }
        }
        for (std::size_t i = 0; i < frames.size(); ++i) {
            if (used[i]) out_.frames.push_back(frames[i]);
        }
    }

    const DrawnGraph& graph_;
    const Ranking& ranking_;
    const std::vector<Net>& nets_;
    Progress& progress_;
    LayeredMatrix out_;
    std::vector<std::uint32_t> box_of_group_; // any of its boxes
    std::vector<Component> components_;
    std::vector<std::vector<std::uint32_t>> paths_of_; // orders by component
    std::vector<std::uint32_t> local_;                 // by node: its place in its component
    std::vector<std::uint32_t> merged_;                // by node: the line it became part of
    std::vector<std::uint32_t> beyond_;                // by line node: see look_along
};

} // namespace

LayeredMatrix place_on_levels(const DrawnGraph& graph, const Ranking& ranking, const std::vector<Net>& nets,
                              Progress& progress) {
    return Layerer(graph, ranking, nets, progress).make();
}

} // namespace planum::strat
