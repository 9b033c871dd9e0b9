// SPDX-License-Identifier: MIT
#include "gui/render/scene_renderer.hpp"

#include <QElapsedTimer>
#include <QMatrix4x4>
#include <QOpenGLBuffer>
#include <QOpenGLContext>
#include <QOpenGLExtraFunctions>
#include <QOpenGLShaderProgram>
#include <QOpenGLVertexArrayObject>
#include <QVector2D>
#include <QVector3D>
#include <QVector4D>

#include <algorithm>
#include <array>
#include <utility>

#include "core/base/error.hpp"
#include "gui/render/gl_target.hpp"

namespace planum::gui {

namespace {

constexpr GLenum kProgramPointSize = 0x8642; // core since OpenGL 3.2; not in OpenGL ES, whose names Qt brings

const char* const kPointVertex = R"(#version 330 core
layout(location = 0) in vec3 place;
layout(location = 1) in vec4 colour;
uniform mat4 clip;
uniform float pixels;
uniform vec3 box_low;
uniform vec3 box_high;
uniform vec4 slab;
uniform float slab_half;
out vec4 tint;
void main() {
  bool outside = any(lessThan(place, box_low)) || any(greaterThan(place, box_high)) ||
                 abs(dot(slab.xyz, place) - slab.w) > slab_half;
  gl_Position = outside ? vec4(0.0, 0.0, 2.0, 1.0) : clip * vec4(place, 1.0);
  gl_PointSize = pixels;
  tint = colour;
}
)";

const char* const kPointFragment = R"(#version 330 core
in vec4 tint;
out vec4 colour;
void main() { colour = vec4(tint.rgb, 1.0); }
)";

const char* const kWholeVertex = R"(#version 330 core
out vec2 at;
void main() {
  at = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2);
  gl_Position = vec4(at * 2.0 - 1.0, 0.0, 1.0);
}
)";

const char* const kDomeFragment = R"(#version 330 core
in vec2 at;
out vec4 result;
uniform sampler2D colours;
uniform sampler2D depths;
uniform vec2 pixel;
uniform float near_plane;
uniform float far_plane;
uniform bool parallel;
float range_of(float depth) {
  if (parallel) return 1.0 + depth * far_plane;
  return near_plane * far_plane / (far_plane - depth * (far_plane - near_plane));
}
void main() {
  float depth = texture(depths, at).r;
  vec4 own = texture(colours, at);
  if (depth >= 1.0) { result = own; return; }
  float here = log2(range_of(depth));
  float shade = 0.0;
  for (int i = 0; i < 8; ++i) {
    float a = 0.7853981 * float(i);
    float there = texture(depths, at + 1.5 * pixel * vec2(cos(a), sin(a))).r;
    if (there < 1.0) shade += max(0.0, here - log2(range_of(there)));
  }
  result = vec4(own.rgb * exp(-shade / 8.0 * 110.0), 1.0);
}
)";

const char* const kCopyFragment = R"(#version 330 core
in vec2 at;
out vec4 result;
uniform sampler2D colours;
void main() { result = texture(colours, at); }
)";

// One step of the still picture ends soon after its time is up: so much is done between two looks at the clock.
constexpr std::size_t kPointsAtOnce = 40'000;
constexpr std::size_t kUploadAtOnce = 400'000;
constexpr int kRowsAtOnce = 50;

struct LineRange {
    GLint first = 0;
    GLsizei count = 0;
    bool closed = false;
    bool strong = false;
};

QVector3D rgb_of(std::uint32_t rgb) {
    return QVector3D(static_cast<float>((rgb >> 16U) & 0xffU), static_cast<float>((rgb >> 8U) & 0xffU),
                     static_cast<float>(rgb & 0xffU)) /
           255.0F;
}

} // namespace

struct SceneRenderer::Gl {
    struct Buffer {
        QOpenGLBuffer vertices{QOpenGLBuffer::VertexBuffer};
        QOpenGLVertexArrayObject layout;
        std::size_t count = 0;
        Eigen::Vector3d origin = Eigen::Vector3d::Zero();
    };

    // How far the still picture is: first the points go to the driver, then into `scene`, then shaded into `picture`.
    struct Still {
        std::shared_ptr<const PointSet> points; ///< until they are uploaded
        std::size_t uploaded = 0;
        Frame frame;
        std::size_t drawn = 0;
        int shaded_rows = 0;
        bool begun = false;
        bool finished = false;
    };

    QOpenGLExtraFunctions* f = nullptr;
    QOpenGLShaderProgram points;
    QOpenGLShaderProgram dome;
    QOpenGLShaderProgram copy;
    std::array<Buffer, 3> buffers; ///< moving, still, lines
    QOpenGLVertexArrayObject nothing;
    std::vector<LineRange> lines;
    GlTarget scene{GlTarget::Depths::With};
    GlTarget picture{GlTarget::Depths::Without};
    Still still;

    static void link(QOpenGLShaderProgram& program, const char* vertex, const char* fragment) {
        if (!program.addShaderFromSourceCode(QOpenGLShader::Vertex, vertex) ||
            !program.addShaderFromSourceCode(QOpenGLShader::Fragment, fragment) || !program.link()) {
            throw Error(ErrorCode::Io, "the graphics driver refuses a shader: " + program.log().toStdString());
        }
    }

    void make_buffer(Buffer& buffer, const void* vertices, std::size_t count, const Eigen::Vector3d& origin) {
        QOpenGLVertexArrayObject::Binder bind(&buffer.layout);
        buffer.vertices.bind();
        buffer.vertices.allocate(vertices, static_cast<int>(count * sizeof(PointVertex)));
        f->glEnableVertexAttribArray(0);
        f->glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(PointVertex), nullptr);
        f->glEnableVertexAttribArray(1);
        f->glVertexAttribPointer(1, 4, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(PointVertex), reinterpret_cast<void*>(12));
        buffer.vertices.release();
        buffer.count = count;
        buffer.origin = origin;
    }

    void set_view(const Buffer& buffer, const Frame& frame, const SceneBox& box, const SceneSlab& slab) {
        const Eigen::Matrix4f clip =
            frame.camera.clip_from(buffer.origin, static_cast<double>(frame.width) / frame.height).cast<float>();
        points.setUniformValue("clip", QMatrix4x4(clip.data()).transposed());
        points.setUniformValue("pixels", frame.point_pixels);
        const auto relative = [&](const Eigen::Vector3d& x) {
            const Eigen::Vector3f v = (x - buffer.origin).cast<float>();
            return QVector3D(v.x(), v.y(), v.z());
        };
        points.setUniformValue("box_low", relative(box.low));
        points.setUniformValue("box_high", relative(box.high));
        const Eigen::Vector3f normal = slab.normal.cast<float>();
        const auto offset = static_cast<float>(slab.offset - slab.normal.dot(buffer.origin));
        points.setUniformValue("slab", QVector4D(normal.x(), normal.y(), normal.z(), offset));
        points.setUniformValue("slab_half", static_cast<float>(slab.half));
    }

    void clear(const Frame& frame) const {
        const QVector3D ground = rgb_of(frame.ground);
        f->glViewport(0, 0, frame.width, frame.height);
        f->glClearColor(ground.x(), ground.y(), ground.z(), 1.0F);
        f->glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    }

    void draw_points(Buffer& cloud, const Frame& frame, std::size_t first, std::size_t count) {
        if (count == 0) return;
        f->glViewport(0, 0, frame.width, frame.height);
        f->glEnable(GL_DEPTH_TEST);
        f->glEnable(kProgramPointSize);
        points.bind();
        set_view(cloud, frame, frame.box, frame.slab);
        QOpenGLVertexArrayObject::Binder bind(&cloud.layout);
        f->glDrawArrays(GL_POINTS, static_cast<GLint>(first), static_cast<GLsizei>(count));
        points.release();
    }

    // Over everything: an outline that dust hides would be no outline.
    void draw_lines(const Frame& frame) {
        if (lines.empty()) return;
        f->glDisable(GL_DEPTH_TEST);
        points.bind();
        set_view(buffers[2], frame, SceneBox{}, SceneSlab{});
        QOpenGLVertexArrayObject::Binder bind(&buffers[2].layout);
        for (const LineRange& line : lines) {
            f->glLineWidth(line.strong ? 3.0F : 1.5F);
            f->glDrawArrays(line.closed ? GL_LINE_LOOP : GL_LINE_STRIP, line.first, line.count);
        }
        points.release();
    }

    // Fills what is drawn into with what `program` makes of the scene's or picture's colours.
    void draw_whole(QOpenGLShaderProgram& program, const GlTarget& from) {
        f->glDisable(GL_DEPTH_TEST);
        f->glActiveTexture(GL_TEXTURE1);
        f->glBindTexture(GL_TEXTURE_2D, from.depths());
        f->glActiveTexture(GL_TEXTURE0);
        f->glBindTexture(GL_TEXTURE_2D, from.colours());
        program.setUniformValue("colours", 0);
        QOpenGLVertexArrayObject::Binder bind(&nothing);
        f->glDrawArrays(GL_TRIANGLES, 0, 3);
    }

    void shade_rows(const Frame& frame, int first, int count) {
        f->glBindFramebuffer(GL_FRAMEBUFFER, picture.framebuffer());
        f->glViewport(0, 0, frame.width, frame.height);
        f->glEnable(GL_SCISSOR_TEST);
        f->glScissor(0, first, frame.width, count);
        QOpenGLShaderProgram& program = frame.eye_dome ? dome : copy;
        program.bind();
        program.setUniformValue("depths", 1);
        program.setUniformValue(
            "pixel", QVector2D(1.0F / static_cast<float>(frame.width), 1.0F / static_cast<float>(frame.height)));
        program.setUniformValue("near_plane", static_cast<float>(Camera::kNear * frame.camera.distance));
        program.setUniformValue("far_plane", static_cast<float>(Camera::kFar * frame.camera.distance));
        program.setUniformValue("parallel", frame.camera.from_above);
        draw_whole(program, scene);
        program.release();
        f->glDisable(GL_SCISSOR_TEST);
    }

    void begin_still() {
        scene.size(*f, still.frame.width, still.frame.height);
        picture.size(*f, still.frame.width, still.frame.height);
        f->glBindFramebuffer(GL_FRAMEBUFFER, scene.framebuffer());
        clear(still.frame);
        still.begun = true;
    }

    // A little of what is left of the still picture.
    void go_on() {
        Buffer& cloud = buffers[1];
        if (still.points != nullptr) {
            const std::vector<PointVertex>& all = still.points->points;
            if (still.uploaded == 0) make_buffer(cloud, nullptr, all.size(), still.points->origin);
            const std::size_t now = std::min(kUploadAtOnce, all.size() - still.uploaded);
            cloud.vertices.bind();
            if (now > 0) {
                cloud.vertices.write(static_cast<int>(still.uploaded * sizeof(PointVertex)),
                                     all.data() + still.uploaded, static_cast<int>(now * sizeof(PointVertex)));
            }
            cloud.vertices.release();
            still.uploaded += now;
            if (still.uploaded == all.size()) still.points = nullptr;
            return;
        }
        if (!still.begun) return begin_still();
        if (still.drawn < cloud.count) {
            // With the first of them the driver makes its program for this target, which takes a step of its own.
            const std::size_t wanted = still.drawn == 0 ? 100 : kPointsAtOnce;
            const std::size_t now = std::min(wanted, cloud.count - still.drawn);
            f->glBindFramebuffer(GL_FRAMEBUFFER, scene.framebuffer());
            draw_points(cloud, still.frame, still.drawn, now);
            still.drawn += now;
        } else {
            const int now = std::min(kRowsAtOnce, still.frame.height - still.shaded_rows);
            shade_rows(still.frame, still.shaded_rows, now);
            still.shaded_rows += now;
            still.finished = still.shaded_rows >= still.frame.height;
        }
        f->glFinish(); // else the driver only takes note, and all of it is waited for at the end
    }
};

SceneRenderer::SceneRenderer() : gl_(std::make_unique<Gl>()) {}

SceneRenderer::~SceneRenderer() {
    if (gl_->f == nullptr || QOpenGLContext::currentContext() == nullptr) return;
    gl_->scene.free(*gl_->f);
    gl_->picture.free(*gl_->f);
}

void SceneRenderer::initialise() {
    QOpenGLContext* context = QOpenGLContext::currentContext();
    if (context == nullptr) throw Error(ErrorCode::Io, "there is no OpenGL here");
    Gl::link(gl_->points, kPointVertex, kPointFragment);
    Gl::link(gl_->dome, kWholeVertex, kDomeFragment);
    Gl::link(gl_->copy, kWholeVertex, kCopyFragment);
    gl_->nothing.create();
    for (Gl::Buffer& buffer : gl_->buffers) {
        buffer.layout.create();
        buffer.vertices.create();
        buffer.vertices.setUsagePattern(QOpenGLBuffer::DynamicDraw);
    }
    gl_->f = context->extraFunctions(); // last: without it nothing is drawn or kept
}

void SceneRenderer::set_moving(const PointSet& points) {
    if (gl_->f == nullptr) return;
    gl_->make_buffer(gl_->buffers[0], points.points.data(), points.points.size(), points.origin);
}

void SceneRenderer::set_still(std::shared_ptr<const PointSet> points, const Frame& frame) {
    gl_->still = {};
    gl_->still.points = std::move(points);
    gl_->still.frame = frame;
}

void SceneRenderer::draw_still_again(const Frame& frame) {
    Gl::Still& still = gl_->still;
    still.frame = frame;
    still.drawn = 0;
    still.shaded_rows = 0;
    still.begun = still.finished = false;
}

bool SceneRenderer::advance_still(int milliseconds) {
    if (gl_->f == nullptr) return true;
    QElapsedTimer timer;
    timer.start();
    const auto began = [this] { return std::pair(gl_->still.begun, gl_->still.drawn > 0); };
    const auto stage = began();
    // What begins anew (targets, programs) takes longer than a little of the same: nothing more in such a step.
    while (!gl_->still.finished && timer.elapsed() < milliseconds && began() == stage) gl_->go_on();
    return gl_->still.finished;
}

std::size_t SceneRenderer::points(Slot slot) const { return gl_->buffers[slot == Slot::Moving ? 0 : 1].count; }

void SceneRenderer::set_lines(const std::vector<SceneLine>& lines, const Eigen::Vector3d& origin) {
    if (gl_->f == nullptr) return;
    std::vector<PointVertex> vertices;
    gl_->lines.clear();
    for (const SceneLine& line : lines) {
        gl_->lines.push_back(
            {static_cast<GLint>(vertices.size()), static_cast<GLsizei>(line.places.size()), line.closed, line.strong});
        for (const Eigen::Vector3d& place : line.places) {
            const Eigen::Vector3f x = (place - origin).cast<float>();
            vertices.push_back({x.x(), x.y(), x.z(), static_cast<std::uint8_t>(line.colour >> 16U),
                                static_cast<std::uint8_t>(line.colour >> 8U), static_cast<std::uint8_t>(line.colour),
                                255});
        }
    }
    gl_->make_buffer(gl_->buffers[2], vertices.data(), vertices.size(), origin);
}

void SceneRenderer::draw(const Frame& frame) {
    if (gl_->f == nullptr) return;
    gl_->f->glBindFramebuffer(GL_FRAMEBUFFER, frame.target_framebuffer);
    if (frame.slot == Slot::Still && gl_->still.finished) {
        gl_->f->glViewport(0, 0, frame.width, frame.height);
        gl_->copy.bind();
        gl_->draw_whole(gl_->copy, gl_->picture);
        gl_->copy.release();
    } else {
        gl_->clear(frame);
        gl_->draw_points(gl_->buffers[0], frame, 0, gl_->buffers[0].count);
    }
    gl_->draw_lines(frame);
}

} // namespace planum::gui
