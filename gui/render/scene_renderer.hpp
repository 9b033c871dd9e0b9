// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <memory>
#include <vector>

#include "gui/render/point_set.hpp"

namespace planum::gui {

/// A line of the 3D view, in site coordinates [m].
struct SceneLine {
    std::vector<Eigen::Vector3d> places;
    std::uint32_t colour = 0xffffff; ///< 0xRRGGBB
    bool closed = false;
    bool strong = false;
};

/// Draws points and lines with OpenGL 3.3. All calls need the same current context; where one fails it throws
/// Error{Io} with the reason, and the rest of the program goes on without.
class SceneRenderer {
  public:
    SceneRenderer();
    ~SceneRenderer();
    SceneRenderer(const SceneRenderer&) = delete;
    SceneRenderer& operator=(const SceneRenderer&) = delete;

    void initialise();

    /// What is drawn while the camera moves, and what when it stands still.
    enum class Slot { Moving, Still };

    void set_points(Slot slot, const PointSet& points);
    void set_lines(const std::vector<SceneLine>& lines, const Eigen::Vector3d& origin);

    struct Frame {
        Camera camera;
        int width = 1; ///< [px]
        int height = 1;
        Slot slot = Slot::Moving;
        bool eye_dome = false; ///< shading by depth, which makes shapes readable without normals (Boucheny 2009)
        float point_pixels = 2.0F;
        std::uint32_t ground = 0xffffff;
        std::uint32_t target_framebuffer = 0; ///< what is drawn into
    };

    void draw(const Frame& frame);
    [[nodiscard]] std::size_t points(Slot slot) const;

  private:
    struct Gl;
    std::unique_ptr<Gl> gl_;
};

} // namespace planum::gui
