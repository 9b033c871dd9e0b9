// SPDX-License-Identifier: MIT
#include "strat/layout/part_packing.hpp"

#include <algorithm>
#include <limits>

#include "strat/layout/drawing_style.hpp"

namespace planum::strat {

namespace {

class Packer {
  public:
    explicit Packer(std::size_t deepest) : right_(deepest, -std::numeric_limits<double>::infinity()) {}

    void put(MatrixPart& part, bool free_level) {
        const std::size_t last = free_level ? right_.size() - part.levels.size() : 0;
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t first = 0; first <= last; ++first) {
            const double x = place_at(part, first);
            const double right = std::max(page_right_, right_side(part, x));
            if (right >= least) continue;
            least = right;
            part.x = x;
            part.level = static_cast<std::int32_t>(first);
        }
        page_right_ = least;
        for (std::size_t k = 0; k < part.levels.size(); ++k) {
            double& right = right_[static_cast<std::size_t>(part.level) + k];
            right = std::max(right, part.x + part.levels[k].right);
        }
    }

  private:
    [[nodiscard]] static double right_side(const MatrixPart& part, double x) {
        double right = x;
        for (const MatrixPart::Level& level : part.levels) right = std::max(right, x + level.right);
        return right;
    }

    // Beside what stands on its levels and on those next to them: bars run between two levels.
    [[nodiscard]] double place_at(const MatrixPart& part, std::size_t first) const {
        double x = 0.0;
        const std::size_t n = part.levels.size();
        const auto keep_off = [&](std::size_t level, const MatrixPart::Level& own) {
            x = std::max(x, right_[level] + style::kComponentGap - own.left);
        };
        for (std::size_t k = 0; k < n; ++k) {
            keep_off(first + k, part.levels[k]);
            if (first + k > 0) keep_off(first + k - 1, part.levels[k]);
            if (first + k + 1 < right_.size()) keep_off(first + k + 1, part.levels[k]);
        }
        return x;
    }

    std::vector<double> right_; // of what stands on each level so far [pt]
    double page_right_ = 0.0;
};

} // namespace

void pack_parts(std::vector<MatrixPart>& parts, bool free_levels) {
    std::size_t deepest = 8; // a page of small parts is no taller than this
    for (const MatrixPart& part : parts) deepest = std::max(deepest, part.levels.size());
    Packer packer(deepest);
    for (MatrixPart& part : parts) packer.put(part, free_levels);
}

} // namespace planum::strat
