// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <unordered_map>
#include <vector>

#include <fmt/format.h>

#include "core/base/text.hpp"
#include "strat/exchange/write_support.hpp"
#include "strat/exchange/writers.hpp"

namespace planum::strat {

namespace {

constexpr std::size_t kMaxName = 8;   // of the BASP programs; Stratify reads longer ones
constexpr std::size_t kMaxLabel = 40; // letters
constexpr std::array<std::string_view, 4> kKeys = {"above", "contemporary with", "equal to", "below"};
constexpr std::string_view kIndent = "            ";

/// Lists by key, in the order of kKeys.
using Lists = std::array<std::vector<std::string>, 4>;

// No blank, comma or single colon, and only letters of Latin-1.
std::string lst_name(std::string_view name) {
    std::string out = text::replace_all(name, "::", "\x01");
    for (char& c : out) {
        if (c == ' ' || c == '\t' || c == '\n' || c == ',' || c == ':') c = '_';
    }
    std::size_t lost = 0;
    std::string latin = text::to_latin1(out, &lost);
    if (lost > 0) std::replace(latin.begin(), latin.end(), '?', '_');
    return text::from_latin1(text::replace_all(latin, "\x01", "::"));
}

/// Everything the writer needs to know by unit.
class LstDocument {
  public:
    LstDocument(const RecordNames& names, std::vector<std::string>& lost) : names_(names), lost_(lost) {}

    std::string write() {
        name_everything();
        collect_relations();
        collect_groups();
        std::string out =
            fmt::format("   Stratigraphic Dataset {}\r\n\r\n  Name\r\n", one_line(names_.record().settings.name));
        for (const model::StratigraphicUnit& unit : names_.record().units) write_unit(out, unit);
        for (const model::UnitGroup& group : names_.record().groups) write_group(out, group);
        std::size_t letters = 0;
        std::string bytes = text::to_latin1(out, &letters);
        add_loss(lost_, letters, "letters beyond Latin-1, written as question marks");
        add_loss(lost_, changed_, "names with _ for blanks, commas, colons and letters beyond Latin-1");
        add_loss(lost_, long_, "names longer than the 8 letters that the BASP programs read");
        add_loss(lost_, shortened_, "titles shortened to 40 letters in one line");
        add_loss(lost_, further_groups_, "further groups of a unit, of which only the first is written");
        return bytes;
    }

  private:
    static std::string one_line(std::string_view text) {
        return std::string{text::trim(text::replace_all(text, "\n", " "))};
    }

    std::string take_name(const std::string& name) {
        std::string written = unique_.take(lst_name(name));
        changed_ += written == name ? 0U : 1U;
        long_ += written.size() > kMaxName ? 1U : 0U;
        return written;
    }

    void name_everything() {
        for (const auto& unit : names_.record().units) written_.emplace(unit.id, take_name(names_.unit(unit.id)));
        for (const auto& group : names_.record().groups) groups_.emplace(group.id, take_name(names_.group(group.id)));
    }

    void add(model::UnitId unit, std::size_t key, model::UnitId other) {
        std::vector<std::string>& list = lists_[unit].at(key);
        const std::string& name = written_.at(other);
        if (std::find(list.begin(), list.end(), name) == list.end()) list.push_back(name);
    }

    void collect_relations() {
        for (const std::size_t i : complete_relations(names_)) {
            const model::PhysicalRelation& r = names_.record().relations[i];
            switch (model::time_meaning(r.kind)) {
            case model::TimeMeaning::SubjectLater:
                add(r.subject, 3, r.object);
                add(r.object, 0, r.subject);
                break;
            case model::TimeMeaning::SameUnit:
                add(r.subject, 2, r.object);
                add(r.object, 2, r.subject);
                break;
            case model::TimeMeaning::SameTime:
                add(r.subject, 1, r.object);
                add(r.object, 1, r.subject);
                break;
            case model::TimeMeaning::None: break;
            }
        }
    }

    void collect_groups() {
        for (const model::UnitGroup& group : names_.record().groups) {
            for (const model::UnitId member : group.members) {
                further_groups_ += group_of_.emplace(member, group.id).second ? 0U : 1U;
            }
        }
    }

    void write_unit(std::string& out, const model::StratigraphicUnit& unit) {
        out += written_.at(unit.id);
        write_label(out, unit.title);
        const auto lists = lists_.find(unit.id);
        for (std::size_t key = 0; key < kKeys.size(); ++key) {
            out += fmt::format("{}{}: {}\r\n", kIndent, kKeys.at(key),
                               lists == lists_.end() ? "" : text::join(lists->second.at(key), ", "));
        }
        const auto group = group_of_.find(unit.id);
        if (group == group_of_.end()) return;
        out += fmt::format("{}Unit class: context\r\n{}Part of: {}\r\n", kIndent, kIndent, groups_.at(group->second));
    }

    void write_group(std::string& out, const model::UnitGroup& group) {
        out += groups_.at(group.id);
        write_label(out, group.title);
        out += fmt::format("{}Unit class: group\r\n", kIndent);
        const auto parent = groups_.find(group.parent);
        if (parent != groups_.end()) out += fmt::format("{}Part of: {}\r\n", kIndent, parent->second);
    }

    void write_label(std::string& out, const std::string& title) {
        std::string label = one_line(title);
        std::size_t lost = 0;
        std::string latin = text::to_latin1(label, &lost);
        if (latin.size() > kMaxLabel) {
            latin.resize(kMaxLabel);
            label = text::trim(text::from_latin1(latin));
        }
        shortened_ += label == title ? 0U : 1U;
        out += label.empty() ? "\r\n" : fmt::format("   {}\r\n", label);
    }

    const RecordNames& names_;
    std::vector<std::string>& lost_;
    UniqueNames unique_;
    std::unordered_map<model::UnitId, std::string> written_;
    std::unordered_map<model::GroupId, std::string> groups_;
    std::unordered_map<model::UnitId, Lists> lists_;
    std::unordered_map<model::UnitId, model::GroupId> group_of_;
    std::size_t changed_ = 0;
    std::size_t long_ = 0;
    std::size_t shortened_ = 0;
    std::size_t further_groups_ = 0;
};

} // namespace

Written write_lst(const model::Record& record, const WriteOptions& /*options*/) {
    Carries carries;
    carries.title = true;
    carries.same_as = true;
    carries.contemporary = true;
    carries.groups = true;
    Written written;
    written.lost = losses(record, carries);
    const RecordNames names(record);
    std::string bytes = LstDocument(names, written.lost).write();
    written.files.push_back({{}, std::move(bytes)});
    return written;
}

} // namespace planum::strat
