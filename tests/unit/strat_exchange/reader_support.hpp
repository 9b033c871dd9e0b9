// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "strat/exchange/reader.hpp"

namespace planum::test {

inline strat::InputFile input(std::string name, std::string bytes) {
    strat::InputFile file;
    file.name = std::move(name);
    file.bytes = std::move(bytes);
    return file;
}

inline strat::Imported<strat::ImportedRecord> read_with(const strat::Reader& reader,
                                                        const std::vector<strat::InputFile>& files,
                                                        const strat::ReadOptions& options = {}) {
    std::vector<const strat::InputFile*> pointers;
    for (const strat::InputFile& file : files) pointers.push_back(&file);
    return reader.read(pointers, options, Progress::none());
}

inline std::size_t count_notes(const std::vector<strat::ReadNote>& notes, std::string_view code) {
    std::size_t count = 0;
    for (const strat::ReadNote& note : notes) count += note.code == code ? 1U : 0U;
    return count;
}

/// The relations as text, one each: `12 covers 13`, in the order read.
inline std::vector<std::string> relation_texts(const strat::ImportedRecord& record) {
    std::vector<std::string> out;
    for (const auto& relation : record.relations) {
        out.push_back(relation.subject.number + " " + std::string(model::to_word(relation.kind)) + " " +
                      relation.object.number);
    }
    return out;
}

} // namespace planum::test
