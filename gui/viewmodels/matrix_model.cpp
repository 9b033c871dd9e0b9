// SPDX-License-Identifier: MIT
#include "gui/viewmodels/matrix_model.hpp"

#include <algorithm>
#include <utility>

namespace planum::gui {

MatrixModel::MatrixModel(Workspace& workspace, const strat::TextMeasure& text, QObject* parent)
    : QObject(parent), workspace_(workspace), text_(text) {
    connect(&workspace_, &Workspace::snapshotChanged, this, &MatrixModel::draw_again);
    connect(&workspace_, &Workspace::selectionChanged, this, &MatrixModel::pointedOut);
    connect(&workspace_, &Workspace::proofChanged, this, [this] {
        find_proof();
        emit pointedOut();
    });
    connect(&workspace_, &Workspace::closed, this, [this] {
        drawing_.reset();
        index_.reset();
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
    workspace_.read(
        QStringLiteral("matrix"), tr("Drawing the matrix"),
        [this, request = request_](app::Project& project, Progress& progress) -> JobRunner::Done {
            auto drawing =
                std::make_shared<const strat::MatrixDrawing>(app::draw_matrix(project, request, text_, progress));
            auto index = std::make_shared<const strat::DrawingIndex>(*drawing);
            return [this, drawing = std::move(drawing), index = std::move(index)] {
                drawing_ = drawing;
                index_ = index;
                trouble_.clear();
                find_proof();
                emit drawn();
            };
        },
        [this](const QString& sentence) {
            drawing_.reset();
            index_.reset();
            trouble_ = sentence;
            emit drawn();
        });
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
