// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/project/project.hpp"

namespace planum::app {

/// One field as people type and read it.
struct FieldInfo {
    std::string name;
    std::string help;
    std::vector<std::string> words = {}; ///< of an enumeration: all it may hold, as they are stored
};

/// Fields and their values as text, in the order of RecordKind::fields.
using FieldValues = std::vector<std::pair<std::string, std::string>>;

/// One kind of thing in the record (unit, relation, find, …) as both front ends edit it: by name, field by
/// field, as text. Every add, set and remove is one undo step. Errors: NotFound for names, BadInput for values
/// (with what is allowed), Conflict for rules of the project.
class RecordKind {
  public:
    virtual ~RecordKind() = default;

    [[nodiscard]] virtual std::string_view word() const noexcept = 0; ///< `unit`, `relation`, …
    /// What names one: `NUMBER`, `UNIT KIND UNIT`, `UNIT/ROLE#n`, ….
    [[nodiscard]] virtual std::string_view name_form() const noexcept = 0;
    [[nodiscard]] virtual std::span<const FieldInfo> fields() const noexcept = 0;

    [[nodiscard]] virtual std::vector<std::string> names(Project& project) const = 0;
    /// All fields that hold something, `name` first.
    [[nodiscard]] virtual FieldValues show(Project& project, const std::string& name) const = 0;
    /// Returns the name of what was made.
    virtual std::string add(Project& project, const std::string& name, const FieldValues& values) const = 0;
    virtual void set(Project& project, const std::string& name, const FieldValues& values) const = 0;
    virtual void remove(Project& project, const std::string& name) const = 0;

    /// What somebody should know about values that are taken for `name` (there already): that they are mended, and how.
    [[nodiscard]] virtual std::vector<std::string> remarks(Project& /*project*/, const std::string& /*name*/,
                                                           const FieldValues& /*values*/) const {
        return {};
    }
};

/// A day of the calendar as `2025-06-01`, or empty for empty text. Throws BadInput that names the field.
[[nodiscard]] std::string date_from(const std::string& field, const std::string& text);

/// All kinds, in the order of the help.
[[nodiscard]] std::span<const std::unique_ptr<RecordKind>> record_kinds();

/// Throws Usage for an unknown word.
[[nodiscard]] const RecordKind& record_kind(std::string_view word);

} // namespace planum::app
