// SPDX-License-Identifier: MIT
#include "gui/viewmodels/outline_edit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "app/regions/outline.hpp"
#include "app/regions/redraw_region.hpp"
#include "app/regions/region_names.hpp"
#include "core/base/error.hpp"
#include "core/geometry/polygons.hpp"
#include "gui/viewmodels/service_sentences.hpp"
#include "gui/viewmodels/words.hpp"

namespace planum::gui {

namespace {

constexpr std::size_t kLeastCorners = 3;

double apart(QPointF a, QPointF b) { return std::hypot(a.x() - b.x(), a.y() - b.y()); }

const model::Region* region_of(const app::Snapshot& snapshot, model::RegionId id) {
    const auto& regions = snapshot.record().regions;
    const auto found = std::find_if(regions.begin(), regions.end(), [&](const auto& one) { return one.id == id; });
    return found == regions.end() ? nullptr : &*found;
}

// Points first … last of a closed ring, going round, by their places in it.
std::vector<std::size_t> run(std::size_t first, std::size_t last, std::size_t size) {
    std::vector<std::size_t> places = {first};
    for (std::size_t i = first; i != last;) {
        i = (i + 1) % size;
        places.push_back(i);
    }
    return places;
}

// Which points of a run remain when all that is straight in the view goes; both ends do.
std::vector<std::size_t> bends(const std::vector<QPointF>& at, const std::vector<std::size_t>& places,
                               double straight) {
    geometry::Line3 line; // the height carries the place in the ring
    for (const std::size_t i : places) line.push_back({at[i].x(), at[i].y(), static_cast<double>(i)});
    std::vector<std::size_t> kept;
    for (const auto& p : geometry::simplified(line, straight)) kept.push_back(static_cast<std::size_t>(p[2]));
    return kept;
}

// Bends of a ring that is wholly seen: halves between two points far apart, and the first only if it is a bend too.
std::vector<std::size_t> bends_of_ring(const std::vector<QPointF>& at, double straight) {
    const auto far =
        std::max_element(at.begin(), at.end(), [&](QPointF a, QPointF b) { return apart(a, at[0]) < apart(b, at[0]); });
    const auto other = static_cast<std::size_t>(far - at.begin());
    // From the far point on, so that it is certainly a bend; the first point is found out about like any other.
    const auto opposite = std::max_element(
        at.begin(), at.end(), [&](QPointF a, QPointF b) { return apart(a, at[other]) < apart(b, at[other]); });
    const auto turn = static_cast<std::size_t>(opposite - at.begin());
    std::vector<std::size_t> kept = bends(at, run(other, turn, at.size()), straight);
    const std::vector<std::size_t> rest = bends(at, run(turn, other, at.size()), straight);
    kept.insert(kept.end(), rest.begin() + 1, rest.end() - 1);
    std::sort(kept.begin(), kept.end());
    return kept;
}

} // namespace

OutlineEdit::Ring corners_of(const geometry::Line3& ring, const EditGround& ground) {
    OutlineEdit::Ring corners;
    if (ring.size() < kLeastCorners) return corners;
    std::vector<QPointF> at;
    bool all_seen = true;
    for (const auto& p : ring) {
        const auto place = ground.to_view(p);
        all_seen = all_seen && place.has_value();
        at.push_back(place.value_or(QPointF(std::nan(""), std::nan(""))));
    }
    std::vector<std::size_t> kept;
    if (all_seen) {
        kept = bends_of_ring(at, ground.straight);
    } else { // where it leaves the view every point stays
        for (std::size_t i = 0; i < ring.size(); ++i) kept.push_back(i);
    }
    for (std::size_t k = 0; k < kept.size(); ++k) {
        const QPointF place = at[kept[k]];
        corners.push_back({place, !std::isnan(place.x()), kept[k], kept[(k + 1) % kept.size()]});
    }
    return corners;
}

geometry::Line3 ring_of(const OutlineEdit::Ring& corners, const geometry::Line3& original, const EditGround& ground) {
    geometry::Line3 ring;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const OutlineEdit::Corner& from = corners[i];
        const OutlineEdit::Corner& to = corners[(i + 1) % corners.size()];
        if (from.original && from.runs_to && from.runs_to == to.original) {
            const auto places = run(*from.original, *to.original, original.size());
            for (std::size_t k = 0; k + 1 < places.size(); ++k) ring.push_back(original[places[k]]);
            continue;
        }
        geometry::Line3 line;
        if (from.seen && to.seen) {
            line = ground.to_site(from.at, to.at);
        } else { // one end is not in the view, and stays where it was
            const auto place = [&](const OutlineEdit::Corner& corner) {
                return corner.original ? original[*corner.original] : ground.to_site(corner.at, corner.at).front();
            };
            line = {place(from), place(to)};
        }
        if (from.original) line.front() = original[*from.original];
        ring.insert(ring.end(), line.begin(), line.end() - 1);
    }
    return ring;
}

OutlineEdit::OutlineEdit(Workspace& workspace, QObject* parent) : QObject(parent), workspace_(workspace) {
    connect(&workspace_, &Workspace::closed, this, &OutlineEdit::end);
    connect(&workspace_, &Workspace::snapshotChanged, this, [this] {
        if (region_.is_nil()) return;
        const model::Region* now = region_of(*workspace_.snapshot(), region_);
        if (now == nullptr) return choose({});
        if (app::shape_of(now->outline) == shape_ && now->has_heights == has_heights_) return;
        load(); // drawn anew, here or elsewhere
        emit changed();
    });
}

void OutlineEdit::begin(const QString& view, EditGround ground) {
    view_ = view;
    ground_ = std::move(ground);
    choose({});
}

void OutlineEdit::end() { begin({}, {}); }

void OutlineEdit::choose(model::RegionId region) {
    region_ = region;
    load();
    emit changed();
}

void OutlineEdit::forget_steps() {
    past_.clear();
    future_.clear();
    held_.reset();
    grabbed_now_ = false;
}

void OutlineEdit::load() {
    forget_steps();
    rings_.clear();
    shape_.clear();
    if (region_.is_nil() || !workspace_.is_open() || !ground_.to_view) return;
    const model::Region* region = region_of(*workspace_.snapshot(), region_);
    if (region == nullptr) return;
    shape_ = app::shape_of(region->outline);
    has_heights_ = region->has_heights;
    for (const geometry::Rings& polygon : app::shape_with_heights(*region)) {
        for (const geometry::Line3& ring : polygon) rings_.push_back(corners_of(ring, ground_));
    }
}

std::optional<OutlineEdit::Handle> OutlineEdit::corner_at(QPointF place, double reach) const {
    std::optional<Handle> best;
    for (std::size_t r = 0; r < rings_.size(); ++r) {
        for (std::size_t c = 0; c < rings_[r].size(); ++c) {
            const double away = apart(rings_[r][c].at, place);
            if (!rings_[r][c].seen || away > reach) continue;
            reach = away;
            best = Handle{r, c};
        }
    }
    return best;
}

std::optional<QPointF> OutlineEdit::middle_of(Handle line) const {
    const Ring& ring = rings_[line.ring];
    const Corner& from = ring[line.corner];
    const Corner& to = ring[(line.corner + 1) % ring.size()];
    if (!from.seen || !to.seen) return std::nullopt;
    if (ground_.period > 0.0 && std::abs(from.at.x() - to.at.x()) > ground_.period / 2.0) return std::nullopt;
    return (from.at + to.at) / 2.0;
}

std::optional<OutlineEdit::Handle> OutlineEdit::middle_at(QPointF place, double reach) const {
    std::optional<Handle> best;
    for (std::size_t r = 0; r < rings_.size(); ++r) {
        for (std::size_t c = 0; c < rings_[r].size(); ++c) {
            const auto middle = middle_of({r, c});
            if (!middle || apart(*middle, place) > reach) continue;
            reach = apart(*middle, place);
            best = Handle{r, c};
        }
    }
    return best;
}

void OutlineEdit::step() {
    past_.push_back(rings_);
    future_.clear();
    grabbed_now_ = false;
}

void OutlineEdit::hold(std::optional<Handle> corner) {
    held_ = corner;
    emit changed();
}

void OutlineEdit::grab(Handle corner) {
    held_ = corner;
    grabbed_now_ = true;
    emit changed();
}

void OutlineEdit::move(QPointF to) {
    if (!held_) return;
    if (grabbed_now_) step();
    Ring& ring = rings_[held_->ring];
    Corner& corner = ring[held_->corner];
    corner.at = to;
    corner.original.reset();
    corner.runs_to.reset();
    emit changed();
}

void OutlineEdit::insert(Handle line, QPointF at) {
    step();
    Ring& ring = rings_[line.ring];
    ring[line.corner].runs_to.reset();
    const auto place = ring.begin() + static_cast<std::ptrdiff_t>(line.corner) + 1;
    ring.insert(place, Corner{at, true, {}, {}});
    held_ = Handle{line.ring, line.corner + 1};
    emit changed();
}

bool OutlineEdit::can_remove() const { return held_ && rings_[held_->ring].size() > kLeastCorners; }

void OutlineEdit::remove(Handle corner) {
    if (rings_[corner.ring].size() <= kLeastCorners) return;
    step();
    Ring& ring = rings_[corner.ring];
    ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(corner.corner));
    held_.reset();
    emit changed();
}

void OutlineEdit::take_back() {
    if (past_.empty()) return;
    future_.push_back(std::exchange(rings_, std::move(past_.back())));
    past_.pop_back();
    held_.reset();
    emit changed();
}

void OutlineEdit::take_forward() {
    if (future_.empty()) return;
    past_.push_back(std::exchange(rings_, std::move(future_.back())));
    future_.pop_back();
    held_.reset();
    emit changed();
}

void OutlineEdit::cancel() {
    if (region_.is_nil()) return end();
    if (!is_changed()) return choose({});
    while (!past_.empty()) {
        future_.push_back(std::exchange(rings_, std::move(past_.back())));
        past_.pop_back();
    }
    held_.reset();
    emit changed();
}

void OutlineEdit::finish() {
    if (region_.is_nil() || !is_changed()) return;
    auto name = std::make_shared<QString>();
    auto mended = std::make_shared<QStringList>();
    const model::Region* before = region_of(*workspace_.snapshot(), region_);
    if (before == nullptr) return;
    const geometry::MultiPolygon known = app::shape_with_heights(*before);
    workspace_.edit(
        tr("Change an outline"),
        [region = region_, shape = shape_, known, rings = rings_, ground = ground_, name, mended](app::Project& project,
                                                                                                  Progress& progress) {
            geometry::MultiPolygon drawn;
            std::size_t r = 0;
            for (const geometry::Rings& polygon : known) {
                geometry::Rings made;
                for (const geometry::Line3& ring : polygon) {
                    progress.check();
                    made.push_back(ring_of(rings[r++], ring, ground));
                }
                drawn.push_back(std::move(made));
            }
            if (ground.heights) ground.heights(project, drawn, progress);
            geometry::take_heights(drawn, known);
            for (const std::string& one : app::redraw_region(project, region, shape, drawn))
                *mended << service_sentence(one);
            const auto& regions = project.record().regions;
            const auto found =
                std::find_if(regions.begin(), regions.end(), [&](const auto& one) { return one.id == region; });
            *name = qt(app::region_name(project.record(), project.index(), *found));
        },
        [this, name, mended] { emit finished(*name, *mended); });
}

QString OutlineEdit::sentence() const {
    if (region_.is_nil()) return tr("Choose the outline that shall be changed: click into it.");
    if (rings_.empty() || std::none_of(rings_.begin(), rings_.end(), [](const Ring& ring) { return !ring.empty(); }))
        return tr("This outline cannot be seen here.");
    return tr("Drag a corner, or the middle of a line for a new one; Delete takes a corner away.");
}

} // namespace planum::gui
