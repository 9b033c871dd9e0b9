// SPDX-License-Identifier: MIT
#include "gui/viewmodels/matrix_model.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "gui/viewmodels/problem_list_model.hpp"

namespace planum::gui {

MatrixModel::MatrixModel(Workspace& workspace, ProblemListModel& problems, const strat::TextMeasure& text,
                         QObject* parent)
    : QObject(parent), workspace_(workspace), problems_(problems), text_(text) {
    connect(&problems_, &ProblemListModel::checked, this, [this] {
        if (shows_evidence_) prepare_again();
    });
    connect(&workspace_, &Workspace::snapshotChanged, this, &MatrixModel::draw_again);
    connect(&workspace_, &Workspace::selectionChanged, this, &MatrixModel::pointedOut);
    connect(&workspace_, &Workspace::proofChanged, this, [this] {
        find_proof();
        emit pointedOut();
    });
    connect(&workspace_, &Workspace::closed, this, [this] {
        drawing_.reset();
        index_.reset();
        prepared_.reset();
        verdicts_.clear();
        drawing_now_ = false;
        request_ = {};
        stale_ = true;
        emit drawn();
    });
}

void MatrixModel::set_watched(bool watched) {
    watched_ = watched;
    if (watched_ && stale_) draw_again();
}

void MatrixModel::set_request(const app::DrawRequest& request) {
    request_ = request;
    draw_again();
}

void MatrixModel::draw_again() {
    stale_ = true;
    if (!watched_ || !workspace_.is_open()) return;
    stale_ = false;
    drawing_now_ = true;
    app::DrawRequest request = request_;
    request.language = language_;
    workspace_.read(
        QStringLiteral("matrix"), tr("Drawing the matrix"),
        [this, request = std::move(request), prepare = prepare_,
         judged = judged()](app::Project& project, Progress& progress) -> JobRunner::Done {
            auto drawing =
                std::make_shared<const strat::MatrixDrawing>(app::draw_matrix(project, request, text_, progress));
            auto index = std::make_shared<const strat::DrawingIndex>(*drawing);
            LineVerdicts verdicts;
            if (judged) verdicts = line_verdicts(*drawing, *index, judged->snapshot->record(), judged->of_relations);
            auto prepared = prepare ? prepare(drawing, verdicts) : nullptr;
            return [this, drawing = std::move(drawing), index = std::move(index), prepared = std::move(prepared),
                    verdicts = std::move(verdicts), judged] {
                drawing_now_ = false;
                drawing_ = drawing;
                index_ = index;
                prepared_ = prepared;
                verdicts_ = verdicts;
                trouble_.clear();
                find_proof();
                emit drawn();
                // Evidence was switched meanwhile, or the check of this record came while it was drawn.
                const auto now = this->judged();
                if ((now == nullptr) != (judged == nullptr) || (now && now->snapshot != judged->snapshot)) {
                    prepare_again();
                }
            };
        },
        [this](const QString& sentence) {
            drawing_now_ = false;
            drawing_.reset();
            index_.reset();
            prepared_.reset();
            verdicts_.clear();
            trouble_ = sentence;
            emit drawn();
        });
}

std::shared_ptr<const MatrixModel::Judged> MatrixModel::judged() const {
    if (!shows_evidence_ || !problems_.is_checked()) return nullptr;
    return std::make_shared<const Judged>(Judged{problems_.checked_snapshot(), problems_.check().verdicts});
}

void MatrixModel::set_shows_evidence(bool shows) {
    if (shows == shows_evidence_) return;
    shows_evidence_ = shows;
    prepare_again();
}

void MatrixModel::prepare_again() {
    if (drawing_ == nullptr || drawing_now_) return; // a drawing that is being made is made ready then
    workspace_.jobs().start(
        QStringLiteral("matrix ink"), JobRunner::Queueing::Newest, tr("Drawing the matrix"), Job::Kind::Quiet,
        [this, drawing = drawing_, index = index_, prepare = prepare_,
         judged = judged()](Progress&) -> JobRunner::Done {
            LineVerdicts verdicts;
            if (judged) verdicts = line_verdicts(*drawing, *index, judged->snapshot->record(), judged->of_relations);
            auto prepared = prepare ? prepare(drawing, verdicts) : nullptr;
            return [this, drawing, prepared = std::move(prepared), verdicts = std::move(verdicts)] {
                if (drawing != drawing_) return; // another one came meanwhile
                prepared_ = prepared;
                verdicts_ = verdicts;
                emit drawn();
            };
        },
        [this](const QString& sentence) { workspace_.say(sentence); });
}

std::optional<std::size_t> MatrixModel::selected_box() const {
    if (!index_ || workspace_.selected().is_nil()) return std::nullopt;
    return index_->box_of(workspace_.selected());
}

void MatrixModel::find_proof() {
    proof_boxes_.clear();
    proof_lines_.clear();
    if (!index_) return;
    const Proof& proof = workspace_.proof();
    for (const model::UnitId unit : proof.units) {
        if (const auto box = index_->box_of(unit)) proof_boxes_.insert(*box);
    }
    for (const model::NamedRelation& relation : proof.relations) {
        const auto upper = index_->box_of(relation.unit);
        const auto lower = index_->box_of(relation.other);
        if (!upper || !lower) continue;
        proof_boxes_.insert(*upper);
        proof_boxes_.insert(*lower);
        for (const std::size_t line : index_->lines_below(*upper)) {
            if (drawing_->lines[line].earlier == *lower) proof_lines_.insert(line);
        }
    }
    if (!proof.relations.empty()) return;
    // Units alone, as in a cycle that is only about to be closed: the lines between neighbours of the list.
    for (std::size_t i = 0; i < proof.units.size(); ++i) {
        const auto a = index_->box_of(proof.units[i]);
        const auto b = index_->box_of(proof.units[(i + 1) % proof.units.size()]);
        if (!a || !b) continue;
        for (const std::size_t line : index_->lines_below(*a)) {
            if (drawing_->lines[line].earlier == *b) proof_lines_.insert(line);
        }
    }
}

void MatrixModel::select_box(std::size_t box) {
    if (!drawing_ || box >= drawing_->boxes.size() || drawing_->boxes[box].units.empty()) return;
    const auto& units = drawing_->boxes[box].units;
    const auto it = std::find(units.begin(), units.end(), workspace_.selected());
    const bool another = it != units.end() && it + 1 != units.end();
    workspace_.select(another ? *(it + 1) : units.front());
}

} // namespace planum::gui
