// SPDX-License-Identifier: MIT
#include "app/import/project_input.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "strat/exchange/writer.hpp"

namespace planum::app {

namespace {

std::optional<model::Record> record_of(const strat::InputFile& input, const store::Environment& environment) {
    try {
        return store::ProjectFile::open(input.path, store::OpenMode::ReadOnly, environment).load();
    } catch (const Error& e) {
        if (e.code() == ErrorCode::BadInput) return std::nullopt; // another database: its reader will say
        throw;
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
    if (!input.is_database) return {};
    const std::optional<model::Record> record = record_of(input, environment);
    if (!record) return {};
    strat::Written written = strat::writer_for("json").write(*record, {});
    input.bytes = std::move(written.files.front().bytes);
    input.is_database = false;
    std::vector<strat::ReadNote> notes;
    if (const auto kinds = left_behind(*record); !kinds.empty()) {
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
