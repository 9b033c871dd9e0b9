// SPDX-License-Identifier: MIT
#include "gui/render/gl_target.hpp"

#include <initializer_list>

#include "core/base/error.hpp"

namespace planum::gui {

GLuint GlTarget::texture(QOpenGLExtraFunctions& f, GLint inside, GLenum format, GLenum type) const {
    GLuint made = 0;
    f.glGenTextures(1, &made);
    f.glBindTexture(GL_TEXTURE_2D, made);
    f.glTexImage2D(GL_TEXTURE_2D, 0, inside, width_, height_, 0, format, type, nullptr);
    for (const GLenum parameter : std::initializer_list<GLenum>{GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER}) {
        f.glTexParameteri(GL_TEXTURE_2D, parameter, GL_NEAREST);
    }
    for (const GLenum parameter : std::initializer_list<GLenum>{GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T}) {
        f.glTexParameteri(GL_TEXTURE_2D, parameter, GL_CLAMP_TO_EDGE);
    }
    return made;
}

void GlTarget::size(QOpenGLExtraFunctions& f, int width, int height) {
    if (width_ == width && height_ == height) return;
    free(f);
    width_ = width;
    height_ = height;
    f.glGenFramebuffers(1, &framebuffer_);
    f.glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    colours_ = texture(f, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE);
    f.glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, colours_, 0);
    if (with_depths_) {
        depths_ = texture(f, GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT);
        f.glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depths_, 0);
    }
    if (f.glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
        throw Error(ErrorCode::Io, "the graphics driver cannot draw beside the screen");
    }
}

void GlTarget::free(QOpenGLExtraFunctions& f) {
    if (framebuffer_ != 0) f.glDeleteFramebuffers(1, &framebuffer_);
    if (colours_ != 0) f.glDeleteTextures(1, &colours_);
    if (depths_ != 0) f.glDeleteTextures(1, &depths_);
    framebuffer_ = colours_ = depths_ = 0;
    width_ = height_ = 0;
}

} // namespace planum::gui
