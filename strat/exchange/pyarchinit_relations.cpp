// SPDX-License-Identifier: MIT
#include "strat/exchange/pyarchinit_relations.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "core/base/text.hpp"
#include "strat/exchange/python_literal.hpp"

namespace planum::strat {

namespace {

// What stands before the number in words: "Covers US 1001".
constexpr std::array<std::string_view, 8> kPrefixes = {"us ", "usm ", "usr ",     "usv ",
                                                       "su ", "ue ",  "context ", "unit "};

std::string target_number(std::string_view raw, bool& uncertain) {
    std::string_view rest = text::trim(raw);
    const std::string folded = text::fold_case(rest);
    for (const std::string_view prefix : kPrefixes) {
        // Prefixes are ASCII, so that folding keeps their length.
        if (folded.starts_with(prefix)) {
            rest = text::trim(rest.substr(prefix.size()));
            break;
        }
    }
    if (rest.size() > 1 && rest.ends_with('?')) {
        uncertain = true;
        rest = text::trim(rest.substr(0, rest.size() - 1));
    }
    return std::string(rest);
}

std::string printed(const PythonValue& value) {
    if (!value.is_list) return value.text;
    std::string out = "[";
    for (const PythonValue& item : value.items) {
        if (out.size() > 1) out += ", ";
        out += item.is_list ? std::string("[…]") : "'" + item.text + "'";
    }
    return out + "]";
}

bool is_blank_item(const PythonValue& item) {
    if (!item.is_list) return text::trim(item.text).empty();
    return std::all_of(item.items.begin(), item.items.end(),
                       [](const PythonValue& field) { return !field.is_list && text::trim(field.text).empty(); });
}

void add(PyarchinitRelations& out, model::DirectedKind kind, std::string_view word, std::string_view target,
         std::string raw) {
    PyarchinitRelation relation;
    relation.kind = kind;
    relation.symbol = word.starts_with('>') || word.starts_with('<');
    relation.target = target_number(target, relation.uncertain);
    relation.raw = std::move(raw);
    if (relation.target.empty()) {
        out.problems.push_back({"empty-target", std::move(relation.raw),
                                "the relation \"" + std::string(word) + "\" names no unit; not kept as a relation"});
        return;
    }
    out.relations.push_back(std::move(relation));
}

void read_item(PyarchinitRelations& out, const PythonValue& item) {
    if (is_blank_item(item)) return;
    const std::string raw = printed(item);
    if (!item.is_list) {
        out.problems.push_back({"unparsed", raw, "an item of the relations is no list; left out"});
        return;
    }
    // Fields moved by one occur: the word then stands second.
    for (std::size_t at = 0; at < std::min<std::size_t>(2, item.items.size()); ++at) {
        const std::string_view word = text::trim(item.items[at].text);
        const auto kind = model::relation_from_any_word(word);
        if (!kind) continue;
        const auto field = [&](std::size_t i) {
            return at + i < item.items.size() ? text::trim(item.items[at + i].text) : std::string_view{};
        };
        const std::size_t before = out.relations.size();
        add(out, *kind, word, field(1), raw);
        if (out.relations.size() > before) {
            out.relations.back().area = field(2);
            out.relations.back().site = field(3);
        }
        return;
    }
    out.problems.push_back(
        {"unknown-relation", raw,
         "\"" + std::string(text::trim(item.items.front().text)) + "\" is no relation word known here"});
}

struct WordAndRest {
    std::string_view word;
    model::DirectedKind kind;
    std::string_view rest;
};

// The longest run of words at the beginning that is a relation.
std::optional<WordAndRest> leading_relation(std::string_view part) {
    std::optional<WordAndRest> best;
    std::size_t end = 0;
    for (int words = 0; words < 5 && end != std::string_view::npos; ++words) {
        end = part.find(' ', end == 0 ? 0 : end + 1);
        const std::string_view word = text::trim(part.substr(0, end));
        if (const auto kind = model::relation_from_any_word(word)) {
            best = WordAndRest{word, *kind, end == std::string_view::npos ? std::string_view{} : part.substr(end)};
        }
    }
    return best;
}

// "Copre 2, 8; Coperto da 3": a number without a word repeats the word before it.
void read_words(PyarchinitRelations& out, std::string_view cell) {
    std::optional<WordAndRest> last;
    while (!cell.empty()) {
        const std::size_t end = cell.find_first_of(",;\n");
        const std::string_view part = text::trim(cell.substr(0, end));
        cell = end == std::string_view::npos ? std::string_view{} : cell.substr(end + 1);
        if (part.empty()) continue;
        if (const auto found = leading_relation(part)) {
            last = found;
            add(out, found->kind, found->word, found->rest, std::string(part));
        } else if (last && part.find(' ') == std::string_view::npos) {
            add(out, last->kind, last->word, part, std::string(part));
        } else {
            out.problems.push_back(
                {"unknown-relation", std::string(part), "no relation word known here at its beginning"});
        }
    }
}

} // namespace

PyarchinitRelations read_rapporti(std::string_view cell) {
    PyarchinitRelations out;
    const std::string_view trimmed = text::trim(cell);
    if (trimmed.empty() || trimmed == "None" || trimmed == "NULL") return out;
    if (!trimmed.starts_with('[') && !trimmed.starts_with('(')) {
        read_words(out, trimmed);
        return out;
    }
    const auto list = read_python_list(trimmed);
    if (!list) {
        out.problems.push_back(
            {"unparsed", std::string(trimmed), "the list of relations is damaged; none of them was read"});
        return out;
    }
    // ['Copre', '13', '1', 'Site']: a single relation without the outer list.
    const bool flat = !list->items.empty() && std::none_of(list->items.begin(), list->items.end(),
                                                           [](const PythonValue& item) { return item.is_list; });
    if (flat) {
        read_item(out, *list);
    } else {
        for (const PythonValue& item : list->items) read_item(out, item);
    }
    return out;
}

} // namespace planum::strat
