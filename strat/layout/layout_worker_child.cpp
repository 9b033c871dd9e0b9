// SPDX-License-Identifier: MIT
// The child's side of layout_worker.hpp: the only file that calls Graphviz.
#include <graphviz/gvc.h>

#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <string>

#include "core/base/text.hpp"
#include "strat/layout/layout_worker.hpp"

namespace planum::strat {

namespace {

constexpr int kOutOfMemory = 71;

std::string read_all(int fd) {
    std::string text;
    std::array<char, 65536> buffer{};
    while (true) {
        const ssize_t n = ::read(fd, buffer.data(), buffer.size());
        if (n <= 0) return text;
        text.append(buffer.data(), static_cast<std::size_t>(n));
    }
}

bool write_all(int fd, const std::string& text) {
    std::size_t done = 0;
    while (done < text.size()) {
        const ssize_t n = ::write(fd, text.data() + done, text.size() - done);
        if (n <= 0) return false;
        done += static_cast<std::size_t>(n);
    }
    return true;
}

void limit(__rlimit_resource resource, rlim_t soft, rlim_t hard) {
    const rlimit both{soft, hard};
    ::setrlimit(resource, &both);
}

void set_limits(long long seconds, long long megabytes) {
    // The soft limit ends us by SIGXCPU, which says why; the hard one by a plain SIGKILL.
    limit(RLIMIT_CPU, static_cast<rlim_t>(seconds), static_cast<rlim_t>(seconds) + 5);
    limit(RLIMIT_CORE, 0, 0);
#if !defined(__SANITIZE_ADDRESS__) // its shadow memory is terabytes of addresses
    limit(RLIMIT_AS, static_cast<rlim_t>(megabytes) << 20U, static_cast<rlim_t>(megabytes) << 20U);
#else
    static_cast<void>(megabytes);
#endif
}

std::string attribute(void* object, const char* name) {
    std::string writable(name);
    const char* value = agget(object, writable.data());
    return value == nullptr ? std::string{} : std::string(value);
}

// Graphviz writes spline points as `x,y x,y`, and here and there breaks the line with a backslash.
std::string plain_numbers(std::string points) {
    for (char& c : points) {
        if (c == ',' || c == ';' || c == '\n' || c == '\r' || c == '\\') c = ' ';
    }
    return points;
}

std::string positions(Agraph_t* graph) {
    std::string out;
    for (Agnode_t* node = agfstnode(graph); node != nullptr; node = agnxtnode(graph, node)) {
        out += std::string("n ") + agnameof(node) + " " + plain_numbers(attribute(node, "pos")) + "\n";
    }
    for (Agnode_t* node = agfstnode(graph); node != nullptr; node = agnxtnode(graph, node)) {
        for (Agedge_t* edge = agfstout(graph, node); edge != nullptr; edge = agnxtout(graph, edge)) {
            out += "e " + attribute(edge, "comment") + " " + plain_numbers(attribute(edge, "pos")) + "\n";
        }
    }
    return out + "end\n";
}

int lay_out(const std::string& dot) {
    GVC_t* context = gvContext();
    if (context == nullptr) return 1;
    Agraph_t* graph = agmemread(dot.c_str());
    if (graph == nullptr) return 2;
    if (gvLayout(context, graph, "dot") != 0) return 3;
    // Rendering to nowhere is Graphviz's own way of writing positions into the attributes.
    if (gvRender(context, graph, "dot", nullptr) != 0) return 4;
    // The process ends here; freeing a large layout takes longer than making it.
    return write_all(STDOUT_FILENO, positions(graph)) ? 0 : 5;
}

} // namespace

std::optional<int> run_layout_worker_if_asked(int argc, const char* const* argv) {
    if (argc < 2 || std::string_view(argv[1]) != kLayoutWorkerArgument) return std::nullopt;
    const auto seconds = argc > 2 ? text::parse_integer(argv[2]) : std::nullopt;
    const auto megabytes = argc > 3 ? text::parse_integer(argv[3]) : std::nullopt;
    if (!seconds || !megabytes || *seconds <= 0 || *megabytes <= 0) return 2;
    set_limits(*seconds, *megabytes);
    try {
        return lay_out(read_all(STDIN_FILENO));
    } catch (const std::bad_alloc&) {
        return kOutOfMemory;
    } catch (const std::exception&) {
        return 1;
    }
}

} // namespace planum::strat
