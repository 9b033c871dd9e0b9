// SPDX-License-Identifier: MIT
#include "gui/viewmodels/records_model.hpp"

#include <memory>
#include <utility>

#include "gui/viewmodels/words.hpp"

namespace planum::gui {

RecordsModel::RecordsModel(Workspace& workspace, QObject* parent) : QObject(parent), workspace_(workspace) {
    connect(&workspace_, &Workspace::snapshotChanged, this, &RecordsModel::list_again);
    connect(&workspace_, &Workspace::closed, this, [this] {
        names_.clear();
        chosen_.clear();
        fields_.clear();
        emit listed();
        emit chosenChanged();
    });
}

QStringList RecordsModel::kinds() {
    QStringList words;
    for (const auto& kind : app::record_kinds()) {
        if (kind->word() != "unit" && kind->word() != "relation") words << qt(kind->word());
    }
    return words;
}

void RecordsModel::set_watched(bool watched) {
    watched_ = watched;
    if (watched_ && stale_) list_again();
}

void RecordsModel::set_kind(const QString& kind) {
    if (kind.toStdString() == kind_) return;
    kind_ = kind.toStdString();
    chosen_.clear();
    fields_.clear();
    emit chosenChanged();
    list_again();
}

QString RecordsModel::name_form() const { return qt(app::record_kind(kind_).name_form()); }

void RecordsModel::list_again() {
    stale_ = true;
    if (!watched_ || !workspace_.is_open()) return;
    stale_ = false;
    workspace_.read(
        QStringLiteral("records"), tr("Listing"),
        [this, kind = kind_, chosen = chosen_.toStdString()](app::Project& project, Progress&) -> JobRunner::Done {
            QStringList names;
            for (const std::string& name : app::record_kind(kind).names(project)) names << qt(name);
            return [this, names, kind] {
                if (kind != kind_) return;
                names_ = names;
                emit listed();
                if (!names_.contains(chosen_)) chosen_.clear();
                show_chosen();
            };
        });
}

void RecordsModel::choose(const QString& name) {
    if (name == chosen_) return;
    chosen_ = name;
    show_chosen();
}

void RecordsModel::show_chosen() {
    fields_.clear();
    if (chosen_.isEmpty() || !workspace_.is_open()) {
        emit chosenChanged();
        return;
    }
    workspace_.read(QStringLiteral("record"), tr("Reading"),
                    [this, kind = kind_, name = chosen_](app::Project& project, Progress&) -> JobRunner::Done {
                        const app::RecordKind& table = app::record_kind(kind);
                        const app::FieldValues values = table.show(project, name.toStdString());
                        std::vector<FieldLine> fields;
                        for (const app::FieldInfo& info : table.fields()) {
                            FieldLine line{qt(info.name), qt(info.help), {}};
                            for (const auto& [field, text] : values) {
                                if (field == info.name) line.value = qt(text);
                            }
                            fields.push_back(std::move(line));
                        }
                        return [this, name, fields = std::move(fields)] {
                            if (name != chosen_) return;
                            fields_ = fields;
                            emit chosenChanged();
                        };
                    });
}

void RecordsModel::add(const QString& name, const QString& first_field, const QString& value) {
    app::FieldValues values;
    if (!first_field.isEmpty()) values.emplace_back(first_field.toStdString(), value.toStdString());
    auto made = std::make_shared<std::string>();
    workspace_.edit(
        tr("Add %1 %2").arg(kind(), name),
        [kind = kind_, wanted = name.toStdString(), values, made](app::Project& project, Progress&) {
            *made = app::record_kind(kind).add(project, wanted, values);
        },
        [this, made] { choose(qt(*made)); });
}

void RecordsModel::set_field(const QString& field, const QString& value) {
    for (const FieldLine& line : fields_) {
        if (line.name == field && line.value == value) return;
    }
    workspace_.edit(tr("Change %1 %2").arg(kind(), chosen_),
                    [kind = kind_, name = chosen_.toStdString(), field = field.toStdString(),
                     value = value.toStdString()](app::Project& project, Progress&) {
                        app::record_kind(kind).set(project, name, {{field, value}});
                    });
}

void RecordsModel::remove() {
    if (chosen_.isEmpty()) return;
    workspace_.edit(tr("Delete %1 %2").arg(kind(), chosen_),
                    [kind = kind_, name = chosen_.toStdString()](app::Project& project, Progress&) {
                        app::record_kind(kind).remove(project, name);
                    });
}

} // namespace planum::gui
