// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/model/record.hpp"
#include "core/sqlite/statement.hpp"
#include "core/store/words.hpp"

namespace planum::store {

/// Collects the columns of a type in order.
class ColumnNames {
  public:
    template<class T>
    void text(std::string_view column, const T&) {
        add(column);
    }

    template<class T>
    void integer(std::string_view column, const T&) {
        add(column);
    }

    template<class T>
    void real(std::string_view column, const T&) {
        add(column);
    }

    template<class T>
    void word(std::string_view column, const T&) {
        add(column);
    }

    template<class T>
    void boolean(std::string_view column, const T&) {
        add(column);
    }

    template<class T>
    void reference(std::string_view column, const T&) {
        add(column);
    }

    template<class T>
    void numbers(std::string_view column, const T&) {
        add(column);
    }

    template<class Z>
    void position(const std::optional<double>&, const std::optional<double>&, const Z&) {
        for (const std::string_view column : {"geom", "x", "y", "z"}) add(column);
    }

    void line(const std::array<double, 2>&, const std::array<double, 2>&) { add("geom"); }

    void outline(const std::vector<model::Polygon>&, bool) { add("geom"); }

    void station(const std::array<double, 16>&) { add("geom"); }

    void details(const model::UnitDetails&) {
        for (const model::UnitFieldInfo& field : model::kUnitFields) add(field.name);
    }

    [[nodiscard]] const std::vector<std::string_view>& names() const noexcept { return names_; }

  private:
    void add(std::string_view column) { names_.push_back(column); }

    std::vector<std::string_view> names_;
};

/// Binds the members of a value to a statement's parameters, from `first` on. The value and the binder must
/// live until the statement has run. Empty texts and nil ids become NULL.
class RowBinder {
  public:
    RowBinder(sqlite::Statement& statement, int first, std::int32_t srs_id)
        : statement_(&statement), index_(first), srs_id_(srs_id) {}

    void text(std::string_view column, const std::string& value);
    void integer(std::string_view column, std::int64_t value);
    void integer(std::string_view column, const std::optional<std::int64_t>& value);
    void real(std::string_view column, double value);
    void real(std::string_view column, const std::optional<double>& value);
    void boolean(std::string_view column, bool value);

    template<class Enum>
    void word(std::string_view, Enum value) {
        const std::string_view said = to_word(value);
        if (said.empty())
            null();
        else
            statement_->bind_static(index_++, said);
    }

    template<class Tag>
    void reference(std::string_view, const Id<Tag>& id) {
        uuid(id.value);
    }

    void uuid(const Uuid& id);
    void position(const std::optional<double>& x, const std::optional<double>& y, const std::optional<double>& z);
    void line(const std::array<double, 2>& from, const std::array<double, 2>& to);
    void outline(const std::vector<model::Polygon>& outline, bool has_heights);
    void station(const std::array<double, 16>& site_from_scan);
    void details(const model::UnitDetails& details);

    template<std::size_t N>
    void numbers(std::string_view, const std::array<double, N>& values) {
        number_list(values);
    }

    template<std::size_t N>
    void numbers(std::string_view, const std::optional<std::array<double, N>>& values) {
        if (values)
            number_list(*values);
        else
            null();
    }

    /// Parameter after the last one that was bound.
    [[nodiscard]] int next() const noexcept { return index_; }

  private:
    void null();
    void number_list(std::span<const double> values);

    sqlite::Statement* statement_;
    int index_;
    std::int32_t srs_id_;
    std::array<std::array<char, 36>, 8> ids_; ///< texts of the ids bound, so that none has to be copied
    std::size_t ids_used_ = 0;
};

/// Reads the members of a value from a row's columns, from `first` on. Throws BadInput, naming the table and
/// the column, for what no rule of ours would have let in.
class RowReader {
  public:
    RowReader(const sqlite::Statement& row, int first, std::string_view table)
        : row_(&row), column_(first), table_(table) {}

    void text(std::string_view, std::string& value) { value.assign(row_->text(column_++)); }

    void integer(std::string_view, std::int64_t& value) { value = row_->integer(column_++); }

    void integer(std::string_view, std::optional<std::int64_t>& value) { value = row_->optional_integer(column_++); }

    void real(std::string_view, double& value) { value = row_->real(column_++); }

    void real(std::string_view, std::optional<double>& value) { value = row_->optional_real(column_++); }

    void boolean(std::string_view, bool& value) { value = row_->integer(column_++) != 0; }

    template<class Enum>
    void word(std::string_view column, Enum& value) {
        const std::string_view said = row_->text(column_++);
        if (said == last_word_of(value)) return;
        const std::optional<Enum> known = value_of_word<Enum>(said);
        if (!known) refuse(column, said);
        value = *known;
    }

    template<class Tag>
    void reference(std::string_view column, Id<Tag>& id) {
        id.value = uuid(column);
    }

    /// Nil for NULL.
    [[nodiscard]] Uuid uuid(std::string_view column);

    void position(std::optional<double>& x, std::optional<double>& y, std::optional<double>& z);
    void position(std::optional<double>& x, std::optional<double>& y, double& z);
    void line(std::array<double, 2>& from, std::array<double, 2>& to);
    void outline(std::vector<model::Polygon>& outline, bool& has_heights);

    void station(const std::array<double, 16>&) { ++column_; }

    void details(model::UnitDetails& details);

    template<std::size_t N>
    void numbers(std::string_view column, std::array<double, N>& values) {
        number_list(column, values);
    }

    template<std::size_t N>
    void numbers(std::string_view column, std::optional<std::array<double, N>>& values) {
        if (row_->is_null(column_)) {
            ++column_;
            values.reset();
            return;
        }
        number_list(column, values.emplace());
    }

  private:
    template<class Enum>
    [[nodiscard]] static std::string_view last_word_of(Enum value) noexcept {
        return to_word(value);
    }

    [[noreturn]] void refuse(std::string_view column, std::string_view value) const;
    void number_list(std::string_view column, std::span<double> values);

    const sqlite::Statement* row_;
    int column_;
    std::string_view table_;
};

} // namespace planum::store
