// SPDX-License-Identifier: MIT
#pragma once

namespace planum::test {

/// Kills a process that imports into a project with SIGKILL, `rounds` times at another moment, and checks after
/// each that every acknowledged change is there whole, no other is there half, and the file verifies.
void kill_during_imports(int rounds);

} // namespace planum::test
