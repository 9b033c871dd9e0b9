// SPDX-License-Identifier: MIT
#pragma once

#include <QOpenGLExtraFunctions>

namespace planum::gui {

/// Colours and depths that are drawn into beside the screen. All calls need the context that `size()` was called in.
class GlTarget {
  public:
    enum class Depths { With, Without };

    explicit GlTarget(Depths depths) : with_depths_(depths == Depths::With) {}

    /// Makes it so large [px]; what was drawn is lost where the size changes. Throws Error{Io} where the driver
    /// refuses.
    void size(QOpenGLExtraFunctions& f, int width, int height);
    void free(QOpenGLExtraFunctions& f);

    [[nodiscard]] GLuint framebuffer() const noexcept { return framebuffer_; }

    [[nodiscard]] GLuint colours() const noexcept { return colours_; }

    [[nodiscard]] GLuint depths() const noexcept { return depths_; }

    [[nodiscard]] int width() const noexcept { return width_; }

    [[nodiscard]] int height() const noexcept { return height_; }

  private:
    GLuint texture(QOpenGLExtraFunctions& f, GLint inside, GLenum format, GLenum type) const;

    bool with_depths_;
    GLuint framebuffer_ = 0;
    GLuint colours_ = 0;
    GLuint depths_ = 0;
    int width_ = 0;
    int height_ = 0;
};

} // namespace planum::gui
