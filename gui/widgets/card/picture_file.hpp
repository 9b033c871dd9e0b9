// SPDX-License-Identifier: MIT
#pragma once

#include <QImage>
#include <QSize>
#include <QString>

#include <filesystem>

namespace planum::gui {

/// A picture as it is shown, or why it is not.
struct ReadPicture {
    QImage image;     ///< null: see the sentence
    QSize whole;      ///< of the file, upright [px]
    QString sentence; ///< names the path
};

/// Reads the picture that a document's path names, made to fit into `bounds` [px] and never larger than it is, turned
/// upright as the camera says. The path stays in the project's folder, the file within kMostPictureBytes and
/// kMostPicturePixels; whatever else is wrong is a sentence, too. For threads.
[[nodiscard]] ReadPicture read_picture(const std::filesystem::path& project, const QString& path, QSize bounds);

} // namespace planum::gui
