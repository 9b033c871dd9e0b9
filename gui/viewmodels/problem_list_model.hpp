// SPDX-License-Identifier: MIT
#pragma once

#include <QAbstractListModel>
#include <QString>
#include <QStringList>

#include <memory>
#include <vector>

#include "app/checks/daily_check.hpp"
#include "core/model/evidence.hpp"
#include "gui/viewmodels/workspace.hpp"

namespace planum::gui {

/// What can be done about a suspect. Each is a revision with author and reason; the field's statement stays readable.
enum class ProblemAction {
    Withdraw,      ///< the relation was not so
    MarkUncertain, ///< it may be so
    Reverse,       ///< it is so the other way round
    MendNumber,    ///< the number that was meant (SuspectNumber only)
    SplitUnit,     ///< the unit is really two (SuspectUnit only)
};

/// One suspect as the window shows it.
struct SuspectLine {
    QString sentence; ///< `1043 covers 1046`
    QStringList reasons;
    int percent = 0; ///< share of suspicion
    std::vector<ProblemAction> actions;
};

/// The problem that is open, in words.
struct ProblemDetail {
    QString id;
    QString title;
    QString message;
    model::Severity severity = model::Severity::Warning;
    bool is_new = false;
    bool has_faces = false; ///< measured: two faces and a section can be drawn, see app::contradiction_sheet()
    QStringList evidence;   ///< `thickness: 0.12`
    QStringList proof;      ///< the relations it rests on
    std::vector<SuspectLine> suspects;
};

/// What the evening's check says, new since the last sign-off first; checked again after every change, in a
/// thread. What the surfaces say is asked once for the scans and outlines there are, and again when they change; until
/// it is known the record is judged by itself. Opening a problem shows its proof in all views.
class ProblemListModel : public QAbstractListModel {
    Q_OBJECT

  public:
    enum Role { SeverityRole = Qt::UserRole + 1, TitleRole, MessageRole, NewRole, IdRole, CodeRole };

    explicit ProblemListModel(Workspace& workspace, QObject* parent = nullptr);

    /// Remarks are many and seldom urgent; hidden unless asked for.
    void set_with_remarks(bool with_remarks);

    [[nodiscard]] const app::DailyCheck& check() const noexcept { return *check_; }

    [[nodiscard]] bool is_checked() const noexcept { return checked_; }

    /// What check() was made of; null before the first.
    [[nodiscard]] const Workspace::SnapshotPtr& checked_snapshot() const noexcept { return snapshot_; }

    /// Whether the surfaces are still being asked; what they say comes with another checked().
    [[nodiscard]] bool is_comparing_surfaces() const noexcept { return comparing_; }

    /// `2 errors, 5 warnings, 12 remarks`
    [[nodiscard]] QString summary() const;
    /// What was changed after the day was signed off, newest first, a line each: when, who, what. Empty as long as
    /// nobody signed.
    [[nodiscard]] QStringList changes_since_sign_off() const;
    /// How much could be judged, a line each.
    [[nodiscard]] QStringList coverage() const;

    /// Shows its proof everywhere; -1 closes.
    void open(int row);

    [[nodiscard]] int opened() const noexcept { return opened_; }

    [[nodiscard]] ProblemDetail detail() const;

    /// Does something about suspect number `suspect` of the open problem. `number` names the new unit of a split.
    void act(std::size_t suspect, ProblemAction action, const QString& because, const QString& number = {});
    /// Keeps the open problem silent until its units or evidence change.
    void accept(const QString& because);
    /// What stands now is not new tomorrow.
    void sign_off();

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;

  signals:
    void checked();
    void openedChanged();

  private:
    using Surfaces = model::Measurements;

    void ask_surfaces();
    void take_surfaces(std::shared_ptr<const Surfaces> said, const Workspace::SnapshotPtr& asked_for);
    void give_up_surfaces(const Workspace::SnapshotPtr& asked_for);
    void check_again();
    void take(std::shared_ptr<const app::DailyCheck> check, Workspace::SnapshotPtr snapshot);
    [[nodiscard]] const model::Diagnostic* open_problem() const;

    Workspace& workspace_;
    Workspace::SnapshotPtr snapshot_; ///< what was checked
    std::shared_ptr<const app::DailyCheck> check_;
    std::shared_ptr<const Surfaces> surfaces_; ///< what they said last
    Workspace::SnapshotPtr asked_for_;         ///< for whose scans and outlines they were asked
    bool comparing_ = false;
    std::vector<std::size_t> rows_; ///< positions in check_->problems
    bool with_remarks_ = false;
    bool checked_ = false;
    int opened_ = -1;
};

[[nodiscard]] QString action_word(ProblemAction action);

} // namespace planum::gui
