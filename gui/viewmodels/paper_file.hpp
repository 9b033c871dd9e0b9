// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

#include <filesystem>

namespace planum::gui {

/// A document's file, or why there is none to be shown.
struct PaperFile {
    std::filesystem::path file; ///< empty: see the sentence
    QString sentence;
};

/// Looks for the file of a document's path, in the project's folder only (app::document_file). Touches the disk: for
/// threads.
[[nodiscard]] PaperFile paper_file(const std::filesystem::path& project, const QString& path);

/// Whether a path is to be shown as a picture, from its ending: that of an image, or none at all.
[[nodiscard]] bool names_picture(const QString& path);

/// Largest pictures that are opened: a file from elsewhere may claim any size, and the whole of it has to be unpacked
/// even for a small copy. Cameras make up to 150 megapixels.
inline constexpr qint64 kMostPictureBytes = 300'000'000;
inline constexpr qint64 kMostPicturePixels = 200'000'000;

/// Why a picture of this size is not opened; empty where it is.
[[nodiscard]] QString picture_too_large(const QString& path, qint64 bytes, qint64 width, qint64 height);

/// That the file at `path` cannot be read as a picture, and why.
[[nodiscard]] QString picture_broken(const QString& path, const QString& reason);
/// That it is a picture of a kind that is not shown here.
[[nodiscard]] QString picture_unknown(const QString& path);

} // namespace planum::gui
