// SPDX-License-Identifier: MIT
#include "scans/formats/text_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "scans/formats/block_builder.hpp"
#include "scans/formats/parse_number.hpp"

namespace planum::scans {

namespace {

constexpr std::uint64_t kSampled = 4096;
constexpr std::uint64_t kSampleWindow = 262144; ///< [bytes]
constexpr std::size_t kMostColumns = 1000;

/// What the values of one column look like.
struct ColumnLook {
    double minimum = 0.0;
    double maximum = 0.0;
    bool whole = true;

    [[nodiscard]] bool is_colour() const noexcept { return whole && minimum >= 0.0 && maximum <= 65535.0; }
};

bool next_data_line(LineReader& lines) {
    while (lines.next()) {
        if (is_data_line(lines.line())) return true;
    }
    return false;
}

std::string_view unquote(std::string_view field) noexcept {
    field = text::trim(field);
    if (field.size() >= 2 && field.front() == '"' && field.back() == '"') field = field.substr(1, field.size() - 2);
    return text::trim(field);
}

bool looks_like_colour(const std::vector<ColumnLook>& looks, std::size_t first) {
    return looks[first].is_colour() && looks[first + 1].is_colour() && looks[first + 2].is_colour();
}

} // namespace

bool is_data_line(std::string_view line) noexcept {
    line = text::trim(line);
    return !line.empty() && line.front() != '#' && !line.starts_with("//");
}

char guess_separator(std::string_view line) noexcept {
    for (const char candidate : {';', '\t'}) {
        if (text::trim(line).find(candidate) != std::string_view::npos) return candidate;
    }
    if (line.find(',') == std::string_view::npos) return ' ';
    // "1,5 2,5 3,5" is cut by blanks, "1.5, 2.5, 3.5" and "1,2,3" by commas.
    const bool blanks_too = text::trim(line).find(' ') != std::string_view::npos;
    const bool comma_then_blank = line.find(", ") != std::string_view::npos;
    const bool has_point = line.find('.') != std::string_view::npos;
    return blanks_too && !comma_then_blank && !has_point && line.find('"') == std::string_view::npos ? ' ' : ',';
}

std::vector<std::string_view> split_line(std::string_view line, char separator) {
    std::vector<std::string_view> fields;
    line = text::trim(line);
    if (separator != ' ') {
        for (const std::string_view field : text::split(line, separator)) fields.push_back(unquote(field));
        if (fields.size() > 1 && fields.back().empty()) fields.pop_back(); // a separator at the end
        return fields;
    }
    std::size_t at = 0;
    while (at < line.size()) {
        std::size_t end = at;
        while (end < line.size() && !is_blank(line[end])) ++end;
        if (end > at) fields.push_back(unquote(line.substr(at, end - at)));
        at = end + 1;
    }
    return fields;
}

void read_row(const LineReader& lines, const TextTable& table, std::vector<double>& values) {
    const char* p = lines.begin();
    const char* const end = lines.end();
    const bool by_blanks = table.separator == ' ';
    for (std::size_t i = 0; i < table.roles.size(); ++i) {
        while (p < end && is_blank(*p) && *p != table.separator) ++p;
        if (by_blanks) {
            while (p < end && is_blank(*p)) ++p;
        }
        if (p >= end) lines.fail(fmt::format("{} columns expected, this line has {}", table.roles.size(), i));
        if (table.roles[i] == Role::Other) {
            while (p < end && !(by_blanks ? is_blank(*p) : *p == table.separator)) ++p;
        } else {
            p = parse_number(p, end, values[i], table.decimal);
            if (p == nullptr) lines.fail(fmt::format("column {} ({}) is no number", i + 1, role_name(table.roles[i])));
            while (p < end && is_blank(*p) && *p != table.separator) ++p;
        }
        if (p >= end) continue;
        if (by_blanks ? is_blank(*p) || is_blank(p[-1]) : *p == table.separator) {
            if (!by_blanks) ++p;
            continue;
        }
        lines.fail(fmt::format("column {} ({}) is no number", i + 1, role_name(table.roles[i])));
    }
    while (p < end && is_blank(*p)) ++p;
    if (p < end) lines.fail(fmt::format("more than the {} columns of the first line", table.roles.size()));
}

std::vector<Role> guess_roles(const ByteSource& source, const TextTable& table, std::size_t columns) {
    LineReader lines(source, table.offset, table.first_line, kSampleWindow);
    std::vector<std::size_t> numeric; // columns that hold a number on the first line: names of points are passed over
    std::vector<ColumnLook> looks;    // one for each of them
    bool first = true;
    for (std::uint64_t i = 0; i < kSampled && next_data_line(lines); ++i) {
        const std::vector<std::string_view> fields = split_line(lines.line(), table.separator);
        if (first) {
            for (std::size_t k = 0; k < std::min(columns, fields.size()); ++k) {
                if (text::parse_double(fields[k])) numeric.push_back(k);
            }
            looks.resize(numeric.size());
        }
        for (std::size_t k = 0; k < numeric.size() && numeric[k] < fields.size(); ++k) {
            const std::optional<double> value = text::parse_double(fields[numeric[k]]);
            ColumnLook& look = looks[k];
            look.whole = look.whole && value && *value == std::floor(*value);
            if (!value) continue;
            look.minimum = first ? *value : std::min(look.minimum, *value);
            look.maximum = first ? *value : std::max(look.maximum, *value);
        }
        first = false;
    }
    std::vector<Role> roles(columns, Role::Other);
    const auto set = [&](std::size_t at, std::initializer_list<Role> some) {
        for (const Role role : some) roles[numeric[at++]] = role;
    };
    if (numeric.size() >= 3) set(0, {Role::X, Role::Y, Role::Z});
    if (numeric.size() >= 7 && looks_like_colour(looks, 4)) {
        set(3, {Role::Intensity, Role::Red, Role::Green, Role::Blue});
    } else if (numeric.size() >= 6 && looks_like_colour(looks, 3)) {
        set(3, {Role::Red, Role::Green, Role::Blue});
        if (numeric.size() == 7) set(6, {Role::Intensity});
    } else if (numeric.size() == 4 || numeric.size() == 5) {
        set(3, {Role::Intensity});
    }
    return roles;
}

void plan_table(const ByteSource& source, TextTable& table, CloudHeader& header) {
    if (table.roles.size() > kMostColumns) {
        throw Error(ErrorCode::BadInput, fmt::format("line {}: more than {} columns", table.first_line, kMostColumns));
    }
    table.plan = plan_of(table.roles);
    if (!table.plan.has_place()) {
        throw Error(ErrorCode::BadInput, fmt::format("line {}: no columns x, y and z among: {}", table.first_line,
                                                     roles_as_text(table.roles)));
    }
    table.plan.at[static_cast<std::size_t>(Role::Row)] = -1; // a grid needs its extent, which no such file states
    ValueSampler intensities;
    ValueSampler colours;
    std::vector<double> values(table.roles.size());
    LineReader lines(source, table.offset, table.first_line, kSampleWindow);
    const std::uint64_t count = std::min(header.records, kSampled);
    for (std::uint64_t i = 0; i < count && next_data_line(lines); ++i) {
        read_row(lines, table, values);
        table.plan.sample(values, intensities, colours);
    }
    table.plan.intensity = intensities.intensity_coding();
    table.plan.colour_scale = colours.colour_scale();
    header.has = table.plan.columns();
    header.intensity = table.plan.intensity;
    for (const Role role : table.roles) header.attributes.emplace_back(role_name(role));
}

ReadSummary read_table(const ByteSource& source, const TextTable& table, const CloudHeader& header,
                       const PointSink& sink, const ReadOptions& options, Progress& progress) {
    BlockBuilder builder(header, sink, options);
    Meter meter(progress, header.records);
    LineReader lines(source, table.offset, table.first_line);
    std::vector<double> values(table.roles.size());
    for (std::uint64_t i = 0; i < header.records; ++i) {
        if ((i & 0xFFFFU) == 0) meter.at(i);
        if (!next_data_line(lines)) lines.fail(fmt::format("the file ends after {} of {} points", i, header.records));
        read_row(lines, table, values);
        table.plan.place(values, builder);
        if (table.turned) {
            const std::size_t at = builder.slot();
            const Eigen::Vector3d p =
                table.scan_from_file * Eigen::Vector3d(builder.block.x[at], builder.block.y[at], builder.block.z[at]);
            builder.set_place(p.x(), p.y(), p.z());
        }
        builder.commit();
    }
    return builder.finish();
}

std::string roles_as_text(const std::vector<Role>& roles) {
    std::string out;
    for (const Role role : roles) {
        if (!out.empty()) out += ' ';
        out += role_name(role);
    }
    return out;
}

} // namespace planum::scans
