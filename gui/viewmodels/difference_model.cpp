// SPDX-License-Identifier: MIT
#include "gui/viewmodels/difference_model.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "app/scans/days_surface.hpp"
#include "app/surfaces/recorded_surface.hpp"
#include "app/surfaces/surface_cache.hpp"
#include "gui/viewmodels/time_model.hpp"
#include "gui/viewmodels/words.hpp"

namespace planum::gui {

namespace {

constexpr int kMostCells = 3000;          // along either side
constexpr std::uint32_t kSame = 0x8f8f8f; // cannot be told from none
using Rgb = std::array<double, 3>;

std::uint32_t mixed(const Rgb& pale, const Rgb& strong, double share) {
    std::uint32_t rgb = 0;
    for (std::size_t c = 0; c < 3; ++c)
        rgb = rgb << 8U | static_cast<std::uint32_t>(std::lround(pale[c] + (strong[c] - pale[c]) * share));
    return rgb;
}

const model::Surface* surface_of(const model::Record& record, model::SurfaceId id) {
    const auto found =
        std::find_if(record.surfaces.begin(), record.surfaces.end(), [&](const auto& s) { return s.id == id; });
    return found == record.surfaces.end() ? nullptr : &*found;
}

} // namespace

std::uint32_t difference_colour(double change, double detectable, double span) noexcept {
    constexpr Rgb kPaleLower = {254, 217, 166};
    constexpr Rgb kLower = {200, 62, 10};
    constexpr Rgb kPaleHigher = {190, 220, 245};
    constexpr Rgb kHigher = {20, 92, 190};
    if (std::abs(change) <= detectable) return kSame;
    const double share = std::clamp(std::abs(change) / std::max(span, 1e-6), 0.0, 1.0);
    return change < 0.0 ? mixed(kPaleLower, kLower, share) : mixed(kPaleHigher, kHigher, share);
}

double difference_span(const app::HeightChange& change) {
    constexpr std::array kRound = {0.02, 0.05, 0.1, 0.2, 0.3, 0.5, 1.0, 2.0, 3.0, 5.0, 10.0};
    std::vector<float> sizes;
    for (std::size_t i = 0; i < change.change.size(); ++i) {
        const float size = std::abs(change.change[i]);
        if (size > change.detectable[i]) sizes.push_back(size); // false where either is not a number
    }
    if (sizes.empty()) return kRound.front();
    const auto at = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() * 98 / 100);
    std::nth_element(sizes.begin(), at, sizes.end());
    const auto round = std::lower_bound(kRound.begin(), kRound.end(), static_cast<double>(*at));
    return round == kRound.end() ? kRound.back() : *round;
}

GroundColours colours_of(const app::HeightChange& change, double span) {
    const int step = std::max(1, (std::max(change.columns, change.rows) + kMostCells - 1) / kMostCells);
    GroundColours colours;
    colours.low_x = change.low_x;
    colours.low_y = change.low_y;
    colours.cell = change.cell * step;
    colours.columns = (change.columns + step - 1) / step;
    colours.rows = (change.rows + step - 1) / step;
    colours.rgb.reserve(static_cast<std::size_t>(colours.columns) * static_cast<std::size_t>(colours.rows));
    for (int row = 0; row < change.rows; row += step) {
        for (int column = 0; column < change.columns; column += step) {
            const auto at = static_cast<std::size_t>(row) * static_cast<std::size_t>(change.columns) +
                            static_cast<std::size_t>(column);
            const auto here = static_cast<double>(change.change[at]);
            colours.rgb.push_back(
                std::isnan(here) ? 0 : difference_colour(here, static_cast<double>(change.detectable[at]), span));
        }
    }
    return colours;
}

DifferenceModel::DifferenceModel(Workspace& workspace, TimeModel& time, QObject* parent)
    : QObject(parent), workspace_(workspace), time_(time) {
    connect(&time_, &TimeModel::moved, this, &DifferenceModel::compare);
    connect(&workspace_, &Workspace::snapshotChanged, this, &DifferenceModel::compare);
    connect(&workspace_, &Workspace::closed, this, [this] {
        chosen_ = {};
        made_.reset();
        take(nullptr, {}, {});
    });
}

void DifferenceModel::set_watched(bool watched) {
    watched_ = watched;
    compare();
}

std::vector<DifferenceModel::Choice> DifferenceModel::choices() const {
    std::vector<Choice> choices;
    if (!workspace_.is_open()) return choices;
    const model::Record& record = workspace_.snapshot()->record();
    const model::Surface* shown = surface_of(record, time_.surface());
    if (shown == nullptr) return choices;
    for (const model::Surface* surface : app::surfaces_in_time(record, shown->area)) {
        if (surface != shown) choices.push_back({surface->id, qt(app::surface_name(record, *surface))});
    }
    return choices;
}

// The one before the surface that is shown; of the first one, the one after.
model::SurfaceId DifferenceModel::other() const {
    const std::vector<Choice> all = choices();
    if (all.empty()) return {};
    if (std::any_of(all.begin(), all.end(), [&](const Choice& c) { return c.surface == chosen_; })) return chosen_;
    const model::Record& record = workspace_.snapshot()->record();
    model::SurfaceId before;
    for (const model::Surface* surface : app::surfaces_in_time(record, surface_of(record, time_.surface())->area)) {
        if (surface->id == time_.surface()) break;
        before = surface->id;
    }
    return before.is_nil() ? all.front().surface : before;
}

void DifferenceModel::compare_with(model::SurfaceId other) {
    chosen_ = other;
    compare();
}

void DifferenceModel::compare() {
    if (!watched_ || !workspace_.is_open()) return;
    const model::Record& record = workspace_.snapshot()->record();
    const auto key = [&](model::SurfaceId id) {
        return id.is_nil() ? std::string() : app::surface_key(record, id, {});
    };
    const Made wanted{time_.surface(), other(), key(time_.surface()) + key(other())};
    if (wanted == made_) return emit changed(); // names of surfaces may be others
    made_ = wanted;
    if (wanted.other.is_nil()) return take(nullptr, {}, tr("There is no other surface of this area to compare with."));
    take(nullptr, {}, tr("comparing the surfaces …"));
    workspace_.read(
        QStringLiteral("difference"), tr("Comparing surfaces"),
        [this, wanted](app::Project& project, Progress& progress) -> JobRunner::Done {
            const app::HeightChange change = app::height_change(project, wanted.other, wanted.surface, progress);
            const double span = difference_span(change);
            auto colours = std::make_shared<const GroundColours>(colours_of(change, span));
            return [this, wanted, colours, span, report = change.report] {
                if (wanted != made_) return;
                const auto area = [](double value) { return number_word(value, 2); };
                DifferenceKey shown;
                shown.span = span;
                shown.detectable = report.detectable;
                shown.lower = tr("lower than %1").arg(qt(report.before));
                shown.higher = tr("higher than %1").arg(qt(report.before));
                shown.summary =
                    tr("of %1 m² compared, %2 m² lower, %3 m² higher")
                        .arg(area(report.compared_area), area(report.lowered_area), area(report.raised_area));
                const QString none = tr("%1 and %2 saw no ground in common.").arg(qt(report.before), qt(report.after));
                if (report.compared_area <= 0.0) return take(nullptr, {}, none);
                take(colours, shown, {});
            };
        },
        [this, wanted](const QString& sentence) {
            if (wanted == made_) take(nullptr, {}, sentence);
        });
}

void DifferenceModel::take(std::shared_ptr<const GroundColours> colours, DifferenceKey key, const QString& said) {
    colours_ = std::move(colours);
    key_ = std::move(key);
    said_ = said;
    emit changed();
}

} // namespace planum::gui
