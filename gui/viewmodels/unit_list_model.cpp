// SPDX-License-Identifier: MIT
#include "gui/viewmodels/unit_list_model.hpp"

#include <algorithm>

#include "core/base/text.hpp"
#include "gui/viewmodels/words.hpp"

namespace planum::gui {

UnitListModel::UnitListModel(Workspace& workspace, QObject* parent)
    : QAbstractTableModel(parent), workspace_(workspace) {
    connect(&workspace_, &Workspace::snapshotChanged, this, &UnitListModel::rebuild);
    connect(&workspace_, &Workspace::closed, this, [this] {
        with_errors_.clear();
        with_warnings_.clear();
        rebuild();
    });
}

void UnitListModel::set_filter(const Filter& filter) {
    if (filter == filter_) return;
    filter_ = filter;
    rebuild();
}

void UnitListModel::set_problems(const std::vector<model::Diagnostic>& problems) {
    with_errors_.clear();
    with_warnings_.clear();
    for (const model::Diagnostic& problem : problems) {
        if (problem.severity == model::Severity::Info) continue;
        auto& units = problem.severity == model::Severity::Error ? with_errors_ : with_warnings_;
        units.insert(problem.units.begin(), problem.units.end());
    }
    if (filter_.with_problems) return rebuild();
    if (!rows_.empty()) emit dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
}

bool UnitListModel::shows(model::UnitIndex at, const std::string& typed) const {
    const model::StratigraphicUnit& unit = snapshot_->record().units[at];
    if (filter_.kind && unit.kind != *filter_.kind) return false;
    if (filter_.status && unit.status != *filter_.status) return false;
    if (!filter_.area.is_nil() && unit.area != filter_.area) return false;
    if (filter_.with_problems && !with_errors_.contains(unit.id) && !with_warnings_.contains(unit.id)) return false;
    if (typed.empty()) return true;
    if (text::fold_case(unit.number).rfind(typed, 0) == 0) return true;
    if (text::fold_case(snapshot_->index().name(at)).rfind(typed, 0) == 0) return true;
    for (const std::string* words : {&unit.title, &unit.description, &unit.interpretation}) {
        if (text::fold_case(*words).find(typed) != std::string::npos) return true;
    }
    return text::fold_case(kind_word(unit.kind, unit.form).toStdString()).rfind(typed, 0) == 0;
}

void UnitListModel::rebuild() {
    beginResetModel();
    snapshot_ = workspace_.snapshot();
    rows_.clear();
    if (snapshot_) {
        const std::string typed = text::fold_case(text::trim(filter_.text.toStdString()));
        for (model::UnitIndex u = 0; u < snapshot_->record().units.size(); ++u) {
            if (shows(u, typed)) rows_.push_back(u);
        }
    }
    endResetModel();
    emit filtered();
}

model::UnitId UnitListModel::unit_at(int row) const {
    if (row < 0 || row >= rowCount()) return {};
    return snapshot_->record().units[rows_[static_cast<std::size_t>(row)]].id;
}

int UnitListModel::row_of(model::UnitId unit) const {
    if (!snapshot_) return -1;
    const model::UnitIndex at = snapshot_->index().find(unit);
    const auto it = std::lower_bound(rows_.begin(), rows_.end(), at);
    return it != rows_.end() && *it == at ? static_cast<int>(it - rows_.begin()) : -1;
}

int UnitListModel::total() const { return snapshot_ ? static_cast<int>(snapshot_->record().units.size()) : 0; }

model::UnitId UnitListModel::best_match() const {
    if (!snapshot_) return {};
    const auto named = snapshot_->index().named(filter_.text.trimmed().toStdString());
    if (!named.empty()) return snapshot_->record().units[named.front()].id;
    return unit_at(0);
}

int UnitListModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int UnitListModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : int{ColumnCount}; }

QVariant UnitListModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || index.row() >= rowCount()) return {};
    const model::UnitIndex at = rows_[static_cast<std::size_t>(index.row())];
    const model::StratigraphicUnit& unit = snapshot_->record().units[at];
    if (role == UnitRole) return qt(unit.id.to_string());
    if (role == SeverityRole) return with_errors_.contains(unit.id) ? 2 : with_warnings_.contains(unit.id) ? 1 : 0;
    if (role == Qt::AccessibleTextRole && index.column() == Number) {
        return tr("unit %1, %2, %3")
            .arg(qt(snapshot_->index().name(at)), kind_word(unit.kind, unit.form), status_word(unit.status));
    }
    if (role == Qt::ToolTipRole) return qt(unit.description);
    if (role != Qt::DisplayRole) return {};
    switch (index.column()) {
    case Number: return qt(snapshot_->index().name(at));
    case Kind: return kind_word(unit.kind, unit.form);
    case Title:
        if (unit.title.empty() && unit.origin == model::UnitOrigin::Mentioned) return tr("(no sheet yet)");
        return qt(unit.title);
    case Status: return status_word(unit.status);
    default: return {};
    }
}

QVariant UnitListModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
    switch (section) {
    case Number: return tr("Unit");
    case Kind: return tr("Kind");
    case Title: return tr("Short definition");
    case Status: return tr("Status");
    default: return {};
    }
}

} // namespace planum::gui
