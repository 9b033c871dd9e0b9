// SPDX-License-Identifier: MIT
#include "gui/viewmodels/relation_entry_model.hpp"

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

#include "app/records/record_kind.hpp"
#include "app/records/relation_entry.hpp"
#include "core/base/text.hpp"
#include "gui/viewmodels/words.hpp"

namespace planum::gui {

using model::DirectedKind;
using model::RelationKind;

namespace {

// In the order in which they are meant when only begun: `c` is covers, `cu` is cuts.
constexpr std::array kOffered = {
    DirectedKind{RelationKind::Covers, false},  DirectedKind{RelationKind::Covers, true},
    DirectedKind{RelationKind::Cuts, false},    DirectedKind{RelationKind::Cuts, true},
    DirectedKind{RelationKind::Fills, false},   DirectedKind{RelationKind::Fills, true},
    DirectedKind{RelationKind::Abuts, false},   DirectedKind{RelationKind::Abuts, true},
    DirectedKind{RelationKind::SameAs, false},  DirectedKind{RelationKind::BondsWith, false},
    DirectedKind{RelationKind::Later, false},   DirectedKind{RelationKind::Later, true},
    DirectedKind{RelationKind::Borders, false}, DirectedKind{RelationKind::Contemporary, false}};

constexpr int kMostShown = 12;

std::string english(DirectedKind kind) {
    return std::string(kind.inverse ? model::inverse_phrase(kind.kind) : model::phrase(kind.kind));
}

bool begins(const std::string& whole, const std::string& typed) {
    return text::fold_case(whole).rfind(text::fold_case(typed), 0) == 0;
}

} // namespace

RelationEntryModel::RelationEntryModel(Workspace& workspace, QObject* parent) : QObject(parent), workspace_(workspace) {
    connect(&workspace_, &Workspace::snapshotChanged, this, &RelationEntryModel::judge);
    connect(&workspace_, &Workspace::closed, this, [this] {
        subject_.clear();
        kind_.clear();
        object_.clear();
        judge();
    });
}

std::optional<DirectedKind> RelationEntryModel::kind_of(const QString& typed) {
    const std::string word = typed.trimmed().toStdString();
    if (word.empty()) return std::nullopt;
    for (const DirectedKind kind : kOffered) {
        if (text::fold_case(relation_word(kind).toStdString()) == text::fold_case(word)) return kind;
    }
    if (const auto known = model::relation_from_any_word(word)) return known;
    for (const DirectedKind kind : kOffered) {
        if (begins(relation_word(kind).toStdString(), word) || begins(english(kind), word)) return kind;
    }
    return std::nullopt;
}

void RelationEntryModel::set(Part part, const QString& text) {
    QString& field = part == Part::Subject ? subject_ : part == Part::Kind ? kind_ : object_;
    if (field == text) return;
    field = text;
    judge();
}

const QString& RelationEntryModel::text(Part part) const {
    switch (part) {
    case Part::Subject: return subject_;
    case Part::Kind: return kind_;
    case Part::Object: return object_;
    }
    return subject_;
}

QStringList RelationEntryModel::completions(Part part) const {
    QStringList words;
    if (part == Part::Kind) {
        const std::string typed = kind_.trimmed().toStdString();
        for (const DirectedKind kind : kOffered) {
            const QString word = relation_word(kind);
            if (typed.empty() || begins(word.toStdString(), typed) || begins(english(kind), typed)) words << word;
        }
        return words;
    }
    if (!workspace_.snapshot()) return words;
    const std::string typed = text(part).trimmed().toStdString();
    const auto& units = workspace_.snapshot()->record().units;
    for (model::UnitIndex u = 0; u < units.size() && words.size() < kMostShown; ++u) {
        const std::string name = workspace_.snapshot()->index().name(u);
        if (begins(units[u].number, typed) || begins(name, typed)) words << qt(name);
    }
    return words;
}

void RelationEntryModel::judge() {
    judgement_ = {};
    const auto& snapshot = workspace_.snapshot();
    const auto missing = [&](Part part, const QString& sentence) {
        judgement_.miss = part;
        judgement_.sentence = sentence;
        emit judged();
    };
    if (!snapshot) return missing(Part::Subject, {});
    const std::string subject = subject_.trimmed().toStdString();
    const std::string object = object_.trimmed().toStdString();
    if (subject.empty()) return missing(Part::Subject, tr("Number of a unit"));
    const auto kind = kind_of(kind_);
    if (!kind) {
        return missing(Part::Kind, kind_.trimmed().isEmpty() ? tr("Relation: covers, cut by, fills, …")
                                                             : tr("“%1” is no relation").arg(kind_.trimmed()));
    }
    if (object.empty()) return missing(Part::Object, tr("Number of the other unit"));
    const auto a = snapshot->index().named(subject);
    const auto b = snapshot->index().named(object);
    for (const auto& [found, typed, part] :
         {std::tuple{a, subject, Part::Subject}, std::tuple{b, object, Part::Object}}) {
        if (found.size() > 1) return missing(part, tr("%1 is used in several areas; write AREA::%1").arg(qt(typed)));
    }
    judgement_.ready = true;
    judgement_.sentence = QStringLiteral("%1 %2 %3").arg(qt(subject), relation_word(*kind), qt(object));
    if (a.empty() || b.empty()) {
        const std::string unknown = a.empty() ? subject : object;
        const auto near = app::near_numbers(snapshot->record(), unknown, 3);
        judgement_.warns = true;
        judgement_.sentence = tr("There is no unit %1 yet; Enter adds it as one only mentioned.").arg(qt(unknown));
        if (!near.empty()) judgement_.sentence += QLatin1Char(' ') + tr("Near it: %1.").arg(qt(text::join(near, ", ")));
        emit judged();
        return;
    }
    judgement_.cycle =
        app::would_close_cycle(*snapshot, app::said_relation(snapshot->record(), a.front(), *kind, b.front()));
    if (!judgement_.cycle.empty()) {
        QStringList names;
        for (const model::UnitId unit : judgement_.cycle) names << qt(snapshot->index().name(unit));
        if (names.size() > 6) names = names.mid(0, 3) + QStringList{QStringLiteral("…")} + names.mid(names.size() - 2);
        judgement_.warns = true;
        judgement_.sentence = names.size() == 1
                                  ? tr("That puts %1 above itself. Enter records it all the same.").arg(names.front())
                                  : tr("That closes a circle: %1. Enter records it all the same.")
                                        .arg(names.join(QStringLiteral(" › ")) + QStringLiteral(" › ") + names.front());
    }
    emit judged();
}

bool RelationEntryModel::commit() {
    if (!judgement_.ready) return false;
    const auto kind = kind_of(kind_);
    const std::string subject = subject_.trimmed().toStdString();
    const std::string object = object_.trimmed().toStdString();
    const std::string written = subject + " " + relation_word(*kind).toStdString() + " " + object;
    const auto certainty = uncertain_ ? model::Certainty::Uncertain : model::Certainty::Certain;
    workspace_.edit(
        tr("Add relation %1").arg(qt(written)),
        [subject, object, written, kind, certainty](app::Project& project, Progress&) {
            for (const std::string& number : {subject, object}) {
                if (!project.index().named(number).empty()) continue;
                model::StratigraphicUnit unit;
                unit.number = number;
                unit.origin = model::UnitOrigin::Mentioned;
                project.change("Add unit " + number, [&] { project.file().insert(unit); });
            }
            app::RelationEntry entry;
            entry.said =
                app::said_relation(project.record(), project.unit_named(subject), *kind, project.unit_named(object));
            entry.certainty = certainty;
            app::add_relation(project, entry, written);
        },
        [this, written] { emit committed(qt(written)); }, Job::Kind::Quiet,
        [this, was = std::array{subject_, kind_, object_}, uncertain = uncertain_](const QString&) {
            if (!kind_.isEmpty() || !object_.isEmpty()) return; // the next one is being typed
            subject_ = was[0];
            kind_ = was[1];
            object_ = was[2];
            uncertain_ = uncertain;
            judge();
            emit cameBack();
        });
    kind_.clear();
    object_.clear();
    uncertain_ = false;
    judge();
    return true;
}

void RelationEntryModel::show_cycle() {
    if (judgement_.cycle.empty()) return;
    workspace_.show_proof({judgement_.cycle, {}});
}

} // namespace planum::gui
