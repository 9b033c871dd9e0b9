// SPDX-License-Identifier: MIT
#include "strat/exchange/reader.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "core/base/error.hpp"
#include "core/base/file.hpp"
#include "strat/exchange/record_builder.hpp"
#include "strat/exchange/text_limits.hpp"

namespace planum::strat {

namespace {

constexpr std::string_view kSqliteHeader{"SQLite format 3\0", 16};

bool is_sqlite(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::array<char, 16> head{};
    in.read(head.data(), head.size());
    return in.gcount() == 16 && std::string_view{head.data(), head.size()} == kSqliteHeader;
}

struct Candidate {
    const Reader* reader = nullptr;
    Recognition recognition;
};

bool shares_a_file(const Recognition& a, const Recognition& b) {
    return std::any_of(a.files.begin(), a.files.end(), [&](std::size_t file) {
        return std::find(b.files.begin(), b.files.end(), file) != b.files.end();
    });
}

std::vector<Candidate> ask_all(std::span<const InputFile> files) {
    std::vector<Candidate> candidates;
    for (const Reader& reader : all_readers()) {
        Recognition recognition = reader.recognise(files);
        std::erase_if(recognition.files, [&](std::size_t file) { return file >= files.size(); });
        if (recognition.confidence == Confidence::No || recognition.files.empty()) continue;
        candidates.push_back({&reader, std::move(recognition)});
    }
    return candidates;
}

// Says the other readings that were as likely, or nearly.
std::string choice_note(const Candidate& taken, const std::vector<Candidate>& candidates) {
    std::string others;
    for (const Candidate& other : candidates) {
        if (other.reader == taken.reader || !shares_a_file(other.recognition, taken.recognition)) continue;
        const bool settled =
            taken.recognition.confidence == Confidence::Certain && other.recognition.confidence != Confidence::Certain;
        if (settled) continue;
        others += fmt::format("; could also be read as {} ({})", other.reader->format, other.recognition.why);
    }
    if (others.empty()) return {};
    return fmt::format("read as {} ({}){}; --format overrules", taken.reader->format, taken.recognition.why, others);
}

[[noreturn]] void fail_unknown(const InputFile& file) {
    if (file.bytes.empty() && !file.is_database) {
        throw Error(ErrorCode::BadInput, fmt::format("{}: the file is empty", file.name));
    }
    std::string looked_for;
    for (const Reader& reader : all_readers()) {
        looked_for += fmt::format("{}{}", looked_for.empty() ? "" : ", ", reader.format);
    }
    throw Error(ErrorCode::BadInput,
                fmt::format("{}: not recognised; looked for {} by content, name and the files beside it; "
                            "name the format with --format",
                            file.name, looked_for));
}

const Reader& reader_named(std::string_view format) {
    std::string known;
    for (const Reader& reader : all_readers()) {
        if (reader.format == format) return reader;
        known += fmt::format("{}{}", known.empty() ? "" : ", ", reader.format);
    }
    throw Error(ErrorCode::Usage, fmt::format("no format {}; there are {}", format, known));
}

// The best reading of some of the files; confidence first, then the order of the readers. None when all that is left
// merely lay in a folder.
std::optional<Reading> best_reading(std::span<const InputFile> files) {
    const std::vector<Candidate> candidates = ask_all(files);
    if (candidates.empty()) {
        const auto named = std::find_if(files.begin(), files.end(), [](const InputFile& file) { return !file.found; });
        if (named == files.end()) return std::nullopt;
        fail_unknown(*named);
    }
    const auto best = std::max_element(candidates.begin(), candidates.end(), [](const auto& a, const auto& b) {
        return a.recognition.confidence < b.recognition.confidence;
    });
    return Reading{best->reader, best->recognition.files, choice_note(*best, candidates)};
}

} // namespace

InputFile load_input_file(const std::filesystem::path& file) {
    InputFile input;
    input.path = file;
    input.name = file.filename().string();
    std::error_code problem;
    input.is_database = std::filesystem::is_regular_file(file, problem) && is_sqlite(file);
    if (input.is_database) return input;
    const std::uintmax_t size = std::filesystem::file_size(file, problem);
    if (!problem && size > kMaxRecordFile) {
        throw Error(ErrorCode::BadInput,
                    fmt::format("{}: {} MB, more than the {} MB that one file of a record may have; look whether this "
                                "is the right file, or split it and import the parts together",
                                input.name, size / 1000000, kMaxRecordFile / 1000000));
    }
    input.bytes = read_file(file, kMaxRecordFile);
    // Of binaries a reader says what they are not.
    if (is_probably_text(input.bytes)) refuse_endless_text(input.bytes, input.name);
    return input;
}

std::vector<Reading> plan_reading(std::span<const InputFile> files, std::string_view format) {
    std::vector<Reading> plan;
    if (files.empty()) return plan;
    if (!format.empty()) {
        Reading reading{&reader_named(format), {}, {}};
        for (std::size_t i = 0; i < files.size(); ++i) reading.files.push_back(i);
        plan.push_back(std::move(reading));
        return plan;
    }
    // Most calls end after the first round. Otherwise what is left is asked about again, alone.
    std::vector<std::size_t> left;
    for (std::size_t i = 0; i < files.size(); ++i) left.push_back(i);
    const auto take = [&](const Reading& reading) {
        std::erase_if(left, [&](std::size_t file) {
            return std::find(reading.files.begin(), reading.files.end(), file) != reading.files.end();
        });
    };
    while (!left.empty()) {
        std::vector<InputFile> rest;
        if (left.size() < files.size()) {
            for (const std::size_t file : left) rest.push_back(files[file]);
        }
        std::optional<Reading> reading = best_reading(rest.empty() ? files : rest);
        if (!reading) break;
        for (std::size_t& file : reading->files) file = left[file];
        take(*reading);
        plan.push_back(std::move(*reading));
    }
    if (plan.empty()) fail_unknown(files.front());
    return plan;
}

} // namespace planum::strat
