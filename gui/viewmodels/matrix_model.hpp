// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <QString>

#include <functional>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "app/drawing/draw_matrix.hpp"
#include "core/model/diagnostic.hpp"
#include "gui/viewmodels/workspace.hpp"
#include "strat/layout/drawing.hpp"
#include "strat/layout/drawing_evidence.hpp"
#include "strat/layout/drawing_index.hpp"
#include "strat/layout/text_measure.hpp"

namespace planum::gui {

class ProblemListModel;

/// See strat::line_verdicts(); empty: not asked for.
using LineVerdicts = std::vector<model::EvidenceVerdict>;
using strat::line_verdicts;

/// The drawing of the matrix, made anew in a thread whenever the record or the choice of what is drawn changes, with
/// what of it is to be pointed out: the unit selected and the proof of the open problem.
class MatrixModel : public QObject {
    Q_OBJECT

  public:
    /// What a view needs to show a drawing, made in the thread that made the drawing: a large one takes a while.
    using Prepare =
        std::function<std::shared_ptr<const void>(std::shared_ptr<const strat::MatrixDrawing>, const LineVerdicts&)>;

    /// `text` must outlive the model and answer in any thread.
    MatrixModel(Workspace& workspace, ProblemListModel& problems, const strat::TextMeasure& text,
                QObject* parent = nullptr);

    void set_prepare(Prepare prepare) { prepare_ = std::move(prepare); }

    /// What `prepare` made of drawing(); null without one.
    [[nodiscard]] const std::shared_ptr<const void>& prepared() const noexcept { return prepared_; }

    /// The same drawing made ready once more, in a thread; drawn() says when: other colours, other verdicts.
    void prepare_again();

    /// Lines show whether surfaces, sections and levels confirm or contradict them.
    void set_shows_evidence(bool shows);

    [[nodiscard]] bool shows_evidence() const noexcept { return shows_evidence_; }

    /// Of drawing(); empty while evidence is not shown.
    [[nodiscard]] const LineVerdicts& verdicts() const noexcept { return verdicts_; }

    /// Drawing costs time: nothing is drawn while nobody looks.
    void set_watched(bool watched);

    /// Code of the language of key and headings, for drawings to come.
    void set_language(std::string code) { language_ = std::move(code); }

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
    /// What a thread needs to judge lines; null: not asked for, or nothing is known yet.
    struct Judged {
        Workspace::SnapshotPtr snapshot;
        std::vector<model::EvidenceVerdict> of_relations;
    };

    [[nodiscard]] std::shared_ptr<const Judged> judged() const;
    void draw_again();
    void find_proof();

    Workspace& workspace_;
    ProblemListModel& problems_;
    Prepare prepare_;
    bool shows_evidence_ = false;
    bool drawing_now_ = false;
    std::shared_ptr<const void> prepared_;
    LineVerdicts verdicts_;
    const strat::TextMeasure& text_;
    app::DrawRequest request_;
    std::string language_;
    bool watched_ = false;
    bool stale_ = true;
    std::shared_ptr<const strat::MatrixDrawing> drawing_;
    std::shared_ptr<const strat::DrawingIndex> index_;
    QString trouble_;
    std::set<std::size_t> proof_boxes_;
    std::set<std::size_t> proof_lines_;
};

} // namespace planum::gui
