// SPDX-License-Identifier: MIT
#include "strat/layout/port_phase.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <span>
#include <tuple>

#include "strat/layout/drawing_style.hpp"

namespace planum::strat {

namespace {

using End = ChannelWires::End;
using ChannelWire = ChannelWires::ChannelWire;

// Pieces of one channel, split into wires: pieces of one net that share an end.
class WireCollector {
  public:
    explicit WireCollector(const LayeredMatrix& matrix)
        : m_(matrix), leader_(matrix.nodes.size(), 0), seen_(matrix.nodes.size(), 0) {}

    std::vector<ChannelWires> collect() {
        std::vector<std::vector<LayeredMatrix::Piece>> by_channel(m_.levels.size() + 1);
        for (const LayeredMatrix::Piece& piece : m_.pieces) {
            by_channel[static_cast<std::size_t>(m_.nodes[piece.lower].level)].push_back(piece);
        }
        channels_.resize(m_.levels.size() + 1);
        for (std::size_t c = 0; c < by_channel.size(); ++c) join(by_channel[c], channels_[c]);
        for (const LayeredMatrix::Path& path : m_.paths) {
            if (path.upwards) add_turns(path);
        }
        return std::move(channels_);
    }

  private:
    void join(std::vector<LayeredMatrix::Piece>& pieces, ChannelWires& channel) {
        std::sort(pieces.begin(), pieces.end(), [](const auto& a, const auto& b) {
            return std::tie(a.net, a.upper, a.lower) < std::tie(b.net, b.upper, b.lower);
        });
        for (std::size_t first = 0; first < pieces.size();) {
            std::size_t last = first;
            while (last < pieces.size() && pieces[last].net == pieces[first].net) ++last;
            join_net(std::span(pieces).subspan(first, last - first), channel);
            first = last;
        }
    }

    void join_net(std::span<const LayeredMatrix::Piece> pieces, ChannelWires& channel) {
        for (const LayeredMatrix::Piece& p : pieces) { // levels differ, so an upper node is no lower one
            leader_[p.upper] = p.upper;
            leader_[p.lower] = p.lower;
        }
        for (const LayeredMatrix::Piece& p : pieces) {
            const std::uint32_t a = find(p.upper);
            const std::uint32_t b = find(p.lower);
            leader_[std::max(a, b)] = std::min(a, b);
        }
        const std::size_t first = channel.wires.size();
        ++mark_;
        for (const LayeredMatrix::Piece& p : pieces) {
            const std::uint32_t root = find(p.upper);
            std::size_t at = first;
            while (at < channel.wires.size() && roots_[at - first] != root) ++at;
            if (at == channel.wires.size()) {
                channel.wires.push_back({p.net, {}, {}});
                roots_.resize(at - first);
                roots_.push_back(root);
            }
            ChannelWire& wire = channel.wires[at];
            if (seen_[p.upper] != mark_) wire.tops.push_back({p.upper, 0.0});
            if (seen_[p.lower] != mark_) wire.bottoms.push_back({p.lower, 0.0});
            seen_[p.upper] = mark_;
            seen_[p.lower] = mark_;
        }
    }

    [[nodiscard]] std::uint32_t find(std::uint32_t v) const {
        while (leader_[v] != v) v = leader_[v];
        return v;
    }

    // Where an upward line leaves below its later box, and where it enters its earlier one.
    void add_turns(const LayeredMatrix::Path& path) {
        const std::uint32_t later = path.nodes.front();
        const std::uint32_t earlier = path.nodes.back();
        const auto below = static_cast<std::size_t>(m_.nodes[later].level) + 1;
        const auto above = static_cast<std::size_t>(m_.nodes[earlier].level);
        channels_[below].wires.push_back({path.net, {{later, 0.0}, {path.nodes[1], 0.0}}, {}});
        channels_[above].wires.push_back({path.net, {}, {{earlier, 0.0}, {path.nodes[path.nodes.size() - 2], 0.0}}});
    }

    const LayeredMatrix& m_;
    std::vector<ChannelWires> channels_;
    // Of the net being joined.
    std::vector<std::uint32_t> leader_; // by node
    std::vector<std::uint32_t> seen_;   // by node: the last mark it got
    std::uint32_t mark_ = 0;
    std::vector<std::uint32_t> roots_; // of its wires
};

// A place where lines leave or enter one side of a box.
struct Port {
    End* end = nullptr;
    double wanted = 0.0;
    double towards = 0.0;  // mean x of where the wire goes
    double straight = 0.0; // 0: `wanted` faces no other end of the wire, else how much it matters
};

constexpr double kOnlyOne = 10.0;  // the wire has one other end
constexpr double kOneOfMany = 1.0; // it has others

class PortPlacer {
  public:
    PortPlacer(const LayeredMatrix& matrix, const DrawnGraph& graph, std::vector<ChannelWires>& channels)
        : m_(matrix), graph_(graph), channels_(channels) {}

    void place() {
        for (ChannelWires& channel : channels_) split_what_runs_straight(channel);
    }

  private:
    void place_channel(ChannelWires& channel) const {
        for (ChannelWire& wire : channel.wires) {
            for (End& end : wire.tops) end.x = m_.nodes[end.node].x;
            for (End& end : wire.bottoms) end.x = m_.nodes[end.node].x;
        }
        place_side(channel, true);
        place_side(channel, false);
        straighten(channel);
    }

    // A bar is needless where a box can reach everything the wire joins it to by straight verticals of their own. What
    // else leaves the same boxes may stand in the way, so it is tried, and joined again where a step came out.
    void split_what_runs_straight(ChannelWires& channel) const {
        const std::vector<ChannelWire> whole = channel.wires;
        std::vector<bool> split(whole.size(), false);
        for (std::size_t i = 0; i < whole.size(); ++i) split[i] = faces_all(whole[i]);
        for (bool failed = true; failed;) {
            std::vector<std::size_t> part_of;
            channel.wires.clear();
            for (std::size_t i = 0; i < whole.size(); ++i) {
                if (split[i]) {
                    for (ChannelWire& part : parts_of(whole[i])) channel.wires.push_back(std::move(part));
                } else {
                    channel.wires.push_back(whole[i]);
                }
                part_of.resize(channel.wires.size(), i);
            }
            place_channel(channel);
            failed = false;
            for (std::size_t k = 0; k < channel.wires.size(); ++k) {
                const ChannelWire& part = channel.wires[k];
                if (!split[part_of[k]] || part.tops.front().x == part.bottoms.front().x) continue;
                split[part_of[k]] = false;
                failed = true;
            }
            failed = rejoin_crowded(channel, part_of, split) || failed;
        }
    }

    [[nodiscard]] static std::vector<ChannelWire> parts_of(const ChannelWire& wire) {
        std::vector<ChannelWire> parts;
        for (const End& top : wire.tops) {
            for (const End& bottom : wire.bottoms) parts.push_back({wire.net, {top}, {bottom}});
        }
        return parts;
    }

    [[nodiscard]] bool faces_all(const ChannelWire& wire) const {
        const bool star =
            (wire.tops.size() == 1 && wire.bottoms.size() > 1) || (wire.bottoms.size() == 1 && wire.tops.size() > 1);
        if (!star) return false;
        const bool below = wire.tops.size() == 1;
        const std::uint32_t box = (below ? wire.tops : wire.bottoms).front().node;
        if (is_line(box)) return false;
        const std::vector<End>& others = below ? wire.bottoms : wire.tops;
        return std::all_of(others.begin(), others.end(), [&](const End& other) {
            const double both = reach(box) + (is_line(other.node) ? 0.0 : reach(other.node));
            return std::abs(m_.nodes[other.node].x - m_.nodes[box].x) <= both;
        });
    }

    // The verticals of a side must keep their gap.
    bool rejoin_crowded(const ChannelWires& channel, const std::vector<std::size_t>& part_of,
                        std::vector<bool>& split) const {
        std::map<std::pair<bool, std::uint32_t>, std::vector<double>> sides;
        for (const ChannelWire& wire : channel.wires) {
            for (const End& end : wire.tops) sides[{true, end.node}].push_back(end.x);
            for (const End& end : wire.bottoms) sides[{false, end.node}].push_back(end.x);
        }
        for (auto& [side, x] : sides) std::sort(x.begin(), x.end());
        const auto crowded = [&](bool top, std::uint32_t node) {
            const std::vector<double>& x = sides.at({top, node});
            return std::adjacent_find(x.begin(), x.end(), [](double a, double b) { return b - a < style::kPortGap; }) !=
                   x.end();
        };
        bool any = false;
        for (std::size_t k = 0; k < channel.wires.size(); ++k) {
            if (!split[part_of[k]]) continue;
            const ChannelWire& part = channel.wires[k];
            if (!crowded(true, part.tops.front().node) && !crowded(false, part.bottoms.front().node)) continue;
            split[part_of[k]] = false;
            any = true;
        }
        return any;
    }

    [[nodiscard]] bool is_line(std::uint32_t node) const { return m_.nodes[node].box == LayeredMatrix::kNoBox; }

    [[nodiscard]] double reach(std::uint32_t node) const {
        // In halves of points like all other x.
        return std::floor(graph_.boxes[m_.nodes[node].box].box.rect.width - 2.0 * style::kPortMargin) / 2.0;
    }

    // All ports at the lower (tops) or upper sides of the boxes along a channel.
    void place_side(ChannelWires& channel, bool tops) const {
        std::map<std::uint32_t, int> ends;
        for (const ChannelWire& wire : channel.wires) {
            for (const End& end : tops ? wire.tops : wire.bottoms) ++ends[end.node];
        }
        std::map<std::uint32_t, std::vector<Port>> by_box;
        for (ChannelWire& wire : channel.wires) {
            std::vector<End>& own = tops ? wire.tops : wire.bottoms;
            const std::vector<End>& far = tops ? wire.bottoms : wire.tops;
            for (End& end : own) {
                if (is_line(end.node)) continue;
                const bool free = tops && (ends.at(end.node) == 1 || (own.size() == 1 && far.size() == 1));
                by_box[end.node].push_back(make_port(end, own, far, free));
            }
        }
        for (auto& [node, ports] : by_box) spread(node, ports);
    }

    // Upper sides are placed when the ends above have their places; before that, boxes are aimed at in the middle, or
    // where both meet half the way if the end is `free` to.
    Port make_port(End& end, const std::vector<End>& own, const std::vector<End>& far, bool free) const {
        const double centre = m_.nodes[end.node].x;
        Port port{&end, centre, 0.0, 0.0};
        const std::vector<End>& aims = far.empty() ? own : far;
        double sum = 0.0;
        std::size_t count = 0;
        for (const End& other : aims) {
            if (&other == &end) continue;
            sum += other.x;
            ++count;
        }
        port.towards = count > 0 ? sum / static_cast<double>(count) : centre;
        if (far.empty()) {
            port.wanted = port.towards; // a turn leaves on the side it turns to
            return port;
        }
        const bool only = far.size() == 1 && own.size() == 1;
        double least = reach(end.node);
        for (const End& other : far) {
            const bool halfway = free && !is_line(other.node); // both boxes meet half the way
            const double place = halfway ? (centre + other.x) / 2.0 : other.x;
            if (only) port.wanted = place;
            if (halfway && std::abs(place - other.x) > reach(other.node)) continue;
            if (std::abs(place - centre) > least) continue;
            least = std::abs(place - centre);
            port.wanted = place;
            port.straight = only ? kOnlyOne : kOneOfMany;
        }
        return port;
    }

    // Ports of one box that stand side by side at the least gap. Its place is that of its first port.
    struct Pool {
        std::span<const Port> ports;
        double place = 0.0;
    };

    // Where the most that can run straight do; where none can, in the mean of what they want.
    static double place_of(std::span<const Port> ports, double gap) {
        std::vector<std::pair<double, double>> straight; // place of the first port, weight
        double total = 0.0;
        double sum = 0.0;
        for (std::size_t i = 0; i < ports.size(); ++i) {
            const double first = ports[i].wanted - gap * static_cast<double>(i);
            sum += first;
            total += ports[i].straight;
            if (ports[i].straight > 0.0) straight.push_back({first, ports[i].straight});
        }
        if (straight.empty()) return sum / static_cast<double>(ports.size());
        std::sort(straight.begin(), straight.end());
        double passed = 0.0;
        for (const auto& [first, weight] : straight) {
            passed += weight;
            if (2.0 * passed >= total) return first;
        }
        return straight.back().first;
    }

    // Sorted by where they go, as near to what they want as the gaps allow; lines that can run straight hold
    // their place and the others make way: medians under an order, by pooling adjacent violators.
    void spread(std::uint32_t node, std::vector<Port>& ports) const {
        std::stable_sort(ports.begin(), ports.end(),
                         [](const Port& a, const Port& b) { return a.towards < b.towards; });
        const double centre = m_.nodes[node].x;
        const double room = reach(node);
        const std::size_t n = ports.size();
        const double gap =
            n < 2 ? 0.0 : std::min(style::kPortGap, std::floor(4.0 * room / static_cast<double>(n - 1)) / 2.0);
        std::vector<Pool> pools;
        const auto pool_of = [&](std::size_t first, std::size_t count) {
            const std::span<const Port> own = std::span<const Port>(ports).subspan(first, count);
            return Pool{own, place_of(own, gap) - gap * static_cast<double>(first)};
        };
        for (std::size_t i = 0; i < n; ++i) {
            pools.push_back(pool_of(i, 1));
            while (pools.size() > 1 && pools[pools.size() - 2].place > pools.back().place) {
                pools.pop_back();
                const auto first = static_cast<std::size_t>(pools.back().ports.data() - ports.data());
                pools.back() = pool_of(first, i + 1 - first);
            }
        }
        std::size_t i = 0;
        const double most = std::max(centre - room, centre + room - gap * static_cast<double>(n - 1));
        for (const Pool& pool : pools) {
            const double base = std::clamp(std::round(pool.place * 2.0) / 2.0, centre - room, most);
            for (std::size_t k = 0; k < pool.ports.size(); ++k, ++i)
                ports[i].end->x = base + gap * static_cast<double>(i);
        }
    }

    // Small steps between ends that nearly face each other are taken out where a box has room.
    void straighten(ChannelWires& channel) const {
        std::map<std::uint32_t, int> at_top;
        std::map<std::uint32_t, int> at_bottom;
        for (const ChannelWire& wire : channel.wires) {
            for (const End& end : wire.tops) ++at_top[end.node];
            for (const End& end : wire.bottoms) ++at_bottom[end.node];
        }
        for (ChannelWire& wire : channel.wires) {
            for (End& top : wire.tops) {
                for (End& bottom : wire.bottoms) {
                    const double step = std::abs(top.x - bottom.x);
                    const bool alone = wire.tops.size() == 1 && wire.bottoms.size() == 1;
                    constexpr double kSmall = 10.0;
                    if (step == 0.0 || (!alone && step > kSmall)) continue;
                    if (at_bottom[bottom.node] == 1 && reaches(bottom.node, top.x)) {
                        bottom.x = top.x;
                    } else if (at_top[top.node] == 1 && reaches(top.node, bottom.x) &&
                               (alone || wire.tops.size() > 1)) {
                        top.x = bottom.x;
                    }
                }
            }
            for (End& top : wire.tops) {
                if (at_top[top.node] == 1) centre_stem(top, wire);
            }
        }
    }

    // A stem that went half the way towards a box for nothing, since other lines enter that box there, comes back.
    void centre_stem(End& stem, const ChannelWire& wire) const {
        const bool straight = std::any_of(wire.bottoms.begin(), wire.bottoms.end(),
                                          [&](const End& bottom) { return bottom.x == stem.x; });
        if (!straight) stem.x = m_.nodes[stem.node].x;
    }

    [[nodiscard]] bool reaches(std::uint32_t node, double x) const {
        return !is_line(node) && std::abs(x - m_.nodes[node].x) <= reach(node);
    }

    const LayeredMatrix& m_;
    const DrawnGraph& graph_;
    std::vector<ChannelWires>& channels_;
};

} // namespace

std::vector<ChannelWires> make_wires(const LayeredMatrix& matrix, const DrawnGraph& graph) {
    std::vector<ChannelWires> channels = WireCollector(matrix).collect();
    PortPlacer(matrix, graph, channels).place();
    return channels;
}

void widen_for_ports(DrawnGraph& graph, const std::vector<Net>& nets) {
    std::vector<int> below(graph.boxes.size(), 0);
    std::vector<int> above(graph.boxes.size(), 0);
    for (const Net& net : nets) {
        for (const std::uint32_t b : net.later) ++below[b];
        for (const std::uint32_t b : net.earlier) ++above[b];
    }
    for (std::size_t b = 0; b < graph.boxes.size(); ++b) {
        const int ports = std::max(below[b], above[b]);
        const double needed = 2.0 * style::kPortMargin + style::kPortGap * static_cast<double>(std::max(ports - 1, 0));
        double& width = graph.boxes[b].box.rect.width;
        width = std::max(width, needed);
    }
}

} // namespace planum::strat
