// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>

#include <optional>
#include <vector>

#include "gui/viewmodels/workspace.hpp"

namespace planum::gui {

/// A relation while it is typed: number, kind, number, Enter. Kinds may be begun only (`cut b`), in the language of
/// the window or any other the program knows; the other side is derived. Warns before a cycle exists, never refuses.
class RelationEntryModel : public QObject {
    Q_OBJECT

  public:
    enum class Part { Subject, Kind, Object };

    /// What stands to be said about what is typed so far.
    struct Judgement {
        bool ready = false;       ///< Enter would add it
        bool warns = false;       ///< … and the sentence says why one should look again
        QString sentence;         ///< what it will read, what is missing, or the warning
        std::optional<Part> miss; ///< what is missing or not understood
        std::vector<model::UnitId> cycle;
    };

    explicit RelationEntryModel(Workspace& workspace, QObject* parent = nullptr);

    void set(Part part, const QString& text);
    [[nodiscard]] const QString& text(Part part) const;

    void set_uncertain(bool uncertain) { uncertain_ = uncertain; }

    [[nodiscard]] bool uncertain() const noexcept { return uncertain_; }

    [[nodiscard]] const Judgement& judgement() const noexcept { return judgement_; }

    /// What may complete what is typed, best first.
    [[nodiscard]] QStringList completions(Part part) const;

    /// Adds the relation (and, where a number has no unit yet, the unit as one only mentioned). Keeps the first number
    /// and forgets the rest, ready for the next one; where it cannot be saved, it comes back. False when there is
    /// nothing ready.
    bool commit();

    /// Shows the cycle that was warned of in all views.
    void show_cycle();

    /// What a person means by a word or its beginning; nullopt: nothing known.
    [[nodiscard]] static std::optional<model::DirectedKind> kind_of(const QString& typed);

  signals:
    void judged();
    /// It is in the file.
    void committed(const QString& sentence);
    /// It could not be saved and stands in the entry again: Enter tries once more.
    void cameBack();

  private:
    void judge();

    Workspace& workspace_;
    QString subject_;
    QString kind_;
    QString object_;
    bool uncertain_ = false;
    Judgement judgement_;
};

} // namespace planum::gui
