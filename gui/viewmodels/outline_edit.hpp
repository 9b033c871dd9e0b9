// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <QPointF>
#include <QString>

#include <functional>
#include <optional>
#include <vector>

#include "core/geometry/gpb.hpp"
#include "gui/viewmodels/region_shapes.hpp"
#include "gui/viewmodels/workspace.hpp"

namespace planum::gui {

/// How a view and the site go together, for outlines that are changed on it. Unset functions: nothing can be changed.
struct EditGround {
    /// Where a place of the site [m] stands in the view; nullopt: not to be seen in it. Its z is NaN where the outline
    /// has no heights.
    std::function<std::optional<QPointF>(const geometry::Point3&)> to_view;
    /// A straight line of the view on the ground, both ends included; runs in a thread. A height of NaN is taken from
    /// heights(), else from the outline. Throws Error where nothing is to be seen.
    std::function<geometry::Line3(QPointF from, QPointF to)> to_site;
    /// Gives points whose height is NaN that of the ground, where it is known; in a thread. Unset: the view does not
    /// know.
    std::function<void(app::Project&, geometry::MultiPolygon&, Progress&)> heights;
    double period = 0.0;    ///< a view around the horizon comes back to itself after so much to the right; 0: none
    double straight = 0.03; ///< what lies so near to a line between two corners is no corner, as the view counts
};

/// An outline of the record while its corners are moved, set and taken away. What was not touched stays to the last
/// digit: lines that a panorama followed over the ground have many points, of which only the corners show.
class OutlineEdit : public QObject {
    Q_OBJECT

  public:
    struct Corner {
        QPointF at;                          ///< as the view counts
        bool seen = true;                    ///< false: not in the view; stays as it is
        std::optional<std::size_t> original; ///< point of the ring as it was; unset: moved or new
        std::optional<std::size_t> runs_to;  ///< original point to which its line runs untouched
    };

    using Ring = std::vector<Corner>;

    /// A corner, or the line that begins there.
    struct Handle {
        std::size_t ring = 0;
        std::size_t corner = 0;

        friend bool operator==(const Handle&, const Handle&) = default;
    };

    explicit OutlineEdit(Workspace& workspace, QObject* parent = nullptr);

    /// A view takes it up; choose() says then which region.
    void begin(const QString& view, EditGround ground);
    void end();

    [[nodiscard]] bool is_active(const QString& view) const { return view_ == view && !view_.isEmpty(); }

    void choose(model::RegionId region);

    /// Nil: none yet.
    [[nodiscard]] model::RegionId region() const noexcept { return region_; }

    [[nodiscard]] bool is_changed() const noexcept { return !past_.empty(); }

    [[nodiscard]] const std::vector<Ring>& rings() const noexcept { return rings_; }

    [[nodiscard]] std::optional<Handle> corner_at(QPointF place, double reach) const;
    /// The line whose middle is there.
    [[nodiscard]] std::optional<Handle> middle_at(QPointF place, double reach) const;
    /// Middle of the line that begins at a corner; nullopt where it cannot be seen.
    [[nodiscard]] std::optional<QPointF> middle_of(Handle line) const;

    /// The corner that remove() takes away; grabbing sets it.
    [[nodiscard]] const std::optional<Handle>& held() const noexcept { return held_; }

    void hold(std::optional<Handle> corner);
    /// Begins a move: all until the next grab is one step back.
    void grab(Handle corner);
    void move(QPointF to);
    /// Sets a corner on a line and grabs it.
    void insert(Handle line, QPointF at);
    /// A ring keeps at least three corners.
    void remove(Handle corner);
    [[nodiscard]] bool can_remove() const;

    void take_back();
    void take_forward();
    /// Esc: back to how the outline was; take_forward brings the work back. Nothing changed: the region is let go, then
    /// the tool.
    void cancel();
    /// Hands the outline in as one undo step.
    void finish();

    /// What can be done now, in a sentence.
    [[nodiscard]] QString sentence() const;

  signals:
    void changed();
    /// Name of the region, and what was mended of its outline.
    void finished(const QString& name, const QStringList& mended);

  private:
    void forget_steps();
    void load();
    void step();

    Workspace& workspace_;
    QString view_;
    EditGround ground_;
    model::RegionId region_;
    geometry::MultiPolygon shape_; ///< as it was
    bool has_heights_ = true;      ///< of shape_
    std::vector<Ring> rings_;
    std::vector<std::vector<Ring>> past_;
    std::vector<std::vector<Ring>> future_;
    std::optional<Handle> held_;
    bool grabbed_now_ = false; ///< nothing was moved since grab()
};

/// The corners of a ring as a view shows it: where it bends by more than `ground.straight`.
[[nodiscard]] OutlineEdit::Ring corners_of(const geometry::Line3& ring, const EditGround& ground);

/// The ring that its corners say now: untouched stretches of `original`, new lines from the ground, with its
/// NaN.
[[nodiscard]] geometry::Line3 ring_of(const OutlineEdit::Ring& corners, const geometry::Line3& original,
                                      const EditGround& ground);

} // namespace planum::gui
