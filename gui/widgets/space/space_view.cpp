// SPDX-License-Identifier: MIT
#include "gui/widgets/space/space_view.hpp"

#include <QCheckBox>
#include <QComboBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QMenu>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

#include "gui/viewmodels/models.hpp"
#include "gui/viewmodels/words.hpp"
#include "gui/widgets/choice_dialog.hpp"
#include "gui/widgets/flow_layout.hpp"
#include "gui/widgets/space/box_panel.hpp"
#include "gui/widgets/space/contents_panel.hpp"
#include "gui/widgets/space/difference_bar.hpp"
#include "gui/widgets/space/flight_cameras.hpp"
#include "gui/widgets/space/opengl_here.hpp"
#include "gui/widgets/space/section_line_bar.hpp"
#include "gui/widgets/space/space_canvas.hpp"
#include "gui/widgets/theme.hpp"

namespace planum::gui {

namespace {

// An upright stroke at either end, and the line between them.
std::vector<SceneLine> section_marks(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
    const Eigen::Vector3d up = 0.1 * Eigen::Vector3d::UnitZ(); // [m]
    std::vector<SceneLine> marks;
    for (const std::vector<Eigen::Vector3d>& places :
         std::initializer_list<std::vector<Eigen::Vector3d>>{{from - up, from + up}, {to - up, to + up}, {from, to}}) {
        marks.push_back({places, 0x30e0d0, false, true});
    }
    return marks;
}

} // namespace

SpaceView::SpaceView(Models& models)
    : models_(models), space_(models.workspace, models.time), difference_(models.workspace, models.time),
      said_(new QLabel) {
    setObjectName(QStringLiteral("3d"));
    auto* whole = new QVBoxLayout(this);
    whole->setContentsMargins(0, 0, 0, 0);
    said_->setObjectName(QStringLiteral("spaceSaid"));
    said_->setProperty("role", "faint");
    said_->setContentsMargins(8, 4, 8, 4);
    said_->setText(tr("Drag to turn, right button to move, wheel to come nearer; a click says the place."));
}

// Made when somebody looks for the first time: a program whose 3D nobody looks at never asks for OpenGL.
void SpaceView::make_scene() {
    scene_ = new QWidget(this);
    layout()->addWidget(scene_);
    if (const QString trouble = display_trouble(); !trouble.isEmpty()) return say_unusable(trouble);
    make_canvas();
}

// Whether there is OpenGL turns out in the thread that draws, when all this stands.
void SpaceView::say_unusable(const QString& why) {
    usable_ = false;
    space_.set_watched(false);
    difference_.set_watched(false);
    scene_->hide();
    auto* label = new QLabel(why);
    label->setObjectName(QStringLiteral("spaceTrouble"));
    label->setAlignment(Qt::AlignCenter);
    label->setWordWrap(true);
    layout()->addWidget(label);
}

void SpaceView::make_canvas() {
    canvas_ = new SpaceCanvas(models_.workspace, space_);
    compared_ = new DifferenceBar(difference_);
    box_ = new BoxPanel;
    section_ = new SectionLineBar(models_.section_line);
    cameras_ = new FlightCameras(models_.workspace);
    cameras_->setParent(this);
    cameras_->setObjectName(QStringLiteral("flightCameras"));
    contents_ = new ContentsPanel(space_.contents());
    auto* column = new QVBoxLayout(scene_);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(make_bar());
    column->addWidget(compared_);
    column->addWidget(box_);
    column->addWidget(section_);
    auto* middle = new QHBoxLayout;
    middle->setSpacing(6);
    middle->addWidget(contents_);
    middle->addWidget(canvas_, 1);
    column->addLayout(middle, 1);
    said_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed); // a long sentence does not widen the window
    column->addWidget(said_);
    compared_->hide();
    box_->hide();
    contents_->hide();
    connect(box_, &BoxPanel::changed, canvas_, &SpaceCanvas::set_box);
    FlightWriter& flight = canvas_->flight();
    connect(&flight, &FlightWriter::flying, this,
            [this](int written, int all) { said_->setText(tr("frame %1 of %2").arg(written).arg(all)); });
    connect(&flight, &FlightWriter::flown, this,
            [this](int written) { said_->setText(tr("%n frame(s) written", nullptr, written)); });
    setFocusProxy(canvas_);
    connect(canvas_, &SpaceCanvas::picked, this, [this](double x, double y, double z) {
        said_->setText(
            tr("x %1  y %2  height %3 m").arg(number_word(x, 3)).arg(number_word(y, 3)).arg(number_word(z, 3)));
        models_.section_line.take({x, y, z});
    });
    connect(canvas_, &SpaceCanvas::missed, this,
            [this] { said_->setText(tr("No point is there; come nearer, or click where points are drawn.")); });
    connect(canvas_, &SpaceCanvas::measured, this, [this](double distance, double rise) {
        said_->setText(tr("%1 m apart, %2 m up").arg(number_word(distance, 3)).arg(number_word(rise, 3)));
    });
    connect(&space_, &SpaceModel::loaded, this, [this] {
        if (!space_.trouble().isEmpty()) said_->setText(space_.trouble());
    });
    connect(cameras_, &FlightCameras::troubled, &models_.workspace, &Workspace::failed);
    connect(&flight, &FlightWriter::troubled, &models_.workspace, &Workspace::failed);
    connect(canvas_, &SpaceCanvas::troubled, &models_.workspace, &Workspace::failed);
    connect(canvas_, &SpaceCanvas::unusable, this, &SpaceView::say_unusable);
}

QWidget* SpaceView::make_bar() {
    make_colours();
    auto* dome = new QCheckBox(tr("shaded by depth"));
    dome->setChecked(true);
    connect(dome, &QCheckBox::toggled, canvas_, &SpaceCanvas::set_eye_dome);
    auto* all = new QCheckBox(tr("all surfaces"));
    connect(all, &QCheckBox::toggled, &space_.contents(), &SpaceContents::set_all_surfaces);
    const auto button = [this](const QString& text, const QString& tip, auto press) {
        auto* made = new QToolButton;
        made->setText(text);
        made->setToolTip(tip);
        connect(made, &QToolButton::clicked, canvas_, press);
        return made;
    };
    auto* cut = new QToolButton;
    cut->setObjectName(QStringLiteral("spaceCut"));
    cut->setText(tr("Cut"));
    cut->setCheckable(true);
    cut->setToolTip(tr("Cut away what lies in front, above or behind"));
    connect(cut, &QToolButton::toggled, this, [this](bool on) {
        box_->setVisible(on);
        if (!on) box_->reset();
    });
    auto* shown = new QToolButton;
    shown->setObjectName(QStringLiteral("spaceShown"));
    shown->setText(tr("Shown"));
    shown->setCheckable(true);
    shown->setToolTip(tr("Surfaces, scans and outlines on and off, one by one"));
    connect(shown, &QToolButton::toggled, this, [this](bool on) {
        contents_->setVisible(on);
        if (on) contents_->setFocus();
    });
    auto* above = button(tr("From above"), tr("Plan, north up (T)"), &SpaceCanvas::from_above);
    auto* whole = button(tr("Fit"), tr("The trench (F)"), &SpaceCanvas::fit);
    auto* bar = new QWidget;
    auto* row = new FlowLayout(6);
    bar->setLayout(row);
    row->setContentsMargins(8, 6, 8, 6);
    for (QWidget* part : std::initializer_list<QWidget*>{colour_, dome, all, shown, cut, make_section_button(),
                                                         make_flight_button(), above, whole})
        row->addWidget(part);
    return bar;
}

void SpaceView::make_colours() {
    colour_ = new QComboBox;
    colour_->setObjectName(QStringLiteral("spaceColour"));
    colour_->setAccessibleName(tr("Colour"));
    colour_->addItem(tr("colour as scanned"), static_cast<int>(PointColour::Colour));
    colour_->addItem(tr("intensity"), static_cast<int>(PointColour::Intensity));
    colour_->addItem(tr("height"), static_cast<int>(PointColour::Height));
    colour_->addItem(tr("day"), static_cast<int>(PointColour::Day));
    colour_->addItem(tr("unit"), static_cast<int>(PointColour::Unit));
    colour_->addItem(tr("difference to another surface"), static_cast<int>(PointColour::Difference));
    connect(colour_, &QComboBox::activated, this,
            [this] { show_colour(static_cast<PointColour>(colour_->currentData().toInt())); });
    connect(&difference_, &DifferenceModel::changed, this, [this] { canvas_->set_difference(difference_.colours()); });
}

void SpaceView::show_colour(PointColour colour) {
    if (canvas() == nullptr) return;
    colour_->setCurrentIndex(colour_->findData(static_cast<int>(colour)));
    compared_->setVisible(colour == PointColour::Difference);
    watch_difference();
    canvas_->set_colour(colour);
}

// Surfaces are compared while somebody looks at the difference.
void SpaceView::watch_difference() {
    difference_.set_watched(isVisible() && canvas() != nullptr && !compared_->isHidden());
}

QToolButton* SpaceView::make_section_button() {
    SectionLine& line = models_.section_line;
    auto* button = new QToolButton;
    button->setObjectName(QStringLiteral("spaceSection"));
    button->setText(tr("Section line"));
    button->setCheckable(true);
    button->setToolTip(tr("Two clicks lay a line; what lies beside it is cut away"));
    connect(button, &QToolButton::clicked, &line, [&line](bool on) { on ? line.begin() : line.clear(); });
    const auto say = [this, button, &line] {
        button->setChecked(line.state() != SectionLine::State::Off);
        show_section_line();
    };
    connect(&line, &SectionLine::changed, this, say);
    connect(section_, &SectionLineBar::faceWanted, this,
            [this, &line] { canvas_->face(Eigen::Vector3d(line.from()->data()), Eigen::Vector3d(line.to()->data())); });
    say();
    return button;
}

void SpaceView::show_section_line() {
    const SectionLine& line = models_.section_line;
    canvas_->set_clicks(line.wants_place() ? SpaceCanvas::Clicks::Place : SpaceCanvas::Clicks::Select);
    std::vector<SceneLine> marks;
    SceneSlab slab;
    if (line.from()) {
        const Eigen::Vector3d from(line.from()->data());
        const Eigen::Vector3d to = line.to() ? Eigen::Vector3d(line.to()->data()) : from;
        if (line.state() == SectionLine::State::Set) slab = SceneSlab::along(from, to, line.thickness());
        marks = section_marks(from, to);
    }
    canvas_->set_marks(std::move(marks));
    canvas_->set_slab(slab);
}

QToolButton* SpaceView::make_flight_button() {
    auto* menu = new QMenu(this);
    menu->addAction(tr("Place a camera here"), cameras_, [this] { cameras_->place(canvas_->camera()); })
        ->setObjectName(QStringLiteral("placeCamera"));
    QAction* fly = menu->addAction(tr("Write the flight …"), this, &SpaceView::ask_flight);
    fly->setObjectName(QStringLiteral("writeFlight"));
    QAction* forget = menu->addAction(tr("Forget the cameras"), cameras_, &FlightCameras::forget);
    forget->setObjectName(QStringLiteral("forgetCameras"));
    QAction* back = menu->addAction(QString(), cameras_, &FlightCameras::take_back);
    back->setObjectName(QStringLiteral("takeCameraBack"));
    auto* button = new QToolButton;
    button->setObjectName(QStringLiteral("spaceFlight"));
    button->setMenu(menu);
    button->setPopupMode(QToolButton::InstantPopup);
    button->setToolTip(tr("A flight along placed cameras, as numbered pictures"));
    const auto say = [this, button, fly, forget, back] {
        const auto n = static_cast<int>(cameras_->placed().size());
        button->setText(n == 0 ? tr("Flight") : tr("Flight (%1)").arg(n));
        fly->setEnabled(n > 0);
        forget->setEnabled(n > 0);
        const QString former = cameras_->former_label();
        back->setEnabled(!former.isEmpty());
        back->setText(former.isEmpty() ? tr("Take back") : tr("Take back: %1").arg(former));
    };
    connect(cameras_, &FlightCameras::placedChanged, this, say);
    say();
    return button;
}

void SpaceView::ask_flight() {
    const QStringList chosen = ask_choices(this, tr("Write the flight"),
                                           {{tr("Frames from camera to camera"),
                                             {QStringLiteral("25"), QStringLiteral("50"), QStringLiteral("100")},
                                             QStringLiteral("50"),
                                             true}});
    if (chosen.isEmpty()) return;
    const QString folder = QFileDialog::getExistingDirectory(this, tr("Folder for the frames"));
    if (!folder.isEmpty() && canvas_->has_scans())
        canvas_->flight().start(cameras_->placed(), folder.toStdString(), std::clamp(chosen[0].toInt(), 1, 2000));
}

void SpaceView::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    if (scene_ == nullptr) make_scene();
    space_.set_watched(canvas() != nullptr);
    watch_difference();
}

// What the parts of the view leave to it.
void SpaceView::keyPressEvent(QKeyEvent* event) {
    if (event->key() != Qt::Key_Escape || models_.section_line.state() == SectionLine::State::Off)
        return QWidget::keyPressEvent(event);
    models_.section_line.clear();
}

void SpaceView::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    space_.set_watched(false);
    difference_.set_watched(false);
}

} // namespace planum::gui
