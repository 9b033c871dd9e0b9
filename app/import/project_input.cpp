// SPDX-License-Identifier: MIT
#include "app/import/project_input.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "core/sqlite/database.hpp"
#include "strat/exchange/writer.hpp"

namespace planum::app {

namespace {

// Whatever else is wrong with it.
bool is_project(const strat::InputFile& input) {
    if (!input.is_database) return false;
    try {
        return sqlite::Database::open_foreign(input.path).has_table("planum_meta");
    } catch (const Error&) {
        return input.path.extension() == ".gpkg"; // opening says what is wrong with it
    }
}

std::vector<std::string> left_behind(const model::Record& record) {
    std::vector<std::string> kinds;
    const auto say = [&](std::size_t count, std::string_view kind) {
        if (count > 0) kinds.push_back(fmt::format("{} {}", count, kind));
    };
    say(record.scans.size(), "scans");
    say(record.regions.size(), "regions");
    say(record.sections.size(), "sections");
    say(record.decisions.size(), "decisions");
    say(record.interpretations.size(), "interpretations");
    return kinds;
}

} // namespace

std::vector<strat::ReadNote> read_as_project(strat::InputFile& input, const store::Environment& environment) {
    if (!is_project(input)) return {};
    const model::Record record = store::ProjectFile::open(input.path, store::OpenMode::ReadOnly, environment).load();
    strat::Written written = strat::writer_for("json").write(record, {});
    input.bytes = std::move(written.files.front().bytes);
    input.is_database = false;
    std::vector<strat::ReadNote> notes;
    if (const auto kinds = left_behind(record); !kinds.empty()) {
        notes.push_back(
            {input.name,
             0,
             "not-taken-over",
             {},
             fmt::format("{} of the project stay behind: only its record is imported", text::join(kinds, ", "))});
    }
    return notes;
}

} // namespace planum::app
