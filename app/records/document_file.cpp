// SPDX-License-Identifier: MIT
#include "app/records/document_file.hpp"

#include <algorithm>
#include <system_error>

namespace planum::app {

namespace fs = std::filesystem;

namespace {

bool lies_in(const fs::path& folder, const fs::path& file) {
    return std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first == folder.end();
}

bool goes_up(const fs::path& path) {
    return std::any_of(path.begin(), path.end(), [](const fs::path& part) { return part == ".."; });
}

DocumentPlace place_of(const std::error_code& trouble) {
    if (trouble == std::errc::permission_denied) return DocumentPlace::Refused;
    return DocumentPlace::Missing; // a name too long or a circle of links names no file either
}

} // namespace

DocumentFile document_file(const fs::path& project, std::string_view path) {
    const fs::path named(path);
    if (named.empty()) return {DocumentPlace::NoPath, {}};
    if (goes_up(named)) return {DocumentPlace::Outside, {}};
    std::error_code trouble;
    const fs::path beside = fs::absolute(project).parent_path();
    const fs::path folder = fs::canonical(beside, trouble);
    if (trouble) return {place_of(trouble), {}};
    if (named.is_absolute() && !lies_in(beside.lexically_normal(), named) && !lies_in(folder, named))
        return {DocumentPlace::Outside, {}};
    const fs::path file = fs::weakly_canonical(folder / named, trouble);
    if (trouble) return {place_of(trouble), {}};
    if (!lies_in(folder, file)) return {DocumentPlace::Outside, {}};
    const fs::file_status status = fs::status(file, trouble);
    if (status.type() == fs::file_type::none) return {place_of(trouble), {}};
    if (!fs::exists(status)) return {DocumentPlace::Missing, {}};
    if (!fs::is_regular_file(status)) return {DocumentPlace::NoFile, {}};
    return {DocumentPlace::Inside, file};
}

} // namespace planum::app
