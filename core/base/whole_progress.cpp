// SPDX-License-Identifier: MIT
#include "core/base/whole_progress.hpp"

#include <algorithm>

namespace planum {

WholeProgress::WholeProgress(Progress& outer, std::string_view name) : Progress(outer.stop_token()), outer_(outer) {
    outer_.step(name);
}

void WholeProgress::part(double until, int steps) {
    from_ = until_;
    until_ = std::clamp(until, from_, 1.0);
    steps_ = std::max(steps, 1);
    step_ = 0;
    tell(from_);
}

void WholeProgress::step(std::string_view /*name*/) {
    step_ = std::min(step_ + 1, steps_ - 1);
    fraction(0.0);
}

void WholeProgress::fraction(double done) {
    const double length = (until_ - from_) / steps_;
    tell(from_ + length * (step_ + std::clamp(done, 0.0, 1.0)));
}

void WholeProgress::tell(double done) {
    told_ = std::max(told_, done);
    outer_.fraction(told_);
}

} // namespace planum
