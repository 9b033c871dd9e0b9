// SPDX-License-Identifier: MIT
#include "gui/render/scene_renderer.hpp"

#include <QMatrix4x4>
#include <QOpenGLBuffer>
#include <QOpenGLContext>
#include <QOpenGLExtraFunctions>
#include <QOpenGLShaderProgram>
#include <QOpenGLVertexArrayObject>
#include <QVector2D>
#include <QVector3D>

#include <array>
#include <initializer_list>

#include "core/base/error.hpp"

namespace planum::gui {

namespace {

constexpr GLenum kProgramPointSize = 0x8642; // core since OpenGL 3.2; not in OpenGL ES, whose names Qt brings

const char* const kPointVertex = R"(#version 330 core
layout(location = 0) in vec3 place;
layout(location = 1) in vec4 colour;
uniform mat4 clip;
uniform float pixels;
out vec4 tint;
void main() { gl_Position = clip * vec4(place, 1.0); gl_PointSize = pixels; tint = colour; }
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

    QOpenGLExtraFunctions* f = nullptr;
    QOpenGLShaderProgram points;
    QOpenGLShaderProgram dome;
    std::array<Buffer, 3> buffers; ///< moving, still, lines
    QOpenGLVertexArrayObject nothing;
    std::vector<LineRange> lines;
    GLuint framebuffer = 0;
    GLuint colours = 0;
    GLuint depths = 0;
    int width = 0;
    int height = 0;

    void link(QOpenGLShaderProgram& program, const char* vertex, const char* fragment) {
        if (!program.addShaderFromSourceCode(QOpenGLShader::Vertex, vertex) ||
            !program.addShaderFromSourceCode(QOpenGLShader::Fragment, fragment) || !program.link()) {
            throw Error(ErrorCode::Io, "the graphics driver refuses a shader: " + program.log().toStdString());
        }
    }

    void upload(Buffer& buffer, const std::vector<PointVertex>& vertices, const Eigen::Vector3d& origin) {
        if (f == nullptr) return; // the driver refused
        QOpenGLVertexArrayObject::Binder bind(&buffer.layout);
        buffer.vertices.bind();
        buffer.vertices.allocate(vertices.data(), static_cast<int>(vertices.size() * sizeof(PointVertex)));
        f->glEnableVertexAttribArray(0);
        f->glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(PointVertex), nullptr);
        f->glEnableVertexAttribArray(1);
        f->glVertexAttribPointer(1, 4, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(PointVertex), reinterpret_cast<void*>(12));
        buffer.vertices.release();
        buffer.count = vertices.size();
        buffer.origin = origin;
    }

    GLuint texture(GLint inside, GLenum format, GLenum type) {
        GLuint made = 0;
        f->glGenTextures(1, &made);
        f->glBindTexture(GL_TEXTURE_2D, made);
        f->glTexImage2D(GL_TEXTURE_2D, 0, inside, width, height, 0, format, type, nullptr);
        for (const GLenum parameter : std::initializer_list<GLenum>{GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER}) {
            f->glTexParameteri(GL_TEXTURE_2D, parameter, GL_NEAREST);
        }
        for (const GLenum parameter : std::initializer_list<GLenum>{GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T}) {
            f->glTexParameteri(GL_TEXTURE_2D, parameter, GL_CLAMP_TO_EDGE);
        }
        return made;
    }

    void size_target(int wanted_width, int wanted_height) {
        if (width == wanted_width && height == wanted_height) return;
        free_target();
        width = wanted_width;
        height = wanted_height;
        colours = texture(GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE);
        depths = texture(GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT);
        f->glGenFramebuffers(1, &framebuffer);
        f->glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
        f->glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, colours, 0);
        f->glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depths, 0);
        if (f->glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
            throw Error(ErrorCode::Io, "the graphics driver cannot draw beside the screen");
        }
    }

    void free_target() {
        if (framebuffer != 0) f->glDeleteFramebuffers(1, &framebuffer);
        if (colours != 0) f->glDeleteTextures(1, &colours);
        if (depths != 0) f->glDeleteTextures(1, &depths);
        framebuffer = colours = depths = 0;
        width = height = 0;
    }

    void draw_buffer(const Buffer& buffer, const Frame& frame) {
        const Eigen::Matrix4f clip =
            frame.camera.clip_from(buffer.origin, static_cast<double>(frame.width) / frame.height).cast<float>();
        points.setUniformValue("clip", QMatrix4x4(clip.data()).transposed());
        points.setUniformValue("pixels", frame.point_pixels);
    }

    void draw_scene(const Frame& frame) {
        const QVector3D ground = rgb_of(frame.ground);
        f->glViewport(0, 0, frame.width, frame.height);
        f->glClearColor(ground.x(), ground.y(), ground.z(), 1.0F);
        f->glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        f->glEnable(GL_DEPTH_TEST);
        f->glEnable(kProgramPointSize);
        points.bind();
        Buffer& cloud = buffers[frame.slot == Slot::Still && buffers[1].count > 0 ? 1 : 0];
        if (cloud.count > 0) {
            draw_buffer(cloud, frame);
            QOpenGLVertexArrayObject::Binder bind(&cloud.layout);
            f->glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(cloud.count));
        }
        points.release();
    }

    // Over everything: an outline that dust hides would be no outline.
    void draw_lines(const Frame& frame) {
        if (lines.empty()) return;
        f->glDisable(GL_DEPTH_TEST);
        points.bind();
        draw_buffer(buffers[2], frame);
        QOpenGLVertexArrayObject::Binder bind(&buffers[2].layout);
        for (const LineRange& line : lines) {
            f->glLineWidth(line.strong ? 3.0F : 1.5F);
            f->glDrawArrays(line.closed ? GL_LINE_LOOP : GL_LINE_STRIP, line.first, line.count);
        }
        points.release();
    }

    void draw_dome(const Frame& frame) {
        f->glBindFramebuffer(GL_FRAMEBUFFER, frame.target_framebuffer);
        f->glViewport(0, 0, frame.width, frame.height);
        f->glDisable(GL_DEPTH_TEST);
        dome.bind();
        f->glActiveTexture(GL_TEXTURE0);
        f->glBindTexture(GL_TEXTURE_2D, colours);
        f->glActiveTexture(GL_TEXTURE1);
        f->glBindTexture(GL_TEXTURE_2D, depths);
        dome.setUniformValue("colours", 0);
        dome.setUniformValue("depths", 1);
        dome.setUniformValue("pixel", QVector2D(1.0F / static_cast<float>(width), 1.0F / static_cast<float>(height)));
        dome.setUniformValue("near_plane", static_cast<float>(Camera::kNear * frame.camera.distance));
        dome.setUniformValue("far_plane", static_cast<float>(Camera::kFar * frame.camera.distance));
        dome.setUniformValue("parallel", frame.camera.from_above);
        QOpenGLVertexArrayObject::Binder bind(&nothing);
        f->glDrawArrays(GL_TRIANGLES, 0, 3);
        dome.release();
        f->glActiveTexture(GL_TEXTURE0);
    }
};

SceneRenderer::SceneRenderer() : gl_(std::make_unique<Gl>()) {}

SceneRenderer::~SceneRenderer() {
    if (gl_->f != nullptr && QOpenGLContext::currentContext() != nullptr) gl_->free_target();
}

void SceneRenderer::initialise() {
    QOpenGLContext* context = QOpenGLContext::currentContext();
    if (context == nullptr) throw Error(ErrorCode::Io, "there is no OpenGL here");
    gl_->link(gl_->points, kPointVertex, kPointFragment);
    gl_->link(gl_->dome, kWholeVertex, kDomeFragment);
    gl_->nothing.create();
    for (Gl::Buffer& buffer : gl_->buffers) {
        buffer.layout.create();
        buffer.vertices.create();
        buffer.vertices.setUsagePattern(QOpenGLBuffer::DynamicDraw);
    }
    gl_->f = context->extraFunctions(); // last: without it nothing is drawn or kept
}

void SceneRenderer::set_points(Slot slot, const PointSet& points) {
    gl_->upload(gl_->buffers[slot == Slot::Moving ? 0 : 1], points.points, points.origin);
}

std::size_t SceneRenderer::points(Slot slot) const { return gl_->buffers[slot == Slot::Moving ? 0 : 1].count; }

void SceneRenderer::set_lines(const std::vector<SceneLine>& lines, const Eigen::Vector3d& origin) {
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
    gl_->upload(gl_->buffers[2], vertices, origin);
}

void SceneRenderer::draw(const Frame& frame) {
    if (gl_->f == nullptr) return;
    if (frame.eye_dome) {
        gl_->size_target(frame.width, frame.height);
        gl_->f->glBindFramebuffer(GL_FRAMEBUFFER, gl_->framebuffer);
        gl_->draw_scene(frame);
        gl_->draw_dome(frame);
    } else {
        gl_->f->glBindFramebuffer(GL_FRAMEBUFFER, frame.target_framebuffer);
        gl_->draw_scene(frame);
    }
    gl_->draw_lines(frame);
}

} // namespace planum::gui
