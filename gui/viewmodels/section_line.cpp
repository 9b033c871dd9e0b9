// SPDX-License-Identifier: MIT
#include "gui/viewmodels/section_line.hpp"

#include <algorithm>
#include <cmath>

#include "gui/viewmodels/words.hpp"

namespace planum::gui {

namespace {

constexpr double kShortest = 0.05; // [m] in plan: a shorter line has no direction worth the name

double apart(const SectionLine::Place& a, const SectionLine::Place& b) { return std::hypot(b[0] - a[0], b[1] - a[1]); }

} // namespace

SectionLine::SectionLine(Workspace& workspace, QObject* parent) : QObject(parent) {
    connect(&workspace, &Workspace::closed, this, &SectionLine::clear);
}

void SectionLine::begin() {
    from_.reset();
    to_.reset();
    objection_.clear();
    state_ = State::WantsFirst;
    emit changed();
}

void SectionLine::take(const Place& x_in_site) {
    if (!wants_place()) return;
    objection_.clear();
    if (state_ == State::WantsFirst) {
        from_ = x_in_site;
        state_ = State::WantsSecond;
    } else if (apart(*from_, x_in_site) < kShortest) {
        objection_ = tr("Too near the first one.");
    } else {
        to_ = x_in_site;
        state_ = State::Set;
    }
    emit changed();
}

void SectionLine::clear() {
    if (state_ == State::Off) return;
    from_.reset();
    to_.reset();
    objection_.clear();
    state_ = State::Off;
    emit changed();
}

void SectionLine::set_thickness(double thickness) {
    thickness_ = std::clamp(thickness, kThinnest, kThickest);
    emit changed();
}

double SectionLine::length() const { return state_ == State::Set ? apart(*from_, *to_) : 0.0; }

QString SectionLine::said() const {
    switch (state_) {
    case State::Off: return {};
    case State::WantsFirst: return tr("Click where the line begins.");
    case State::WantsSecond:
        return objection_.isEmpty() ? tr("Click where it ends.")
                                    : objection_ + QLatin1Char(' ') + tr("Click where it ends.");
    case State::Set: return tr("%1 m long").arg(number_word(length(), 2));
    }
    return {};
}

void SectionLine::hand_over() {
    if (state_ != State::Set) return;
    model::Section section;
    section.from_in_site = {(*from_)[0], (*from_)[1]};
    section.to_in_site = {(*to_)[0], (*to_)[1]};
    emit handedOver(section, thickness_);
}

} // namespace planum::gui
