// SPDX-License-Identifier: MIT
#include "gui/viewmodels/records_model.hpp"

#include <memory>
#include <utility>

#include "core/base/text.hpp"
#include "gui/viewmodels/record_words.hpp"
#include "gui/viewmodels/service_sentences.hpp"
#include "gui/viewmodels/words.hpp"

namespace planum::gui {

namespace {

RecordsModel::FieldLine line_of(const QString& kind, const app::FieldInfo& info, const app::FieldValues& values) {
    RecordsModel::FieldLine line;
    line.name = qt(info.name);
    // The words are offered, so that the help need not list them.
    const std::string listed = " (" + text::join(info.words, ", ") + ")";
    std::string help = info.help;
    if (!info.words.empty() && help.ends_with(listed)) help.resize(help.size() - listed.size());
    line.help = service_sentence(help);
    for (const std::string& word : info.words) {
        line.stored << qt(word);
        line.choices << record_value_word(kind, line.name, line.stored.back());
    }
    for (const auto& [field, text] : values) {
        if (field == info.name) line.value = qt(text);
    }
    const auto at = line.stored.indexOf(line.value);
    if (at >= 0) line.value = line.choices[at];
    return line;
}

} // namespace

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

QString RecordsModel::name_form() const { return record_name_form(kind()); }

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
                            fields.push_back(line_of(qt(kind), info, values));
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
        tr("Add %1 %2").arg(record_thing_word(kind()), name),
        [kind = kind_, wanted = name.toStdString(), values, made](app::Project& project, Progress&) {
            *made = app::record_kind(kind).add(project, wanted, values);
        },
        [this, made] { choose(qt(*made)); });
}

void RecordsModel::set_field(const QString& field, const QString& value) {
    QString stored = value;
    for (const FieldLine& line : fields_) {
        if (line.name != field) continue;
        if (line.value == value) return;
        const auto at = line.choices.indexOf(value);
        if (at >= 0) stored = line.stored[at];
    }
    workspace_.edit(tr("Change %1 %2").arg(record_thing_word(kind()), chosen_),
                    [kind = kind_, name = chosen_.toStdString(), field = field.toStdString(),
                     value = stored.toStdString()](app::Project& project, Progress&) {
                        app::record_kind(kind).set(project, name, {{field, value}});
                    });
}

void RecordsModel::remove() {
    if (chosen_.isEmpty()) return;
    workspace_.edit(tr("Delete %1 %2").arg(record_thing_word(kind()), chosen_),
                    [kind = kind_, name = chosen_.toStdString()](app::Project& project, Progress&) {
                        app::record_kind(kind).remove(project, name);
                    });
}

} // namespace planum::gui
