// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include <fmt/format.h>

#include "core/base/error.hpp"
#include "core/store/record_columns.hpp"
#include "core/store/row_visitors.hpp"
#include "core/store/state.hpp"

namespace planum::store {

/// Columns of a type's table in the order of describe_columns().
template<class T>
[[nodiscard]] const std::vector<std::string_view>& columns_of() {
    static const std::vector<std::string_view> names = [] {
        ColumnNames visitor;
        const T value{};
        describe_columns(visitor, value);
        return visitor.names();
    }();
    return names;
}

/// `INSERT INTO area(uuid, name, …) VALUES (:uuid, :name, …)`
[[nodiscard]] std::string insert_sql(std::string_view table, const std::vector<std::string_view>& columns);
/// `UPDATE area SET name = :name, … WHERE uuid = :uuid AND deleted_at IS NULL`
[[nodiscard]] std::string update_sql(std::string_view table, const std::vector<std::string_view>& columns);

/// Marks one living record; NotFound when there is none.
void remove_record(ProjectFile::State& state, std::string_view table, std::string_view noun, const Uuid& id);

/// What SQLite refused, as a sentence about the record: `site.gpkg: adding unit 1042: number already used
/// in area A`. Errors that are no conflicts get the context only.
[[nodiscard]] Error explain(const ProjectFile::State& state, const Error& error, std::string_view doing,
                            std::string_view noun, const std::string& name, const Uuid& area);

/// What a record is called in messages; empty where it has no name of its own.
template<class T>
[[nodiscard]] std::string name_of(const T& value) {
    if constexpr (requires { value.number; }) {
        return value.number;
    } else if constexpr (requires { value.name; }) {
        return value.name;
    } else {
        return {};
    }
}

template<class T>
[[nodiscard]] Uuid area_of(const T& value) {
    if constexpr (requires { value.area.value; }) {
        return value.area.value;
    } else {
        return {};
    }
}

template<class T>
void insert_record(ProjectFile::State& state, const T& value, const Uuid& id) {
    constexpr std::string_view kTable = TableOf<T>::name;
    state.require_change(kTable);
    sqlite::Statement& insert = state.statements[std::string{kTable}].insert;
    try {
        if (!insert) insert = state.database.prepare(insert_sql(kTable, columns_of<T>()));
        RowBinder binder(insert, 1, state.srs_id);
        binder.uuid(id);
        describe_columns(binder, value);
        insert.run();
        state.note_insert(kTable);
    } catch (const Error& e) {
        throw explain(state, e, "adding", TableOf<T>::noun, name_of(value), area_of(value));
    }
}

template<class T>
void update_record(ProjectFile::State& state, const T& value, const Uuid& id) {
    constexpr std::string_view kTable = TableOf<T>::name;
    state.require_change(kTable);
    state.log_inserts();
    sqlite::Statement& update = state.statements[std::string{kTable}].update;
    try {
        if (!update) update = state.database.prepare(update_sql(kTable, columns_of<T>()));
        RowBinder binder(update, 1, state.srs_id);
        describe_columns(binder, value);
        binder.uuid(id);
        update.run();
    } catch (const Error& e) {
        throw explain(state, e, "changing", TableOf<T>::noun, name_of(value), area_of(value));
    }
    if (state.database.changes() == 0) {
        throw Error(ErrorCode::NotFound,
                    fmt::format("{}: no {} {}", state.file.string(), TableOf<T>::noun, name_of(value)));
    }
}

} // namespace planum::store
