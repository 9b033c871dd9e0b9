// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace planum::bench {

/// Wall time, processor time and largest memory of one run.
struct Measured {
    double wall = 0.0;    ///< [s]
    double cpu = 0.0;     ///< [s]
    double peak_mb = 0.0; ///< [MB] of the process (children) or 0 (in process)
    int status = 0;
    bool timed_out = false;
};

/// Runs a program to its end, output thrown away; killed after `limit` seconds.
Measured run_child(const std::vector<std::string>& command, double limit);

/// Median of `runs` in-process runs [s].
double median_seconds(int runs, const std::function<void()>& work);

/// A scratch folder that goes away.
class Scratch {
  public:
    Scratch();
    ~Scratch();
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;

    [[nodiscard]] std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

  private:
    std::filesystem::path path_;
};

/// Folder the running program lies in: the other programs are beside it.
[[nodiscard]] std::filesystem::path program_folder();

/// "4 cores, AMD …": for the line above a table.
[[nodiscard]] std::string machine();

} // namespace planum::bench
