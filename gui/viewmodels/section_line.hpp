// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <QString>

#include <array>
#include <optional>

#include "core/model/place.hpp"
#include "gui/viewmodels/workspace.hpp"

namespace planum::gui {

/// A line across the site through two places that somebody points at in 3D: what lies beside it is cut away there, and
/// the section view can show it. It is a way of looking, no section of the record, and goes with the project.
class SectionLine : public QObject {
    Q_OBJECT

  public:
    enum class State { Off, WantsFirst, WantsSecond, Set };
    using Place = std::array<double, 3>; ///< site [m]

    static constexpr double kThinnest = 0.02; ///< [m]
    static constexpr double kThickest = 20.0;

    explicit SectionLine(Workspace& workspace, QObject* parent = nullptr);

    [[nodiscard]] State state() const noexcept { return state_; }

    /// Whether the next place pointed at is an end of the line.
    [[nodiscard]] bool wants_place() const noexcept {
        return state_ == State::WantsFirst || state_ == State::WantsSecond;
    }

    /// A new line; the former one goes.
    void begin();
    /// The next end. One straight above the first makes no line and is left aside.
    void take(const Place& x_in_site);
    void clear();

    void set_thickness(double thickness); ///< between both planes [m]; kept from one line to the next

    [[nodiscard]] double thickness() const noexcept { return thickness_; }

    /// Both ends are places once it is Set, the first one before.
    [[nodiscard]] const std::optional<Place>& from() const noexcept { return from_; }

    [[nodiscard]] const std::optional<Place>& to() const noexcept { return to_; }

    /// In plan [m]; 0 unless it is Set.
    [[nodiscard]] double length() const;

    /// What to do next, or how long it is.
    [[nodiscard]] QString said() const;

    /// Shows it in the section view; nothing happens unless it is Set.
    void hand_over();

  signals:
    void changed();
    void handedOver(const planum::model::Section& section, double thickness);

  private:
    State state_ = State::Off;
    std::optional<Place> from_;
    std::optional<Place> to_;
    double thickness_ = 0.1;
    QString objection_; ///< why the last place was not taken
};

} // namespace planum::gui
