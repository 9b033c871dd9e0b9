// SPDX-License-Identifier: MIT
#include "strat/layout/read_back.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace planum::strat {

namespace {

// Two strokes nearer than this look like one [pt].
constexpr double kSame = 0.3;

using Stroke = AxisStroke;

class Reader {
  public:
    explicit Reader(const MatrixDrawing& drawing) : d_(drawing) {}

    ReadBack read() {
        if (!collect()) return std::move(out_);
        check_boxes();
        upright_ = joined_strokes(std::move(upright_), kSame);
        level_ = joined_strokes(std::move(level_), kSame);
        check_lines_through_boxes();
        connect();
        attach();
        return std::move(out_);
    }

  private:
    void fault(std::string what) {
        constexpr std::size_t kEnough = 50;
        if (out_.faults.size() < kEnough) out_.faults.push_back(std::move(what));
    }

    // False where numbers are missing, so that nothing else can be read.
    bool collect() {
        bool good = std::isfinite(d_.width) && std::isfinite(d_.height);
        for (const DrawnBox& box : d_.boxes) {
            const DrawRect& r = box.rect;
            if (std::isfinite(r.x) && std::isfinite(r.y) && std::isfinite(r.width) && std::isfinite(r.height)) continue;
            fault("the place of " + box.id + " is no number");
            good = false;
        }
        for (const DrawnLine& line : d_.lines) {
            if (line.points.size() < 2) fault(line.id + " has no line");
            for (std::size_t i = 1; i < line.points.size(); ++i) {
                const DrawPoint& a = line.points[i - 1];
                const DrawPoint& b = line.points[i];
                if (!std::isfinite(a.x + a.y + b.x + b.y)) {
                    fault("a point of " + line.id + " is no number");
                    good = false;
                } else if (std::abs(a.x - b.x) < 1e-6) {
                    upright_.push_back({a.x, std::min(a.y, b.y), std::max(a.y, b.y)});
                } else if (std::abs(a.y - b.y) < 1e-6) {
                    level_.push_back({a.y, std::min(a.x, b.x), std::max(a.x, b.x)});
                } else {
                    fault(line.id + " slants");
                }
            }
        }
        return good;
    }

    // Boxes sorted by their upper edge; only those that can still reach down are compared.
    void check_boxes() {
        std::vector<std::size_t> order(d_.boxes.size());
        for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
        std::sort(order.begin(), order.end(),
                  [&](std::size_t a, std::size_t b) { return d_.boxes[a].rect.y < d_.boxes[b].rect.y; });
        std::vector<std::size_t> open;
        for (const std::size_t i : order) {
            const DrawRect& r = d_.boxes[i].rect;
            std::erase_if(open, [&](std::size_t j) { return d_.boxes[j].rect.bottom() <= r.y; });
            for (const std::size_t j : open) {
                const DrawRect& s = d_.boxes[j].rect;
                if (r.x < s.right() && s.x < r.right()) fault(d_.boxes[i].id + " overlaps " + d_.boxes[j].id);
            }
            open.push_back(i);
            if (r.x < 0.0 || r.y < 0.0 || r.right() > d_.width || r.bottom() > d_.height)
                fault(d_.boxes[i].id + " leaves the page");
            for (const double w : d_.boxes[i].line_widths) {
                if (w > r.width) fault("the label of " + d_.boxes[i].id + " is cut off");
            }
        }
    }

    void check_lines_through_boxes() {
        for (const DrawnBox& box : d_.boxes) {
            const DrawRect& r = box.rect;
            const auto inside = [](const std::vector<Stroke>& strokes, double at0, double at1, double low,
                                   double high) {
                auto s = std::lower_bound(strokes.begin(), strokes.end(), Stroke{at0 + kSame, -1e300, -1e300});
                for (; s != strokes.end() && s->at < at1 - kSame; ++s) {
                    if (s->low < high - kSame && s->high > low + kSame) return true;
                }
                return false;
            };
            if (inside(upright_, r.x, r.right(), r.y, r.bottom()) || inside(level_, r.y, r.bottom(), r.x, r.right())) {
                fault("a line runs through " + box.id);
            }
        }
    }

    std::size_t find(std::size_t i) {
        while (leader_[i] != i) {
            leader_[i] = leader_[leader_[i]];
            i = leader_[i];
        }
        return i;
    }

    [[nodiscard]] bool has_dot(double x, double y) const {
        const auto at = std::lower_bound(dots_.begin(), dots_.end(), std::pair{x - kSame, -1e300});
        for (auto d = at; d != dots_.end() && d->first < x + kSame; ++d) {
            if (std::abs(d->second - y) < kSame) return true;
        }
        return false;
    }

    void connect() {
        for (const DrawPoint& p : d_.junctions) dots_.push_back({p.x, p.y});
        std::sort(dots_.begin(), dots_.end());
        leader_.resize(upright_.size() + level_.size());
        for (std::size_t i = 0; i < leader_.size(); ++i) leader_[i] = i;
        for (std::size_t l = 0; l < level_.size(); ++l) {
            const Stroke& h = level_[l];
            auto v = std::lower_bound(upright_.begin(), upright_.end(), Stroke{h.low - kSame, -1e300, -1e300});
            for (; v != upright_.end() && v->at <= h.high + kSame; ++v) {
                if (v->high < h.at - kSame || v->low > h.at + kSame) continue;
                const bool v_goes_on = v->low < h.at - kSame && v->high > h.at + kSame;
                const bool h_goes_on = h.low < v->at - kSame && h.high > v->at + kSame;
                if (v_goes_on && h_goes_on && !has_dot(v->at, h.at)) continue;
                const std::size_t a = find(static_cast<std::size_t>(v - upright_.begin()));
                const std::size_t b = find(upright_.size() + l);
                leader_[std::max(a, b)] = std::min(a, b);
            }
        }
    }

    // Only uprights touch boxes, at their lower and upper edges.
    void attach() {
        std::map<std::size_t, std::set<std::size_t>> later;
        std::map<std::size_t, std::set<std::size_t>> earlier;
        for (std::size_t b = 0; b < d_.boxes.size(); ++b) {
            const DrawRect& r = d_.boxes[b].rect;
            auto v = std::lower_bound(upright_.begin(), upright_.end(), Stroke{r.x, -1e300, -1e300});
            for (; v != upright_.end() && v->at <= r.right(); ++v) {
                const std::size_t group = find(static_cast<std::size_t>(v - upright_.begin()));
                if (std::abs(v->low - r.bottom()) < kSame) later[group].insert(b);
                if (std::abs(v->high - r.y) < kSame) earlier[group].insert(b);
            }
        }
        for (std::size_t i = 0; i < leader_.size(); ++i) {
            const std::size_t group = find(i);
            if (group != i) continue;
            if (later[group].empty() || earlier[group].empty()) {
                const DrawPoint at = i < upright_.size()
                                         ? DrawPoint{upright_[i].at, upright_[i].low}
                                         : DrawPoint{level_[i - upright_.size()].low, level_[i - upright_.size()].at};
                fault(fmt::format("a line at {:.1f}, {:.1f} hangs in the air", at.x, at.y));
            }
            for (const std::size_t u : later[group]) {
                for (const std::size_t v : earlier[group]) out_.orders.push_back({u, v});
            }
        }
        std::sort(out_.orders.begin(), out_.orders.end());
        out_.orders.erase(std::unique(out_.orders.begin(), out_.orders.end()), out_.orders.end());
    }

    const MatrixDrawing& d_;
    ReadBack out_;
    std::vector<Stroke> upright_;
    std::vector<Stroke> level_;
    std::vector<std::pair<double, double>> dots_;
    std::vector<std::size_t> leader_; // uprights first, then levels
};

} // namespace

ReadBack read_back(const MatrixDrawing& drawing) { return Reader(drawing).read(); }

} // namespace planum::strat
