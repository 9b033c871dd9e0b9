// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

namespace planum::test {

/// Runs `work` in a process of its own; returns its exit status, or 1000 + the signal that ended it.
int in_child(const std::function<int()>& work);

} // namespace planum::test
