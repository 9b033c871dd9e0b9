// SPDX-License-Identifier: MIT
// PTS: docs/formats/pts.md says what is read and what is made of it.
#include <fmt/format.h>

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "scans/formats/block_builder.hpp"
#include "scans/formats/readers.hpp"
#include "scans/formats/text_table.hpp"

namespace planum::scans {

namespace {

constexpr std::size_t kMostClouds = 10000;
constexpr std::uint64_t kShortestPoint = 6; // "0 0 0\n"

class PtsReader final : public ScanReader {
  public:
    PtsReader(std::unique_ptr<ByteSource> source, Progress& progress) : source_(std::move(source)) {
        info_.format = ScanFormat::Pts;
        LineReader lines(*source_);
        Meter meter(progress, source_->size());
        std::uint64_t offset = 0;
        while (true) {
            offset = lines.offset();
            if (!lines.next()) break;
            if (!is_data_line(lines.line())) continue;
            if (tables_.size() == kMostClouds) lines.fail(fmt::format("more than {} clouds", kMostClouds));
            add_cloud(lines, offset, meter);
        }
        if (tables_.empty())
            throw Error(ErrorCode::BadInput, "line 1: empty, a PTS file starts with its number of points");
        info_.column_guess = roles_as_text(tables_.front().roles) + " (by their number)";
    }

  protected:
    ReadSummary read_cloud(std::size_t cloud, const PointSink& sink, const ReadOptions& options,
                           Progress& progress) override {
        return read_table(*source_, tables_[cloud], clouds_[cloud], sink, options, progress);
    }

  private:
    void add_cloud(LineReader& lines, std::uint64_t offset, Meter& meter);
    void add_surplus(const LineReader& lines);
    static std::vector<Role> roles_of(const LineReader& lines, std::size_t columns);

    std::unique_ptr<ByteSource> source_;
    std::vector<TextTable> tables_;
    std::uint64_t surplus_ = 0; ///< points of the last cloud beyond its stated number
};

std::vector<Role> PtsReader::roles_of(const LineReader& lines, std::size_t columns) {
    switch (columns) {
    case 3: return {Role::X, Role::Y, Role::Z};
    case 4: return {Role::X, Role::Y, Role::Z, Role::Intensity};
    case 6: return {Role::X, Role::Y, Role::Z, Role::Red, Role::Green, Role::Blue};
    case 7: return {Role::X, Role::Y, Role::Z, Role::Intensity, Role::Red, Role::Green, Role::Blue};
    default: lines.fail(fmt::format("{} columns; PTS has 3, 4, 6 or 7: x y z, intensity, red green blue", columns));
    }
}

// Some programs state fewer points than they write; a point more is not thrown away.
void PtsReader::add_surplus(const LineReader& lines) {
    CloudHeader& header = clouds_.back();
    if (split_line(lines.line(), ' ').size() != tables_.back().roles.size()) {
        lines.fail("after the last point the next cloud's number of points is expected");
    }
    if (surplus_ == 0) header.notes.emplace_back(fmt::format("states {} points but has more", header.records));
    ++surplus_;
    ++header.records;
}

// The current line is a count, or already the first point of a file without one.
void PtsReader::add_cloud(LineReader& lines, std::uint64_t offset, Meter& meter) {
    TextTable table;
    CloudHeader header;
    const std::optional<long long> count = text::parse_integer(lines.line());
    if (count && *count < 0) lines.fail("the number of points is negative");
    if (!count && !tables_.empty()) {
        add_surplus(lines);
        return;
    }
    table.offset = count ? lines.offset() : offset;
    table.first_line = lines.number() + (count ? 1 : 0);
    if (count) {
        header.records = static_cast<std::uint64_t>(*count);
        const std::uint64_t room = source_->size() - table.offset;
        if (header.records > room / kShortestPoint + 1) {
            lines.fail(fmt::format("{} points do not fit into the {} bytes that follow", header.records, room));
        }
    }
    LineReader first(*source_, table.offset, table.first_line, 4096);
    if (count && header.records == 0) {
        table.roles = {Role::X, Role::Y, Role::Z};
    } else {
        if (!first.next()) first.fail("the file ends before the first point");
        table.roles = roles_of(first, split_line(first.line(), ' ').size());
    }
    std::uint64_t done = count ? 0 : 1;
    while (!count || done < header.records) {
        const std::uint64_t step = count ? std::min<std::uint64_t>(header.records - done, 65536) : 65536;
        const std::uint64_t skipped = lines.skip(step);
        done += skipped;
        meter.at(lines.offset());
        if (skipped == step) continue;
        if (!count) break;
        lines.fail(fmt::format("the file ends after {} of {} points", done, header.records));
    }
    if (!count) {
        header.records = done;
        header.notes.emplace_back("the file does not state its number of points");
    }
    surplus_ = 0;
    plan_table(*source_, table, header);
    tables_.push_back(std::move(table));
    clouds_.push_back(std::move(header));
}

} // namespace

std::unique_ptr<ScanReader> make_pts_reader(std::unique_ptr<ByteSource> source, Progress& progress) {
    return std::make_unique<PtsReader>(std::move(source), progress);
}

} // namespace planum::scans
