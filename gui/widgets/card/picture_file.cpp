// SPDX-License-Identifier: MIT
#include "gui/widgets/card/picture_file.hpp"

#include <QByteArrayList>
#include <QFile>
#include <QImageReader>

#include <mutex>

#include "gui/viewmodels/paper_file.hpp"
#include "gui/viewmodels/words.hpp"

namespace planum::gui {

namespace {

// Qt's own limit is less than a large photo takes; ours is looked at before anything is unpacked.
void set_limit_once() {
    static std::once_flag once;
    constexpr qint64 kBytesOfPixel = 4;
    std::call_once(once, [] {
        QImageReader::setAllocationLimit(static_cast<int>(kMostPicturePixels * kBytesOfPixel / 1'000'000));
    });
}

// What is shown is photos and scanned sheets. Other kinds that Qt may have been given (vector drawings that name
// further files, say) are none of it.
bool is_shown(const QByteArray& format) {
    static const QByteArrayList kShown = {"jpeg", "jpg", "png", "tif", "tiff", "webp", "bmp", "gif"};
    return kShown.contains(format);
}

} // namespace

ReadPicture read_picture(const std::filesystem::path& project, const QString& path, QSize bounds) {
    set_limit_once();
    ReadPicture picture;
    const PaperFile paper = paper_file(project, path);
    picture.sentence = paper.sentence;
    if (!picture.sentence.isEmpty()) return picture;
    QFile file(qt(paper.file.string()));
    if (!file.open(QIODevice::ReadOnly)) {
        picture.sentence = picture_broken(path, file.errorString());
        return picture;
    }
    picture.sentence = picture_too_large(path, file.size(), 0, 0);
    if (!picture.sentence.isEmpty()) return picture;
    QImageReader reader(&file);
    reader.setDecideFormatFromContent(true);
    reader.setAutoTransform(true);
    if (!is_shown(reader.format())) {
        picture.sentence = picture_unknown(path);
        return picture;
    }
    const QSize size = reader.size();
    picture.sentence = picture_too_large(path, 0, size.width(), size.height());
    if (!picture.sentence.isEmpty()) return picture;
    const bool turned = reader.transformation().testFlag(QImageIOHandler::TransformationRotate90);
    const QSize room = turned ? bounds.transposed() : bounds;
    if (size.isValid() && (size.width() > room.width() || size.height() > room.height())) {
        reader.setScaledSize(size.scaled(room, Qt::KeepAspectRatio).expandedTo(QSize(1, 1)));
        reader.setQuality(60); // of a JPEG: smooth, yet unpacked at a fraction of its size
    }
    picture.image = reader.read();
    if (picture.image.isNull()) picture.sentence = picture_broken(path, reader.errorString());
    picture.whole = turned ? size.transposed() : size;
    return picture;
}

} // namespace planum::gui
