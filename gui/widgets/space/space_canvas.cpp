// SPDX-License-Identifier: MIT
#include "gui/widgets/space/space_canvas.hpp"

#include <QEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
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
#include "gui/widgets/space/opengl_here.hpp"
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
constexpr double kClick = 4.0;
constexpr double kRound = 0.55; // share of the ball around all scans that fit() shows: fences stand far off

std::uint32_t ground() { return theme().kind == ThemeKind::Sunlight ? 0xffffffU : 0x24272bU; }

std::uint32_t tint_of(std::size_t day) {
    constexpr std::array<std::uint32_t, 6> kTints = {0xe07a3f, 0x3f9be0, 0x6cc070, 0xc46ad6, 0xd9c04a, 0x55c7c0};
    return kTints[day % kTints.size()];
}

} // namespace

SpaceCanvas::SpaceCanvas(Workspace& workspace, SpaceModel& space)
    : workspace_(workspace), space_(space), scene_(opengl_format()), flight_(workspace.jobs()) {
    setObjectName(QStringLiteral("spaceCanvas"));
    setAccessibleName(tr("The site in 3D"));
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(200, 110);
    setAttribute(Qt::WA_OpaquePaintEvent);
    settle_.setSingleShot(true);
    connect(&settle_, &QTimer::timeout, this, [this] { ask_for_points(SceneRenderer::Slot::Still); });
    connect(&scene_, &SceneThread::drawn, this, &SpaceCanvas::take_picture);
    connect(&scene_, &SceneThread::troubled, this, [this](const QString& sentence) {
        stop_waiting();
        emit troubled(sentence);
    });
    connect(&scene_, &SceneThread::unusable, this, [this](int major, int minor) {
        stop_waiting();
        emit unusable(opengl_trouble(major, minor));
    });
    scene_.begin();
    connect(&flight_, &FlightWriter::wanted, this, &SpaceCanvas::show_frame);
    connect(&space_, &SpaceModel::loaded, this, &SpaceCanvas::take_scans);
    connect(&space_, &SpaceModel::outlinesChanged, this, &SpaceCanvas::take_lines);
    connect(&workspace_, &Workspace::snapshotChanged, this, [this] {
        if (colour_ == PointColour::Unit && !flight_.is_flying()) set_colour(colour_);
    });
}

// No picture is on its way, and none will be.
void SpaceCanvas::stop_waiting() {
    broken_ = true;
    set_busy(false);
    flight_.stop();
}

void SpaceCanvas::set_busy(bool busy) { setProperty("busy", busy && !broken_); }

void SpaceCanvas::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    if (!std::exchange(begun_, true)) take_scans();
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
    flight_.stop();
    scene_.set_moving(std::make_shared<const PointSet>());
    settle_.stop();
    still_ = StillPicture::None;
    set_busy(true); // until it is known that there is OpenGL
    asked_ = scene_.draw(frame(SceneRenderer::Slot::Moving));
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
    if (still_ == StillPicture::None) return;
    asked_ = scene_.make_still_again(frame(SceneRenderer::Slot::Still));
    still_ = StillPicture::Made;
    set_busy(true);
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
    still_ = StillPicture::None;
    settle_.stop();
    set_busy(true);
    ask_for_points(SceneRenderer::Slot::Still);
}

// Choosing fine points for where the camera no longer is would take a core from the driver that draws the moving ones.
void SpaceCanvas::move() {
    flight_.stop();
    workspace_.jobs().cancel(QString::fromLatin1(kStillLane));
    if (scans_.empty()) return show_no_points();
    still_ = StillPicture::None;
    settle_.start(std::max(kSettle, static_cast<int>(1.5 * frame_ms_)));
    set_busy(true);
    asked_ = scene_.draw(frame(SceneRenderer::Slot::Moving));
}

void SpaceCanvas::take_picture(const ScenePicture& picture) {
    const bool is_still = picture.slot == SceneRenderer::Slot::Still;
    if (is_still && picture.number != asked_) return; // moved meanwhile
    picture_ = picture.image;
    drawn_ = picture.points;
    frame_ms_ = picture.milliseconds;
    if (!is_still && frame_ms_ > kSlowFrame) slow_ = true;
    update();
    emit framed();
    if (scans_.empty()) set_busy(false);
    if (!is_still || still_ != StillPicture::Made) return;
    still_ = StillPicture::Shown;
    set_busy(false);
    if (flight_.is_flying()) flight_.take(picture_);
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
                if (slot == SceneRenderer::Slot::Still) {
                    if (settle_.isActive()) return; // moved meanwhile: another set is asked for soon
                    asked_ = scene_.make_still(set, frame(slot));
                    still_ = StillPicture::Made;
                    return;
                }
                scene_.set_moving(set);
                if (still_ != StillPicture::Shown) scene_.draw_meanwhile(frame(slot));
            };
        },
        [this](const QString& sentence) {
            set_busy(false);
            flight_.stop();
            emit troubled(sentence);
        });
}

void SpaceCanvas::take_lines() {
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
    scene_.set_lines(std::move(lines), origin_);
    const bool is_still = still_ == StillPicture::Shown;
    scene_.draw_meanwhile(frame(is_still ? SceneRenderer::Slot::Still : SceneRenderer::Slot::Moving));
}

void SpaceCanvas::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    if (begun_) move();
}

// Another theme has another ground.
void SpaceCanvas::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (begun_ && event->type() == QEvent::PaletteChange) move();
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
    frame.ground = ground();
    return frame;
}

// Until there is a picture of this size, the last one is stretched.
void SpaceCanvas::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    if (picture_.isNull()) return painter.fillRect(rect(), QColor::fromRgb(ground()));
    painter.drawImage(rect(), picture_);
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
    default: QWidget::keyPressEvent(event);
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
