// SPDX-License-Identifier: MIT
#include "gui/widgets/problems/proof_picture.hpp"

#include <QDialog>
#include <QGuiApplication>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <QScreen>
#include <QScrollArea>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

#include "app/checks/contradiction_sheet.hpp"
#include "gui/viewmodels/models.hpp"
#include "gui/viewmodels/words.hpp"
#include "gui/widgets/theme.hpp"
#include "paint/sheet_group_painter.hpp"

namespace planum::gui {

namespace {

constexpr double kDots = 144.0; // an inch; legible when shown large
constexpr int kWidest = 620;    // in the pane [px]

} // namespace

ProofPicture::ProofPicture(Models& models) : models_(models) {
    setObjectName(QStringLiteral("proofPicture"));
    setAccessibleName(tr("Both faces in plan and cross-section"));
    QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
    setVisible(false);
    connect(&models_.problems, &ProblemListModel::openedChanged, this, &ProofPicture::draw_again);
}

QSize ProofPicture::sizeHint() const { return {kWidest, heightForWidth(kWidest)}; }

int ProofPicture::heightForWidth(int width) const {
    constexpr int kLineOfWords = 60;
    if (picture_.isNull()) return kLineOfWords;
    return std::min(width, kWidest) * picture_.height() / picture_.width();
}

void ProofPicture::draw_again() {
    const ProblemDetail detail = models_.problems.detail();
    setVisible(detail.has_faces);
    if (!detail.has_faces) return take({}, {}, {});
    if (detail.id != problem_) take(detail.id, {}, tr("drawing both faces …"));
    models_.workspace.read(
        QStringLiteral("proof"), tr("Drawing the proof"),
        [this, id = detail.id](app::Project& project, Progress& progress) -> JobRunner::Done {
            const auto sheet = app::contradiction_sheet(project, id.toStdString(), {}, progress);
            const std::string png = paint::render_sheet_group_png(sheet.group, kDots);
            QImage picture;
            picture.loadFromData(reinterpret_cast<const uchar*>(png.data()), static_cast<int>(png.size()), "PNG");
            return [this, id, picture] {
                if (id == problem_) take(id, picture, {});
            };
        },
        [this, id = detail.id](const QString& sentence) {
            if (id == problem_) take(id, {}, sentence);
        });
}

void ProofPicture::take(const QString& problem, QImage picture, QString sentence) {
    problem_ = problem;
    picture_ = std::move(picture);
    sentence_ = std::move(sentence);
    setCursor(picture_.isNull() ? Qt::ArrowCursor : Qt::PointingHandCursor);
    setToolTip(picture_.isNull() ? QString() : tr("Click to see it large"));
    updateGeometry();
    update();
}

QRectF ProofPicture::box() const {
    return {QPointF(), QSizeF(picture_.size()).scaled(QSizeF(size()), Qt::KeepAspectRatio)};
}

void ProofPicture::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    if (picture_.isNull()) {
        painter.setPen(theme().faint);
        painter.drawText(rect().adjusted(12, 12, -12, -12), Qt::AlignCenter | Qt::TextWordWrap, sentence_);
        return;
    }
    const QRectF at = box();
    // Scaled down in the image, not by the painter: fine lines would break up.
    const QSize pixels = (at.size() * devicePixelRatioF()).toSize();
    painter.drawImage(at, picture_.scaled(pixels, Qt::IgnoreAspectRatio, Qt::SmoothTransformation));
}

void ProofPicture::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || picture_.isNull()) return;
    auto* dialog = new QDialog(this);
    dialog->setObjectName(QStringLiteral("proofLarge"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(models_.problems.detail().title);
    auto* label = new QLabel;
    label->setPixmap(QPixmap::fromImage(picture_));
    auto* scroll = new QScrollArea;
    scroll->setWidget(label);
    auto* column = new QVBoxLayout(dialog);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(scroll);
    const QSize room = QGuiApplication::primaryScreen()->availableSize() * 0.9;
    dialog->resize((picture_.size() + QSize(24, 24)).boundedTo(room));
    dialog->show();
}

} // namespace planum::gui
