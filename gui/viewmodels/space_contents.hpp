// SPDX-License-Identifier: MIT
#pragma once

#include <QAbstractItemModel>
#include <QString>

#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "core/model/record.hpp"
#include "gui/viewmodels/workspace.hpp"

namespace planum::gui {

class TimeModel;

/// What of the site 3D shows: a tree of surfaces (and sections), of their scans and outlines, each with a check. By
/// itself that is what the time line stands on; what somebody checks or clears stays so, wherever the time line goes,
/// until follow_time_line().
class SpaceContents : public QAbstractItemModel {
    Q_OBJECT

  public:
    enum Role { PlaceIdRole = Qt::UserRole + 1 }; ///< of the surface or section, as text: the same after a change

    SpaceContents(Workspace& workspace, TimeModel& time, QObject* parent = nullptr);
    ~SpaceContents() override;

    /// Scans of all surfaces at once instead of those of one, where nobody chose otherwise.
    void set_all_surfaces(bool all);
    /// Forgets what was checked and cleared.
    void follow_time_line();

    /// Something was checked or cleared by hand.
    [[nodiscard]] bool is_chosen() const noexcept { return !groups_.empty() || !things_.empty(); }

    [[nodiscard]] bool shows(const model::Scan& scan) const;
    [[nodiscard]] bool shows(const model::Region& region) const;

    [[nodiscard]] QModelIndex index(int row, int column, const QModelIndex& parent) const override;
    [[nodiscard]] QModelIndex parent(const QModelIndex& child) const override;
    [[nodiscard]] int rowCount(const QModelIndex& parent) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
    /// Checks or clears a scan, an outline, or all that is below.
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;

    /// The row of what the time line stands on; invalid: none.
    [[nodiscard]] QModelIndex current() const;

  signals:
    void scansChanged();
    void outlinesChanged();
    /// is_chosen() is other.
    void choiceChanged();

  private:
    enum class Kind { Scans, Outlines, UprightOutlines };
    using GroupKey = std::pair<Uuid, Kind>; ///< of a surface or section
    struct Node;

    void refresh();
    void add_scans(Node& place, model::SurfaceId surface) const;
    void add_outlines(Node& place, Kind kind) const;
    [[nodiscard]] static GroupKey group_of(const model::Region& region);
    void take_time();
    [[nodiscard]] bool shows(Uuid thing, const GroupKey& group) const;
    void choose(const Node& node, bool on);
    void tell();
    [[nodiscard]] Qt::CheckState state_of(const Node& node) const;
    [[nodiscard]] static bool can_be_shown(const Node& node);

    Workspace& workspace_;
    TimeModel& time_;
    bool all_ = false;
    std::unique_ptr<Node> root_;
    std::map<GroupKey, bool> groups_; ///< chosen by hand
    std::map<Uuid, bool> things_;     ///< scans and outlines chosen by hand; they go before their group
};

} // namespace planum::gui
