// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "app/records/record_kind.hpp"
#include "core/base/error.hpp"
#include "core/base/text.hpp"

namespace planum::app {

/// One field of T: how it reads as text and how it is set from text.
template<class T>
struct Field {
    FieldInfo info;
    std::function<std::string(const T&, Project&)> get;
    std::function<void(T&, const std::string&, Project&)> set;
};

[[nodiscard]] std::string text_of(const std::optional<double>& value);
[[nodiscard]] std::string text_of(const std::optional<std::int64_t>& value);
/// Throw BadInput naming the field. An empty text unsets.
[[nodiscard]] std::optional<double> number_from(const std::string& field, const std::string& text);
[[nodiscard]] std::optional<std::int64_t> integer_from(const std::string& field, const std::string& text);

template<class T>
Field<T> text_field(std::string name, std::string help, std::string T::*member) {
    return {{std::move(name), std::move(help)},
            [member](const T& value, Project&) { return value.*member; },
            [member](T& value, const std::string& text, Project&) { value.*member = text; }};
}

template<class T>
Field<T> date_field(std::string name, std::string help, std::string T::*member) {
    return {{name, std::move(help)},
            [member](const T& value, Project&) { return value.*member; },
            [member, name](T& value, const std::string& text, Project&) { value.*member = date_from(name, text); }};
}

template<class T>
Field<T> number_field(std::string name, std::string help, std::optional<double> T::*member) {
    return {{name, std::move(help)},
            [member](const T& value, Project&) { return text_of(value.*member); },
            [member, name](T& value, const std::string& text, Project&) { value.*member = number_from(name, text); }};
}

template<class T>
Field<T> integer_field(std::string name, std::string help, std::optional<std::int64_t> T::*member) {
    return {{name, std::move(help)},
            [member](const T& value, Project&) { return text_of(value.*member); },
            [member, name](T& value, const std::string& text, Project&) { value.*member = integer_from(name, text); }};
}

/// `top, base` → the two words.
[[nodiscard]] std::vector<std::string> words_of(std::string_view list);

/// A field of an enumeration; `from` reads its words, `allowed` lists them for the error.
template<class T, class Enum, class From>
Field<T> word_field(std::string name, const std::string& help, Enum T::*member, From from, const std::string& allowed) {
    return {{name, help + " (" + allowed + ")", words_of(allowed)},
            [member](const T& value, Project&) { return std::string(to_word(value.*member)); },
            [member, name, from, allowed](T& value, const std::string& text, Project&) {
                const auto read = from(text);
                if (!read) {
                    throw Error(ErrorCode::BadInput, fmt::format("{}: {} is none of {}", name, text, allowed));
                }
                value.*member = *read;
            }};
}

/// A field that names a unit.
template<class T>
Field<T> unit_field(std::string name, std::string help, model::UnitId T::*member) {
    return {{std::move(name), std::move(help)},
            [member](const T& value, Project& project) {
                return (value.*member).is_nil() ? std::string{} : project.index().name(value.*member);
            },
            [member](T& value, const std::string& text, Project& project) {
                value.*member = text.empty() ? model::UnitId{} : project.record().units[project.unit_named(text)].id;
            }};
}

/// A field that names one of the things of a vector of the record, by `name`.
template<class T, class Other>
Field<T> named_field(std::string name, std::string help, decltype(Other::id) T::*member,
                     std::vector<Other> model::Record::*all, std::string Other::*name_of) {
    return {{name, std::move(help)},
            [=](const T& value, Project& project) {
                for (const Other& other : project.record().*all) {
                    if (other.id == value.*member) return other.*name_of;
                }
                return std::string{};
            },
            [=](T& value, const std::string& text, Project& project) {
                value.*member = {};
                if (text.empty()) return;
                for (const Other& other : project.record().*all) {
                    if (other.*name_of == text) value.*member = other.id;
                }
                if ((value.*member).is_nil()) {
                    throw Error(ErrorCode::NotFound, fmt::format("{}: there is no {}; add it first", name, text));
                }
            }};
}

/// A kind made of a table of fields. Derived classes say how things are named and found.
template<class T>
class FieldTableKind : public RecordKind {
  public:
    FieldTableKind(std::string_view word, std::string_view name_form, std::vector<T> model::Record::*all,
                   std::vector<Field<T>> fields)
        : word_(word), name_form_(name_form), all_(all), table_(std::move(fields)) {
        for (const Field<T>& field : table_) infos_.push_back(field.info);
    }

    [[nodiscard]] std::string_view word() const noexcept override { return word_; }

    [[nodiscard]] std::string_view name_form() const noexcept override { return name_form_; }

    [[nodiscard]] std::span<const FieldInfo> fields() const noexcept override { return infos_; }

    [[nodiscard]] std::vector<std::string> names(Project& project) const override {
        std::vector<std::string> all;
        for (const T& value : project.record().*all_) all.push_back(name_of(value, project));
        return all;
    }

    [[nodiscard]] FieldValues show(Project& project, const std::string& name) const override {
        const T& value = find(project, name);
        FieldValues values = {{"name", name_of(value, project)}};
        for (const Field<T>& field : table_) {
            std::string text = field.get(value, project);
            if (!text.empty()) values.emplace_back(field.info.name, std::move(text));
        }
        return values;
    }

    std::string add(Project& project, const std::string& name, const FieldValues& values) const override {
        T value = make(project, name);
        assign(project, value, values);
        check_new(project, value);
        std::string shown;
        project.change(fmt::format("Add {} {}", word_, name), [&] { value.id = project.file().insert(value); });
        for (const T& now : project.record().*all_) {
            if (now.id == value.id) shown = name_of(now, project);
        }
        return shown;
    }

    void set(Project& project, const std::string& name, const FieldValues& values) const override {
        T value = find(project, name);
        assign(project, value, values);
        project.change(fmt::format("Change {} {}", word_, name), [&] { write(project, value); });
    }

    void remove(Project& project, const std::string& name) const override {
        const auto id = find(project, name).id;
        project.change(fmt::format("Delete {} {}", word_, name), [&] { project.file().remove(id); });
    }

  protected:
    [[nodiscard]] virtual std::string name_of(const T& value, Project& project) const = 0;
    /// A new value with that name; throws BadInput when the name cannot be one.
    [[nodiscard]] virtual T make(Project& project, const std::string& name) const = 0;

    virtual void check_new(Project& /*project*/, const T& /*value*/) const {}

    virtual void write(Project& project, const T& value) const { project.file().update(value); }

    [[nodiscard]] virtual const T& find(Project& project, const std::string& name) const {
        const std::string wanted{text::trim(name)};
        for (const T& value : project.record().*all_) {
            if (name_of(value, project) == wanted) return value;
        }
        throw Error(ErrorCode::NotFound, fmt::format("no {} {}", word_, name));
    }

  private:
    void assign(Project& project, T& value, const FieldValues& values) const {
        for (const auto& [name, text] : values) {
            const auto is_it = [&](const FieldInfo& info) { return info.name == name; };
            if (std::none_of(infos_.begin(), infos_.end(), is_it)) {
                throw Error(ErrorCode::Usage,
                            fmt::format("{} has no field {}; see planum {} --help", word_, name, word_));
            }
        }
        // In the order of the table: a later field may build on an earlier one.
        for (const Field<T>& field : table_) {
            for (const auto& [name, text] : values) {
                if (field.info.name == name) field.set(value, text, project);
            }
        }
    }

    std::string word_;
    std::string name_form_;
    std::vector<T> model::Record::*all_;
    std::vector<Field<T>> table_;
    std::vector<FieldInfo> infos_;
};

/// A kind whose things carry their name in one member (`number` or `name`).
template<class T>
class NamedKind : public FieldTableKind<T> {
  public:
    NamedKind(std::string_view word, std::vector<T> model::Record::*all, std::string T::*name_member,
              std::vector<Field<T>> fields)
        : FieldTableKind<T>(word, "NAME", all, std::move(fields)), name_member_(name_member), all_(all) {}

  protected:
    [[nodiscard]] std::string name_of(const T& value, Project&) const override { return value.*name_member_; }

    [[nodiscard]] T make(Project&, const std::string& name) const override {
        T value;
        value.*name_member_ = std::string(text::trim(name));
        if ((value.*name_member_).empty()) {
            throw Error(ErrorCode::BadInput, fmt::format("a {} needs a name", this->word()));
        }
        return value;
    }

    void check_new(Project& project, const T& value) const override {
        for (const T& other : project.record().*all_) {
            if (other.*name_member_ == value.*name_member_) {
                throw Error(ErrorCode::Conflict, fmt::format("{} {} exists already; change it with `planum {} set`",
                                                             this->word(), value.*name_member_, this->word()));
            }
        }
    }

  private:
    std::string T::*name_member_;
    std::vector<T> model::Record::*all_;
};

/// The kinds of each file of this folder.
[[nodiscard]] std::unique_ptr<RecordKind> make_unit_kind();
[[nodiscard]] std::unique_ptr<RecordKind> make_relation_kind();
[[nodiscard]] std::unique_ptr<RecordKind> make_region_kind();
void add_chronology_kinds(std::vector<std::unique_ptr<RecordKind>>& kinds);
void add_measured_kinds(std::vector<std::unique_ptr<RecordKind>>& kinds);
void add_place_kinds(std::vector<std::unique_ptr<RecordKind>>& kinds);
void add_interpretation_kind(std::vector<std::unique_ptr<RecordKind>>& kinds);

} // namespace planum::app
