// SPDX-License-Identifier: MIT
#include "tests/unit/strat_exchange/support.hpp"

#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>

#include "tests/support/real_data.hpp"

namespace planum::test {

namespace {

template<class T>
void append(std::vector<T>& to, std::vector<T>& from) {
    to.insert(to.end(), from.begin(), from.end());
}

void merge(strat::Imported<strat::ImportedRecord>& to, strat::Imported<strat::ImportedRecord> from) {
    append(to.diagnostics, from.diagnostics);
    strat::ImportedRecord& a = to.values;
    strat::ImportedRecord& b = from.values;
    if (a.project_name.empty()) a.project_name = b.project_name;
    append(a.areas, b.areas);
    append(a.units, b.units);
    append(a.relations, b.relations);
    append(a.periods, b.periods);
    append(a.phases, b.phases);
    append(a.groups, b.groups);
    append(a.datings, b.datings);
    append(a.levels, b.levels);
    append(a.finds, b.finds);
    append(a.samples, b.samples);
    append(a.documents, b.documents);
}

std::vector<strat::InputFile> to_files(Files files) {
    std::vector<strat::InputFile> result;
    for (const auto& [name, bytes] : files) result.push_back(a_file(name, bytes));
    return result;
}

std::string text_of(const strat::UnitName& name) {
    return name.area.empty() ? name.number : name.area + "::" + name.number;
}

} // namespace

strat::InputFile a_file(std::string_view name, std::string_view bytes) {
    strat::InputFile file;
    file.path = std::filesystem::path{name};
    file.name = file.path.filename().string();
    file.bytes = bytes;
    return file;
}

strat::Imported<strat::ImportedRecord> read_all(const std::vector<strat::InputFile>& files, std::string_view format) {
    strat::Imported<strat::ImportedRecord> all;
    for (const strat::Reading& reading : strat::plan_reading(files, format)) {
        std::vector<const strat::InputFile*> chosen;
        for (const std::size_t file : reading.files) chosen.push_back(&files.at(file));
        merge(all, reading.reader->read(chosen, {}, Progress::none()));
    }
    return all;
}

strat::Imported<strat::ImportedRecord> read_all(Files files, std::string_view format) {
    return read_all(to_files(files), format);
}

std::string format_of(const std::vector<strat::InputFile>& files) {
    std::string formats;
    for (const strat::Reading& reading : strat::plan_reading(files, {})) {
        formats += (formats.empty() ? "" : " ") + std::string{reading.reader->format};
    }
    return formats;
}

std::string format_of(Files files) { return format_of(to_files(files)); }

std::vector<strat::InputFile> load_folder(const std::filesystem::path& path) {
    if (!std::filesystem::is_directory(path)) return {strat::load_input_file(path)};
    std::vector<std::filesystem::path> names;
    for (const auto& entry : std::filesystem::directory_iterator(path)) {
        if (entry.is_regular_file()) names.push_back(entry.path());
    }
    std::sort(names.begin(), names.end());
    std::vector<strat::InputFile> files;
    for (const auto& name : names) files.push_back(strat::load_input_file(name));
    return files;
}

std::vector<strat::InputFile> sample(std::string_view name) {
    return load_folder(planum::test::source_folder() / "tests/data/exchange" / name);
}

std::map<std::string, std::vector<strat::InputFile>> all_samples() {
    std::map<std::string, std::vector<strat::InputFile>> samples;
    for (const auto& entry :
         std::filesystem::directory_iterator(planum::test::source_folder() / "tests/data/exchange")) {
        if (entry.is_directory()) samples[entry.path().filename().string()] = load_folder(entry.path());
    }
    return samples;
}

std::vector<std::string> relations_of(const strat::ImportedRecord& record) {
    std::vector<std::string> texts;
    for (const strat::StatedRelation& r : record.relations) {
        texts.push_back(fmt::format("{} {} {}{}", text_of(r.subject), model::to_word(r.kind), text_of(r.object),
                                    r.certainty == model::Certainty::Uncertain ? " ?" : ""));
    }
    return texts;
}

std::vector<std::string> notes_of(const std::vector<strat::ReadNote>& notes) {
    std::vector<std::string> texts;
    for (const strat::ReadNote& n : notes) texts.push_back(fmt::format("{}:{} {}", n.file, n.line, n.code));
    return texts;
}

Counts counts_of(const strat::ImportedRecord& record) {
    using Pair = std::pair<std::string, std::string>;
    std::set<std::string> units;
    std::set<Pair> orders;
    std::set<Pair> same;
    std::set<Pair> contemporary;
    std::set<std::string> self;
    for (const strat::ImportedUnit& unit : record.units) units.insert(text_of(unit.name));
    for (const strat::StatedRelation& r : record.relations) {
        const std::string a = text_of(r.subject);
        const std::string b = text_of(r.object);
        units.insert(a);
        units.insert(b);
        switch (model::time_meaning(r.kind)) {
        case model::TimeMeaning::SubjectLater: a == b ? void(self.insert(a)) : void(orders.insert({a, b})); break;
        case model::TimeMeaning::SameUnit: same.insert(std::minmax(a, b)); break;
        case model::TimeMeaning::SameTime: contemporary.insert(std::minmax(a, b)); break;
        case model::TimeMeaning::None: break;
        }
    }
    Counts counts{units.size(), orders.size(), same.size(), contemporary.size(), self.size(), 0, 0};
    std::set<std::string> ordered;
    for (const Pair& order : orders) {
        if (order.first < order.second && orders.contains({order.second, order.first})) ++counts.mutual;
        ordered.insert(order.first);
        ordered.insert(order.second);
    }
    // What is the same as an ordered unit is not isolated; and what is the same counts once.
    for (bool grows = true; grows;) {
        grows = false;
        for (const Pair& pair : same) {
            if (ordered.contains(pair.first) == ordered.contains(pair.second)) continue;
            grows = ordered.insert(pair.first).second || ordered.insert(pair.second).second;
        }
    }
    std::map<std::string, std::string> smallest; // of those that are the same
    for (const std::string& unit : units) smallest[unit] = unit;
    for (bool changes = true; changes;) {
        changes = false;
        for (const Pair& pair : same) {
            const std::string least = std::min(smallest[pair.first], smallest[pair.second]);
            changes = changes || smallest[pair.first] != least || smallest[pair.second] != least;
            smallest[pair.first] = least;
            smallest[pair.second] = least;
        }
    }
    for (const std::string& unit : units)
        counts.isolated += !ordered.contains(unit) && smallest[unit] == unit ? 1U : 0U;
    return counts;
}

std::string to_text(const Counts& c) {
    return fmt::format("units {} orders {} same-as {} contemporary {} self {} mutual {} isolated {}", c.units, c.orders,
                       c.same_as, c.contemporary, c.self, c.mutual, c.isolated);
}

} // namespace planum::test
