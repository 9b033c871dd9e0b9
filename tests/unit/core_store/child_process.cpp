// SPDX-License-Identifier: MIT
#include "tests/unit/core_store/child_process.hpp"

#include <sys/wait.h>
#include <unistd.h>

namespace planum::test {

int in_child(const std::function<int()>& work) {
    const pid_t child = fork();
    if (child == 0) {
        int status = 70;
        try {
            status = work();
        } catch (...) {
            status = 71;
        }
        _exit(status);
    }
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status);
}

} // namespace planum::test
