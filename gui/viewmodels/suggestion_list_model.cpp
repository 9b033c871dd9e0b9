// SPDX-License-Identifier: MIT
#include "gui/viewmodels/suggestion_list_model.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include "app/scans/days_surface.hpp"
#include "app/suggestions/suggestions.hpp"
#include "gui/viewmodels/sentences.hpp"
#include "gui/viewmodels/service_sentences.hpp"
#include "gui/viewmodels/words.hpp"

namespace planum::gui {

using model::Suggestion;
using model::SuggestionState;
using model::SuggestionType;

QString suggestion_state_word(SuggestionState state) {
    switch (state) {
    case SuggestionState::Open: return SuggestionListModel::tr("open");
    case SuggestionState::Accepted: return SuggestionListModel::tr("accepted");
    case SuggestionState::Rejected: return SuggestionListModel::tr("rejected");
    case SuggestionState::Recorded: return SuggestionListModel::tr("recorded already");
    }
    return {};
}

QStringList lines_of_unused(const std::vector<app::UnusedSurface>& unused) {
    constexpr int kNamed = 6;
    std::vector<std::pair<std::string, QStringList>> reasons;
    std::map<std::string, std::size_t> place;
    for (const app::UnusedSurface& one : unused) {
        const auto [found, fresh] = place.try_emplace(one.why, reasons.size());
        if (fresh) reasons.emplace_back(one.why, QStringList{});
        reasons[found->second].second << qt(one.surface);
    }
    QStringList lines;
    for (const auto& [why, surfaces] : reasons) {
        QString names = surfaces.mid(0, kNamed).join(QStringLiteral(", "));
        if (surfaces.size() > kNamed) {
            names = SuggestionListModel::tr("%1 and %n more", nullptr, static_cast<int>(surfaces.size()) - kNamed)
                        .arg(names);
        }
        lines << QStringLiteral("%1: %2").arg(names, service_sentence(why));
    }
    return lines;
}

SuggestionListModel::SuggestionListModel(Workspace& workspace, QObject* parent)
    : QAbstractListModel(parent), workspace_(workspace) {
    connect(&workspace_, &Workspace::snapshotChanged, this, &SuggestionListModel::list_again);
    connect(&workspace_, &Workspace::closed, this, [this] {
        unused_.clear();
        take({});
        listed_ = false;
        stale_ = true;
    });
}

void SuggestionListModel::set_watched(bool watched) {
    watched_ = watched;
    if (watched_ && stale_) list_again();
}

void SuggestionListModel::set_with_decided(bool with_decided) {
    with_decided_ = with_decided;
    take(suggestions_);
}

void SuggestionListModel::list_again() {
    stale_ = true;
    if (!watched_ || !workspace_.is_open()) return;
    stale_ = false;
    workspace_.read(QStringLiteral("suggestions"), tr("Asking the surfaces"),
                    [this](app::Project& project, Progress& progress) -> JobRunner::Done {
                        app::SuggestionList list = app::list_suggestions(project, progress);
                        const QStringList unused = lines_of_unused(list.unused);
                        auto said = std::make_shared<std::vector<Suggestion>>(std::move(list.suggestions));
                        return [this, said, unused] {
                            unused_ = unused;
                            listed_ = true;
                            take(std::move(*said));
                        };
                    });
}

void SuggestionListModel::take(std::vector<Suggestion> suggestions) {
    const QString open_id = suggestion() != nullptr ? qt(suggestion()->id) : QString();
    beginResetModel();
    suggestions_ = std::move(suggestions);
    choose_rows();
    opened_ = -1;
    endResetModel();
    emit listed();
    int again = -1;
    for (std::size_t row = 0; row < rows_.size() && !open_id.isEmpty(); ++row) {
        if (qt(suggestions_[rows_[row]].id) == open_id) again = static_cast<int>(row);
    }
    if (again >= 0) return open(again);
    if (!open_id.isEmpty()) workspace_.show_proof({});
    emit openedChanged();
}

void SuggestionListModel::choose_rows() {
    rows_.clear();
    for (std::size_t i = 0; i < suggestions_.size(); ++i) {
        if (with_decided_ || suggestions_[i].state == SuggestionState::Open) rows_.push_back(i);
    }
}

QString SuggestionListModel::summary() const {
    if (!listed_) return {};
    int relations = 0;
    int questions = 0;
    for (const Suggestion& s : suggestions_) {
        if (s.state != SuggestionState::Open) continue;
        ++(s.type == SuggestionType::Question ? questions : relations);
    }
    if (relations + questions == 0) return tr("nothing proposed");
    return tr("%n relation(s) proposed", nullptr, relations) + QStringLiteral(", ") +
           tr("%n question(s)", nullptr, questions);
}

const Suggestion* SuggestionListModel::suggestion() const {
    if (opened_ < 0 || opened_ >= static_cast<int>(rows_.size())) return nullptr;
    return &suggestions_[rows_[static_cast<std::size_t>(opened_)]];
}

void SuggestionListModel::open(int row) {
    if (row == opened_) return;
    opened_ = row;
    const Suggestion* s = suggestion();
    if (s == nullptr) opened_ = -1;
    workspace_.show_proof(s == nullptr ? Proof{} : Proof{{s->unit, s->other}, {}});
    emit openedChanged();
}

std::pair<QString, QString> SuggestionListModel::unit_names() const {
    const Suggestion* s = suggestion();
    if (s == nullptr || !workspace_.is_open()) return {};
    const model::RecordIndex& index = workspace_.snapshot()->index();
    return {qt(index.name(s->unit)), qt(index.name(s->other))};
}

QString SuggestionListModel::title_of(const Suggestion& s) const {
    if (!workspace_.is_open()) return {};
    const model::RecordIndex& index = workspace_.snapshot()->index();
    const QString unit = qt(index.name(s.unit));
    const QString other = qt(index.name(s.other));
    if (s.type == SuggestionType::Question) return tr("%1 and %2: which is later?").arg(unit, other);
    return QStringLiteral("%1 %2 %3").arg(unit, relation_word({s.kind, false}), other);
}

QString SuggestionListModel::title() const { return suggestion() == nullptr ? QString() : title_of(*suggestion()); }

QStringList SuggestionListModel::numbers() const {
    const Suggestion* s = suggestion();
    QStringList lines;
    if (s == nullptr || !workspace_.is_open()) return lines;
    if (s->area > 0.0) lines << tr("area %1 m²").arg(number_word(s->area, 2));
    if (s->thickness > 0.0) lines << tr("thickness %1 m").arg(number_word(s->thickness, 2));
    if (s->confidence > 0.0) lines << tr("sure to %1 %").arg(number_word(100.0 * s->confidence, 0));
    const model::Record& record = workspace_.snapshot()->record();
    QStringList surfaces;
    for (const model::SurfaceId id : s->surfaces) {
        const auto found = std::find_if(record.surfaces.begin(), record.surfaces.end(),
                                        [&](const model::Surface& one) { return one.id == id; });
        if (found != record.surfaces.end()) surfaces << qt(app::surface_name(record, *found));
    }
    if (!surfaces.isEmpty()) lines << tr("seen on %1").arg(surfaces.join(QStringLiteral(", ")));
    if (s->type == SuggestionType::Relation && !s->direct) lines << tr("not known to have touched");
    return lines;
}

// Answers ask the surfaces once more, which may take a while: beside the window.
void SuggestionListModel::accept() {
    const Suggestion* s = suggestion();
    if (s == nullptr) return;
    workspace_.work(
        tr("Accepting a suggestion"),
        [ids = std::array{s->id}](app::Project& project, Progress& progress) {
            app::accept_suggestions(project, ids, progress);
        },
        [this, what = title()] { emit done(tr("recorded from surfaces: %1").arg(what)); });
}

void SuggestionListModel::reject(const QString& because) {
    const Suggestion* s = suggestion();
    if (s == nullptr) return;
    workspace_.work(tr("Rejecting a suggestion"), [ids = std::array{s->id}, because = because.toStdString()](
                                                      app::Project& project, Progress& progress) {
        app::reject_suggestions(project, ids, because, progress);
    });
}

void SuggestionListModel::cannot_tell() { reject(tr("cannot tell from the surfaces")); }

void SuggestionListModel::compile(const QString& interpretation) {
    auto count = std::make_shared<std::size_t>(0);
    workspace_.work(
        tr("Compiling a reading"),
        [count, name = interpretation.toStdString()](app::Project& project, Progress& progress) {
            *count = app::compile_interpretation(project, name, progress);
        },
        [this, count, interpretation] {
            emit done(tr("reading %1: %2 relations from surfaces").arg(interpretation).arg(*count));
        });
}

int SuggestionListModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

QVariant SuggestionListModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || index.row() >= rowCount()) return {};
    const Suggestion& s = suggestions_[rows_[static_cast<std::size_t>(index.row())]];
    switch (role) {
    case Qt::DisplayRole:
    case TitleRole:
        return s.state == SuggestionState::Open
                   ? title_of(s)
                   : QStringLiteral("%1  · %2").arg(title_of(s), suggestion_state_word(s.state));
    case Qt::ToolTipRole:
    case ReasonRole: return in_window_language(s.reason);
    case QuestionRole: return s.type == SuggestionType::Question;
    case StateRole: return static_cast<int>(s.state);
    default: return {};
    }
}

} // namespace planum::gui
