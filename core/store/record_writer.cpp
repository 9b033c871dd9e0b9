// SPDX-License-Identifier: MIT
#include "core/store/record_writer.hpp"

#include "core/base/text.hpp"

namespace planum::store {

namespace {

std::string name_of_area(const ProjectFile::State& state, const Uuid& area) {
    if (area.is_nil()) return {};
    sqlite::Statement query = state.database.prepare("SELECT name FROM area WHERE uuid = :uuid");
    query.bind(":uuid", std::string_view{area.to_string()});
    return query.step() ? std::string{query.text(0)} : std::string{};
}

std::string after(std::string_view text, std::string_view mark) {
    const std::size_t at = text.find(mark);
    return at == std::string_view::npos ? std::string{} : std::string{text.substr(at + mark.size())};
}

std::string sentence_of(const ProjectFile::State& state, std::string_view said, const Uuid& area) {
    if (said.find("number already used") != std::string_view::npos) return "number already used";
    if (said.find("'unit_number'") != std::string_view::npos) {
        const std::string where = name_of_area(state, area);
        return where.empty() ? "number already used" : fmt::format("number already used in area {}", where);
    }
    if (said.find("FOREIGN KEY") != std::string_view::npos) return "it refers to a record that does not exist";
    if (const std::string check = after(said, "CHECK constraint failed: "); !check.empty()) {
        return fmt::format("a value is not allowed ({})", check);
    }
    if (const std::string column = after(said, "NOT NULL constraint failed: "); !column.empty()) {
        return fmt::format("{} must not be empty", column);
    }
    if (const std::string unique = after(said, "UNIQUE constraint failed: "); !unique.empty()) {
        const bool same_id = unique.ends_with(".uuid");
        return same_id ? "a record with this id is there already" : "one of this name is there already";
    }
    return {};
}

} // namespace

std::string insert_sql(std::string_view table, const std::vector<std::string_view>& columns) {
    return fmt::format("INSERT INTO {0}(uuid, {1}) VALUES (:uuid, :{2})", table, fmt::join(columns, ", "),
                       fmt::join(columns, ", :"));
}

std::string update_sql(std::string_view table, const std::vector<std::string_view>& columns) {
    std::string sets;
    for (const std::string_view column : columns) {
        sets += fmt::format("{}{} = :{}", sets.empty() ? "" : ", ", column, column);
    }
    return fmt::format("UPDATE {} SET {} WHERE uuid = :uuid AND deleted_at IS NULL", table, sets);
}

void remove_record(ProjectFile::State& state, std::string_view table, std::string_view noun, const Uuid& id) {
    state.require_change(table);
    state.log_inserts();
    sqlite::Statement& remove = state.statements[std::string{table}].remove;
    if (!remove) {
        remove = state.database.prepare(
            fmt::format("UPDATE {} SET deleted_at = :now WHERE uuid = :uuid AND deleted_at IS NULL", table));
    }
    const std::string uuid = id.to_string();
    const std::string time = state.now();
    remove.bind(":now", std::string_view{time}).bind(":uuid", std::string_view{uuid}).run();
    if (state.database.changes() == 0) {
        throw Error(ErrorCode::NotFound, fmt::format("{}: no {} with the id {}", state.file.string(), noun, uuid));
    }
}

Error explain(const ProjectFile::State& state, const Error& error, std::string_view doing, std::string_view noun,
              const std::string& name, const Uuid& area) {
    const std::string context = fmt::format("{} {}{}{}", doing, noun, name.empty() ? "" : " ", name);
    const std::string file = state.file.string();
    std::string said = error.what();
    if (said.starts_with(file + ": ")) said.erase(0, file.size() + 2);
    if (error.code() == ErrorCode::Conflict) {
        const std::string sentence = sentence_of(state, said, area);
        if (!sentence.empty()) said = sentence;
    }
    return {error.code(), fmt::format("{}: {}: {}", file, context, said)};
}

} // namespace planum::store
