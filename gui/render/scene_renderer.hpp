// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <memory>
#include <vector>

#include "gui/render/point_set.hpp"
#include "gui/render/scene_cut.hpp"

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

    struct Frame {
        Camera camera;
        int width = 1; ///< [px]
        int height = 1;
        Slot slot = Slot::Moving;
        bool eye_dome = false; ///< shading by depth, which makes shapes readable without normals (Boucheny 2009)
        float point_pixels = 2.0F;
        std::uint32_t ground = 0xffffff;
        SceneBox box;
        SceneSlab slab;
        std::uint32_t target_framebuffer = 0; ///< what is drawn into
    };

    void set_moving(const PointSet& points);
    void set_lines(const std::vector<SceneLine>& lines, const Eigen::Vector3d& origin);

    /// The still picture is made of millions of points: in steps beside the screen, so that the window answers between
    /// them. `frame` says how; its target counts only in draw().
    void set_still(std::shared_ptr<const PointSet> points, const Frame& frame);
    /// The same points once more: another shading, another ground.
    void draw_still_again(const Frame& frame);
    /// Works on it for about so long; true once it is finished.
    bool advance_still(int milliseconds);

    /// The finished still picture, or the moving points as long as there is none; lines over either.
    void draw(const Frame& frame);
    [[nodiscard]] std::size_t points(Slot slot) const;

  private:
    struct Gl;
    std::unique_ptr<Gl> gl_;
};

} // namespace planum::gui
