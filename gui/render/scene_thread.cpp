// SPDX-License-Identifier: MIT
#include "gui/render/scene_thread.hpp"

#include <QElapsedTimer>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLExtraFunctions>
#include <QSurfaceFormat>
#include <QThread>

#include <exception>
#include <functional>
#include <utility>

#include "core/base/error.hpp"
#include "gui/render/gl_target.hpp"

namespace planum::gui {

namespace {

constexpr int kStep = 25;          // [ms] of work on the still picture between two looks at what else is asked for
constexpr GLenum kGlBgra = 0x80e1; // core since OpenGL 1.2; not in OpenGL ES, whose names Qt brings

} // namespace

// Lives in the thread that draws; all of it runs there but the constructor.
class SceneThread::Worker : public QObject {
  public:
    Worker(SceneThread& owner, const QSurfaceFormat& format) : owner_(owner), format_(format) {}

    // Loads the driver, which takes a while the first time, even to ask it whether it may be used in this thread.
    void begin() {
        if (!QOpenGLContext::supportsThreadedOpenGL() && thread() != owner_.thread()) {
            moveToThread(owner_.thread()); // what was posted comes along
            QMetaObject::invokeMethod(
                this, [this] { begin(); }, Qt::QueuedConnection);
            return;
        }
        context_ = std::make_unique<QOpenGLContext>();
        context_->setFormat(format_);
        if (!context_->create()) return give_up({0, 0});
        QMetaObject::invokeMethod(
            &owner_, [this] { owner_.make_surface(); }, Qt::QueuedConnection);
    }

    void go_on_with_surface() {
        if (!context_->makeCurrent(owner_.surface_.get())) return give_up({0, 0});
        if (const auto version = context_->format().version(); version < format_.version()) return give_up(version);
        try {
            renderer_ = std::make_unique<SceneRenderer>();
            renderer_->initialise();
        } catch (const std::exception& error) {
            fail(error);
        }
        for (const auto& work : std::exchange(waiting_, {})) work();
    }

    void end() {
        if (context_ == nullptr) return;
        if (renderer_ != nullptr) target_.free(gl());
        renderer_.reset();
        context_->doneCurrent();
        context_.reset();
    }

    // Runs `work` in turn; what goes wrong with the driver is said, and nothing more is drawn.
    template<typename Work>
    void post(Work work) {
        QMetaObject::invokeMethod(
            this, [this, work = std::move(work)] { do_now_or_later(work); }, Qt::QueuedConnection);
    }

    void draw(const SceneRenderer::Frame& frame, std::uint64_t number) {
        if (number != owner_.newest_) return; // a newer one is on its way
        QElapsedTimer timer;
        timer.start();
        target_.size(gl(), frame.width, frame.height);
        SceneRenderer::Frame own = frame;
        own.target_framebuffer = target_.framebuffer();
        renderer_->draw(own);
        ScenePicture picture{read_back(frame), frame.slot, number, renderer_->points(frame.slot), 0.0};
        picture.milliseconds = static_cast<double>(timer.nsecsElapsed()) / 1e6;
        emit owner_.drawn(picture);
    }

    // A little of the still picture, then what else is asked for.
    void go_on(const SceneRenderer::Frame& frame, std::uint64_t number) {
        if (number != owner_.newest_) return;
        if (renderer_->advance_still(kStep)) return draw(frame, number);
        post([this, frame, number](SceneRenderer&) { go_on(frame, number); });
    }

  private:
    [[nodiscard]] QOpenGLExtraFunctions& gl() const { return *context_->extraFunctions(); }

    void do_now_or_later(const std::function<void(SceneRenderer&)>& work) {
        if (is_over_) return;
        if (renderer_ == nullptr) {
            waiting_.emplace_back([this, work] { do_now_or_later(work); });
            return;
        }
        try {
            work(*renderer_);
        } catch (const std::exception& error) {
            fail(error);
        }
    }

    void fail(const std::exception& error) {
        stop();
        emit owner_.troubled(QString::fromUtf8(error.what()));
    }

    void give_up(std::pair<int, int> version) {
        stop();
        emit owner_.unusable(version.first, version.second);
    }

    void stop() {
        renderer_.reset();
        waiting_.clear();
        is_over_ = true;
    }

    // OpenGL counts rows from below.
    QImage read_back(const SceneRenderer::Frame& frame) {
        QImage upside_down(frame.width, frame.height, QImage::Format_RGB32);
        if (upside_down.isNull()) throw Error(ErrorCode::Io, "no memory for a picture of the site in 3D");
        gl().glPixelStorei(GL_PACK_ALIGNMENT, 4);
        gl().glReadPixels(0, 0, frame.width, frame.height, kGlBgra, GL_UNSIGNED_BYTE, upside_down.bits());
        return std::move(upside_down).mirrored();
    }

    SceneThread& owner_;
    QSurfaceFormat format_;
    std::unique_ptr<QOpenGLContext> context_;
    std::unique_ptr<SceneRenderer> renderer_;    ///< null: not yet, or nothing can be drawn
    std::vector<std::function<void()>> waiting_; ///< for the renderer
    bool is_over_ = false;
    GlTarget target_{GlTarget::Depths::With};
};

SceneThread::SceneThread(const QSurfaceFormat& format)
    : surface_(std::make_unique<QOffscreenSurface>()), thread_(std::make_unique<QThread>()),
      worker_(std::make_unique<Worker>(*this, format)) {
    qRegisterMetaType<ScenePicture>();
    surface_->setFormat(format);
    thread_->setObjectName(QStringLiteral("3D"));
    worker_->moveToThread(thread_.get());
    connect(
        thread_.get(), &QThread::finished, worker_.get(), [this] { leave(); }, Qt::DirectConnection);
    thread_->start();
}

// A context is given up in the thread that used it last.
void SceneThread::leave() {
    if (worker_->thread() == QThread::currentThread()) worker_->end();
}

void SceneThread::begin() {
    QMetaObject::invokeMethod(
        worker_.get(), [this] { worker_->begin(); }, Qt::QueuedConnection);
}

// Platforms want that in the window's thread; it is quick once the driver is there.
void SceneThread::make_surface() {
    surface_->create();
    QMetaObject::invokeMethod(
        worker_.get(), [this] { worker_->go_on_with_surface(); }, Qt::QueuedConnection);
}

SceneThread::~SceneThread() {
    next(); // nothing more of what was asked for is drawn
    thread_->quit();
    thread_->wait();
    leave();
}

void SceneThread::set_moving(std::shared_ptr<const PointSet> points) {
    worker_->post([points = std::move(points)](SceneRenderer& renderer) { renderer.set_moving(*points); });
}

void SceneThread::set_lines(std::vector<SceneLine> lines, const Eigen::Vector3d& origin) {
    worker_->post([lines = std::move(lines), origin](SceneRenderer& renderer) { renderer.set_lines(lines, origin); });
}

std::uint64_t SceneThread::draw(const SceneRenderer::Frame& frame) {
    const std::uint64_t number = next();
    worker_->post([this, frame, number](SceneRenderer&) { worker_->draw(frame, number); });
    return number;
}

void SceneThread::draw_meanwhile(const SceneRenderer::Frame& frame) {
    worker_->post([this, frame, number = newest_.load()](SceneRenderer&) { worker_->draw(frame, number); });
}

std::uint64_t SceneThread::make_still(std::shared_ptr<const PointSet> points, const SceneRenderer::Frame& frame) {
    const std::uint64_t number = next();
    worker_->post([this, points = std::move(points), frame, number](SceneRenderer& renderer) {
        if (number != newest_) return;
        renderer.set_still(points, frame);
        worker_->go_on(frame, number);
    });
    return number;
}

std::uint64_t SceneThread::make_still_again(const SceneRenderer::Frame& frame) {
    const std::uint64_t number = next();
    worker_->post([this, frame, number](SceneRenderer& renderer) {
        if (number != newest_) return;
        renderer.draw_still_again(frame);
        worker_->go_on(frame, number);
    });
    return number;
}

} // namespace planum::gui
