// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <QString>

#include <memory>
#include <set>

#include "app/drawing/draw_matrix.hpp"
#include "gui/viewmodels/workspace.hpp"
#include "strat/layout/drawing.hpp"
#include "strat/layout/drawing_index.hpp"
#include "strat/layout/text_measure.hpp"

namespace planum::gui {

/// The drawing of the matrix, made anew in a thread whenever the record or the choice of what is drawn changes, with
/// what of it is to be pointed out: the unit selected and the proof of the open problem.
class MatrixModel : public QObject {
    Q_OBJECT

  public:
    /// `text` must outlive the model and answer in any thread.
    MatrixModel(Workspace& workspace, const strat::TextMeasure& text, QObject* parent = nullptr);

    /// Drawing costs time: nothing is drawn while nobody looks.
    void set_watched(bool watched);

    void set_request(const app::DrawRequest& request);

    [[nodiscard]] const app::DrawRequest& request() const noexcept { return request_; }

    /// Null until the first drawing is there.
    [[nodiscard]] const std::shared_ptr<const strat::MatrixDrawing>& drawing() const noexcept { return drawing_; }

    [[nodiscard]] const strat::DrawingIndex& index() const { return *index_; }

    /// Why there is no drawing; empty where there is one, or none was asked for yet.
    [[nodiscard]] const QString& trouble() const noexcept { return trouble_; }

    [[nodiscard]] std::optional<std::size_t> selected_box() const;

    /// Boxes and lines of the open problem's proof.
    [[nodiscard]] const std::set<std::size_t>& proof_boxes() const noexcept { return proof_boxes_; }

    [[nodiscard]] const std::set<std::size_t>& proof_lines() const noexcept { return proof_lines_; }

    /// Selects the unit of the box; with several (merged by same_as, folded) the next one each time.
    void select_box(std::size_t box);

  signals:
    /// Another drawing.
    void drawn();
    /// The same drawing, other things pointed out.
    void pointedOut();

  private:
    void draw_again();
    void find_proof();

    Workspace& workspace_;
    const strat::TextMeasure& text_;
    app::DrawRequest request_;
    bool watched_ = false;
    bool stale_ = true;
    std::shared_ptr<const strat::MatrixDrawing> drawing_;
    std::shared_ptr<const strat::DrawingIndex> index_;
    QString trouble_;
    std::set<std::size_t> proof_boxes_;
    std::set<std::size_t> proof_lines_;
};

} // namespace planum::gui
