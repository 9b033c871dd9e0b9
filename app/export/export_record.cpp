// SPDX-License-Identifier: MIT
#include "app/export/export_record.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "app/checks/daily_check.hpp"
#include "core/base/error.hpp"
#include "core/base/file.hpp"
#include "core/base/text.hpp"
#include "strat/exchange/writer.hpp"

namespace planum::app {

namespace {

const strat::Writer& writer_of(const std::filesystem::path& file, const std::string& format) {
    if (!format.empty()) return strat::writer_for(format);
    const std::string ending = text::fold_case(file.extension().string());
    if (ending == ".csv") return strat::writer_for("planum-csv");
    for (const strat::Writer& writer : strat::all_writers()) {
        if (!writer.extension.empty() && "." + std::string(writer.extension) == ending) return writer;
    }
    std::vector<std::string> known;
    for (const strat::Writer& writer : strat::all_writers()) {
        std::string one = "." + std::string(writer.extension);
        if (one.size() > 1 && std::find(known.begin(), known.end(), one) == known.end())
            known.push_back(std::move(one));
    }
    throw Error(ErrorCode::Usage, fmt::format("{}: no format ends in {}; known are {}", file.string(),
                                              ending.empty() ? "nothing" : ending, text::join(known, ", ")));
}

} // namespace

Exported export_record(Project& project, const std::filesystem::path& file, const ExportOptions& options) {
    const strat::Writer& writer = writer_of(file, options.format);
    strat::WriteOptions write_options;
    write_options.prefix = file.stem().string() + "-";
    strat::Written written = writer.write(interpreted(project.record(), options.interpretation), write_options);
    Exported done;
    done.lost = std::move(written.lost);
    for (const strat::WrittenFile& part : written.files) {
        std::filesystem::path target = file;
        if (!part.name.empty()) target = file.parent_path() / (write_options.prefix + part.name);
        write_file_atomically(target, part.bytes);
        done.files.push_back(std::move(target));
    }
    return done;
}

} // namespace planum::app
