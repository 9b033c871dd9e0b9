// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "core/base/progress.hpp"

namespace planum {

/// A work of many steps that is told as one, so that the time left is that of all of it and not of the step just
/// running. Invariant: what is told never goes back.
class WholeProgress final : public Progress {
  public:
    /// Tells `outer` one step, `name`; further steps are shares of it.
    WholeProgress(Progress& outer, std::string_view name);

    /// From here to the next call the work goes on to the share `until` (0…1) of the whole, in `steps` steps of equal
    /// length, a step begun by part() and each further one by step().
    void part(double until, int steps = 1);

    void step(std::string_view name) override;
    void fraction(double done) override;

  private:
    void tell(double done);

    Progress& outer_;
    double from_ = 0.0;
    double until_ = 0.0; ///< where the next part begins
    int steps_ = 1;
    int step_ = 0;
    double told_ = 0.0;
};

} // namespace planum
