// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/model/record.hpp"
#include "core/store/project_file.hpp"

namespace planum::app {

/// Who works; clock and ids may be injected by tests and the demo (nil: the system's).
struct Session {
    std::string author; ///< empty: $PLANUM_AUTHOR, else the name of the account
    const Clock* clock = nullptr;
    UuidSource* uuids = nullptr;
};

/// One open project: the file, and its record in memory. What both front ends hold.
///
/// The record is loaded when first asked for and again after every change, so references to it are valid
/// until the next change, undo or redo.
class Project {
  public:
    static Project create(const std::filesystem::path& file, const model::ProjectSettings& settings,
                          const Session& session);
    static Project open(const std::filesystem::path& file, store::OpenMode mode, const Session& session);

    Project(Project&&) noexcept;
    Project& operator=(Project&&) noexcept;
    ~Project();

    [[nodiscard]] const std::filesystem::path& path() const noexcept;
    [[nodiscard]] const std::string& author() const noexcept;
    [[nodiscard]] const Clock& clock() const noexcept;
    [[nodiscard]] UuidSource& uuids() noexcept;

    [[nodiscard]] const model::Record& record();
    [[nodiscard]] const model::RecordIndex& index();

    /// One transaction and one undo step (see store::ProjectFile::change); `work` writes through file().
    std::int64_t change(std::string_view label, const std::function<void()>& work);
    store::ChangeEntry undo();
    store::ChangeEntry redo();

    [[nodiscard]] store::ProjectFile& file() noexcept;
    [[nodiscard]] const store::ProjectFile& file() const noexcept;

    /// The unit that a person means by `NUMBER` or `AREA::NUMBER`. Throws NotFound (with near numbers) or
    /// Usage when several areas have it.
    [[nodiscard]] model::UnitIndex unit_named(std::string_view name);

  private:
    struct State;
    explicit Project(std::unique_ptr<State> state) noexcept;
    std::unique_ptr<State> state_;
};

/// Numbers of the record that a mistyped one may stand for: one digit changed, left out, added or two
/// swapped; at most `most`, in natural order.
[[nodiscard]] std::vector<std::string> near_numbers(const model::Record& record, std::string_view number,
                                                    std::size_t most);

} // namespace planum::app
