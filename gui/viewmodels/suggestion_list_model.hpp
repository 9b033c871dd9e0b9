// SPDX-License-Identifier: MIT
#pragma once

#include <QAbstractListModel>
#include <QString>
#include <QStringList>

#include <vector>

#include "core/model/suggestion.hpp"
#include "gui/viewmodels/workspace.hpp"

namespace planum::app {
struct UnusedSurface;
}

namespace planum::gui {

/// What the surfaces propose, and what they ask: open ones first, relations before questions. Read in a thread after
/// every change while somebody looks, since surfaces may have to be made for it. Every answer is one undo step with
/// author and reason.
class SuggestionListModel : public QAbstractListModel {
    Q_OBJECT

  public:
    enum Role { TitleRole = Qt::UserRole + 1, ReasonRole, QuestionRole, StateRole };

    explicit SuggestionListModel(Workspace& workspace, QObject* parent = nullptr);

    void set_watched(bool watched);
    /// Accepted, rejected and recorded ones too.
    void set_with_decided(bool with_decided);

    [[nodiscard]] bool is_listed() const noexcept { return listed_; }

    /// `12 relations proposed, 3 questions`
    [[nodiscard]] QString summary() const;

    /// Surfaces from which nothing, or less than all, could be concluded: a line for each reason, with those it holds
    /// for.
    [[nodiscard]] const QStringList& unused() const noexcept { return unused_; }

    /// Shows the two units everywhere; -1 closes.
    void open(int row);

    [[nodiscard]] int opened() const noexcept { return opened_; }

    /// The open one; nullptr: none.
    [[nodiscard]] const model::Suggestion* suggestion() const;
    /// `1003 covers 1004`, or `1003 and 1004: which is later?`
    [[nodiscard]] QString title() const;
    /// Area, thickness, confidence, days, in words.
    [[nodiscard]] QStringList numbers() const;
    /// Names of the two units of the open one, the later first.
    [[nodiscard]] std::pair<QString, QString> unit_names() const;

    /// Takes the open relation into the record, with its reason as the raw text of a statement of its own.
    void accept();
    void reject(const QString& because);
    /// Keeps a question, or a relation, silent until surfaces say half as much again.
    void cannot_tell();
    /// All proposed relations, as a reading of their own beside the record.
    void compile(const QString& interpretation);

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;

  signals:
    void listed();
    void openedChanged();
    /// One sentence about what was done.
    void done(const QString& sentence);

  private:
    void list_again();
    void take(std::vector<model::Suggestion> suggestions);
    void choose_rows();
    [[nodiscard]] QString title_of(const model::Suggestion& suggestion) const;

    Workspace& workspace_;
    std::vector<model::Suggestion> suggestions_;
    std::vector<std::size_t> rows_; ///< positions in suggestions_
    QStringList unused_;
    bool with_decided_ = false;
    bool watched_ = false;
    bool stale_ = true;
    bool listed_ = false;
    int opened_ = -1;
};

[[nodiscard]] QString suggestion_state_word(model::SuggestionState state);

/// `2025-06-01, 2025-06-02 and 97 more: no scan is on the site grid`: a line for each reason, in the order they come
/// first; at most six names.
[[nodiscard]] QStringList lines_of_unused(const std::vector<app::UnusedSurface>& unused);

} // namespace planum::gui
