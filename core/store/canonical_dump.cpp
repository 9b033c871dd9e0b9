// SPDX-License-Identifier: MIT
#include <algorithm>
#include <unordered_map>

#include <fmt/format.h>

#include "core/base/text.hpp"
#include "core/store/record_columns.hpp"
#include "core/store/record_loader.hpp"
#include "core/store/state.hpp"

namespace planum::store {

namespace {

using Names = std::unordered_map<Uuid, std::string>;

std::string escaped(std::string_view value) {
    return text::replace_all(text::replace_all(text::replace_all(value, "\\", "\\\\"), "\n", "\\n"), "\t", "\\t");
}

bool is_time(std::string_view column) noexcept {
    return column == "made_at" || column == "imported_at" || column == "stated_at";
}

/// Writes `column=value` for every member that holds something; references by the names of their records.
class LineWriter {
  public:
    LineWriter(std::string_view table, const Names& names) : names_(&names), line_(table) {}

    void text(std::string_view column, const std::string& value) {
        if (!value.empty() && !is_time(column)) put(column, escaped(value));
    }

    void integer(std::string_view column, std::int64_t value) { put(column, fmt::format("{}", value)); }

    void integer(std::string_view column, const std::optional<std::int64_t>& value) {
        if (value) integer(column, *value);
    }

    void real(std::string_view column, double value) { put(column, fmt::format("{}", value)); }

    void real(std::string_view column, const std::optional<double>& value) {
        if (value) real(column, *value);
    }

    void boolean(std::string_view column, bool value) { put(column, value ? "yes" : "no"); }

    template<class Enum>
    void word(std::string_view column, Enum value) {
        put(column, to_word(value));
    }

    template<class Tag>
    void reference(std::string_view column, const Id<Tag>& id) {
        if (id.is_nil()) return;
        const auto it = names_->find(id.value);
        put(column, it == names_->end() ? std::string_view{"?"} : std::string_view{it->second});
    }

    template<class Z>
    void position(const std::optional<double>& x, const std::optional<double>& y, const Z& z) {
        real("x", x);
        real("y", y);
        real("z", z);
    }

    void line(const std::array<double, 2>& from, const std::array<double, 2>& to) {
        put("line", fmt::format("{} {} {} {}", from[0], from[1], to[0], to[1]));
    }

    void station(const std::array<double, 16>&) {} // follows from the matrix

    void outline(const std::vector<model::Polygon>& outline, bool has_heights) {
        std::string rings;
        const auto add = [&](std::string_view kind, const model::Ring& ring) {
            rings += kind;
            for (const auto& p : ring)
                rings += has_heights ? fmt::format(" {} {} {}", p[0], p[1], p[2]) : fmt::format(" {} {}", p[0], p[1]);
        };
        for (const model::Polygon& polygon : outline) {
            add(" outer", polygon.outer);
            for (const model::Ring& hole : polygon.holes) add(" hole", hole);
        }
        put("outline", rings);
    }

    void details(const model::UnitDetails& details) {
        for (const auto& [name, value] : details) text(name, value);
    }

    template<std::size_t N>
    void numbers(std::string_view column, const std::array<double, N>& values) {
        put(column, fmt::format("{}", fmt::join(values, " ")));
    }

    template<std::size_t N>
    void numbers(std::string_view column, const std::optional<std::array<double, N>>& values) {
        if (values) numbers(column, *values);
    }

    void put(std::string_view column, std::string_view value) {
        line_ += '\t';
        line_ += column;
        line_ += '=';
        line_ += value;
    }

    [[nodiscard]] std::string take() { return std::move(line_); }

  private:
    const Names* names_;
    std::string line_;
};

template<class T>
std::string line_of(const T& value, const Names& names) {
    LineWriter writer(TableOf<T>::name, names);
    describe_columns(writer, value);
    return writer.take();
}

template<class T>
void add_lines(const std::vector<T>& values, const Names& names, std::vector<std::string>& lines) {
    for (const T& value : values) lines.push_back(line_of(value, names));
}

/// Names the records that others refer to, each by what it holds itself; referred-to tables come first.
Names names_of(const model::Record& record) {
    Names names;
    for (const auto& a : record.areas) names.emplace(a.id.value, a.name);
    for (const auto& s : record.sources) names.emplace(s.id.value, s.name);
    for (const auto& p : record.periods) names.emplace(p.id.value, p.number);
    const auto name = [&](const Uuid& id) {
        const auto it = names.find(id);
        return it == names.end() ? std::string{} : it->second;
    };
    for (const auto& p : record.phases) names.emplace(p.id.value, name(p.period.value) + "/" + p.number);
    for (const auto& u : record.units) names.emplace(u.id.value, name(u.area.value) + "::" + u.number);
    const auto relation = [&](const model::PhysicalRelation& r) {
        return fmt::format("{} {} {}", name(r.subject.value), to_word(r.kind), name(r.object.value));
    };
    for (const auto& r : record.relations) names.emplace(r.id.value, relation(r));
    for (const auto& i : record.interpretations) {
        names.emplace(i.id.value, i.name);
        for (const auto& r : i.added) names.emplace(r.id.value, relation(r));
    }
    for (const auto& g : record.groups) names.emplace(g.id.value, g.type + "/" + g.number);
    for (const auto& f : record.finds) names.emplace(f.id.value, name(f.unit.value) + "/" + f.number);
    for (const auto& s : record.surfaces) {
        names.emplace(s.id.value, fmt::format("{}/{}/{}/{}", name(s.area.value), s.first_day, s.name, s.order));
    }
    for (const auto& s : record.sections) names.emplace(s.id.value, name(s.area.value) + "/" + s.name);
    for (const auto& s : record.scans) names.emplace(s.id.value, s.name);
    for (const auto& r : record.runs) names.emplace(r.id.value, r.name + "/" + r.method + "/" + r.state);
    return names;
}

void add_members(const model::Record& record, const Names& names, std::vector<std::string>& lines) {
    for (const model::UnitGroup& group : record.groups) {
        for (const model::UnitId& unit : group.members) {
            LineWriter writer("group_member", names);
            writer.reference("unit_group", group.id);
            writer.reference("unit", unit);
            lines.push_back(writer.take());
        }
    }
    for (const model::Interpretation& reading : record.interpretations) {
        for (const model::PhysicalRelation& relation : reading.added) {
            LineWriter writer("interpretation_added", names);
            writer.reference("interpretation", reading.id);
            describe_columns(writer, relation);
            lines.push_back(writer.take());
        }
        for (const model::RelationId& relation : reading.dropped) {
            LineWriter writer("interpretation_dropped", names);
            writer.reference("interpretation", reading.id);
            writer.reference("relation", relation);
            lines.push_back(writer.take());
        }
    }
}

} // namespace

std::string ProjectFile::canonical_dump() const {
    const model::Record record = load();
    const Names names = names_of(record);
    std::vector<std::string> lines{line_of(record.settings, names)};
    add_lines(record.areas, names, lines);
    add_lines(record.units, names, lines);
    add_lines(record.relations, names, lines);
    add_lines(record.statements, names, lines);
    add_lines(record.sources, names, lines);
    add_lines(record.import_notes, names, lines);
    add_lines(record.periods, names, lines);
    add_lines(record.phases, names, lines);
    add_lines(record.groups, names, lines);
    add_lines(record.datings, names, lines);
    add_lines(record.levels, names, lines);
    add_lines(record.finds, names, lines);
    add_lines(record.samples, names, lines);
    add_lines(record.documents, names, lines);
    add_lines(record.surfaces, names, lines);
    add_lines(record.sections, names, lines);
    add_lines(record.regions, names, lines);
    add_lines(record.scans, names, lines);
    add_lines(record.poses, names, lines);
    add_lines(record.runs, names, lines);
    add_lines(record.decisions, names, lines);
    add_lines(record.interpretations, names, lines);
    add_members(record, names, lines);
    std::sort(lines.begin(), lines.end());
    std::string dump;
    for (const std::string& line : lines) dump += line + "\n";
    return dump;
}

} // namespace planum::store
