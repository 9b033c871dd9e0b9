// SPDX-License-Identifier: MIT
#include "gui/viewmodels/space_contents.hpp"

#include <algorithm>
#include <optional>

#include "app/regions/region_layout.hpp"
#include "app/regions/region_names.hpp"
#include "gui/viewmodels/time_model.hpp"
#include "gui/viewmodels/words.hpp"

namespace planum::gui {

/// A surface or section, its scans or its outlines, or one of these.
struct SpaceContents::Node {
    Node* parent = nullptr;
    int row = 0;
    QString text;
    QString why_not;          ///< it cannot be shown; empty: it can
    Uuid place;               ///< of the surface or section
    std::optional<Kind> kind; ///< unset: surface or section
    Uuid thing;               ///< scan or region; nil above
    std::vector<std::unique_ptr<Node>> children;

    Node& add(QString name) {
        auto child = std::make_unique<Node>();
        child->parent = this;
        child->row = static_cast<int>(children.size());
        child->text = std::move(name);
        child->place = place;
        child->kind = kind;
        children.push_back(std::move(child));
        return *children.back();
    }

    friend bool same(const Node& a, const Node& b) {
        return a.text == b.text && a.why_not == b.why_not && a.place == b.place && a.thing == b.thing &&
               std::equal(a.children.begin(), a.children.end(), b.children.begin(), b.children.end(),
                          [](const auto& x, const auto& y) { return same(*x, *y); });
    }
};

SpaceContents::SpaceContents(Workspace& workspace, TimeModel& time, QObject* parent)
    : QAbstractItemModel(parent), workspace_(workspace), time_(time), root_(std::make_unique<Node>()) {
    connect(&time_, &TimeModel::moved, this, &SpaceContents::take_time);
    connect(&time_, &TimeModel::changed, this, &SpaceContents::refresh);
    connect(&workspace_, &Workspace::snapshotChanged, this, &SpaceContents::refresh);
    connect(&workspace_, &Workspace::closed, this, [this] {
        groups_.clear();
        things_.clear();
        refresh();
        emit choiceChanged();
    });
    refresh();
}

SpaceContents::~SpaceContents() = default;

void SpaceContents::set_all_surfaces(bool all) {
    if (all == all_) return;
    all_ = all;
    tell();
    emit scansChanged();
}

void SpaceContents::follow_time_line() {
    if (!is_chosen()) return;
    groups_.clear();
    things_.clear();
    tell();
    emit scansChanged();
    emit outlinesChanged();
    emit choiceChanged();
}

// Who goes to a surface wants to see it, though it was cleared before; single things that were cleared stay so.
void SpaceContents::take_time() {
    const Uuid now = time_.surface().value;
    for (const Kind kind : {Kind::Scans, Kind::Outlines}) {
        const auto found = groups_.find({now, kind});
        if (found != groups_.end() && !found->second) groups_.erase(found);
    }
    tell();
    emit scansChanged();
    emit outlinesChanged();
    emit choiceChanged();
}

void SpaceContents::add_scans(Node& place, model::SurfaceId surface) const {
    const model::Record& record = workspace_.snapshot()->record();
    Node& group = place.add(tr("Scans"));
    group.kind = Kind::Scans;
    for (const model::Scan& scan : record.scans) {
        if (scan.surface != surface) continue;
        Node& node = group.add(qt(scan.name).section(QLatin1Char('/'), -1));
        node.thing = scan.id.value;
        if (model::pose_in_force(record, scan.id) == nullptr) node.why_not = tr("it is not on the site grid yet");
    }
    if (group.children.empty()) place.children.pop_back();
}

void SpaceContents::add_outlines(Node& place, Kind kind) const {
    const app::Snapshot& snapshot = *workspace_.snapshot();
    Node& group = place.add(tr("Outlines"));
    group.kind = kind;
    for (const model::Region& region : snapshot.record().regions) {
        if (group_of(region) != GroupKey{place.place, kind}) continue;
        QString name = outline_word(snapshot.index(), region);
        if (region.part > 1) name += QStringLiteral(" #%1").arg(region.part);
        Node& node = group.add(name);
        node.thing = region.id.value;
        if (!region.has_heights) node.why_not = tr("it has no heights");
    }
    if (group.children.empty()) place.children.pop_back();
}

void SpaceContents::refresh() {
    auto root = std::make_unique<Node>();
    if (workspace_.is_open()) {
        for (const TimeModel::Stop& stop : time_.stops()) {
            Node& place = root->add(stop.name);
            place.place = stop.surface.value;
            add_scans(place, stop.surface);
            add_outlines(place, Kind::Outlines);
        }
        for (const model::Section& section : workspace_.snapshot()->record().sections) {
            Node& place = root->add(tr("section %1").arg(qt(section.name)));
            place.place = section.id.value;
            add_outlines(place, Kind::UprightOutlines);
            if (place.children.empty()) root->children.pop_back();
        }
    }
    if (same(*root, *root_)) return tell(); // a view keeps what is open in it
    beginResetModel();
    root_ = std::move(root);
    endResetModel();
}

SpaceContents::GroupKey SpaceContents::group_of(const model::Region& region) {
    return region.surface.is_nil() ? GroupKey{region.section.value, Kind::UprightOutlines}
                                   : GroupKey{region.surface.value, Kind::Outlines};
}

bool SpaceContents::shows(Uuid thing, const GroupKey& group) const {
    if (const auto chosen = things_.find(thing); chosen != things_.end()) return chosen->second;
    if (const auto chosen = groups_.find(group); chosen != groups_.end()) return chosen->second;
    switch (group.second) {
    case Kind::Scans: return all_ || group.first == time_.surface().value;
    case Kind::Outlines: return group.first == time_.surface().value;
    case Kind::UprightOutlines: return true; // a section stands through all surfaces
    }
    return false;
}

bool SpaceContents::shows(const model::Scan& scan) const {
    return shows(scan.id.value, {scan.surface.value, Kind::Scans});
}

bool SpaceContents::shows(const model::Region& region) const {
    return region.has_heights && shows(region.id.value, group_of(region));
}

bool SpaceContents::can_be_shown(const Node& node) {
    if (node.children.empty()) return node.thing != Uuid{} && node.why_not.isEmpty();
    return std::any_of(node.children.begin(), node.children.end(), [](const auto& one) { return can_be_shown(*one); });
}

Qt::CheckState SpaceContents::state_of(const Node& node) const {
    if (node.children.empty()) {
        const bool shown = can_be_shown(node) && shows(node.thing, {node.place, *node.kind});
        return shown ? Qt::Checked : Qt::Unchecked;
    }
    std::optional<Qt::CheckState> all;
    for (const auto& child : node.children) {
        if (!can_be_shown(*child)) continue;
        const Qt::CheckState state = state_of(*child);
        if (all && *all != state) return Qt::PartiallyChecked;
        all = state;
    }
    return all.value_or(Qt::Unchecked);
}

void SpaceContents::choose(const Node& node, bool on) {
    if (node.thing != Uuid{}) {
        things_[node.thing] = on;
        return;
    }
    if (node.kind) groups_[{node.place, *node.kind}] = on;
    for (const auto& child : node.children) {
        if (child->thing != Uuid{}) {
            things_.erase(child->thing);
        } else {
            choose(*child, on);
        }
    }
}

// All checks may be others: those of what is above and below too.
void SpaceContents::tell() {
    const auto go = [this](const auto& self, const Node& node, const QModelIndex& at) -> void {
        if (node.children.empty()) return;
        emit dataChanged(index(0, 0, at), index(static_cast<int>(node.children.size()) - 1, 0, at),
                         {Qt::CheckStateRole});
        for (const auto& child : node.children) self(self, *child, index(child->row, 0, at));
    };
    go(go, *root_, {});
}

QModelIndex SpaceContents::index(int row, int column, const QModelIndex& parent) const {
    const Node* above = parent.isValid() ? static_cast<const Node*>(parent.internalPointer()) : root_.get();
    if (column != 0 || row < 0 || row >= static_cast<int>(above->children.size())) return {};
    return createIndex(row, column, above->children[static_cast<std::size_t>(row)].get());
}

QModelIndex SpaceContents::parent(const QModelIndex& child) const {
    if (!child.isValid()) return {};
    Node* above = static_cast<const Node*>(child.internalPointer())->parent;
    return above == nullptr || above == root_.get() ? QModelIndex() : createIndex(above->row, 0, above);
}

int SpaceContents::rowCount(const QModelIndex& parent) const {
    const Node* node = parent.isValid() ? static_cast<const Node*>(parent.internalPointer()) : root_.get();
    return static_cast<int>(node->children.size());
}

int SpaceContents::columnCount(const QModelIndex& /*parent*/) const { return 1; }

QVariant SpaceContents::data(const QModelIndex& index, int role) const {
    if (!index.isValid()) return {};
    const Node& node = *static_cast<const Node*>(index.internalPointer());
    switch (role) {
    case Qt::DisplayRole:
        return node.why_not.isEmpty() ? node.text : QStringLiteral("%1 (%2)").arg(node.text, node.why_not);
    case Qt::CheckStateRole: return static_cast<int>(state_of(node));
    case PlaceIdRole: return qt(node.place.to_string());
    default: return {};
    }
}

Qt::ItemFlags SpaceContents::flags(const QModelIndex& index) const {
    if (!index.isValid()) return Qt::NoItemFlags;
    const Qt::ItemFlags seen = Qt::ItemIsSelectable | Qt::ItemIsUserCheckable;
    return can_be_shown(*static_cast<const Node*>(index.internalPointer())) ? seen | Qt::ItemIsEnabled : seen;
}

bool SpaceContents::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (!index.isValid() || role != Qt::CheckStateRole) return false;
    const Node& node = *static_cast<const Node*>(index.internalPointer());
    if (!can_be_shown(node)) return false;
    choose(node, value.toInt() != Qt::Unchecked);
    tell();
    if (!node.kind || node.kind == Kind::Scans) emit scansChanged();
    if (node.kind != Kind::Scans) emit outlinesChanged();
    emit choiceChanged();
    return true;
}

QModelIndex SpaceContents::current() const {
    for (const auto& place : root_->children) {
        if (place->place == time_.surface().value) return createIndex(place->row, 0, place.get());
    }
    return {};
}

} // namespace planum::gui
