// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <QTimer>

#include <string>
#include <vector>

#include "app/records/record_kind.hpp"
#include "gui/viewmodels/workspace.hpp"

namespace planum::gui {

/// One field of the record card.
struct CardField {
    std::string name; ///< as app::RecordKind calls it
    QString label;
    QString value;
    QString block; ///< heading it stands under in the full record; empty on the first screen
    /// Words that may be chosen, as shown, and as stored beside them; empty: free text.
    QStringList choices;
    QStringList stored;
    bool is_long = false; ///< more than one line
    bool unsaved = false; ///< the value could not be saved and stands here only
};

/// One relation as it reads from the unit's own sheet.
struct CardRelation {
    model::RelationId id;
    QString sentence; ///< `cut by 1017`
    QString said_by;  ///< who and where, one line a statement
    model::UnitId other;
    model::DirectedKind kind;
    bool uncertain = false;
};

/// One line of the things that belong to a unit.
struct CardLine {
    QString kind; ///< level, find, sample, sheet
    QString text;
    QString path = {}; ///< of a paper that names its file; else empty
};

/// A photo or document of a unit that is shown as a picture.
struct CardPicture {
    model::DocumentId id;
    QString title; ///< `photo 12, the pit from the east`
    QString path;  ///< as recorded, relative to the project
    QString made;  ///< day and author, as far as they are known

    friend bool operator==(const CardPicture&, const CardPicture&) = default;
};

/// The record card of the unit that is selected: the few fields of the first screen, the full record behind,
/// its relations read from its side, levels, finds, samples, papers, photos, and what was changed when by whom.
class UnitCardModel : public QObject {
    Q_OBJECT

  public:
    explicit UnitCardModel(Workspace& workspace, QObject* parent = nullptr);

    /// Nil: nothing is selected.
    [[nodiscard]] model::UnitId unit() const noexcept { return unit_; }

    [[nodiscard]] const QString& name() const noexcept { return name_; }

    [[nodiscard]] const std::vector<CardField>& fields() const noexcept { return fields_; }

    [[nodiscard]] const std::vector<CardRelation>& relations() const noexcept { return relations_; }

    [[nodiscard]] const std::vector<CardLine>& lines() const noexcept { return lines_; }

    /// Documents whose files are pictures, by natural number; papers without one are lines.
    [[nodiscard]] const std::vector<CardPicture>& pictures() const noexcept { return pictures_; }

    /// Log of the unit, newest first; comes some milliseconds after the rest (historyChanged).
    [[nodiscard]] const QStringList& history() const noexcept { return history_; }

    /// One change of one field, saved at once. Nothing happens when the value is as it was. What cannot be saved (a
    /// full disk, another program that holds the file) stays in the card and is tried again every few seconds.
    void set_field(const std::string& field, const QString& value);

    /// What stands in cards only because it could not be saved: `1011: Description`.
    [[nodiscard]] QStringList unsaved() const;
    /// Adds a unit and selects it. An empty number takes the next free one.
    void add_unit(const QString& number);
    void delete_unit();

    /// The next number after the largest that is a plain number: what an empty form offers.
    [[nodiscard]] QString next_number() const;

    void load_history();

  signals:
    void changed();
    void historyChanged();

  private:
    void refresh();

    /// A field on its way into the file, or held back by what went wrong.
    struct Typed {
        model::UnitId unit;
        QString unit_name;
        std::string field;
        QString label;
        QString shown;
        app::FieldValues values;
        bool failed = false;
    };

    void save(const Typed& typed);
    void try_again();
    [[nodiscard]] Typed* typed_in(model::UnitId unit, const std::string& field);
    void fill_relations(model::UnitIndex unit);
    void fill_lines();
    void fill_papers();

    Workspace& workspace_;
    model::UnitId unit_;
    QString name_;
    std::vector<CardField> fields_;
    std::vector<CardRelation> relations_;
    std::vector<CardLine> lines_;
    std::vector<CardPicture> pictures_;
    QStringList history_;
    std::vector<Typed> typed_;
    QTimer again_;
};

/// Every field of a unit as the card shows it, first screen first.
[[nodiscard]] std::vector<CardField> card_fields(const app::Snapshot& snapshot, model::UnitIndex unit);

} // namespace planum::gui
