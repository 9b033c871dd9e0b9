// SPDX-License-Identifier: MIT
#include "gui/render/scene_thread.hpp"

#include <QElapsedTimer>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLExtraFunctions>
#include <QSurfaceFormat>
#include <QThread>

#include <exception>
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

    void begin() {
        try {
            context_ = std::make_unique<QOpenGLContext>();
            context_->setFormat(format_);
            if (!context_->create() || !context_->makeCurrent(owner_.surface_.get()))
                throw Error(ErrorCode::Io, "there is no OpenGL here");
            renderer_ = std::make_unique<SceneRenderer>();
            renderer_->initialise();
        } catch (const std::exception& error) {
            fail(error);
        }
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
            this,
            [this, work = std::move(work)] {
                if (renderer_ == nullptr) return;
                try {
                    work(*renderer_);
                } catch (const std::exception& error) {
                    fail(error);
                }
            },
            Qt::QueuedConnection);
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

    void fail(const std::exception& error) {
        renderer_.reset();
        emit owner_.troubled(QString::fromUtf8(error.what()));
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
    std::unique_ptr<SceneRenderer> renderer_; ///< null: nothing can be drawn
    GlTarget target_{GlTarget::Depths::With};
};

SceneThread::SceneThread(const QSurfaceFormat& format)
    : surface_(std::make_unique<QOffscreenSurface>()), worker_(std::make_unique<Worker>(*this, format)) {
    qRegisterMetaType<ScenePicture>();
    surface_->setFormat(format);
    surface_->create(); // platforms want that in the window's thread
    if (QOpenGLContext::supportsThreadedOpenGL()) {
        thread_ = std::make_unique<QThread>();
        thread_->setObjectName(QStringLiteral("3D"));
        worker_->moveToThread(thread_.get());
        thread_->start();
    }
}

void SceneThread::begin() {
    QMetaObject::invokeMethod(
        worker_.get(), [this] { worker_->begin(); }, Qt::QueuedConnection);
}

SceneThread::~SceneThread() {
    next(); // nothing more of what was asked for is drawn
    if (thread_ == nullptr) {
        worker_->end();
        return;
    }
    QMetaObject::invokeMethod(
        worker_.get(), [this] { worker_->end(); }, Qt::BlockingQueuedConnection);
    thread_->quit();
    thread_->wait();
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
