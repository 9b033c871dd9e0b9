// SPDX-License-Identifier: MIT
#include "gui/widgets/space/space_canvas.hpp"

#include <QElapsedTimer>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QSurfaceFormat>
#include <QWheelEvent>

#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "core/base/error.hpp"
#include "gui/viewmodels/words.hpp"
#include "gui/widgets/theme.hpp"

namespace planum::gui {

namespace {

constexpr std::uint64_t kMovingPoints = 300'000;
constexpr std::uint64_t kStillPoints = 4'000'000;
constexpr int kSettle = 180; // [ms] without a move before the fine set is chosen
constexpr double kClick = 4.0;
constexpr double kRound = 0.55; // share of the ball around all scans that fit() shows: fences stand far off

QSurfaceFormat wanted_format() {
    QSurfaceFormat format;
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(24);
    return format;
}

std::uint32_t tint_of(std::size_t day) {
    constexpr std::array<std::uint32_t, 6> kTints = {0xe07a3f, 0x3f9be0, 0x6cc070, 0xc46ad6, 0xd9c04a, 0x55c7c0};
    return kTints[day % kTints.size()];
}

} // namespace

QString opengl_trouble() {
    QOffscreenSurface surface;
    surface.setFormat(wanted_format());
    surface.create();
    QOpenGLContext context;
    context.setFormat(wanted_format());
    if (!context.create() || !context.makeCurrent(&surface)) {
        return SpaceCanvas::tr(
            "The 3D view needs OpenGL 3.3, which this display does not offer. All other views work.");
    }
    const auto version = context.format().version();
    context.doneCurrent();
    if (version < std::pair(3, 3)) {
        return SpaceCanvas::tr("The 3D view needs OpenGL 3.3; there is %1.%2 here. All other views work.")
            .arg(version.first)
            .arg(version.second);
    }
    return {};
}

SpaceCanvas::SpaceCanvas(Workspace& workspace, SpaceModel& space)
    : workspace_(workspace), space_(space), renderer_(std::make_unique<SceneRenderer>()) {
    setObjectName(QStringLiteral("spaceCanvas"));
    setAccessibleName(tr("The site in 3D"));
    setFormat(wanted_format());
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(200, 150);
    settle_.setSingleShot(true);
    settle_.setInterval(kSettle);
    connect(&settle_, &QTimer::timeout, this, [this] { ask_for_points(SceneRenderer::Slot::Still); });
    connect(&space_, &SpaceModel::loaded, this, &SpaceCanvas::take_scans);
    connect(&space_, &SpaceModel::outlinesChanged, this, &SpaceCanvas::take_lines);
}

SpaceCanvas::~SpaceCanvas() {
    makeCurrent();
    renderer_.reset();
    doneCurrent();
}

void SpaceCanvas::initializeGL() {
    try {
        renderer_->initialise();
    } catch (const Error& error) {
        emit troubled(qt(error.what()));
        return;
    }
    take_scans();
}

void SpaceCanvas::take_scans() {
    const bool first = scans_.empty();
    scans_.clear();
    std::vector<std::string> days;
    for (const app::PlacedScan& placed : space_.scans()) {
        auto day = std::find(days.begin(), days.end(), placed.scan.day);
        if (day == days.end()) day = days.insert(days.end(), placed.scan.day);
        scans_.push_back({placed.store, placed.site_from_scan, tint_of(static_cast<std::size_t>(day - days.begin()))});
    }
    if (scans_.empty()) {
        if (isValid()) {
            makeCurrent();
            renderer_->set_points(SceneRenderer::Slot::Moving, {});
            renderer_->set_points(SceneRenderer::Slot::Still, {});
            doneCurrent();
        }
        update();
        return;
    }
    const SceneBounds bounds = bounds_of(scans_);
    origin_ = bounds.middle;
    if (first) fit();
    take_lines();
    ask_for_points(SceneRenderer::Slot::Moving);
    move();
}

// The trench is where the outlines are; without any, where the scanners stood.
void SpaceCanvas::fit() {
    Eigen::Vector3d low = Eigen::Vector3d::Constant(1e300);
    Eigen::Vector3d high = Eigen::Vector3d::Constant(-1e300);
    for (const SpaceModel::Outline& outline : space_.outlines()) {
        for (const auto& p : outline.ring) {
            low = low.cwiseMin(Eigen::Vector3d(p.data()));
            high = high.cwiseMax(Eigen::Vector3d(p.data()));
        }
    }
    if (low.x() > high.x()) {
        for (const ShownScan& scan : scans_) {
            low = low.cwiseMin(scan.site_from_scan.translation - Eigen::Vector3d(3.0, 3.0, 3.0));
            high = high.cwiseMax(scan.site_from_scan.translation + Eigen::Vector3d(3.0, 3.0, 0.0));
        }
    }
    if (low.x() > high.x()) return;
    low_ = low.z();
    high_ = std::max(high.z(), low.z() + 0.2);
    camera_.look_at((low + high) / 2.0, (high - low).norm() * kRound);
    move();
}

void SpaceCanvas::from_above() {
    camera_.from_above = true;
    move();
}

void SpaceCanvas::set_colour(PointColour colour) {
    colour_ = colour;
    ask_for_points(SceneRenderer::Slot::Moving);
    move();
}

void SpaceCanvas::set_eye_dome(bool on) {
    eye_dome_ = on;
    update();
}

void SpaceCanvas::move() {
    still_ = false;
    settle_.start();
    update();
}

void SpaceCanvas::ask_for_points(SceneRenderer::Slot slot) {
    if (scans_.empty()) return;
    PointQuery query;
    query.camera = camera_;
    query.aspect = aspect();
    query.everywhere = slot == SceneRenderer::Slot::Moving;
    query.budget = query.everywhere ? kMovingPoints : kStillPoints;
    query.colour = colour_;
    query.origin = origin_;
    query.height_low = low_;
    query.height_high = high_;
    workspace_.jobs().start(
        query.everywhere ? QStringLiteral("points moving") : QStringLiteral("points still"),
        JobRunner::Queueing::Newest, tr("Choosing points"), Job::Kind::Quiet,
        [this, query, slot, scans = scans_](Progress& progress) -> JobRunner::Done {
            auto set = std::make_shared<const PointSet>(choose_points(scans, query, progress));
            return [this, set, slot] {
                if (!isValid()) return;
                makeCurrent();
                renderer_->set_points(slot, *set);
                doneCurrent();
                if (slot == SceneRenderer::Slot::Still) still_ = true;
                update();
            };
        },
        [this](const QString& sentence) { emit troubled(sentence); });
}

void SpaceCanvas::take_lines() {
    if (!isValid()) return;
    std::vector<SceneLine> lines;
    const Proof& proof = workspace_.proof();
    const auto colour = [](const QColor& c) { return static_cast<std::uint32_t>(c.rgb() & 0xffffffU); };
    for (const SpaceModel::Outline& outline : space_.outlines()) {
        SceneLine line;
        for (const auto& p : outline.ring) line.places.emplace_back(p.data());
        line.closed = true;
        const bool selected = !outline.unit.is_nil() && outline.unit == workspace_.selected();
        const bool in_proof = std::find(proof.units.begin(), proof.units.end(), outline.unit) != proof.units.end();
        line.strong = selected || in_proof;
        line.colour = in_proof ? colour(theme().error) : selected ? 0x1fb6ff : 0xffd166;
        lines.push_back(std::move(line));
    }
    makeCurrent();
    renderer_->set_lines(lines, origin_);
    doneCurrent();
    update();
}

void SpaceCanvas::paintGL() {
    QElapsedTimer timer;
    timer.start();
    SceneRenderer::Frame frame;
    frame.camera = camera_;
    const double pixels = devicePixelRatioF();
    frame.width = std::max(1, static_cast<int>(width() * pixels));
    frame.height = std::max(1, static_cast<int>(height() * pixels));
    frame.slot = still_ ? SceneRenderer::Slot::Still : SceneRenderer::Slot::Moving;
    frame.eye_dome = eye_dome_ && still_;
    frame.point_pixels = still_ ? 2.0F : 2.5F;
    frame.ground = theme().kind == ThemeKind::Sunlight ? 0xffffffU : 0x24272bU;
    frame.target_framebuffer = defaultFramebufferObject();
    try {
        renderer_->draw(frame);
        context()->functions()->glFinish();
    } catch (const Error& error) {
        emit troubled(qt(error.what()));
    }
    drawn_ = renderer_->points(frame.slot);
    frame_ms_ = static_cast<double>(timer.nsecsElapsed()) / 1e6;
    emit framed();
}

void SpaceCanvas::mousePressEvent(QMouseEvent* event) {
    last_ = pressed_ = event->position();
    dragged_ = false;
}

void SpaceCanvas::mouseMoveEvent(QMouseEvent* event) {
    const QPointF step = event->position() - last_;
    last_ = event->position();
    if (event->buttons() == Qt::NoButton) return;
    if ((event->position() - pressed_).manhattanLength() > kClick) dragged_ = true;
    if (!dragged_) return;
    const bool shifts = event->buttons().testFlag(Qt::RightButton) || event->buttons().testFlag(Qt::MiddleButton) ||
                        event->modifiers().testFlag(Qt::ShiftModifier) || camera_.from_above;
    if (shifts) {
        camera_.pan(-step.x() / height(), step.y() / height());
    } else {
        constexpr double kTurn = 0.008; // [rad per px]
        camera_.orbit(-step.x() * kTurn, step.y() * kTurn);
    }
    move();
}

void SpaceCanvas::mouseReleaseEvent(QMouseEvent* event) {
    if (!dragged_) pick_at(event->position(), event->modifiers().testFlag(Qt::ShiftModifier));
    dragged_ = false;
}

void SpaceCanvas::wheelEvent(QWheelEvent* event) {
    camera_.zoom(std::pow(1.18, event->angleDelta().y() / 120.0));
    move();
    event->accept();
}

void SpaceCanvas::keyPressEvent(QKeyEvent* event) {
    constexpr double kTurn = 0.12;
    switch (event->key()) {
    case Qt::Key_Left: camera_.orbit(-kTurn, 0.0); return move();
    case Qt::Key_Right: camera_.orbit(kTurn, 0.0); return move();
    case Qt::Key_Up: camera_.orbit(0.0, kTurn); return move();
    case Qt::Key_Down: camera_.orbit(0.0, -kTurn); return move();
    case Qt::Key_Plus:
    case Qt::Key_Equal: camera_.zoom(1.2); return move();
    case Qt::Key_Minus: camera_.zoom(1.0 / 1.2); return move();
    case Qt::Key_F:
    case Qt::Key_Home: return fit();
    case Qt::Key_T: return from_above();
    default: QOpenGLWidget::keyPressEvent(event);
    }
}

// Looking into the point store takes a while where it is large: in a thread.
void SpaceCanvas::pick_at(QPointF at, bool measure) {
    if (scans_.empty()) return;
    const Camera::Sight sight = camera_.sight(2.0 * at.x() / width() - 1.0, 1.0 - 2.0 * at.y() / height(), aspect());
    const double spread = camera_.from_above ? 0.0 : 3.0 * std::tan(camera_.opening / 2.0) / height();
    workspace_.jobs().start(
        QStringLiteral("pick"), JobRunner::Queueing::Newest, tr("Looking up a point"), Job::Kind::Quiet,
        [this, sight, spread, measure, scans = scans_](Progress&) -> JobRunner::Done {
            const auto place = pick_point(scans, sight, spread);
            return [this, place, measure] {
                if (!place) return;
                emit picked(place->x(), place->y(), place->z());
                if (!measure) {
                    measure_from_.reset();
                    const model::UnitId unit = space_.unit_at(place->x(), place->y());
                    if (!unit.is_nil()) workspace_.select(unit);
                    return;
                }
                if (measure_from_) emit measured((*place - *measure_from_).norm(), place->z() - measure_from_->z());
                measure_from_ = measure_from_ ? std::nullopt : place;
            };
        },
        [this](const QString& sentence) { emit troubled(sentence); });
}

} // namespace planum::gui
