// SPDX-License-Identifier: MIT
#include "strat/exchange/delimited_table.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "core/base/text.hpp"

namespace planum::strat {

namespace {

// Records are far smaller; beyond these a file is no table, and memory would go before sense came.
constexpr std::size_t kMaxCellsInRow = 2000;
constexpr std::size_t kMaxCells = 8'000'000;
constexpr std::size_t kMaxQuotedCell = 1U << 20U; // bytes
constexpr std::array kDelimiters = {',', ';', '\t', '|'};

std::string_view trim_blanks(std::string_view s) {
    const auto blank = [](char c) { return c == ' ' || c == '\t'; };
    while (!s.empty() && blank(s.front())) s.remove_prefix(1);
    while (!s.empty() && blank(s.back())) s.remove_suffix(1);
    return s;
}

/// Reads cells one after the other; keeps the line it is on.
class TableParser {
  public:
    TableParser(std::string_view text, char delimiter, std::string_view file_name)
        : text_(text), delimiter_(delimiter), file_(file_name) {}

    void parse(DelimitedTable& table) {
        std::size_t cells = 0;
        while (at_ < text_.size()) {
            TableRow row = next_row(table);
            if (row.cells.size() == 1 && row.cells.front().empty()) continue; // an empty line
            cells += row.cells.size();
            table.rows.push_back(std::move(row));
            if (cells > kMaxCells && at_ < text_.size()) {
                note(table, line_, "too-large",
                     fmt::format("the table has more than {} cells; what follows was not read", kMaxCells));
                return;
            }
        }
    }

  private:
    TableRow next_row(DelimitedTable& table) {
        TableRow row{line_, {}};
        bool said = false;
        while (true) {
            const bool quoted = quote_opens();
            std::string value;
            if (!quoted || !read_quoted(value, table)) value = read_plain();
            if (row.cells.size() < kMaxCellsInRow) {
                row.cells.push_back(std::move(value));
            } else if (!said) {
                said = true;
                note(table, row.line, "too-long",
                     fmt::format("the row has more than {} cells; the rest of it was not read", kMaxCellsInRow));
            }
            if (at_ >= text_.size()) return row;
            const char end = text_[at_++];
            if (end != delimiter_) { // a line feed
                ++line_;
                return row;
            }
            if (at_ >= text_.size()) { // the file ends behind a delimiter: one more, empty cell
                if (row.cells.size() < kMaxCellsInRow) row.cells.emplace_back();
                return row;
            }
        }
    }

    bool at_end_of_cell(std::size_t at) const {
        return at >= text_.size() || text_[at] == delimiter_ || text_[at] == '\n';
    }

    bool quote_opens() {
        std::size_t at = at_;
        while (at < text_.size() && (text_[at] == ' ' || text_[at] == '\t') && text_[at] != delimiter_) ++at;
        if (at >= text_.size() || text_[at] != '"') return false;
        quote_at_ = at;
        return true;
    }

    std::string read_plain() {
        const std::size_t from = at_;
        while (!at_end_of_cell(at_)) ++at_;
        return std::string{trim_blanks(text_.substr(from, at_ - from))};
    }

    // False, and nothing moved, when the quote never closes: then it is an ordinary character.
    bool read_quoted(std::string& value, DelimitedTable& table) {
        std::size_t at = quote_at_ + 1;
        std::int64_t lines = 0;
        while (true) {
            const bool gone = at >= text_.size() || at - quote_at_ > kMaxQuotedCell;
            if (gone || (text_[at] == '\n' && !quotes_span_lines_)) {
                if (gone) quotes_span_lines_ = false; // else every further quote would search the whole file
                note(table, line_, "open-quote", "a quotation mark is opened and never closed; taken as a character");
                value.clear();
                return false;
            }
            if (text_[at] == '"') {
                if (at + 1 >= text_.size() || text_[at + 1] != '"') break;
                ++at; // doubled
            }
            if (text_[at] == '\n') ++lines;
            value.push_back(text_[at++]);
        }
        at_ = at + 1;
        line_ += lines;
        const std::size_t rest = at_;
        while (!at_end_of_cell(at_)) ++at_;
        // `"12" floor`: what stands behind the closing quote belongs to the cell.
        value +=
            trim_blanks(text_.substr(rest, at_ - rest)).empty() ? std::string_view{} : text_.substr(rest, at_ - rest);
        return true;
    }

    void note(DelimitedTable& table, std::int64_t line, std::string_view code, std::string message) const {
        if (table.notes.size() >= kMaxNotes) return;
        table.notes.push_back({std::string{file_}, line, std::string{code}, {}, std::move(message)});
    }

    static constexpr std::size_t kMaxNotes = 1000;
    std::string_view text_;
    char delimiter_;
    std::string_view file_;
    std::size_t at_ = 0;
    std::size_t quote_at_ = 0;
    std::int64_t line_ = 1;
    bool quotes_span_lines_ = true;
};

// How often each delimiter stands in each of the first lines, outside quotes.
std::vector<std::array<std::size_t, kDelimiters.size()>> delimiter_counts(std::string_view text) {
    std::vector<std::array<std::size_t, kDelimiters.size()>> lines;
    std::array<std::size_t, kDelimiters.size()> counts{};
    bool in_quotes = false;
    bool anything = false;
    for (const char c : text.substr(0, 1U << 16U)) {
        if (c == '"') in_quotes = !in_quotes;
        if (c == '\n' && !in_quotes) {
            if (anything) lines.push_back(counts);
            counts = {};
            anything = false;
            if (lines.size() == 60) return lines;
            continue;
        }
        anything = true;
        if (in_quotes) continue;
        for (std::size_t d = 0; d < kDelimiters.size(); ++d) counts.at(d) += c == kDelimiters.at(d) ? 1U : 0U;
    }
    if (anything) lines.push_back(counts);
    return lines;
}

// The delimiter that stands equally often in most lines; one missing in the first line counts half.
char find_delimiter(std::string_view text) {
    const auto lines = delimiter_counts(text);
    if (lines.empty()) return ',';
    char best = ',';
    std::pair<std::size_t, std::size_t> best_score{0, 0};
    for (std::size_t d = 0; d < kDelimiters.size(); ++d) {
        std::map<std::size_t, std::size_t> seen;
        for (const auto& line : lines) {
            if (line.at(d) > 0) ++seen[line.at(d)];
        }
        std::pair<std::size_t, std::size_t> score{0, 0};
        for (const auto& [count, times] : seen) score = std::max(score, std::pair{times * 2, count});
        if (lines.front().at(d) == 0) score.first /= 2;
        if (score > best_score) {
            best_score = score;
            best = kDelimiters.at(d);
        }
    }
    return best;
}

std::string header_key(std::string_view name) {
    std::string key = text::fold_case(text::trim(name));
    for (char& c : key) {
        if (c == ' ' || c == '-') c = '_';
    }
    return key;
}

bool is_formula_like(std::string_view value) {
    const std::size_t at = value.find_first_not_of('\'');
    if (at == std::string_view::npos) return false;
    return std::string_view{"=+-@"}.find(value[at]) != std::string_view::npos;
}

} // namespace

DelimitedTable parse_table(std::string_view bytes, std::string_view file_name, const TableOptions& options) {
    DecodedText decoded = decode_text(bytes, file_name, options.encoding);
    DelimitedTable table;
    table.encoding = std::move(decoded.encoding);
    table.notes = std::move(decoded.notes);
    std::string_view body = decoded.text;
    table.delimiter = options.delimiter;
    // Excel's own first line: sep=;
    if (body.size() >= 5 && text::fold_case(body.substr(0, 4)) == "sep=" && (body.size() == 5 || body[5] == '\n')) {
        if (table.delimiter == '\0') table.delimiter = body[4];
        const std::string blank = "\n" + std::string{body.substr(std::min<std::size_t>(body.size(), 6))};
        TableParser(blank, table.delimiter, file_name).parse(table);
        return table;
    }
    if (table.delimiter == '\0') table.delimiter = find_delimiter(body);
    TableParser(body, table.delimiter, file_name).parse(table);
    return table;
}

TableHeader::TableHeader(const TableRow& row) {
    names_.reserve(row.cells.size());
    for (const std::string& name : row.cells) names_.push_back(header_key(name));
}

std::optional<std::size_t> TableHeader::find(std::string_view name) const {
    const auto it = std::find(names_.begin(), names_.end(), name);
    if (it == names_.end()) return std::nullopt;
    return static_cast<std::size_t>(it - names_.begin());
}

std::optional<std::size_t> TableHeader::find_any(std::span<const std::string_view> names) const {
    for (const std::string_view name : names) {
        if (const auto at = find(name)) return at;
    }
    return std::nullopt;
}

std::string_view cell(const TableRow& row, std::optional<std::size_t> column) {
    if (!column || *column >= row.cells.size()) return {};
    return text::trim(row.cells[*column]);
}

std::string RowWriter::write(std::span<const std::string> cells) const {
    std::string out;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        if (i > 0) out.push_back(delimiter);
        const bool guard = guard_formulas && is_formula_like(cells[i]) && !text::parse_double(cells[i]);
        const std::string value = (guard ? "'" : "") + cells[i];
        const bool blank_ends = !value.empty() && text::trim(value).size() != value.size();
        const bool quote = always_quote || blank_ends || value.find('"') != std::string::npos ||
                           value.find('\n') != std::string::npos || value.find(delimiter) != std::string::npos;
        if (quote) {
            out += '"' + text::replace_all(value, "\"", "\"\"") + '"';
        } else {
            out += value;
        }
    }
    // One empty cell alone would be an empty line, which readers skip.
    if (cells.size() == 1 && out.empty()) out = "\"\"";
    out += line_end;
    return out;
}

} // namespace planum::strat
