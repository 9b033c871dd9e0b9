// SPDX-License-Identifier: MIT
#include "gui/viewmodels/problem_list_model.hpp"

#include <QLocale>

#include <algorithm>
#include <span>
#include <utility>

#include "app/evidence/evidence.hpp"
#include "app/evidence/section_evidence.hpp"
#include "app/records/revision.hpp"
#include "core/base/error.hpp"
#include "gui/viewmodels/change_labels.hpp"
#include "gui/viewmodels/log_words.hpp"
#include "gui/viewmodels/sentences.hpp"
#include "gui/viewmodels/words.hpp"

namespace planum::gui {

using model::Diagnostic;
using model::NamedRelation;

namespace {

QString sentence_of(const NamedRelation& named, const model::RecordIndex& index) {
    return QStringLiteral("%1 %2 %3")
        .arg(qt(index.name(named.unit)), relation_word({named.kind, false}), qt(index.name(named.other)));
}

struct SuspectWords {
    const model::RecordIndex& index;
    SuspectLine& line;

    void operator()(const model::SuspectRelation& s) const {
        line.sentence = sentence_of(s.relation, index);
        if (s.relation.relation.is_nil()) return;
        line.actions = {ProblemAction::Withdraw, ProblemAction::MarkUncertain};
        if (!model::is_symmetric(s.relation.kind)) line.actions.push_back(ProblemAction::Reverse);
    }

    void operator()(const model::SuspectSameAs& s) const {
        line.sentence = sentence_of(s.same_as, index);
        if (!s.same_as.relation.is_nil()) line.actions = {ProblemAction::Withdraw, ProblemAction::MarkUncertain};
    }

    void operator()(const model::SuspectNumber& s) const {
        line.sentence = ProblemListModel::tr("number %1 in “%2”, probably %3")
                            .arg(qt(s.written), sentence_of(s.relation, index), qt(s.probably));
        if (!s.relation.relation.is_nil()) {
            line.actions = {ProblemAction::MendNumber, ProblemAction::Withdraw, ProblemAction::MarkUncertain};
        }
    }

    void operator()(const model::SuspectUnit& s) const {
        line.sentence = ProblemListModel::tr("unit %1, probably two").arg(qt(index.name(s.unit)));
        line.actions = {ProblemAction::SplitUnit};
    }
};

QString evidence_text(const model::EvidenceValue& value) {
    if (const auto* whole = std::get_if<std::int64_t>(&value)) return QString::number(*whole);
    if (const auto* number = std::get_if<double>(&value)) return QLocale().toString(*number, 'g', 4);
    return in_window_language(std::get<std::string>(value));
}

// The relation a suspect is about; nullptr for a unit.
const NamedRelation* relation_of(const model::Suspect& suspect) {
    if (const auto* s = std::get_if<model::SuspectRelation>(&suspect.what)) return &s->relation;
    if (const auto* s = std::get_if<model::SuspectSameAs>(&suspect.what)) return &s->same_as;
    if (const auto* s = std::get_if<model::SuspectNumber>(&suspect.what)) return &s->relation;
    return nullptr;
}

void mend_number(app::Project& project, const model::SuspectNumber& suspect, const std::string& because) {
    const model::UnitIndex right = project.unit_named(suspect.probably);
    const bool subject_wrong =
        project.index().name(suspect.relation.unit) == suspect.written ||
        project.record().units[project.index().find(suspect.relation.unit)].number == suspect.written;
    const model::UnitIndex a = subject_wrong ? right : project.index().find(suspect.relation.unit);
    const model::UnitIndex b = subject_wrong ? project.index().find(suspect.relation.other) : right;
    app::replace_relation(project, suspect.relation.relation,
                          app::said_relation(project.record(), a, {suspect.relation.kind, false}, b), because);
}

// Half of the relations go to the new unit: those above the old one stay, those below move.
void split(app::Project& project, model::UnitId unit, const std::string& number, const std::string& because) {
    std::vector<model::RelationId> moved;
    for (const model::PhysicalRelation& relation : project.record().relations) {
        if (relation.subject == unit && model::time_meaning(relation.kind) == model::TimeMeaning::SubjectLater) {
            moved.push_back(relation.id);
        }
    }
    app::split_unit(project, unit, number, moved, because);
}

} // namespace

QString action_word(ProblemAction action) {
    switch (action) {
    case ProblemAction::Withdraw: return ProblemListModel::tr("Withdraw");
    case ProblemAction::MarkUncertain: return ProblemListModel::tr("Mark uncertain");
    case ProblemAction::Reverse: return ProblemListModel::tr("Reverse");
    case ProblemAction::MendNumber: return ProblemListModel::tr("Correct the number");
    case ProblemAction::SplitUnit: return ProblemListModel::tr("Split the unit");
    }
    return {};
}

ProblemListModel::ProblemListModel(Workspace& workspace, QObject* parent)
    : QAbstractListModel(parent), workspace_(workspace), check_(std::make_shared<app::DailyCheck>()) {
    connect(&workspace_, &Workspace::snapshotChanged, this, [this] {
        ask_surfaces();
        check_again();
    });
    connect(&workspace_, &Workspace::closed, this, [this] {
        surfaces_ = {};
        asked_for_ = nullptr;
        comparing_ = false;
        take(std::make_shared<app::DailyCheck>(), nullptr);
        checked_ = false;
    });
}

// Minutes on a large dig that was never asked before, so beside the checks: they first say what the record alone says.
void ProblemListModel::ask_surfaces() {
    const auto snapshot = workspace_.snapshot();
    if (asked_for_ != nullptr && app::same_sources(asked_for_->record(), snapshot->record())) return;
    asked_for_ = snapshot;
    comparing_ = true;
    workspace_.read(
        QStringLiteral("evidence"), tr("Comparing the surfaces"),
        [this, snapshot](app::Project& project, Progress& progress) -> JobRunner::Done {
            try {
                auto said = std::make_shared<const Surfaces>(app::measured_evidence(project, progress));
                return [this, said, snapshot] { take_surfaces(said, snapshot); };
            } catch (const Error& e) {
                if (e.code() != ErrorCode::Cancelled) throw;
                return [this, snapshot] { give_up_surfaces(snapshot); };
            }
        },
        [this, snapshot](const QString& sentence) {
            give_up_surfaces(snapshot);
            workspace_.say(sentence);
        });
}

void ProblemListModel::take_surfaces(std::shared_ptr<const Surfaces> said, const Workspace::SnapshotPtr& asked_for) {
    if (asked_for_ != asked_for) return; // closed, or changed since
    comparing_ = false;
    const bool news = surfaces_ == nullptr ? !said->empty() : *surfaces_ != *said;
    surfaces_ = std::move(said);
    if (news) check_again();
    emit checked();
}

// They are asked again at the next change.
void ProblemListModel::give_up_surfaces(const Workspace::SnapshotPtr& asked_for) {
    if (asked_for_ != asked_for) return;
    comparing_ = false;
    asked_for_ = nullptr;
    emit checked();
}

void ProblemListModel::check_again() {
    const auto snapshot = workspace_.snapshot();
    if (snapshot == nullptr) return;
    workspace_.jobs().start(
        QStringLiteral("check"), JobRunner::Queueing::Newest, tr("Checking"), Job::Kind::Quiet,
        [this, snapshot, surfaces = surfaces_](Progress& progress) -> JobRunner::Done {
            const Surfaces none;
            auto check = std::make_shared<const app::DailyCheck>(
                app::check_record(snapshot->record(), surfaces == nullptr ? none : *surfaces, progress));
            return [this, check, snapshot] {
                if (workspace_.is_open()) take(check, snapshot);
            };
        },
        [this](const QString& sentence) { workspace_.say(sentence); });
}

void ProblemListModel::take(std::shared_ptr<const app::DailyCheck> check, Workspace::SnapshotPtr snapshot) {
    const QString open_id = open_problem() != nullptr ? qt(open_problem()->id) : QString();
    beginResetModel();
    check_ = std::move(check);
    snapshot_ = std::move(snapshot);
    checked_ = snapshot_ != nullptr;
    rows_.clear();
    for (std::size_t i = 0; i < check_->problems.size(); ++i) {
        if (with_remarks_ || check_->problems[i].severity != model::Severity::Info) rows_.push_back(i);
    }
    endResetModel();
    emit checked();
    int again = -1;
    for (std::size_t row = 0; row < rows_.size() && !open_id.isEmpty(); ++row) {
        if (qt(check_->problems[rows_[row]].id) == open_id) again = static_cast<int>(row);
    }
    opened_ = -2;
    if (!open_id.isEmpty()) {
        open(again);
    } else {
        opened_ = -1;
        emit openedChanged();
    }
}

void ProblemListModel::set_with_remarks(bool with_remarks) {
    if (with_remarks == with_remarks_) return;
    with_remarks_ = with_remarks;
    take(check_, snapshot_);
}

QString ProblemListModel::summary() const {
    const auto count = [&](model::Severity severity) { return static_cast<int>(check_->count(severity)); };
    const int errors = count(model::Severity::Error);
    const int warnings = count(model::Severity::Warning);
    const int remarks = count(model::Severity::Info);
    if (errors + warnings == 0) {
        const QString well = tr("nothing contradicts anything");
        return remarks == 0 ? well : well + QStringLiteral(", ") + tr("%n remark(s)", nullptr, remarks);
    }
    return QStringList{tr("%n error(s)", nullptr, errors), tr("%n warning(s)", nullptr, warnings),
                       tr("%n remark(s)", nullptr, remarks)}
        .join(QStringLiteral(", "));
}

QStringList ProblemListModel::changes_since_sign_off() const {
    QStringList lines;
    if (snapshot_ == nullptr || check_->signed_off_at.empty()) return lines;
    for (const store::ChangeEntry& change : snapshot_->changes) { // newest first
        if (change.undone) continue;
        if (change.label == app::kSignOffLabel) break;
        const QString when = qt(change.made_at).left(16).replace(QLatin1Char('T'), QLatin1Char(' '));
        lines << tr("%1, %2: %3").arg(when, author_word(change.author), change_label(change.label));
    }
    return lines;
}

QStringList ProblemListModel::coverage() const {
    const model::Coverage& c = check_->coverage;
    QStringList lines;
    lines << tr("%1 relations state an order").arg(c.relations) << tr("%1 confirmed").arg(c.confirmed)
          << tr("%1 contradicted").arg(c.contradicted);
    for (const auto& [why, count] : c.untestable)
        lines << tr("%1 not testable: %2").arg(count).arg(in_window_language(why));
    return lines;
}

const Diagnostic* ProblemListModel::open_problem() const {
    if (opened_ < 0 || opened_ >= rowCount()) return nullptr;
    return &check_->problems[rows_[static_cast<std::size_t>(opened_)]];
}

void ProblemListModel::open(int row) {
    if (row == opened_) return;
    opened_ = row;
    const Diagnostic* problem = open_problem();
    if (problem == nullptr) opened_ = -1;
    workspace_.show_proof(problem == nullptr ? Proof{} : Proof{problem->units, problem->relations});
    emit openedChanged();
}

ProblemDetail ProblemListModel::detail() const {
    ProblemDetail detail;
    const Diagnostic* problem = open_problem();
    if (problem == nullptr) return detail;
    const model::RecordIndex& index = snapshot_->index();
    detail.id = qt(problem->id);
    detail.title = check_title(problem->code);
    detail.message = in_window_language(problem->message);
    detail.severity = problem->severity;
    detail.is_new = check_->new_ids.contains(problem->id);
    detail.has_faces = problem->code == "height-contradiction";
    for (const auto& [name, value] : problem->evidence) {
        detail.evidence << evidence_word(name) + QStringLiteral(": ") + evidence_text(value);
    }
    for (const NamedRelation& relation : problem->relations) detail.proof << sentence_of(relation, index);
    for (const model::Suspect& suspect : problem->suspects) {
        SuspectLine line;
        std::visit(SuspectWords{index, line}, suspect.what);
        line.percent = static_cast<int>(100.0 * suspect.score + 0.5);
        for (const std::string& why : suspect.reasons) line.reasons << in_window_language(why);
        detail.suspects.push_back(std::move(line));
    }
    return detail;
}

void ProblemListModel::act(std::size_t at, ProblemAction action, const QString& because_text, const QString& number) {
    const Diagnostic* problem = open_problem();
    if (problem == nullptr || at >= problem->suspects.size()) return;
    const model::Suspect suspect = problem->suspects[at];
    const std::string because = because_text.toStdString();
    workspace_.edit(action_word(action), [suspect, action, because,
                                          new_number = number.toStdString()](app::Project& project, Progress&) {
        const NamedRelation* named = relation_of(suspect);
        switch (action) {
        case ProblemAction::Withdraw: return app::withdraw_relation(project, named->relation, because);
        case ProblemAction::MarkUncertain: return app::mark_uncertain(project, named->relation, because);
        case ProblemAction::Reverse:
            return app::replace_relation(project, named->relation, {named->other, named->kind, named->unit}, because);
        case ProblemAction::MendNumber:
            return mend_number(project, std::get<model::SuspectNumber>(suspect.what), because);
        case ProblemAction::SplitUnit:
            return split(project, std::get<model::SuspectUnit>(suspect.what).unit, new_number, because);
        }
    });
}

void ProblemListModel::accept(const QString& because) {
    const Diagnostic* problem = open_problem();
    if (problem == nullptr) return;
    workspace_.edit(tr("Keep a problem silent"),
                    [id = problem->id, why = because.toStdString()](app::Project& project, Progress& progress) {
                        app::accept_problem(project, id, why, progress);
                    });
}

void ProblemListModel::sign_off() {
    workspace_.edit(tr("Sign the day off"),
                    [](app::Project& project, Progress& progress) { app::sign_off(project, progress); });
}

int ProblemListModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

QVariant ProblemListModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || index.row() >= rowCount()) return {};
    const Diagnostic& problem = check_->problems[rows_[static_cast<std::size_t>(index.row())]];
    switch (role) {
    case SeverityRole: return static_cast<int>(problem.severity);
    case TitleRole: return check_title(problem.code);
    case MessageRole: return in_window_language(problem.message);
    case NewRole: return check_->new_ids.contains(problem.id);
    case IdRole: return qt(problem.id);
    case CodeRole: return qt(problem.code);
    case Qt::DisplayRole: return check_title(problem.code) + QStringLiteral(": ") + in_window_language(problem.message);
    case Qt::AccessibleTextRole:
        return severity_word(problem.severity) + QStringLiteral(", ") + check_title(problem.code) +
               QStringLiteral(": ") + in_window_language(problem.message);
    default: return {};
    }
}

} // namespace planum::gui
