// SPDX-License-Identifier: MIT
#pragma once

#include <QImage>
#include <QObject>

#include <atomic>
#include <cstdint>
#include <memory>
#include <vector>

#include "gui/render/scene_renderer.hpp"

class QOffscreenSurface;
class QSurfaceFormat;
class QThread;

namespace planum::gui {

/// One picture of the scene.
struct ScenePicture {
    QImage image;
    SceneRenderer::Slot slot = SceneRenderer::Slot::Moving;
    std::uint64_t number = 0; ///< of what asked for it
    std::size_t points = 0;
    double milliseconds = 0.0; ///< that it took to draw; of a still picture only the last step
};

/// Draws the scene in a thread of its own, beside the screen: without a graphics card a frame takes a tenth of a second
/// and its first one longer, and a window must not wait for that. What is asked of it is done in turn; of pictures that
/// are asked for, only the newest. Where the driver allows OpenGL in one thread only (see
/// QOpenGLContext::supportsThreadedOpenGL()), the worker moves to the window's, and the work is done between others.
class SceneThread : public QObject {
    Q_OBJECT

  public:
    explicit SceneThread(const QSurfaceFormat& format);
    ~SceneThread() override;

    /// To be called once, when its signals are connected: what is wrong from the start is said, too.
    void begin();

    void set_moving(std::shared_ptr<const PointSet> points);
    void set_lines(std::vector<SceneLine> lines, const Eigen::Vector3d& origin);

    /// One picture of the moving points, or of the still picture where that is finished; ends work on a still one. The
    /// number that it returns comes with the picture.
    std::uint64_t draw(const SceneRenderer::Frame& frame);
    /// One picture as things are now, beside the still one that may be in the making; with the number of the last
    /// picture that was asked for, and left out where that is a newer one.
    void draw_meanwhile(const SceneRenderer::Frame& frame);
    /// A still picture of these points, when it is finished. Anything that is asked for later ends it.
    std::uint64_t make_still(std::shared_ptr<const PointSet> points, const SceneRenderer::Frame& frame);
    /// The same points once more: another shading, another ground.
    std::uint64_t make_still_again(const SceneRenderer::Frame& frame);

  signals:
    void drawn(const planum::gui::ScenePicture& picture);
    /// Nothing is drawn from now on, and why.
    void troubled(const QString& sentence);
    /// The display offers less OpenGL than what is asked for: only this version, 0.0 for none. Nothing will be drawn.
    void unusable(int major, int minor);

  private:
    class Worker;

    std::uint64_t next() { return ++newest_; }

    void make_surface();
    void leave();

    std::atomic<std::uint64_t> newest_{0};
    std::unique_ptr<QOffscreenSurface> surface_;
    std::unique_ptr<QThread> thread_;
    std::unique_ptr<Worker> worker_;
};

} // namespace planum::gui
