// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.hpp"
#include "strat/exchange/reader.hpp"

namespace planum::fuzz {

/// Gives the bytes to one reader: recognising must never throw, reading nothing but Error. The byte 0x1E
/// parts the input into several files, so that companion files are tried too.
inline int try_reader(const strat::Reader& reader, const std::uint8_t* data, std::size_t size, std::string_view name) {
    constexpr char kNextFile = '\x1E';
    std::string_view rest(reinterpret_cast<const char*>(data), size); // bytes are bytes
    std::vector<strat::InputFile> files;
    while (files.size() < 8) {
        const std::size_t end = files.size() == 7 ? std::string_view::npos : rest.find(kNextFile);
        strat::InputFile& file = files.emplace_back();
        file.name = std::to_string(files.size()) + std::string(name);
        file.bytes = rest.substr(0, end);
        if (end == std::string_view::npos) break;
        rest = rest.substr(end + 1);
    }
    const strat::Recognition recognition = reader.recognise(files);
    for (const std::size_t file : recognition.files) {
        if (file >= files.size()) __builtin_trap();
    }
    std::vector<const strat::InputFile*> pointers;
    for (const strat::InputFile& file : files) pointers.push_back(&file);
    try {
        const auto read = reader.read(pointers, {}, Progress::none());
        for (const auto& unit : read.values.units) {
            if (unit.name.number.empty()) __builtin_trap();
        }
    } catch (const Error&) {
        return 0;
    }
    return 0;
}

} // namespace planum::fuzz
