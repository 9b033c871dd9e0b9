// SPDX-License-Identifier: MIT
#include "app/checks/section_contradiction.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "app/checks/contradiction_looks.hpp"
#include "app/evidence/section_evidence.hpp"
#include "app/scans/days_surface.hpp"
#include "app/suggestions/reasons.hpp"
#include "app/surfaces/section_sheet.hpp"
#include "core/base/error.hpp"
#include "core/geometry/polygon_overlay.hpp"
#include "core/geometry/polygons.hpp"

namespace planum::app {

namespace {

using geometry::SheetDash;
using geometry::SheetLook;

constexpr SheetLook kOther{0x6b6760, 0.25, SheetDash::Solid, 0xffffff, 0.0};
constexpr SheetLook kContact{kClashColour, 1.2, SheetDash::Solid, kClashColour, 0.0};
constexpr double kColumn = 0.02;       // as sections are walked [m]
constexpr double kWordsBeside = 0.014; // middle of the words of a dimension line from that line [m on paper]

// The section whose contact is longest, as the checks take it.
SectionEvidence find_evidence(const model::Record& record, const model::Diagnostic& problem) {
    if (problem.units.size() == 2) {
        for (const SectionEvidence& one : proven_by_sections(section_evidence(record))) {
            if (one.upper == problem.units[1] && one.lower == problem.units[0]) return one;
        }
    }
    throw Error(ErrorCode::Conflict, "no section shows this contradiction any more; check again");
}

std::array<double, 2> site_at(const model::Section& section, double along) {
    const double dx = section.to_in_site[0] - section.from_in_site[0];
    const double dy = section.to_in_site[1] - section.from_in_site[1];
    const double length = std::hypot(dx, dy);
    return {section.from_in_site[0] + along * dx / length, section.from_in_site[1] + along * dy / length};
}

class SectionMaker {
  public:
    SectionMaker(Project& project, const SectionEvidence& evidence, const model::Section& section, Progress& progress)
        : project_(project), record_(project.record()), evidence_(evidence), section_(section),
          shown_(shown_in_section(record_, project.index(), section)),
          columns_(scans::contact_columns(shown_.regions, evidence.contact.upper, evidence.contact.lower, kColumn)),
          progress_(progress) {}

    ContradictionSheet make(const model::Diagnostic& problem) {
        worst_ = worst_column();
        made_.upper = project_.index().name(evidence_.upper);
        made_.lower = project_.index().name(evidence_.lower);
        made_.section = section_.name;
        made_.length = evidence_.contact.length;
        const auto [x, y] = site_at(section_, worst_.along);
        made_.x = x;
        made_.y = y;
        made_.z_upper = worst_.upper;
        made_.z_lower = worst_.lower;
        made_.group.title = fmt::format("{} or {}: which lies above?", made_.upper, made_.lower);
        made_.group.text = problem.message;
        if (!made_.group.text.empty() && made_.group.text.back() != '.') made_.group.text += '.';
        made_.group.site = record_.settings.name;
        made_.group.sheets.push_back(whole());
        geometry::ScaledSheet larger = detail();
        if (larger.scale < made_.group.sheets.front().scale) {
            made_.group.sheets.push_back(std::move(larger));
        } else { // large enough already
            add_measures(made_.group.sheets.front());
        }
        return std::move(made_);
    }

  private:
    // Median over five columns, so that a single corner of a line does not decide.
    [[nodiscard]] scans::ContactColumn worst_column() const {
        const auto thinner = [](const scans::ContactColumn& c) {
            return std::min(c.top - c.upper, c.lower - c.bottom);
        };
        const double middle = 0.5 * (columns_.front().along + columns_.back().along);
        std::pair<double, double> best{-1e300, 0.0};
        scans::ContactColumn worst = columns_.front();
        for (const scans::ContactColumn& column : columns_) {
            std::vector<double> around;
            for (const scans::ContactColumn& near : columns_) {
                if (std::abs(near.along - column.along) < 2.5 * kColumn) around.push_back(thinner(near));
            }
            std::sort(around.begin(), around.end());
            // To a centimetre; of places as good the one nearest to the middle.
            const std::pair here{std::round(100.0 * around[around.size() / 2]), -std::abs(column.along - middle)};
            if (here <= best) continue;
            best = here;
            worst = column;
        }
        return worst;
    }

    [[nodiscard]] std::string name(scans::UnitNumber unit) const {
        return project_.index().name(shown_.units[static_cast<std::size_t>(unit)].id);
    }

    // Both units with room for words, at the largest scale that holds them.
    [[nodiscard]] geometry::ScaledSheet whole() const {
        geometry::Extent pair;
        for (const scans::SectionRegion& region : shown_.regions) {
            if (region.unit == evidence_.contact.upper || region.unit == evidence_.contact.lower)
                pair.add(geometry::extent(region.shape));
        }
        const double wide = 1.1 * (pair.high[0] - pair.low[0]);
        const double high = 1.1 * (pair.high[1] - pair.low[1]);
        geometry::ScaledSheet sheet;
        sheet.scale = contradiction_scale({wide, high}, {kContradictionWidth, kContradictionHeight});
        const std::array<double, 2> middle = {0.5 * (pair.low[0] + pair.high[0]), 0.5 * (pair.low[1] + pair.high[1])};
        set_extent(sheet, middle, std::max(high, 0.5 * kContradictionHeight * sheet.scale));
        sheet.sheet.title = fmt::format("Section {} with both outlines", section_.name);
        sheet.sheet.subtitle = place_words(sheet.sheet.extent);
        add_all(sheet);
        return sheet;
    }

    [[nodiscard]] geometry::ScaledSheet detail() const {
        constexpr double kMost = 0.088; // of both on paper [m]
        geometry::ScaledSheet sheet;
        sheet.scale = kContradictionScales.back();
        for (const double scale : kContradictionScales) {
            if (worst_.top - worst_.bottom > kMost * scale) continue;
            sheet.scale = scale;
            break;
        }
        set_extent(sheet, {worst_.along, 0.5 * (worst_.top + worst_.bottom)},
                   worst_.top - worst_.bottom + 0.024 * sheet.scale);
        sheet.sheet.title = "The worst place";
        sheet.sheet.subtitle =
            "where the thinner of the two is thickest; heights and lengths in metres, not exaggerated";
        add_all(sheet);
        add_measures(sheet);
        return sheet;
    }

    static void set_extent(geometry::ScaledSheet& sheet, const std::array<double, 2>& middle, double high) {
        sheet.sheet.is_section = true;
        const double half = 0.5 * kContradictionWidth * sheet.scale;
        sheet.sheet.extent.low = {middle[0] - half, middle[1] - 0.5 * high};
        sheet.sheet.extent.high = {middle[0] + half, middle[1] + 0.5 * high};
    }

    [[nodiscard]] std::string place_words(const geometry::Extent& extent) const {
        const auto a = site_at(section_, extent.low[0]);
        const auto b = site_at(section_, extent.high[0]);
        return fmt::format("{}from {:.2f} {:.2f} to {:.2f} {:.2f}",
                           section_.day.empty() ? "" : "drawn " + day_words(section_.day) + ", ", a[0], a[1], b[0],
                           b[1]);
    }

    void add_all(geometry::ScaledSheet& sheet) const {
        add_picture(sheet.sheet);
        const geometry::Extent& e = sheet.sheet.extent;
        const geometry::MultiPolygon window = {{{{e.low[0], e.low[1], 0.0},
                                                 {e.high[0], e.low[1], 0.0},
                                                 {e.high[0], e.high[1], 0.0},
                                                 {e.low[0], e.high[1], 0.0}}}};
        for (const bool own : {false, true}) { // theirs over the others'
            for (const scans::SectionRegion& region : shown_.regions) {
                const bool is_upper = region.unit == evidence_.contact.upper;
                const bool is_own = is_upper || region.unit == evidence_.contact.lower;
                if (is_own != own) continue;
                const SheetLook& look = !is_own ? kOther : is_upper ? kUpperFace : kLowerFace;
                sheet.sheet.shapes.push_back({region.shape, look});
                add_label(region, window, sheet);
            }
        }
        add_contact(sheet.sheet);
        sheet.sheet.keys = {{made_.upper, kUpperFace, geometry::SheetSign::None},
                            {made_.lower, kLowerFace, geometry::SheetSign::None},
                            {fmt::format("{} on {}: {:.2f} m", made_.upper, made_.lower, made_.length), kContact,
                             geometry::SheetSign::None}};
    }

    void add_label(const scans::SectionRegion& region, const geometry::MultiPolygon& window,
                   geometry::ScaledSheet& sheet) const {
        const double room = 0.004 * sheet.scale;
        const geometry::MultiPolygon visible = geometry::intersection(region.shape, window);
        if (visible.empty() || geometry::area(visible) < room * room) return;
        std::array<double, 2> place = geometry::inner_place(visible);
        // Beside the dimension line and its words.
        const double left = worst_.along - 0.016 * sheet.scale;
        if (std::abs(place[0] - worst_.along) < 0.016 * sheet.scale && geometry::contains(visible, left, place[1]))
            place[0] = left;
        sheet.sheet.labels.push_back({place[0], place[1], name(region.unit), {}});
    }

    // Lines along the contact; where columns are missing between, a new one.
    void add_contact(geometry::MapSheet& sheet) const {
        geometry::Line3 line;
        const auto finish = [&] {
            if (!line.empty()) {
                // A column stands for its whole width.
                line.insert(line.begin(), {line.front()[0] - 0.5 * kColumn, line.front()[1], 0.0});
                line.push_back({line.back()[0] + 0.5 * kColumn, line.back()[1], 0.0});
                sheet.lines.push_back({line, kContact});
            }
            line.clear();
        };
        for (const scans::ContactColumn& column : columns_) {
            if (!line.empty() && column.along - line.back()[0] > 1.5 * kColumn) finish();
            line.push_back({column.along, column.height(), 0.0});
        }
        finish();
    }

    // How thick both are at the worst place, with the height of the contact.
    void add_measures(geometry::ScaledSheet& sheet) const {
        const double x = worst_.along;
        const double tick = 0.0012 * sheet.scale;
        const auto measure = [&](double low, double high, const std::string& unit) {
            sheet.sheet.lines.push_back({{{x, low, 0.0}, {x, high, 0.0}}, kMeasureLine});
            for (const double z : {low, high})
                sheet.sheet.lines.push_back({{{x - tick, z, 0.0}, {x + tick, z, 0.0}}, kMeasureLine});
            sheet.sheet.labels.push_back({x + kWordsBeside * sheet.scale,
                                          0.5 * (low + high),
                                          fmt::format("{}: {:.2f} m", unit, high - low),
                                          {}});
        };
        measure(worst_.height(), worst_.top, made_.upper);
        measure(worst_.bottom, worst_.height(), made_.lower);
        sheet.sheet.marks.push_back(
            {x, worst_.height(), geometry::SheetSign::Level, fmt::format("{:.2f}", worst_.height())});
    }

    // What the scans of the day of the section show; without any the outlines stand alone.
    void add_picture(geometry::MapSheet& sheet) const {
        const model::Surface* surface =
            section_.day.empty() ? nullptr : surface_on_day(record_.surfaces, section_.area, section_.day);
        if (surface == nullptr) return;
        SectionRequest request;
        request.surface = surface_name(record_, *surface);
        request.from = site_at(section_, sheet.extent.low[0]);
        request.to = site_at(section_, sheet.extent.high[0]);
        try {
            for (geometry::SheetPicture& picture : section_sheet(project_, request, progress_).sheet.pictures) {
                if (!soften(picture)) continue;
                picture.left += sheet.extent.low[0];
                sheet.pictures.push_back(std::move(picture));
            }
        } catch (const Error& e) {
            if (e.code() == ErrorCode::Cancelled) throw;
            // Points that are missing, or none in the plane: the outlines are what contradicts.
        }
    }

    // Half clear, so that lines and words stay on top. False: points that are all black, from scans with neither
    // colour nor reflectance, show nothing.
    static bool soften(geometry::SheetPicture& picture) {
        bool shows = false;
        for (std::size_t i = 0; i + 3 < picture.rgba.size(); i += 4) {
            shows =
                shows || (picture.rgba[i + 3] > 0 && picture.rgba[i] + picture.rgba[i + 1] + picture.rgba[i + 2] > 0);
            picture.rgba[i + 3] = static_cast<std::uint8_t>(picture.rgba[i + 3] / 2);
        }
        return shows;
    }

    Project& project_;
    const model::Record& record_;
    const SectionEvidence& evidence_;
    const model::Section& section_;
    const ShownSection shown_;
    const std::vector<scans::ContactColumn> columns_;
    Progress& progress_;
    ContradictionSheet made_;
    scans::ContactColumn worst_;
};

} // namespace

bool is_seen_in_section(const model::Diagnostic& problem) { return problem.evidence.contains("length_m"); }

ContradictionSheet section_contradiction(Project& project, const model::Diagnostic& problem, Progress& progress) {
    const model::Record& record = project.record();
    const SectionEvidence evidence = find_evidence(record, problem);
    const auto section = std::find_if(record.sections.begin(), record.sections.end(),
                                      [&](const model::Section& s) { return s.id == evidence.section; });
    return SectionMaker(project, evidence, *section, progress).make(problem);
}

} // namespace planum::app
