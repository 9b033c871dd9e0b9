// SPDX-License-Identifier: MIT
// One workbook for the authorities: a sheet a kind, a row a thing. Text is written as text, so no formula can hide in
// it.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <unistd.h>
#include <xlsxwriter.h>

#include "core/base/error.hpp"
#include "core/base/file.hpp"
#include "core/base/text.hpp"
#include "strat/exchange/write_support.hpp"
#include "strat/exchange/writers.hpp"
#include "strat/exchange/xlsx_tables.hpp"

namespace planum::strat {

namespace {

constexpr std::uintmax_t kMostBytes = 1U << 31U;
constexpr std::size_t kMostLetters = 32767;   // of a cell
constexpr std::size_t kMostRows = 1048575;    // of a sheet, less its heading
constexpr std::time_t kFixedTime = 315619200; // the same record gives the same bytes

/// Longest beginning of at most `most` letters and never half of one.
std::string shortened(const std::string& utf8, std::size_t most) {
    std::size_t letters = 0;
    for (std::size_t i = 0; i < utf8.size(); ++i) {
        const auto byte = static_cast<unsigned char>(utf8[i]);
        if ((byte & 0xC0U) == 0x80U) continue;
        letters += byte >= 0xF0 ? 2 : 1; // a spreadsheet counts UTF-16
        if (letters > most) return utf8.substr(0, i);
    }
    return utf8;
}

class Workbook {
  public:
    explicit Workbook(const std::filesystem::path& file) {
        lxw_workbook_options options{};
        options.constant_memory = LXW_TRUE;
        book_ = workbook_new_opt(file.c_str(), &options);
        if (book_ == nullptr) throw Error(ErrorCode::Io, "the spreadsheet cannot be made in " + file.string());
        lxw_doc_properties properties{};
        properties.created = kFixedTime;
        workbook_set_properties(book_, &properties);
        heading_ = workbook_add_format(book_);
        format_set_bold(heading_);
        format_set_bg_color(heading_, 0xE8E4DC);
        format_set_bottom(heading_, LXW_BORDER_THIN);
    }

    Workbook(const Workbook&) = delete;
    Workbook& operator=(const Workbook&) = delete;

    ~Workbook() {
        if (book_ != nullptr) (void)workbook_close(book_);
    }

    void add(const XlsxSheet& sheet) {
        lxw_worksheet* page = workbook_add_worksheet(book_, sheet.name);
        const auto columns = static_cast<lxw_col_t>(sheet.columns.size());
        for (lxw_col_t c = 0; c < columns; ++c) worksheet_set_column(page, c, c, width(sheet, c), nullptr);
        for (lxw_col_t c = 0; c < columns; ++c) {
            (void)worksheet_write_string(page, 0, c, sheet.columns[c].c_str(), heading_);
        }
        const std::size_t rows = std::min(sheet.rows.size(), kMostRows);
        left_out_ += sheet.rows.size() - rows;
        for (std::size_t r = 0; r < rows; ++r) write_row(page, static_cast<lxw_row_t>(r + 1), sheet.rows[r]);
        worksheet_freeze_panes(page, 1, 1);
        worksheet_autofilter(page, 0, 0, static_cast<lxw_row_t>(rows), static_cast<lxw_col_t>(columns - 1));
        worksheet_set_landscape(page);
        worksheet_set_paper(page, 9); // A4
        worksheet_fit_to_pages(page, 1, 0);
        worksheet_repeat_rows(page, 0, 0);
    }

    void close() {
        const lxw_error result = workbook_close(std::exchange(book_, nullptr));
        if (result != LXW_NO_ERROR) {
            throw Error(ErrorCode::Io, fmt::format("the spreadsheet cannot be written: {}", lxw_strerror(result)));
        }
    }

    std::size_t cut_ = 0;      ///< cells that were too long
    std::size_t left_out_ = 0; ///< rows beyond what a sheet holds

  private:
    static double width(const XlsxSheet& sheet, std::size_t column) {
        std::size_t longest = sheet.columns[column].size();
        for (std::size_t r = 0; r < sheet.rows.size() && r < 1000; ++r) {
            const auto* text = std::get_if<std::string>(&sheet.rows[r][column]);
            if (text != nullptr) longest = std::max(longest, text->size());
        }
        return static_cast<double>(std::clamp<std::size_t>(longest + 2, 8, 60));
    }

    void write_row(lxw_worksheet* page, lxw_row_t r, const std::vector<XlsxCell>& row) {
        for (std::size_t c = 0; c < row.size(); ++c) {
            const auto column = static_cast<lxw_col_t>(c);
            if (const auto* number = std::get_if<double>(&row[c])) {
                (void)worksheet_write_number(page, r, column, *number, nullptr);
            } else if (const auto* words = std::get_if<std::string>(&row[c])) {
                const std::string clean = text::clean_utf8(*words).text;
                const std::string fitting = shortened(clean, kMostLetters);
                if (fitting.size() < clean.size()) ++cut_;
                (void)worksheet_write_string(page, r, column, fitting.c_str(), nullptr);
            }
        }
    }

    lxw_workbook* book_ = nullptr;
    lxw_format* heading_ = nullptr;
};

/// A folder of its own below the system's temporary one; libxlsxwriter 1.1 writes to files only.
class ScratchFolder {
  public:
    ScratchFolder() {
        std::string pattern = (std::filesystem::temp_directory_path() / "planum-XXXXXX").string();
        if (::mkdtemp(pattern.data()) == nullptr) {
            throw Error(ErrorCode::Io,
                        "no temporary folder can be made in " + std::filesystem::temp_directory_path().string());
        }
        path_ = pattern;
    }

    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    ~ScratchFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }

    [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }

  private:
    std::filesystem::path path_;
};

} // namespace

Written write_xlsx(const model::Record& record, const WriteOptions& /*options*/) {
    const RecordNames names(record);
    const ScratchFolder scratch;
    const std::filesystem::path file = scratch.path() / "record.xlsx";
    Workbook book(file);
    for (const XlsxSheet& sheet : xlsx_tables(names)) book.add(sheet);
    book.close();
    Written written;
    written.files.push_back({"", read_file(file, kMostBytes)});
    add_loss(written.lost, book.cut_, "texts longer than a cell holds, cut at 32767 letters");
    add_loss(written.lost, book.left_out_, "rows beyond the 1048576 that a sheet holds");
    add_loss(written.lost, record.regions.size(), "outlines of regions (GeoJSON and DXF carry them)");
    return written;
}

} // namespace planum::strat
