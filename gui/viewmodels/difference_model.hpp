// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <QString>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/surfaces/height_change.hpp"
#include "gui/viewmodels/workspace.hpp"

namespace planum::gui {

class TimeModel;

/// Colours of ground in plan, cell by cell.
struct GroundColours {
    double low_x = 0.0; ///< of the south-western corner, site [m]
    double low_y = 0.0;
    double cell = 0.02; ///< [m]
    int columns = 0;
    int rows = 0;
    std::vector<std::uint32_t> rgb; ///< row by row from the south, 0xRRGGBB; 0: not compared
};

/// What the colours of a difference mean.
struct DifferenceKey {
    double span = 0.0;       ///< the strongest colours stand for this and more [m]
    double detectable = 0.0; ///< median: what is closer is grey [m]
    QString lower;           ///< lower than the other surface
    QString higher;
    QString summary; ///< areas in words
};

/// By how much the surface of the time line lies above or below another one of its area: the one before, unless
/// somebody chose. Compared beside the window, while somebody looks.
class DifferenceModel : public QObject {
    Q_OBJECT

  public:
    struct Choice {
        model::SurfaceId surface;
        QString name;
    };

    DifferenceModel(Workspace& workspace, TimeModel& time, QObject* parent = nullptr);

    void set_watched(bool watched);

    /// Surfaces of the same area, in time.
    [[nodiscard]] std::vector<Choice> choices() const;

    /// What is compared with; nil: there is none.
    [[nodiscard]] model::SurfaceId other() const;

    /// Until another surface is shown that has it not beside it.
    void compare_with(model::SurfaceId other);

    /// Null: nothing is compared, or not yet.
    [[nodiscard]] const std::shared_ptr<const GroundColours>& colours() const noexcept { return colours_; }

    [[nodiscard]] const DifferenceKey& key() const noexcept { return key_; }

    /// Why there are no colours; empty where there are.
    [[nodiscard]] const QString& said() const noexcept { return said_; }

  signals:
    void changed();

  private:
    /// What a comparison was made from.
    struct Made {
        model::SurfaceId surface;
        model::SurfaceId other;
        std::string heights; ///< hashes of what either is made from

        friend bool operator==(const Made&, const Made&) = default;
    };

    void compare();
    void take(std::shared_ptr<const GroundColours> colours, DifferenceKey key, const QString& said);

    Workspace& workspace_;
    TimeModel& time_;
    model::SurfaceId chosen_;
    bool watched_ = false;
    std::optional<Made> made_;
    std::shared_ptr<const GroundColours> colours_;
    DifferenceKey key_;
    QString said_;
};

/// Grey where a difference cannot be told from none, else from pale to strong: orange where the ground is lower, blue
/// where it is higher, which all eyes tell apart. Never 0.
[[nodiscard]] std::uint32_t difference_colour(double change, double detectable, double span) noexcept;

/// The difference that the strongest colours stand for: a round number [m] that 98 of 100 detectable ones keep below.
[[nodiscard]] double difference_span(const app::HeightChange& change);

/// At most 3,000 cells along either side; others are left out between them.
[[nodiscard]] GroundColours colours_of(const app::HeightChange& change, double span);

} // namespace planum::gui
