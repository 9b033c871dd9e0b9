// SPDX-License-Identifier: MIT
#include "gui/viewmodels/unit_card_model.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "app/records/record_kind.hpp"
#include "core/base/text.hpp"
#include "gui/viewmodels/log_words.hpp"
#include "gui/viewmodels/paper_file.hpp"
#include "gui/viewmodels/record_words.hpp"
#include "gui/viewmodels/words.hpp"

namespace planum::gui {

namespace {

QString metres(double value) { return QStringLiteral("%1 m").arg(number_word(value, 2)); }

QString joined(std::initializer_list<std::string_view> parts) {
    QStringList words;
    for (const std::string_view part : parts) {
        if (!part.empty()) words << qt(part);
    }
    return words.join(QStringLiteral(", "));
}

QString stored_word(const char* kind, const char* field, std::string_view stored) {
    return record_value_word(QString::fromLatin1(kind), QString::fromLatin1(field), qt(stored));
}

QString joined(const QStringList& parts) {
    QStringList words = parts;
    words.removeAll(QString());
    return words.join(QStringLiteral(", "));
}

constexpr int kTryAgain = 4000; // [ms] after what could not be saved

} // namespace

UnitCardModel::UnitCardModel(Workspace& workspace, QObject* parent) : QObject(parent), workspace_(workspace) {
    connect(&workspace_, &Workspace::snapshotChanged, this, &UnitCardModel::refresh);
    connect(&workspace_, &Workspace::selectionChanged, this, &UnitCardModel::refresh);
    connect(&workspace_, &Workspace::closed, this, [this] {
        typed_.clear();
        refresh();
    });
    again_.setSingleShot(true);
    again_.setInterval(kTryAgain);
    connect(&again_, &QTimer::timeout, this, &UnitCardModel::try_again);
}

void UnitCardModel::refresh() {
    unit_ = {};
    name_.clear();
    fields_.clear();
    relations_.clear();
    lines_.clear();
    pictures_.clear();
    history_.clear();
    const auto& snapshot = workspace_.snapshot();
    const model::UnitIndex at = snapshot ? snapshot->index().find(workspace_.selected()) : model::kNoUnit;
    if (at != model::kNoUnit) {
        unit_ = workspace_.selected();
        name_ = qt(snapshot->index().name(at));
        fields_ = card_fields(*snapshot, at);
        for (CardField& field : fields_) {
            const Typed* typed = typed_in(unit_, field.name);
            if (typed == nullptr) continue;
            field.value = typed->shown;
            field.unsaved = typed->failed;
        }
        fill_relations(at);
        fill_lines();
        fill_papers();
    }
    emit changed();
}

void UnitCardModel::fill_relations(model::UnitIndex at) {
    const auto& snapshot = *workspace_.snapshot();
    const model::Record& record = snapshot.record();
    for (const std::uint32_t r : snapshot.relations_of(at)) {
        const model::PhysicalRelation& relation = record.relations[r];
        CardRelation line;
        line.id = relation.id;
        const bool from_object = relation.object == unit_ && relation.subject != unit_;
        line.kind = {relation.kind, from_object};
        line.other = from_object ? relation.subject : relation.object;
        line.uncertain = relation.certainty == model::Certainty::Uncertain;
        line.sentence = relation_word(line.kind) + QLatin1Char(' ') + qt(snapshot.index().name(line.other));
        QStringList said;
        for (std::uint32_t s = snapshot.statements_begin(r); s < snapshot.statements_begin(r + 1); ++s) {
            const model::RelationStatement& statement = record.statements[s];
            QString source = qt(statement.person);
            for (const model::Source& file : record.sources) {
                if (file.id == statement.source) source = tr("%1, line %2").arg(qt(file.name)).arg(statement.line);
            }
            said << tr("“%1”  %2").arg(qt(statement.raw_text), source);
        }
        line.said_by = said.join(QLatin1Char('\n'));
        relations_.push_back(std::move(line));
    }
    // Above first, then together, then below: how one reads a sheet's matrix box.
    const auto place = [](const CardRelation& r) {
        if (model::time_meaning(r.kind.kind) != model::TimeMeaning::SubjectLater) return 1;
        return r.kind.inverse ? 0 : 2;
    };
    std::stable_sort(relations_.begin(), relations_.end(),
                     [&](const auto& a, const auto& b) { return place(a) < place(b); });
}

void UnitCardModel::fill_lines() {
    const model::Record& record = workspace_.snapshot()->record();
    for (const model::Level& level : record.levels) {
        if (level.unit == unit_)
            lines_.push_back({level_word(level.role), metres(level.z) + QLatin1Char(' ') + qt(level.label)});
    }
    for (const model::Find& find : record.finds) {
        if (find.unit == unit_) lines_.push_back({tr("find"), joined({find.number, find.type, find.material})});
    }
    for (const model::Sample& sample : record.samples) {
        if (sample.unit == unit_)
            lines_.push_back(
                {tr("sample"), joined(QStringList{qt(sample.number), stored_word("sample", "type", sample.type),
                                                  stored_word("sample", "state", sample.state)})});
    }
    for (const model::Dating& dating : record.datings) {
        if (dating.unit == unit_)
            lines_.push_back({tr("date"), joined(QStringList{qt(dating.label),
                                                             stored_word("dating", "kind", to_word(dating.kind))})});
    }
}

void UnitCardModel::fill_papers() {
    std::vector<const model::Document*> papers;
    for (const model::Document& paper : workspace_.snapshot()->record().documents) {
        if (paper.unit == unit_) papers.push_back(&paper);
    }
    std::stable_sort(papers.begin(), papers.end(), [](const model::Document* a, const model::Document* b) {
        return text::natural_order(a->number, b->number) < 0;
    });
    for (const model::Document* paper : papers) {
        const QString type = paper->type.empty() ? tr("paper") : stored_word("document", "type", paper->type);
        const QString name = joined({paper->number, paper->title});
        const QString path = qt(paper->path);
        if (names_picture(path)) {
            pictures_.push_back(
                {paper->id, type + QLatin1Char(' ') + name, path, joined({paper->made_on, paper->author})});
        } else {
            lines_.push_back({type, name, path});
        }
    }
}

void UnitCardModel::set_field(const std::string& name, const QString& value) {
    const auto it = std::find_if(fields_.begin(), fields_.end(), [&](const CardField& f) { return f.name == name; });
    if (it == fields_.end() || it->value == value || !workspace_.read_only_because().isEmpty()) return;
    QString stored = value;
    const auto choice = it->choices.indexOf(value);
    if (choice >= 0) stored = it->stored[choice];
    app::FieldValues values = {{name, stored.toStdString()}};
    // A kind without a form of its own takes the old form away.
    if (name == "kind" && !model::from_word<model::UnitForm>(stored.toStdString())) values.emplace_back("form", "");
    Typed* known = typed_in(unit_, name);
    if (known == nullptr) known = &typed_.emplace_back();
    *known = {unit_, name_, name, it->label, value, std::move(values), false};
    it->value = value;
    save(*known);
}

void UnitCardModel::save(const Typed& typed) {
    const auto ended = [this, unit = typed.unit, field = typed.field, shown = typed.shown](bool failed) {
        Typed* now = typed_in(unit, field);
        if (now == nullptr || now->shown != shown) return; // typed again meanwhile
        if (failed) {
            now->failed = true;
            again_.start();
        } else {
            typed_.erase(typed_.begin() + (now - typed_.data()));
        }
        refresh();
    };
    workspace_.edit(
        tr("Change unit %1").arg(typed.unit_name),
        [unit = typed.unit_name.toStdString(), values = typed.values](app::Project& project, Progress&) {
            app::record_kind("unit").set(project, unit, values);
        },
        [ended] { ended(false); }, Job::Kind::Quiet, [ended](const QString&) { ended(true); });
}

void UnitCardModel::try_again() {
    const std::vector<Typed> all = typed_; // the original changes as they are saved
    for (const Typed& typed : all) {
        if (!typed.failed) continue;
        typed_in(typed.unit, typed.field)->failed = false;
        save(typed);
    }
}

UnitCardModel::Typed* UnitCardModel::typed_in(model::UnitId unit, const std::string& field) {
    const auto it =
        std::find_if(typed_.begin(), typed_.end(), [&](const Typed& t) { return t.unit == unit && t.field == field; });
    return it == typed_.end() ? nullptr : &*it;
}

QStringList UnitCardModel::unsaved() const {
    QStringList all;
    for (const Typed& typed : typed_) all << typed.unit_name + QStringLiteral(": ") + typed.label;
    return all;
}

QString UnitCardModel::next_number() const {
    long long largest = 0;
    if (workspace_.snapshot()) {
        for (const model::StratigraphicUnit& unit : workspace_.snapshot()->record().units) {
            largest = std::max(largest, text::parse_integer(unit.number).value_or(0));
        }
    }
    return QString::number(largest + 1);
}

void UnitCardModel::add_unit(const QString& number) {
    const std::string name = (number.trimmed().isEmpty() ? next_number() : number.trimmed()).toStdString();
    auto added = std::make_shared<model::UnitId>();
    workspace_.edit(
        tr("Add unit %1").arg(qt(name)),
        [name, added](app::Project& project, Progress&) {
            const std::string made = app::record_kind("unit").add(project, name, {});
            *added = project.record().units[project.unit_named(made)].id;
        },
        [this, added] { workspace_.select(*added); });
}

void UnitCardModel::delete_unit() {
    if (unit_.is_nil()) return;
    const std::string name = name_.toStdString();
    workspace_.edit(tr("Delete unit %1").arg(name_),
                    [name](app::Project& project, Progress&) { app::record_kind("unit").remove(project, name); });
}

void UnitCardModel::load_history() {
    if (unit_.is_nil()) return;
    workspace_.read(QStringLiteral("unit history"), tr("Reading what was changed"),
                    [this, unit = unit_](app::Project& project, Progress&) -> JobRunner::Done {
                        constexpr std::size_t kMost = 200;
                        QStringList lines;
                        for (const store::LogEntry& entry : project.file().log(unit.value, kMost)) {
                            QString line = qt(entry.made_at).left(16).replace(QLatin1Char('T'), QLatin1Char(' ')) +
                                           QStringLiteral("  ") + author_word(entry.author) + QStringLiteral("  ") +
                                           log_action_word(entry.action);
                            if (!entry.field.empty()) {
                                line += QLatin1Char(' ') + tr("%1: “%2” → “%3”")
                                                               .arg(stored_field_label(entry.field),
                                                                    stored_value_word(entry.field, entry.old_value),
                                                                    stored_value_word(entry.field, entry.new_value));
                            }
                            lines << line;
                        }
                        return [this, unit, lines] {
                            if (unit != unit_) return;
                            history_ = lines;
                            emit historyChanged();
                        };
                    });
}

} // namespace planum::gui
