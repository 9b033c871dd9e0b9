// SPDX-License-Identifier: MIT
#pragma once

#include <QImage>
#include <QTimer>
#include <QWidget>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "gui/render/scene_thread.hpp"
#include "gui/viewmodels/difference_model.hpp"
#include "gui/viewmodels/space_model.hpp"
#include "gui/viewmodels/workspace.hpp"
#include "gui/widgets/space/flight_writer.hpp"

namespace planum::gui {

/// The site in 3D. While it moves, a coarse set of points keeps the frame rate; when it stands still, a fine set of
/// what the camera sees is chosen in a thread and drawn with depth shading. It shows the pictures that a SceneThread
/// draws, so the window answers however long a frame takes.
class SpaceCanvas : public QWidget {
    Q_OBJECT

  public:
    SpaceCanvas(Workspace& workspace, SpaceModel& space);

    void set_colour(PointColour colour);
    /// What PointColour::Difference shows; null: nothing is compared.
    void set_difference(std::shared_ptr<const GroundColours> colours);
    void set_eye_dome(bool on);
    void fit();
    void from_above();
    /// Shares of what the scans fill, 0 … 1, along x, y and height: what lies outside is cut away.
    void set_box(const std::array<double, 3>& low, const std::array<double, 3>& high);

    /// Cuts away what lies beside it; by itself nothing.
    void set_slab(const SceneSlab& slab);
    /// Lines over everything besides the outlines.
    void set_marks(std::vector<SceneLine> marks);
    /// Looks level along the normal of the slab at what it leaves between these places.
    void face(const Eigen::Vector3d& from, const Eigen::Vector3d& to);

    /// What a click is for: a unit, or only the place that picked() says.
    enum class Clicks { Select, Place };

    void set_clicks(Clicks clicks) { clicks_ = clicks; }

    /// Writes flights; moving the camera by hand ends one, and so does another size or theme of the view.
    [[nodiscard]] FlightWriter& flight() noexcept { return flight_; }

    [[nodiscard]] bool has_scans() const noexcept { return !scans_.empty(); }

    [[nodiscard]] const Camera& camera() const noexcept { return camera_; }

    /// Points of the last frame.
    [[nodiscard]] std::size_t drawn_points() const noexcept { return drawn_; }

    /// Time that the last frame took [ms].
    [[nodiscard]] double frame_milliseconds() const noexcept { return frame_ms_; }

  signals:
    /// What is under a click: place of the site.
    void picked(double x, double y, double z);
    /// Nothing is drawn under a click.
    void missed();
    /// Two places were clicked with Shift: what lies between them.
    void measured(double distance, double rise);
    void troubled(const QString& sentence);
    /// There is no OpenGL that this could draw with; nothing ever comes.
    void unusable(const QString& sentence);
    /// Another picture is there.
    void framed();

  protected:
    void showEvent(QShowEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

  private:
    void set_busy(bool busy);
    void stop_waiting();

    enum class StillPicture { None, Made, Shown };

    void show_frame(const Camera& camera);
    void take_picture(const ScenePicture& picture);
    void take_scans();
    void show_no_points();
    void take_lines();
    void move();
    [[nodiscard]] SceneRenderer::Frame frame(SceneRenderer::Slot slot) const;
    void ask_for_points(SceneRenderer::Slot slot);
    void pick_at(QPointF at, bool measure);

    [[nodiscard]] double aspect() const { return static_cast<double>(width()) / std::max(height(), 1); }

    Workspace& workspace_;
    SpaceModel& space_;
    SceneThread scene_;
    QImage picture_;
    std::uint64_t asked_ = 0; ///< number of the newest picture that was asked for
    std::vector<ShownScan> scans_;
    Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
    double low_ = 0.0;
    double high_ = 1.0;
    Camera camera_;
    PointColour colour_ = PointColour::Colour;
    std::shared_ptr<const GroundColours> difference_;
    bool eye_dome_ = true;
    bool fitted_ = false; ///< the camera looks at this project; choosing what is shown does not turn it
    bool broken_ = false; ///< nothing can be drawn any more
    bool begun_ = false;  ///< it was shown
    StillPicture still_ = StillPicture::None; ///< of where the camera is now
    QTimer settle_;
    QPointF last_;
    QPointF pressed_;
    bool dragged_ = false;
    std::optional<Eigen::Vector3d> measure_from_;
    SceneBox box_;
    SceneSlab slab_;
    std::vector<SceneLine> marks_;
    Clicks clicks_ = Clicks::Select;
    FlightWriter flight_;
    std::size_t drawn_ = 0;
    double frame_ms_ = 0.0;
    bool slow_ = false; ///< a frame of the moving points took long
};

} // namespace planum::gui
