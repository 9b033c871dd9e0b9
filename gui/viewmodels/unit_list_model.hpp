// SPDX-License-Identifier: MIT
#pragma once

#include <QAbstractTableModel>
#include <QString>

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/model/record.hpp"
#include "gui/viewmodels/workspace.hpp"

namespace planum::gui {

/// The units of the project, narrowed by what is typed and by choices; in natural order.
class UnitListModel : public QAbstractTableModel {
    Q_OBJECT

  public:
    enum Column { Number, Kind, Title, Status, ColumnCount };

    /// Roles beside those of Qt.
    enum Role { UnitRole = Qt::UserRole + 1, SeverityRole };

    /// Unset and empty choices narrow nothing.
    struct Filter {
        QString text; ///< beginning of a number, else words of the short definition, description or kind
        std::optional<model::UnitKind> kind;
        std::optional<model::UnitStatus> status;
        model::AreaId area;
        bool with_problems = false; ///< named by an error or a warning

        friend bool operator==(const Filter&, const Filter&) = default;
    };

    explicit UnitListModel(Workspace& workspace, QObject* parent = nullptr);

    void set_filter(const Filter& filter);

    [[nodiscard]] const Filter& filter() const noexcept { return filter_; }

    /// Worst severity of the problems that name each unit: what the list marks, and `with_problems` keeps.
    void set_problems(const std::vector<model::Diagnostic>& problems);

    [[nodiscard]] model::UnitId unit_at(int row) const;
    /// -1 when the unit is not among those shown.
    [[nodiscard]] int row_of(model::UnitId unit) const;
    /// Of all units, shown or not.
    [[nodiscard]] int total() const;
    /// The unit that a typed number means exactly, else the first one shown; nil: none.
    [[nodiscard]] model::UnitId best_match() const;

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

  signals:
    void filtered();

  private:
    void rebuild();
    [[nodiscard]] bool shows(model::UnitIndex unit, const std::string& typed) const;

    Workspace& workspace_;
    Workspace::SnapshotPtr snapshot_;
    Filter filter_;
    std::vector<model::UnitIndex> rows_;
    std::set<model::UnitId> with_errors_;
    std::set<model::UnitId> with_warnings_;
};

} // namespace planum::gui
