// SPDX-License-Identifier: MIT
#include "app/survey/code_table.hpp"

#include <array>
#include <cstddef>
#include <utility>

#include <fmt/format.h>

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "strat/exchange/delimited_table.hpp"

namespace planum::app {

namespace {

constexpr std::array<std::pair<std::string_view, SurveyMeaning>, 31> kCodes = {{
    {"t", SurveyMeaning::Top},         {"top", SurveyMeaning::Top},       {"ok", SurveyMeaning::Top},
    {"oberkante", SurveyMeaning::Top}, {"l", SurveyMeaning::Top},         {"lev", SurveyMeaning::Top},
    {"level", SurveyMeaning::Top},     {"niv", SurveyMeaning::Top},       {"nivellement", SurveyMeaning::Top},
    {"quota", SurveyMeaning::Top},     {"q", SurveyMeaning::Top},         {"b", SurveyMeaning::Base},
    {"base", SurveyMeaning::Base},     {"uk", SurveyMeaning::Base},       {"unterkante", SurveyMeaning::Base},
    {"c", SurveyMeaning::Cut},         {"cut", SurveyMeaning::Cut},       {"grube", SurveyMeaning::Cut},
    {"taglio", SurveyMeaning::Cut},    {"o", SurveyMeaning::OtherLevel},  {"other", SurveyMeaning::OtherLevel},
    {"f", SurveyMeaning::Find},        {"find", SurveyMeaning::Find},     {"fund", SurveyMeaning::Find},
    {"kf", SurveyMeaning::Find},       {"sf", SurveyMeaning::Find},       {"rf", SurveyMeaning::Find},
    {"reperto", SurveyMeaning::Find},  {"mobilier", SurveyMeaning::Find}, {"ignore", SurveyMeaning::Ignored},
    {"fp", SurveyMeaning::Ignored},
}};

constexpr std::array<std::pair<std::string_view, SurveyMeaning>, 6> kWords = {{
    {"top", SurveyMeaning::Top},
    {"base", SurveyMeaning::Base},
    {"cut", SurveyMeaning::Cut},
    {"other", SurveyMeaning::OtherLevel},
    {"find", SurveyMeaning::Find},
    {"ignore", SurveyMeaning::Ignored},
}};

bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool is_between(char c) { return c == ' ' || c == '.' || c == ':' || c == '_' || c == '-' || c == '#' || c == '/'; }

} // namespace

CodeTable::CodeTable() {
    for (const auto& [code, meaning] : kCodes) meanings_.emplace(code, meaning);
}

void CodeTable::add_table(std::string_view bytes, std::string_view file_name) {
    const strat::DelimitedTable table = strat::parse_table(bytes, file_name);
    for (const strat::TableRow& row : table.rows) {
        if (row.cells.size() < 2) continue;
        const std::string code = text::fold_case(text::trim(row.cells[0]));
        const std::string word = text::fold_case(text::trim(row.cells[1]));
        if (code.empty() || (code == "code" && word == "meaning")) continue;
        bool known = false;
        for (const auto& [name, meaning] : kWords) {
            if (name != word) continue;
            meanings_.insert_or_assign(code, meaning);
            known = true;
        }
        if (!known) {
            throw Error(ErrorCode::BadInput, fmt::format("{}:{}: {} is none of top, base, cut, other, find, ignore",
                                                         file_name, row.line, row.cells[1]));
        }
    }
}

std::optional<ReadCode> CodeTable::read(std::string_view code) const {
    const std::string_view whole = text::trim(code);
    if (whole.empty()) return std::nullopt;
    if (const auto it = meanings_.find(text::fold_case(whole)); it != meanings_.end()) return ReadCode{it->second, {}};
    // The longest beginning that is a code, with a number or a separator behind it.
    for (std::size_t length = whole.size() - 1; length > 0; --length) {
        const char next = whole[length];
        if (!is_digit(next) && !is_between(next)) continue;
        const auto it = meanings_.find(text::fold_case(text::trim(whole.substr(0, length))));
        if (it == meanings_.end()) continue;
        std::string_view number = whole.substr(length);
        while (!number.empty() && is_between(number.front())) number.remove_prefix(1);
        return ReadCode{it->second, std::string(text::trim(number))};
    }
    return std::nullopt;
}

} // namespace planum::app
