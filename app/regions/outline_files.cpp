// SPDX-License-Identifier: MIT
#include "app/regions/outline_files.hpp"

#include <cstdint>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>

#include "app/regions/geojson_outlines.hpp"
#include "app/regions/pixel_outlines.hpp"
#include "core/base/error.hpp"
#include "core/base/file.hpp"

namespace planum::app {

namespace {

OutlineFile read_outlines(Project& project, const std::filesystem::path& file, Progress& progress) {
    constexpr std::uintmax_t kLargest = 256ULL << 20U;
    const std::string bytes = read_file(file, kLargest);
    const strat::Json json = strat::parse_json(bytes);
    return is_pixel_outlines(json) ? outlines_from_pixels(project, pixel_outlines_from(json), progress)
                                   : geojson_outlines_from(json);
}

void say_file(OutlineFile& outlines, const std::string& name) {
    const auto with_name = [&](std::string& where) { where = where.empty() ? name : name + ", " + where; };
    for (DrawnOutline& outline : outlines.outlines) with_name(outline.where);
    for (OutlineNote& note : outlines.notes) with_name(note.where);
}

} // namespace

OutlineFile read_outline_files(Project& project, const std::vector<std::filesystem::path>& files, Progress& progress) {
    OutlineFile all;
    for (const std::filesystem::path& file : files) {
        const std::string name = file.filename().string();
        try {
            OutlineFile one = read_outlines(project, file, progress);
            if (files.size() > 1) say_file(one, name);
            std::move(one.outlines.begin(), one.outlines.end(), std::back_inserter(all.outlines));
            std::move(one.notes.begin(), one.notes.end(), std::back_inserter(all.notes));
        } catch (Error& e) {
            // A file that cannot be opened is named already.
            if (!std::string_view(e.what()).starts_with(file.string())) e.add_context(name);
            throw;
        }
    }
    return all;
}

} // namespace planum::app
