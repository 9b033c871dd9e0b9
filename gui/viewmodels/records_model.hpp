// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>

#include <string>
#include <vector>

#include "app/records/record_kind.hpp"
#include "gui/viewmodels/workspace.hpp"

namespace planum::gui {

/// Any kind of thing in the record (finds, levels, samples, phases, …) as a list with the fields of the one that is
/// chosen: the same kinds and fields as on the command line.
class RecordsModel : public QObject {
    Q_OBJECT

  public:
    struct FieldLine {
        QString name;
        QString help;
        QString value;       ///< as the window says it
        QStringList choices; ///< of an enumeration; empty: free text
        QStringList stored;  ///< what each choice is in the record
    };

    explicit RecordsModel(Workspace& workspace, QObject* parent = nullptr);

    /// `find`, `level`, …: all kinds but units and relations, which have views of their own.
    [[nodiscard]] static QStringList kinds();

    void set_watched(bool watched);
    void set_kind(const QString& kind);

    [[nodiscard]] QString kind() const { return QString::fromStdString(kind_); }

    /// What names a new one: `number of the find`.
    [[nodiscard]] QString name_form() const;

    [[nodiscard]] const QStringList& names() const noexcept { return names_; }

    void choose(const QString& name);

    [[nodiscard]] const QString& chosen() const noexcept { return chosen_; }

    [[nodiscard]] const std::vector<FieldLine>& fields() const noexcept { return fields_; }

    void add(const QString& name, const QString& first_field = {}, const QString& value = {});
    /// `value` as the window says it.
    void set_field(const QString& field, const QString& value);
    void remove();

  signals:
    void listed();
    void chosenChanged();

  private:
    void list_again();
    void show_chosen();

    Workspace& workspace_;
    std::string kind_ = "find";
    QStringList names_;
    QString chosen_;
    std::vector<FieldLine> fields_;
    bool watched_ = false;
    bool stale_ = true;
};

} // namespace planum::gui
