// SPDX-License-Identifier: MIT
#include "strat/layout/planum_engine.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/base/error.hpp"
#include "strat/layout/drawing_page.hpp"
#include "strat/layout/drawing_style.hpp"
#include "strat/layout/layered_matrix.hpp"
#include "strat/layout/net_phase.hpp"
#include "strat/layout/port_phase.hpp"
#include "strat/layout/rank_phase.hpp"

namespace planum::strat {

namespace {

// Turns levels, wires and tracks into points.
class Assembler {
  public:
    Assembler(const DrawnGraph& graph, const LayeredMatrix& matrix, const std::vector<ChannelWires>& channels)
        : graph_(graph), m_(matrix), channels_(channels), drawing_(drawing_without_places(graph)) {}

    MatrixDrawing assemble(Progress& progress) {
        for (const ChannelWires& channel : channels_) {
            progress.check();
            std::vector<Wire> wires;
            for (const ChannelWires::ChannelWire& w : channel.wires) {
                Wire wire;
                for (const ChannelWires::End& e : w.tops) wire.tops.push_back(e.x);
                for (const ChannelWires::End& e : w.bottoms) wire.bottoms.push_back(e.x);
                wires.push_back(std::move(wire));
            }
            routes_.push_back(route_channel(wires));
        }
        place_levels();
        place_boxes();
        index_ends();
        for (std::size_t i = 0; i < m_.paths.size(); ++i)
            drawing_.lines[i].points = points_of(m_.paths[i], drawing_.lines[i]);
        find_junctions();
        place_bands();
        place_frames();
        return std::move(drawing_);
    }

  private:
    struct EndKey {
        std::uint32_t node;
        std::uint32_t net;
        bool top; // the node is above the channel
        friend auto operator<=>(const EndKey&, const EndKey&) = default;
    };

    struct EndPlace {
        std::size_t channel = 0;
        std::size_t wire = 0;
        double x = 0.0;
    };

    [[nodiscard]] bool begins_band(std::size_t level) const {
        return std::find(m_.band_begin.begin(), m_.band_begin.end(), static_cast<std::int32_t>(level)) !=
               m_.band_begin.end();
    }

    [[nodiscard]] double channel_height(std::size_t c) const {
        const std::int32_t tracks = routes_[c].tracks;
        const bool outside = c == 0 || c == m_.levels.size();
        double height = outside && tracks == 0 ? 0.0 : style::kChannelMin;
        if (tracks > 0) {
            height = std::max(height, 2.0 * style::kChannelMargin + style::kTrackGap * static_cast<double>(tracks - 1));
        }
        return height + edge_height(c) + frames_end_above(c) + frames_begin_below(c);
    }

    // Frames' upper and lower edges, too, have strips to themselves, next to the boxes.
    [[nodiscard]] double frames_begin_below(std::size_t c) const {
        const bool any = std::any_of(m_.frames.begin(), m_.frames.end(),
                                     [&](const auto& f) { return static_cast<std::size_t>(f.first_level) == c; });
        return any ? style::kFramePad : 0.0;
    }

    [[nodiscard]] double frames_end_above(std::size_t c) const {
        const bool any = std::any_of(m_.frames.begin(), m_.frames.end(),
                                     [&](const auto& f) { return static_cast<std::size_t>(f.last_level) + 1 == c; });
        return any ? style::kFramePad : 0.0;
    }

    // A band's edge has a strip of the channel to itself, above all horizontal lines: none may run along it.
    [[nodiscard]] double edge_height(std::size_t c) const {
        if (m_.band_begin.empty() || !begins_band(c)) return 0.0;
        return c == 0 || c == m_.levels.size() ? 9.0 : 14.0;
    }

    [[nodiscard]] double edge_y(std::size_t c) const {
        if (c == 0) return channel_top_[c];
        if (c == m_.levels.size()) return channel_bottom_[c];
        return channel_top_[c] + frames_end_above(c) + 9.0;
    }

    void place_levels() {
        double y = 0.0;
        for (std::size_t l = 0; l <= m_.levels.size(); ++l) {
            channel_top_.push_back(y);
            y += channel_height(l);
            channel_bottom_.push_back(y);
            if (l == m_.levels.size()) break;
            double height = style::kBoxHeight;
            for (const std::uint32_t v : m_.levels[l]) {
                if (!is_line(v)) height = std::max(height, graph_.boxes[m_.nodes[v].box].box.rect.height);
            }
            level_top_.push_back(y);
            y += height;
            level_bottom_.push_back(y);
        }
    }

    [[nodiscard]] bool is_line(std::uint32_t v) const { return m_.nodes[v].box == LayeredMatrix::kNoBox; }

    void place_boxes() {
        for (std::size_t l = 0; l < m_.levels.size(); ++l) {
            for (const std::uint32_t v : m_.levels[l]) {
                if (is_line(v)) continue;
                DrawRect& rect = drawing_.boxes[m_.nodes[v].box].rect;
                rect.x = m_.nodes[v].x - rect.width / 2.0;
                rect.y = (level_top_[l] + level_bottom_[l] - rect.height) / 2.0;
            }
        }
    }

    void index_ends() {
        for (std::size_t c = 0; c < channels_.size(); ++c) {
            for (std::size_t w = 0; w < channels_[c].wires.size(); ++w) {
                const ChannelWires::ChannelWire& wire = channels_[c].wires[w];
                for (const ChannelWires::End& e : wire.tops) ends_.push_back({{e.node, wire.net, true}, {c, w, e.x}});
                for (const ChannelWires::End& e : wire.bottoms)
                    ends_.push_back({{e.node, wire.net, false}, {c, w, e.x}});
            }
        }
        std::sort(ends_.begin(), ends_.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    }

    // A node has several ends of one net where a wire was split into verticals: then it is the one that goes to
    // `other`.
    [[nodiscard]] const EndPlace& end_at(const EndKey& key, std::uint32_t other) const {
        auto at = std::lower_bound(ends_.begin(), ends_.end(), key,
                                   [](const auto& a, const EndKey& b) { return a.first < b; });
        while (std::next(at) != ends_.end() && std::next(at)->first == key && !joins(at->second, other)) ++at;
        return at->second;
    }

    [[nodiscard]] bool joins(const EndPlace& place, std::uint32_t node) const {
        const ChannelWires::ChannelWire& wire = channels_[place.channel].wires[place.wire];
        const auto is_node = [&](const ChannelWires::End& e) { return e.node == node; };
        return std::any_of(wire.tops.begin(), wire.tops.end(), is_node) ||
               std::any_of(wire.bottoms.begin(), wire.bottoms.end(), is_node);
    }

    // Tracks stand in the middle of the channel, or of what a band's edge leaves of it.
    [[nodiscard]] double track_y(std::size_t channel, std::int32_t track) const {
        const double edge = channel == m_.levels.size() ? -edge_height(channel) : edge_height(channel);
        const double strips = edge + frames_end_above(channel) - frames_begin_below(channel);
        const double middle = (channel_top_[channel] + channel_bottom_[channel] + strips) / 2.0;
        return middle +
               style::kTrackGap * (static_cast<double>(track) - static_cast<double>(routes_[channel].tracks - 1) / 2.0);
    }

    // From one end of a wire to another, without the verticals beyond its ends.
    void cross(std::vector<DrawPoint>& points, const EndPlace& from, const EndPlace& to, bool from_top,
               bool to_top) const {
        const WireRoute& route = routes_[from.channel].wires[from.wire];
        if (route.track < 0) return; // one straight vertical
        const double upper = track_y(from.channel, route.track);
        const double lower = route.knee ? track_y(from.channel, route.knee->track) : upper;
        points.push_back({from.x, from_top ? upper : lower});
        if (route.knee && from_top != to_top) {
            points.push_back({route.knee->x, from_top ? upper : lower});
            points.push_back({route.knee->x, from_top ? lower : upper});
        }
        points.push_back({to.x, to_top ? upper : lower});
    }

    std::vector<DrawPoint> points_of(const LayeredMatrix::Path& path, DrawnLine& line) const {
        line.upwards = path.upwards;
        std::vector<DrawPoint> points;
        const DrawRect& later = drawing_.boxes[line.later].rect;
        const DrawRect& earlier = drawing_.boxes[line.earlier].rect;
        const std::size_t last = path.nodes.size() - 1;
        points.push_back({end_at({path.nodes.front(), path.net, true}, path.nodes[1]).x, later.bottom()});
        for (std::size_t k = 0; k < last; ++k) {
            // Out of a box a line always goes from below it, into one from above it, whichever way it runs.
            const bool rises = path.upwards && k > 0;
            const bool from_top = !rises;
            const bool to_top = path.upwards && k + 1 < last;
            const EndPlace& from = end_at({path.nodes[k], path.net, from_top}, path.nodes[k + 1]);
            const EndPlace& to = end_at({path.nodes[k + 1], path.net, to_top}, path.nodes[k]);
            cross(points, from, to, from_top, to_top);
        }
        points.push_back({end_at({path.nodes.back(), path.net, false}, path.nodes[last - 1]).x, earlier.y});
        return without_needless(points);
    }

    static std::vector<DrawPoint> without_needless(const std::vector<DrawPoint>& points) {
        std::vector<DrawPoint> kept;
        kept.reserve(points.size());
        for (const DrawPoint& p : points) {
            if (!kept.empty() && kept.back() == p) continue;
            while (kept.size() >= 2) {
                const DrawPoint& a = kept[kept.size() - 2];
                const DrawPoint& b = kept.back();
                const bool on_line = (a.x == b.x && b.x == p.x) || (a.y == b.y && b.y == p.y);
                if (!on_line) break;
                kept.pop_back();
            }
            kept.push_back(p);
        }
        return kept;
    }

    // Where a vertical comes down onto a horizontal and another goes on from the same place.
    void find_junctions() {
        for (std::size_t c = 0; c < channels_.size(); ++c) {
            for (std::size_t w = 0; w < channels_[c].wires.size(); ++w) {
                const ChannelWires::ChannelWire& wire = channels_[c].wires[w];
                const WireRoute& route = routes_[c].wires[w];
                if (route.track < 0 || route.knee) continue;
                std::vector<double> tops;
                std::vector<double> all;
                for (const ChannelWires::End& e : wire.tops) tops.push_back(e.x);
                for (const ChannelWires::End& e : wire.bottoms) all.push_back(e.x);
                std::sort(tops.begin(), tops.end());
                const std::vector<double> bottoms = all;
                all.insert(all.end(), tops.begin(), tops.end());
                const auto [low, high] = std::minmax_element(all.begin(), all.end());
                for (const double x : bottoms) {
                    if (x > *low && x < *high && std::binary_search(tops.begin(), tops.end(), x)) {
                        drawing_.junctions.push_back({x, track_y(c, route.track)});
                    }
                }
            }
        }
    }

    void place_bands() {
        for (std::size_t b = 0; b < graph_.bands.size(); ++b) {
            const auto first = static_cast<std::size_t>(m_.band_begin[b]);
            const auto after = static_cast<std::size_t>(m_.band_begin[b + 1]);
            DrawnBand band;
            band.id = graph_.bands[b].id;
            band.heading = graph_.bands[b].heading;
            band.rect.y = edge_y(first);
            band.rect.height = edge_y(after) - band.rect.y;
            if (band.rect.height > 0.0) drawing_.bands.push_back(std::move(band));
        }
    }

    void place_frames() {
        for (const LayeredMatrix::Frame& f : m_.frames) {
            DrawnFrame frame;
            frame.id = graph_.groups[static_cast<std::size_t>(f.group)].id;
            frame.heading = graph_.groups[static_cast<std::size_t>(f.group)].heading;
            const double top = level_top_[static_cast<std::size_t>(f.first_level)] - style::kFramePad;
            const double bottom = level_bottom_[static_cast<std::size_t>(f.last_level)] + style::kFramePad;
            frame.rect = {f.left, top, f.right - f.left, bottom - top};
            drawing_.frames.push_back(std::move(frame));
        }
    }

    const DrawnGraph& graph_;
    const LayeredMatrix& m_;
    const std::vector<ChannelWires>& channels_;
    MatrixDrawing drawing_;
    std::vector<ChannelRoute> routes_;
    std::vector<double> channel_top_; // [pt]
    std::vector<double> channel_bottom_;
    std::vector<double> level_top_;
    std::vector<double> level_bottom_;
    std::vector<std::pair<EndKey, EndPlace>> ends_; // sorted
};

} // namespace

MatrixDrawing PlanumEngine::draw(const LayoutRequest& request, Progress& progress) const {
    progress.step("drawing the matrix");
    DrawnGraph graph = make_drawn_graph(request);
    const Ranking ranking = rank_boxes(graph);
    const std::vector<Net> nets = bundle_orders(graph, ranking);
    widen_for_ports(graph, nets);
    const LayeredMatrix matrix = place_on_levels(graph, ranking, nets, progress);
    const std::vector<ChannelWires> channels = make_wires(matrix, graph);
    MatrixDrawing drawing = Assembler(graph, matrix, channels).assemble(progress);
    drawing.engine = name();
    finish_page(drawing, graph, request.text);
    return drawing;
}

} // namespace planum::strat
