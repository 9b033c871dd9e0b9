// SPDX-License-Identifier: MIT
#include "gui/viewmodels/paper_file.hpp"

#include <QCoreApplication>
#include <QFileInfo>
#include <QLocale>
#include <QStringList>

#include "app/records/document_file.hpp"

namespace planum::gui {

namespace {

struct Papers {
    Q_DECLARE_TR_FUNCTIONS(papers)
};

QString sentence_of(app::DocumentPlace place, const QString& path) {
    switch (place) {
    case app::DocumentPlace::Inside: return {};
    case app::DocumentPlace::NoPath: return Papers::tr("no file is named");
    case app::DocumentPlace::Outside: return Papers::tr("%1 is not shown: it is not in the project's folder").arg(path);
    case app::DocumentPlace::Missing: return Papers::tr("%1 is not there").arg(path);
    case app::DocumentPlace::NoFile: return Papers::tr("%1 is no file").arg(path);
    case app::DocumentPlace::Refused: return Papers::tr("%1 may not be read by this user").arg(path);
    }
    return {};
}

} // namespace

PaperFile paper_file(const std::filesystem::path& project, const QString& path) {
    const app::DocumentFile found = app::document_file(project, path.toStdString());
    return {found.file, sentence_of(found.place, path)};
}

bool names_picture(const QString& path) {
    static const QStringList kEndings = {QStringLiteral(""),     QStringLiteral("jpg"), QStringLiteral("jpeg"),
                                         QStringLiteral("png"),  QStringLiteral("tif"), QStringLiteral("tiff"),
                                         QStringLiteral("webp"), QStringLiteral("bmp"), QStringLiteral("gif")};
    return !path.isEmpty() && kEndings.contains(QFileInfo(path).suffix().toLower());
}

QString picture_too_large(const QString& path, qint64 bytes, qint64 width, qint64 height) {
    const QLocale locale;
    constexpr qint64 kMillion = 1'000'000;
    if (bytes > kMostPictureBytes) {
        return Papers::tr("%1 is too large to be shown: %2 MB, up to %3 MB are")
            .arg(path, locale.toString((bytes + kMillion - 1) / kMillion),
                 locale.toString(kMostPictureBytes / kMillion));
    }
    // By division: a file may claim a size whose product is no number any more.
    if (width > 0 && height > kMostPicturePixels / width) {
        return Papers::tr("%1 is too large to be shown: %2 × %3 pixels, up to %4 million are")
            .arg(path, locale.toString(width), locale.toString(height), locale.toString(kMostPicturePixels / kMillion));
    }
    return {};
}

QString picture_broken(const QString& path, const QString& reason) {
    return Papers::tr("%1 cannot be read as a picture: %2").arg(path, reason);
}

QString picture_unknown(const QString& path) {
    return Papers::tr("%1 is no picture of a kind that can be shown here").arg(path);
}

} // namespace planum::gui
