// SPDX-License-Identifier: MIT
#include "strat/layout/layout_worker.hpp"

#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstring>
#include <utility>

#include "core/base/error.hpp"

// The child needs no more of our environment than where to find Graphviz's plugins.
extern char** environ;

namespace planum::strat {

namespace {

class Descriptor {
  public:
    Descriptor() = default;

    explicit Descriptor(int fd) : fd_(fd) {}

    Descriptor(Descriptor&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}

    Descriptor& operator=(Descriptor&& other) noexcept {
        close();
        fd_ = std::exchange(other.fd_, -1);
        return *this;
    }

    ~Descriptor() { close(); }

    void close() noexcept {
        if (fd_ >= 0) ::close(fd_);
        fd_ = -1;
    }

    [[nodiscard]] int get() const noexcept { return fd_; }

    [[nodiscard]] bool is_open() const noexcept { return fd_ >= 0; }

  private:
    int fd_ = -1;
};

struct Pipe {
    Descriptor read;
    Descriptor write;
};

Pipe make_pipe() {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) {
        throw Error(ErrorCode::Io, std::string("cannot make a pipe to the layout process: ") + std::strerror(errno));
    }
    return {Descriptor(ends[0]), Descriptor(ends[1])};
}

// A child that is ended and waited for, whatever happens.
class Child {
  public:
    explicit Child(pid_t pid) : pid_(pid) {}

    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;

    ~Child() {
        if (pid_ <= 0) return;
        ::kill(pid_, SIGKILL);
        wait();
    }

    /// Status as waitpid gives it.
    int wait() noexcept {
        int status = 0;
        while (::waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
        }
        pid_ = -1;
        return status;
    }

  private:
    pid_t pid_;
};

pid_t start(const std::filesystem::path& executable, const WorkerLimits& limits, const Pipe& in, const Pipe& out) {
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, in.read.get(), STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, out.write.get(), STDOUT_FILENO);
    // Graphviz talks on stderr; what matters comes back as an exit status.
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    sigset_t none;
    sigemptyset(&none);
    sigset_t defaults;
    sigemptyset(&defaults);
    sigaddset(&defaults, SIGPIPE);
    sigaddset(&defaults, SIGXCPU);
    posix_spawnattr_setsigmask(&attributes, &none);
    posix_spawnattr_setsigdefault(&attributes, &defaults);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);

    std::string program = executable.string();
    std::string argument(kLayoutWorkerArgument);
    std::string seconds = fmt::format("{}", limits.seconds);
    std::string megabytes = fmt::format("{}", limits.megabytes);
    const std::array<char*, 5> arguments = {program.data(), argument.data(), seconds.data(), megabytes.data(), nullptr};
    pid_t pid = -1;
    const int error = ::posix_spawn(&pid, program.c_str(), &actions, &attributes, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    posix_spawnattr_destroy(&attributes);
    if (error != 0) {
        throw Error(ErrorCode::Io,
                    fmt::format("cannot start {} to lay the matrix out: {}", program, std::strerror(error)));
    }
    return pid;
}

void set_non_blocking(const Descriptor& fd) { ::fcntl(fd.get(), F_SETFL, ::fcntl(fd.get(), F_GETFL) | O_NONBLOCK); }

// Writes what the pipe takes without waiting; closes it when all is written or nobody reads any more.
void feed(Descriptor& to, std::string_view text, std::size_t& written) {
    while (written < text.size()) {
        const ssize_t n = ::write(to.get(), text.data() + written, text.size() - written);
        if (n > 0) {
            written += static_cast<std::size_t>(n);
            continue;
        }
        if (n < 0 && errno == EINTR) continue;
        if (n < 0 && errno == EAGAIN) return;
        break;
    }
    to.close();
}

// False at the end of the stream.
bool drain(const Descriptor& from, std::string& answer) {
    std::array<char, 65536> buffer{};
    while (true) {
        const ssize_t n = ::read(from.get(), buffer.data(), buffer.size());
        if (n > 0) {
            answer.append(buffer.data(), static_cast<std::size_t>(n));
            continue;
        }
        if (n < 0 && errno == EINTR) continue;
        return n < 0 && errno == EAGAIN;
    }
}

// SIGPIPE would end the program when the child dies while we write to it; only this thread's is held
// back, and one that we caused is taken away.
class HeldPipeSignal {
  public:
    HeldPipeSignal() {
        sigemptyset(&pipe_);
        sigaddset(&pipe_, SIGPIPE);
        ::pthread_sigmask(SIG_BLOCK, &pipe_, &before_);
    }

    HeldPipeSignal(const HeldPipeSignal&) = delete;
    HeldPipeSignal& operator=(const HeldPipeSignal&) = delete;

    ~HeldPipeSignal() {
        const timespec no_time{};
        while (::sigtimedwait(&pipe_, nullptr, &no_time) == SIGPIPE) {
        }
        ::pthread_sigmask(SIG_SETMASK, &before_, nullptr);
    }

  private:
    sigset_t pipe_{};
    sigset_t before_{};
};

std::string talk(Descriptor& to, const Descriptor& from, std::string_view dot, const WorkerLimits& limits,
                 Progress& progress) {
    const HeldPipeSignal held;
    set_non_blocking(to);
    set_non_blocking(from);
    std::string answer;
    std::size_t written = 0;
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(limits.seconds);
    while (true) {
        progress.check();
        if (std::chrono::steady_clock::now() > deadline) {
            throw Error(
                ErrorCode::BadInput,
                fmt::format("graphviz did not finish within {} seconds; draw a smaller part, or use the engine planum",
                            limits.seconds));
        }
        std::array<pollfd, 2> wait = {pollfd{from.get(), POLLIN, 0}, pollfd{to.get(), POLLOUT, 0}};
        constexpr int kMilliseconds = 100;
        ::poll(wait.data(), to.is_open() ? 2 : 1, kMilliseconds);
        if (to.is_open() && wait[1].revents != 0) feed(to, dot, written);
        if (wait[0].revents != 0 && !drain(from, answer)) return answer;
    }
}

[[noreturn]] void fail(int status, const WorkerLimits& limits) {
    std::string why;
    if (WIFSIGNALED(status)) {
        const int signal = WTERMSIG(status);
        if (signal == SIGXCPU) {
            why = fmt::format("used up its {} seconds", limits.seconds);
        } else {
            why = fmt::format("crashed with signal {}", signal);
        }
    } else if (WEXITSTATUS(status) == 71) {
        why = fmt::format("needed more than {} MB of memory", limits.megabytes);
    } else {
        why = fmt::format("ended with status {}", WEXITSTATUS(status));
    }
    throw Error(ErrorCode::BadInput, "graphviz " + why + "; draw a smaller part, or use the engine planum");
}

} // namespace

std::string run_layout_worker(const std::filesystem::path& executable, std::string_view dot, const WorkerLimits& limits,
                              Progress& progress) {
    Pipe in = make_pipe();
    Pipe out = make_pipe();
    Child child(start(executable, limits, in, out));
    in.read.close();
    out.write.close();
    std::string answer = talk(in.write, out.read, dot, limits, progress);
    const int status = child.wait();
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) fail(status, limits);
    if (!answer.ends_with("end\n")) {
        throw Error(ErrorCode::Internal, executable.string() + " did not answer as a layout process");
    }
    return answer;
}

} // namespace planum::strat
