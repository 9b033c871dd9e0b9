// SPDX-License-Identifier: MIT
#include "gui/widgets/space/flight_writer.hpp"

#include <QBuffer>

#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include "core/base/file.hpp"
#include "gui/render/flight.hpp"
#include "gui/viewmodels/words.hpp"

namespace planum::gui {

void FlightWriter::start(const std::vector<Camera>& cameras, const std::filesystem::path& folder, int frames) {
    stop();
    if (cameras.empty()) return;
    folder_ = folder;
    way_ = flight_along(cameras, frames);
    next_ = 0;
    ++flight_;
    emit flying(0, static_cast<int>(way_.size()));
    go_on();
}

std::filesystem::path FlightWriter::file_of(std::size_t frame) const {
    return folder_ / fmt::format("fly-{:04}.png", frame + 1);
}

void FlightWriter::stop() {
    if (!is_flying()) return;
    way_.clear();
    emit flown(static_cast<int>(next_));
}

void FlightWriter::go_on() {
    if (!is_flying()) return;
    if (next_ == way_.size()) {
        std::error_code refused; // then they stay; the flight itself is whole
        for (std::size_t former = next_; std::filesystem::remove(file_of(former), refused);) ++former;
        return stop();
    }
    const Camera camera = way_[next_];
    emit wanted(camera);
}

// The frame is on its way to the disk while nothing else is drawn: no frame is lost where the disk is slower.
void FlightWriter::take(const QImage& frame) {
    if (!is_flying()) return;
    const std::filesystem::path file = file_of(next_);
    jobs_.start(
        QStringLiteral("flight"), JobRunner::Queueing::InOrder, tr("Writing %1").arg(qt(file.filename().string())),
        Job::Kind::Quiet,
        [this, frame, file, flight = flight_](Progress&) -> JobRunner::Done {
            QByteArray bytes;
            QBuffer buffer(&bytes);
            frame.save(&buffer, "PNG");
            write_file_atomically(file, std::string_view(bytes.constData(), static_cast<std::size_t>(bytes.size())));
            return [this, flight] {
                if (!is_flying() || flight != flight_) return;
                ++next_;
                emit flying(static_cast<int>(next_), static_cast<int>(way_.size()));
                go_on();
            };
        },
        [this](const QString& sentence) {
            stop();
            emit troubled(sentence);
        });
}

} // namespace planum::gui
