// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string_view>

namespace planum::app {

/// Where the path of a document leads.
enum class DocumentPlace {
    Inside,  ///< to an ordinary file in the project's folder or below it
    NoPath,  ///< nowhere: it is empty
    Outside, ///< out of the project's folder, by `..`, from the root, or over a link
    Missing, ///< to nothing
    NoFile,  ///< to a folder or a device
    Refused, ///< where this user may not look
};

struct DocumentFile {
    DocumentPlace place = DocumentPlace::NoPath;
    std::filesystem::path file; ///< free of links; empty but for Inside
};

/// The file that a document's path names, counted from the project file. A project comes from elsewhere and may name
/// any file of this machine: only what lies in its own folder, links followed, is given out, and of what lies outside
/// it is not even said whether it exists. Touches the disk.
[[nodiscard]] DocumentFile document_file(const std::filesystem::path& project, std::string_view path);

} // namespace planum::app
