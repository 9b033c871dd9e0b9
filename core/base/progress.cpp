// SPDX-License-Identifier: MIT
#include "core/base/progress.hpp"

#include "core/base/error.hpp"

namespace planum {

void Progress::check() const {
    if (token_.stop_requested()) throw Error(ErrorCode::Cancelled, "stopped by the user");
}

Progress& Progress::none() {
    static Progress nothing;
    return nothing;
}

} // namespace planum
