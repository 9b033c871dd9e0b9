// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "core/base/progress.hpp"

namespace planum {

/// SHA-256 in pieces. Invariant: finished exactly once.
class Sha256 {
  public:
    Sha256();
    ~Sha256();
    Sha256(const Sha256&) = delete;
    Sha256& operator=(const Sha256&) = delete;

    void add(std::string_view bytes);

    /// 64 lower-case hexadecimal digits.
    [[nodiscard]] std::string finish();

  private:
    struct State;
    std::unique_ptr<State> state_;
};

[[nodiscard]] std::string sha256(std::string_view bytes);

/// Hash of a file's content, read in pieces. Throws BadInput when it is a folder or pipe, Io when it cannot be
/// read, Cancelled.
[[nodiscard]] std::string sha256_of_file(const std::filesystem::path& file, Progress& progress = Progress::none());

} // namespace planum
