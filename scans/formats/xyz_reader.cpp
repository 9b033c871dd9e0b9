// SPDX-License-Identifier: MIT
// XYZ, CSV and other tables: docs/formats/xyz.md says how the columns are guessed.
#include <algorithm>

#include <fmt/format.h>

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "scans/formats/block_builder.hpp"
#include "scans/formats/readers.hpp"
#include "scans/formats/text_table.hpp"

namespace planum::scans {

namespace {

class XyzReader final : public ScanReader {
  public:
    XyzReader(std::unique_ptr<ByteSource> source, const OpenOptions& options, Progress& progress)
        : source_(std::move(source)) {
        info_.format = ScanFormat::Xyz;
        CloudHeader header;
        const std::vector<std::string> names = find_table();
        choose_roles(names, options);
        count(header, progress);
        plan_table(*source_, table_, header);
        if (!names.empty()) header.attributes = names;
        clouds_.push_back(std::move(header));
    }

  protected:
    ReadSummary read_cloud(std::size_t cloud, const PointSink& sink, const ReadOptions& options,
                           Progress& progress) override {
        return read_table(*source_, table_, clouds_[cloud], sink, options, progress);
    }

  private:
    std::vector<std::string> find_table();
    void choose_roles(const std::vector<std::string>& names, const OpenOptions& options);
    void count(CloudHeader& header, Progress& progress);

    std::unique_ptr<ByteSource> source_;
    TextTable table_;
    std::size_t columns_ = 0;
};

bool is_numeric(std::string_view field) { return text::parse_double(field).has_value(); }

bool has_three_numbers(const std::vector<std::string_view>& fields) {
    return std::count_if(fields.begin(), fields.end(), is_numeric) >= 3;
}

// Goes to the first line of numbers; what stands in front of it may be names, a count, or comments.
std::vector<std::string> XyzReader::find_table() {
    constexpr std::uint64_t kMostLinesBefore = 100;
    LineReader lines(*source_, 0, 1, 65536);
    std::vector<std::string> names;
    std::uint64_t offset = 0;
    while (true) {
        offset = lines.offset();
        if (!lines.next())
            throw Error(ErrorCode::BadInput, fmt::format("line {}: no line with x, y and z as numbers",
                                                         std::max<std::uint64_t>(lines.number(), 1)));
        std::string_view line = text::trim(lines.line());
        if (lines.number() == 1 && line.starts_with("\xEF\xBB\xBF")) { // byte order mark
            line.remove_prefix(3);
            offset += 3;
        }
        if (line.empty()) continue;
        const char separator = guess_separator(line);
        const std::vector<std::string_view> fields = split_line(line, separator);
        if (has_three_numbers(fields) && is_data_line(line)) {
            table_.separator = separator;
            columns_ = fields.size();
            const bool comma_inside = std::any_of(
                fields.begin(), fields.end(), [](std::string_view f) { return f.find(',') != std::string_view::npos; });
            table_.decimal = separator != ',' && comma_inside ? ',' : '.';
            break;
        }
        if (lines.number() > kMostLinesBefore)
            lines.fail("no line with x, y and z as numbers so far, this is no table of points");
        if (fields.size() < 3) continue;
        names.clear();
        for (std::string_view field : fields) {
            while (field.starts_with('#') || field.starts_with('/')) field.remove_prefix(1);
            if (!text::trim(field).empty()) names.push_back(text::clean_utf8(text::trim(field)).text);
        }
    }
    table_.offset = offset;
    table_.first_line = lines.number();
    if (names.size() != columns_) names.clear();
    return names;
}

void XyzReader::choose_roles(const std::vector<std::string>& names, const OpenOptions& options) {
    std::string_view how = "by number and values";
    if (!options.columns.empty()) {
        how = "as told";
        for (const std::string_view word : text::split(options.columns, ',')) {
            const Role role = role_of_name(word);
            if (role == Role::Other && text::trim(word) != "-") {
                throw Error(
                    ErrorCode::Usage,
                    fmt::format("'{}' is no column; known are x y z intensity red green blue time and - for others",
                                word));
            }
            table_.roles.push_back(role);
        }
        if (table_.roles.size() > columns_) {
            throw Error(ErrorCode::BadInput, fmt::format("line {}: {} columns are named, the file has {}",
                                                         table_.first_line, table_.roles.size(), columns_));
        }
        table_.roles.resize(columns_, Role::Other);
    } else {
        for (const std::string& name : names) table_.roles.push_back(role_of_name(name));
        const PointPlan by_name = plan_of(table_.roles);
        if (by_name.has_place()) {
            how = "by the names in the file";
        } else {
            table_.roles = guess_roles(*source_, table_, columns_);
        }
    }
    const char* const cut = table_.separator == ' '    ? "blanks"
                            : table_.separator == '\t' ? "tabs"
                            : table_.separator == ';'  ? "semicolons"
                                                       : "commas";
    info_.column_guess = fmt::format("{} ({}; cut by {}{})", roles_as_text(table_.roles), how, cut,
                                     table_.decimal == ',' ? "; decimal comma" : "");
}

void XyzReader::count(CloudHeader& header, Progress& progress) {
    LineReader lines(*source_, table_.offset, table_.first_line);
    Meter meter(progress, source_->size());
    while (lines.next()) {
        if ((lines.number() & 0xFFFFU) == 0) meter.at(lines.offset());
        if (is_data_line(lines.line())) ++header.records;
    }
}

} // namespace

std::unique_ptr<ScanReader> make_xyz_reader(std::unique_ptr<ByteSource> source, const OpenOptions& options,
                                            Progress& progress) {
    return std::make_unique<XyzReader>(std::move(source), options, progress);
}

} // namespace planum::scans
