// SPDX-License-Identifier: MIT
#include <algorithm>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "core/store/state.hpp"

namespace planum::store {

namespace {

constexpr std::string_view kSelectHistory = "SELECT fid, label, author, made_at, state <> 'done', state = 'dropped' "
                                            "FROM planum_change ORDER BY fid DESC LIMIT :most";
// No index on the record: the log is written far more often than it is read.
constexpr std::string_view kSelectLog =
    "SELECT made_at, author, action, table_name, record, field, old_value, new_value, change FROM planum_log "
    "WHERE :record IS NULL OR record = :record ORDER BY fid DESC LIMIT :most";

// One line for what another program did to a table within a minute; such work is no undo step.
constexpr std::string_view kSelectOutside =
    "SELECT max(made_at), author, action, table_name, count(DISTINCT record) FROM planum_log "
    "WHERE change IS NULL AND author = 'outside Planum' "
    "GROUP BY substr(made_at, 1, 16), action, table_name ORDER BY 1 DESC LIMIT :most";

std::string outside_label(std::string_view action, std::string_view table, std::int64_t records) {
    const std::string_view verb = action == "insert"    ? "Added"
                                  : action == "delete"  ? "Deleted"
                                  : action == "restore" ? "Restored"
                                                        : "Changed";
    return fmt::format("{} {} {} of {} with another program", verb, records, records == 1 ? "row" : "rows", table);
}

std::vector<ChangeEntry> outside_entries(const sqlite::Database& database, std::int64_t most) {
    sqlite::Statement rows = database.prepare(kSelectOutside);
    rows.bind(":most", most);
    std::vector<ChangeEntry> entries;
    while (rows.step()) {
        entries.push_back({0, outside_label(rows.text(2), rows.text(3), rows.integer(4)), std::string{rows.text(1)},
                           std::string{rows.text(0)}, false, false});
    }
    return entries;
}

std::int64_t limit_of(std::size_t most) {
    constexpr std::size_t kMost = 0x7FFFFFFF;
    return static_cast<std::int64_t>(most < kMost ? most : kMost);
}

} // namespace

std::vector<ChangeEntry> ProjectFile::history(std::size_t most) const {
    state_->wait_for_check();
    sqlite::Statement rows = state_->database.prepare(kSelectHistory);
    rows.bind(":most", limit_of(most));
    std::vector<ChangeEntry> entries;
    while (rows.step()) {
        entries.push_back({rows.integer(0), std::string{rows.text(1)}, std::string{rows.text(2)},
                           std::string{rows.text(3)}, rows.integer(4) != 0, rows.integer(5) != 0});
    }
    // Changes keep their order, whatever clocks said; what came from outside goes to its time between them.
    auto next = entries.begin();
    for (ChangeEntry& outside : outside_entries(state_->database, limit_of(most))) {
        next = std::find_if(next, entries.end(), [&](const auto& entry) { return entry.made_at <= outside.made_at; });
        next = std::next(entries.insert(next, std::move(outside)));
    }
    if (entries.size() > most) entries.resize(most);
    return entries;
}

std::vector<LogEntry> ProjectFile::log(std::optional<Uuid> record, std::size_t most) const {
    state_->wait_for_check();
    sqlite::Statement rows = state_->database.prepare(kSelectLog);
    rows.bind(":most", limit_of(most));
    if (record) rows.bind(":record", std::string_view{record->to_string()});
    std::vector<LogEntry> entries;
    while (rows.step()) {
        entries.push_back({std::string{rows.text(0)}, std::string{rows.text(1)}, std::string{rows.text(2)},
                           std::string{rows.text(3)}, std::string{rows.text(4)}, std::string{rows.text(5)},
                           std::string{rows.text(6)}, std::string{rows.text(7)}, rows.integer(8)});
    }
    return entries;
}

} // namespace planum::store
