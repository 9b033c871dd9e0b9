// SPDX-License-Identifier: MIT
#pragma once

#include <QImage>
#include <QObject>

#include <filesystem>
#include <vector>

#include "gui/render/camera.hpp"
#include "gui/viewmodels/job.hpp"

namespace planum::gui {

/// The frames of a flight on their way to the disk: it says which camera is next, somebody draws what that sees and
/// hands the picture in.
class FlightWriter : public QObject {
    Q_OBJECT

  public:
    explicit FlightWriter(JobRunner& jobs) : jobs_(jobs) {}

    /// Begins the way along these cameras, so many frames from each to the next, as `fly-0001.png` and so on in
    /// `folder`. When all are there, frames of a longer flight that stood there before go: a film made of the folder
    /// would end with them. Another flight that goes on is given up; without a camera nothing happens.
    void start(const std::vector<Camera>& cameras, const std::filesystem::path& folder, int frames);
    /// Ends it with the frames that are written; nothing where none goes on.
    void stop();

    [[nodiscard]] bool is_flying() const noexcept { return !way_.empty(); }

    /// The picture of the camera that wanted() named.
    void take(const QImage& frame);

  signals:
    /// The next picture: take() is waited for.
    void wanted(const planum::gui::Camera& camera);
    /// Frames written of all.
    void flying(int written, int all);
    /// It ended with so many frames.
    void flown(int written);
    void troubled(const QString& sentence);

  private:
    void go_on();
    [[nodiscard]] std::filesystem::path file_of(std::size_t frame) const;

    JobRunner& jobs_;
    std::filesystem::path folder_;
    std::vector<Camera> way_; ///< empty: no flight goes on
    std::size_t next_ = 0;
    std::size_t flight_ = 0; ///< counts flights: a frame of an earlier one that reaches the disk late moves nothing on
};

} // namespace planum::gui
