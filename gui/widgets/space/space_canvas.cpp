// SPDX-License-Identifier: MIT
#include "gui/widgets/space/space_canvas.hpp"

#include <QElapsedTimer>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QSurfaceFormat>
#include <QWheelEvent>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "core/base/error.hpp"
#include "gui/viewmodels/region_shapes.hpp"
#include "gui/viewmodels/words.hpp"
#include "gui/widgets/space/ground_tints.hpp"
#include "gui/widgets/theme.hpp"

namespace planum::gui {

namespace {

constexpr std::uint64_t kMovingPoints = 260'000;
constexpr std::uint64_t kStillPoints = 4'000'000;
constexpr std::uint64_t kFlightPoints = 1'500'000; // of each frame of a flight: there are hundreds
constexpr int kSettle = 180; // [ms] at least without a move before the fine set is chosen; of a slow frame, half as
                             // long again as it took, else the set is chosen between two moves
constexpr double kSlowFrame = 70.0; // [ms]: from then on points are drawn smaller while the camera moves
constexpr const char* kMovingLane = "points moving";
constexpr const char* kStillLane = "points still";
constexpr int kStep = 25; // [ms] of work on the still picture between two looks at what was pressed
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
    // Qt's platforms without a screen may well hand out a context, yet none that a widget can draw with.
    if (const QString platform = QGuiApplication::platformName();
        platform == QLatin1String("offscreen") || platform == QLatin1String("minimal")) {
        return SpaceCanvas::tr("The 3D view needs a display; the program runs without one (%1). All other views work.")
            .arg(platform);
    }
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
    : workspace_(workspace), space_(space), flight_(workspace.jobs()) {
    setObjectName(QStringLiteral("spaceCanvas"));
    setAccessibleName(tr("The site in 3D"));
    setFormat(wanted_format());
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(200, 110);
    settle_.setSingleShot(true);
    connect(&settle_, &QTimer::timeout, this, [this] { ask_for_points(SceneRenderer::Slot::Still); });
    connect(&step_, &QTimer::timeout, this, &SpaceCanvas::go_on_with_still);
    connect(&flight_, &FlightWriter::wanted, this, &SpaceCanvas::show_frame);
    connect(&space_, &SpaceModel::loaded, this, &SpaceCanvas::take_scans);
    connect(&space_, &SpaceModel::outlinesChanged, this, &SpaceCanvas::take_lines);
    connect(&workspace_, &Workspace::snapshotChanged, this, [this] {
        if (colour_ == PointColour::Unit) set_colour(colour_);
    });
}

SpaceCanvas::~SpaceCanvas() { drop_renderer(); }

// What it keeps belongs to one context; with the context it goes.
void SpaceCanvas::drop_renderer() {
    step_.stop();
    still_ = false;
    if (renderer_ == nullptr) return;
    makeCurrent();
    renderer_.reset();
    doneCurrent();
}

// Called again where the window is moved to another screen's driver.
void SpaceCanvas::initializeGL() {
    connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &SpaceCanvas::drop_renderer,
            Qt::ConnectionType(Qt::DirectConnection | Qt::UniqueConnection));
    try {
        renderer_ = std::make_unique<SceneRenderer>();
        renderer_->initialise();
    } catch (const Error& error) {
        emit troubled(qt(error.what()));
        return;
    }
    take_scans();
}

void SpaceCanvas::take_scans() {
    scans_.clear();
    for (const app::PlacedScan& placed : space_.scans())
        scans_.push_back({placed.store, placed.site_from_scan, tint_of(space_.place_of_day(placed.scan.day))});
    if (!workspace_.is_open()) fitted_ = false;
    if (!scans_.empty()) origin_ = bounds_of(scans_).middle;
    if (!scans_.empty() && !std::exchange(fitted_, true)) fit();
    take_lines(); // where all scans are switched off, outlines may be left
    if (scans_.empty()) return show_no_points();
    ask_for_points(SceneRenderer::Slot::Moving);
    move();
}

void SpaceCanvas::show_no_points() {
    for (const char* lane : {kMovingLane, kStillLane}) workspace_.jobs().cancel(QString::fromLatin1(lane));
    if (can_draw()) {
        makeCurrent();
        renderer_->set_moving({});
        doneCurrent();
    }
    settle_.stop();
    step_.stop();
    still_ = false;
    setProperty("busy", false);
    update();
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

void SpaceCanvas::set_difference(std::shared_ptr<const GroundColours> colours) {
    if (colours == difference_) return;
    difference_ = std::move(colours);
    if (colour_ == PointColour::Difference) set_colour(colour_);
}

void SpaceCanvas::set_eye_dome(bool on) {
    eye_dome_ = on;
    if (!still_ || !can_draw()) return;
    renderer_->draw_still_again(frame(SceneRenderer::Slot::Still));
    still_ = false;
    step_.start();
}

void SpaceCanvas::set_box(const std::array<double, 3>& low, const std::array<double, 3>& high) {
    box_ = {};
    const SceneCorners all = corners_of(scans_);
    for (int axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<std::size_t>(axis);
        const double span = all.high(axis) - all.low(axis);
        if (low.at(i) > 0.0) box_.low(axis) = all.low(axis) + low.at(i) * span;
        if (high.at(i) < 1.0) box_.high(axis) = all.low(axis) + high.at(i) * span;
    }
    move();
}

// Where little is left of the scans, more of it can be shown: other points are chosen.
void SpaceCanvas::set_slab(const SceneSlab& slab) {
    if (slab == slab_) return;
    slab_ = slab;
    ask_for_points(SceneRenderer::Slot::Moving);
    move();
}

void SpaceCanvas::set_marks(std::vector<SceneLine> marks) {
    marks_ = std::move(marks);
    take_lines();
}

void SpaceCanvas::face(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
    const Eigen::Vector3d eye = -slab_.normal; // `from` on the left
    camera_.from_above = false;
    camera_.yaw = std::atan2(eye.y(), eye.x());
    camera_.pitch = 0.0;
    camera_.look_at((from + to) / 2.0, (to - from).norm() * kRound);
    move();
}

// One frame of a flight: the fine points of where the camera is now, nothing else in between.
void SpaceCanvas::show_frame(const Camera& camera) {
    camera_ = camera;
    still_ = false;
    step_.stop();
    settle_.stop();
    setProperty("busy", true);
    ask_for_points(SceneRenderer::Slot::Still);
}

// Choosing fine points for where the camera no longer is would take a core from the driver that draws the moving ones.
void SpaceCanvas::move() {
    flight_.stop();
    workspace_.jobs().cancel(QString::fromLatin1(kStillLane));
    if (scans_.empty()) return show_no_points();
    still_ = false;
    step_.stop();
    settle_.start(std::max(kSettle, static_cast<int>(1.5 * frame_ms_)));
    setProperty("busy", true);
    update();
}

// The millions of points of the still picture are drawn beside the screen, a little at a time.
void SpaceCanvas::go_on_with_still() {
    if (!can_draw()) return step_.stop();
    makeCurrent();
    try {
        still_ = renderer_->advance_still(kStep);
    } catch (const Error& error) {
        step_.stop();
        emit troubled(qt(error.what()));
    }
    doneCurrent();
    if (!still_) return;
    step_.stop();
    setProperty("busy", false);
    update();
    if (flight_.is_flying()) flight_.take(grabFramebuffer());
}

void SpaceCanvas::ask_for_points(SceneRenderer::Slot slot) {
    if (scans_.empty()) return;
    PointQuery query;
    query.camera = camera_;
    query.aspect = aspect();
    query.everywhere = slot == SceneRenderer::Slot::Moving;
    query.budget = query.everywhere ? kMovingPoints : flight_.is_flying() ? kFlightPoints : kStillPoints;
    query.colour = colour_;
    query.origin = origin_;
    query.cuts = slab_.planes();
    query.height_low = low_;
    query.height_high = high_;
    workspace_.jobs().start(
        QString::fromLatin1(query.everywhere ? kMovingLane : kStillLane), JobRunner::Queueing::Newest,
        tr("Choosing points"), Job::Kind::Quiet,
        [this, query, slot, scans = scans_, snapshot = workspace_.snapshot(), surface = space_.surface(),
         difference = difference_](Progress& progress) mutable -> JobRunner::Done {
            if (query.colour == PointColour::Unit && snapshot != nullptr && !surface.is_nil())
                query.tints = tints_of(regions_in_plan(*snapshot, surface), snapshot->index());
            if (query.colour == PointColour::Difference && difference != nullptr) query.tints = tints_of(*difference);
            auto set = std::make_shared<const PointSet>(choose_points(scans, query, progress));
            return [this, set, slot] {
                if (!can_draw()) return;
                if (slot == SceneRenderer::Slot::Still) {
                    if (settle_.isActive()) return; // moved meanwhile: another set is asked for soon
                    renderer_->set_still(set, frame(slot));
                    step_.start();
                    return;
                }
                makeCurrent();
                renderer_->set_moving(*set);
                doneCurrent();
                update();
            };
        },
        [this](const QString& sentence) { emit troubled(sentence); });
}

void SpaceCanvas::take_lines() {
    if (!can_draw()) return;
    const std::vector<SpaceModel::Outline> outlines = space_.outlines();
    if (scans_.empty() && !outlines.empty()) {
        origin_ = Eigen::Vector3d(outlines.front().ring.front().data());
        if (!std::exchange(fitted_, true)) fit();
    }
    std::vector<SceneLine> lines;
    const Proof& proof = workspace_.proof();
    const auto colour = [](const QColor& c) { return static_cast<std::uint32_t>(c.rgb() & 0xffffffU); };
    for (const SpaceModel::Outline& outline : outlines) {
        SceneLine line;
        for (const auto& p : outline.ring) line.places.emplace_back(p.data());
        line.closed = true;
        const bool selected = !outline.unit.is_nil() && outline.unit == workspace_.selected();
        const bool in_proof = std::find(proof.units.begin(), proof.units.end(), outline.unit) != proof.units.end();
        line.strong = selected || in_proof;
        line.colour = in_proof ? colour(theme().error) : selected ? 0x1fb6ff : 0xffd166;
        lines.push_back(std::move(line));
    }
    lines.insert(lines.end(), marks_.begin(), marks_.end());
    makeCurrent();
    renderer_->set_lines(lines, origin_);
    doneCurrent();
    update();
}

void SpaceCanvas::resizeGL(int, int) {
    if (!scans_.empty()) move();
}

SceneRenderer::Frame SpaceCanvas::frame(SceneRenderer::Slot slot) const {
    SceneRenderer::Frame frame;
    frame.camera = camera_;
    const double pixels = devicePixelRatioF();
    frame.width = std::max(1, static_cast<int>(width() * pixels));
    frame.height = std::max(1, static_cast<int>(height() * pixels));
    frame.slot = slot;
    frame.eye_dome = eye_dome_;
    frame.box = box_;
    frame.slab = slab_;
    // Without a graphics card each pixel counts: points of 1.5 instead of 2.5 pixels take half of the time.
    frame.point_pixels = slot == SceneRenderer::Slot::Still ? 2.0F : slow_ ? 1.5F : 2.5F;
    frame.ground = theme().kind == ThemeKind::Sunlight ? 0xffffffU : 0x24272bU;
    return frame;
}

void SpaceCanvas::paintGL() {
    if (!can_draw() || QOpenGLContext::currentContext() == nullptr) return;
    QElapsedTimer timer;
    timer.start();
    SceneRenderer::Frame frame = this->frame(still_ ? SceneRenderer::Slot::Still : SceneRenderer::Slot::Moving);
    frame.target_framebuffer = defaultFramebufferObject();
    try {
        renderer_->draw(frame);
        context()->functions()->glFinish();
    } catch (const Error& error) {
        emit troubled(qt(error.what()));
    }
    drawn_ = renderer_->points(frame.slot);
    frame_ms_ = static_cast<double>(timer.nsecsElapsed()) / 1e6;
    if (frame.slot == SceneRenderer::Slot::Moving && frame_ms_ > kSlowFrame) slow_ = true;
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
    const std::optional<SightPart> part = part_inside(sight, box_, slab_);
    if (!part) return emit missed(); // all of it is cut away
    workspace_.jobs().start(
        QStringLiteral("pick"), JobRunner::Queueing::Newest, tr("Looking up a point"), Job::Kind::Quiet,
        [this, part, spread, measure, clicks = clicks_, scans = scans_](Progress&) -> JobRunner::Done {
            const auto place = pick_point(scans, *part, spread);
            return [this, place, measure, clicks] {
                if (!place) return emit missed();
                emit picked(place->x(), place->y(), place->z());
                if (clicks == Clicks::Place) return;
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
