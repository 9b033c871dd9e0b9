// SPDX-License-Identifier: MIT
#include "app/checks/contradiction_sheet.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "app/checks/contradicting_faces.hpp"
#include "app/checks/contradiction_cut.hpp"
#include "app/checks/contradiction_looks.hpp"
#include "app/checks/daily_check.hpp"
#include "app/checks/section_contradiction.hpp"
#include "app/scans/days_surface.hpp"
#include "app/suggestions/reasons.hpp"
#include "app/surfaces/surface_picture.hpp"
#include "core/base/error.hpp"
#include "core/geometry/polygon_overlay.hpp"

namespace planum::app {

namespace {

using geometry::SheetDash;
using geometry::SheetLook;

constexpr SheetLook kUpperGround{kUpperColour, 0.25, SheetDash::Solid, kUpperColour, 0.0};
constexpr SheetLook kLowerGround{kLowerColour, 0.25, SheetDash::Dashed, kLowerColour, 0.0};
constexpr SheetLook kUpperLine{kUpperColour, 0.8, SheetDash::Solid, kUpperColour, 0.0};
constexpr SheetLook kLowerLine{kLowerColour, 0.8, SheetDash::Dashed, kLowerColour, 0.0};
constexpr SheetLook kClashArea{kClashColour, 0.0, SheetDash::Solid, kClashColour, 0.30};

constexpr double kLetterBeyond = 0.0035;                   // of the ends of the line of the section [m on paper]
constexpr double kBothMaps = 0.154;                        // height of both maps on a page of A4 [m on paper]
constexpr std::array<double, 2> kLeastPlan = {0.09, 0.04}; // [m on paper]

geometry::MultiPolygon box(const geometry::Extent& e) {
    return {{{{e.low[0], e.low[1], 0.0},
              {e.high[0], e.low[1], 0.0},
              {e.high[0], e.high[1], 0.0},
              {e.low[0], e.high[1], 0.0}}}};
}

class SheetMaker {
  public:
    SheetMaker(Project& project, const ContradictingFaces& faces)
        : project_(project), record_(project.record()), faces_(faces), frame_(faces.before.frame) {}

    ContradictionSheet make(const model::Diagnostic& problem) {
        made_.upper = project_.index().name(faces_.units[static_cast<std::size_t>(faces_.upper)].id);
        made_.lower = project_.index().name(faces_.units[static_cast<std::size_t>(faces_.lower)].id);
        made_.before = surface_name(record_, *faces_.surface_before);
        made_.after = surface_name(record_, *faces_.surface_after);
        // As the text says it: the step weighs cells at the limit of what can be told in its own way.
        made_.area = static_cast<double>(faces_.clash.size()) * frame_.cell * frame_.cell;
        if (const auto told = problem.evidence.find("area_m2"); told != problem.evidence.end()) {
            if (const auto* area = std::get_if<double>(&told->second)) made_.area = *area;
        }
        const std::size_t worst = faces_.worst;
        made_.x = frame_.x(static_cast<std::int32_t>(worst % static_cast<std::size_t>(frame_.columns)));
        made_.y = frame_.y(static_cast<std::int32_t>(worst / static_cast<std::size_t>(frame_.columns)));
        made_.z_upper = static_cast<double>(faces_.before.height[worst]);
        made_.z_lower = static_cast<double>(faces_.after.height[worst]);
        cut_ = choose_cut(faces_, place(), made_.z_upper - made_.z_lower);
        std::string text = problem.message;
        if (!text.empty() && text.back() != '.') text += '.';
        made_.group.title = fmt::format("{} or {}: which lay above?", made_.upper, made_.lower);
        made_.group.text = std::move(text);
        made_.group.site = record_.settings.name;
        geometry::ScaledSheet below = section();
        const double height = (below.sheet.extent.high[1] - below.sheet.extent.low[1]) / below.scale;
        made_.group.sheets.push_back(plan(std::max(kContradictionHeight, kBothMaps - height)));
        made_.group.sheets.push_back(std::move(below));
        return std::move(made_);
    }

  private:
    [[nodiscard]] std::string day_before() const { return day_words(last_day_of(*faces_.surface_before)); }

    [[nodiscard]] std::string day_after() const { return day_words(last_day_of(*faces_.surface_after)); }

    [[nodiscard]] std::array<double, 2> place() const { return {made_.x, made_.y}; }

    // That, the section line and its letters with some room around.
    [[nodiscard]] geometry::Extent plan_extent(geometry::Extent seen, double scale) const {
        constexpr double kAround = 0.003; // [m on paper]
        constexpr double kLetter = 0.002; // half of one
        for (std::size_t k = 0; k < 2; ++k) {
            seen.low[k] -= kAround * scale;
            seen.high[k] += kAround * scale;
        }
        for (const double along : {-kLetterBeyond * scale, cut_.length + kLetterBeyond * scale}) {
            for (const double room : {-kLetter * scale, kLetter * scale})
                seen.add(cut_.at(along)[0] + room, cut_.at(along)[1] + room);
        }
        geometry::Extent extent;
        for (std::size_t k = 0; k < 2; ++k) {
            const double middle = 0.5 * (seen.low[k] + seen.high[k]);
            const double half = 0.5 * std::max(seen.high[k] - seen.low[k], kLeastPlan[k] * scale);
            extent.low[k] = middle - half;
            extent.high[k] = middle + half;
        }
        return extent;
    }

    // What the plan shows: both faces whole. Where they are so large that the contradiction would be a dot among them,
    // its surroundings only.
    void set_plan_extent(geometry::ScaledSheet& made, double height) const {
        constexpr double kLeastCut = 0.012; // [m on paper]
        const auto set = [&](const geometry::MultiPolygon& shown) {
            for (const double scale : kContradictionScales) {
                made.scale = scale;
                made.sheet.extent = plan_extent(geometry::extent(shown), scale);
                const auto& [low, high] = made.sheet.extent;
                if (high[0] - low[0] <= kContradictionWidth * scale && high[1] - low[1] <= height * scale) break;
            }
        };
        geometry::MultiPolygon both = faces_.face_before;
        both.insert(both.end(), faces_.face_after.begin(), faces_.face_after.end());
        set(both);
        made.sheet.title = "Both faces in plan";
        made.sheet.subtitle = fmt::format("ground of {} as relief", day_after());
        if (cut_.length >= kLeastCut * made.scale) return;
        set(box(faces_.extent));
        made.sheet.title = "Where they contradict, in plan";
        made.sheet.subtitle += "; the faces go on beyond the frame";
    }

    [[nodiscard]] geometry::ScaledSheet plan(double height) const {
        geometry::ScaledSheet made;
        geometry::MapSheet& sheet = made.sheet;
        set_plan_extent(made, height);
        sheet.pictures.push_back(shaded_relief(faces_.ground_after));
        sheet.pictures.push_back(clash_picture());
        const auto add_face = [&](const geometry::MultiPolygon& face, const SheetLook& look, const std::string& unit,
                                  const std::string& day) {
            sheet.shapes.push_back({face, look});
            const geometry::MultiPolygon visible = geometry::intersection(face, box(sheet.extent));
            sheet.keys.push_back({fmt::format("{} on {}", unit, day), look, geometry::SheetSign::None});
            if (visible.empty()) return;
            const auto [x, y] = place_off_line(visible, 0.007 * made.scale);
            sheet.labels.push_back({x, y, unit, day});
        };
        add_face(faces_.face_before, kUpperFace, made_.upper, day_before());
        add_face(faces_.face_after, kLowerFace, made_.lower, day_after());
        sheet.keys.push_back({fmt::format("{} above {}: {:.2f} m²", made_.upper, made_.lower, made_.area), kClashArea,
                              geometry::SheetSign::None});
        add_section_line(made);
        return made;
    }

    // The middle of a face, moved aside where the line of the section would run through the words.
    [[nodiscard]] std::array<double, 2> place_off_line(const geometry::MultiPolygon& face, double room) const {
        const std::array<double, 2> middle = geometry::inner_place(face);
        const double along = (middle[0] - cut_.from[0]) * cut_.way[0] + (middle[1] - cut_.from[1]) * cut_.way[1];
        const double off = (middle[1] - cut_.from[1]) * cut_.way[0] - (middle[0] - cut_.from[0]) * cut_.way[1];
        if (std::abs(off) >= room || along < -room || along > cut_.length + room) return middle;
        for (const double side : {off < 0.0 ? -room : room, off < 0.0 ? room : -room}) {
            const std::array moved = {middle[0] - (side - off) * cut_.way[1], middle[1] + (side - off) * cut_.way[0]};
            if (geometry::contains(face, moved[0], moved[1])) return moved;
        }
        return middle;
    }

    void add_section_line(geometry::ScaledSheet& plan) const {
        const double letter = kLetterBeyond * plan.scale;
        const auto a = cut_.at(0.0);
        const auto b = cut_.at(cut_.length);
        plan.sheet.lines.push_back({{{a[0], a[1], 0.0}, {b[0], b[1], 0.0}}, kMeasureLine});
        const auto outside_a = cut_.at(-letter);
        const auto outside_b = cut_.at(cut_.length + letter);
        plan.sheet.labels.insert(plan.sheet.labels.begin(),
                                 {{outside_a[0], outside_a[1], "A", {}}, {outside_b[0], outside_b[1], "B", {}}});
        const double tick = 0.002 * plan.scale;
        for (const auto& end : {a, b, place()})
            plan.sheet.lines.push_back({{{end[0] - tick * cut_.way[1], end[1] + tick * cut_.way[0], 0.0},
                                         {end[0] + tick * cut_.way[1], end[1] - tick * cut_.way[0], 0.0}},
                                        kMeasureLine});
    }

    // The cells that contradict, red over the relief.
    [[nodiscard]] geometry::SheetPicture clash_picture() const {
        geometry::SheetPicture picture;
        picture.left = static_cast<double>(frame_.west) * frame_.cell;
        picture.top = static_cast<double>(frame_.south + frame_.rows) * frame_.cell;
        picture.pixel = frame_.cell;
        picture.width = frame_.columns;
        picture.height = frame_.rows;
        picture.rgba.assign(4 * frame_.cells(), 0);
        const auto columns = static_cast<std::size_t>(frame_.columns);
        for (const std::size_t cell : faces_.clash) {
            const std::size_t row = static_cast<std::size_t>(frame_.rows) - 1 - cell / columns;
            const std::size_t at = 4 * (row * columns + cell % columns);
            for (std::size_t k = 0; k < 3; ++k)
                picture.rgba[at + k] = static_cast<std::uint8_t>(kClashColour >> (8 * (2 - k)) & 0xffU);
            picture.rgba[at + 3] = static_cast<std::uint8_t>(std::lround(255.0 * kClashArea.opacity));
        }
        return picture;
    }

    [[nodiscard]] geometry::ScaledSheet section() const {
        geometry::ScaledSheet made;
        made.scale = cut_.scale;
        geometry::MapSheet& sheet = made.sheet;
        const std::vector<FaceSample> along = samples_along(faces_, cut_);
        sheet.is_section = true;
        sheet.title = "Cross-section A–B through the worst place";
        sheet.subtitle =
            fmt::format("from {:.2f} {:.2f} to {:.2f} {:.2f}; heights and lengths in metres, not exaggerated",
                        cut_.at(0.0)[0], cut_.at(0.0)[1], cut_.at(cut_.length)[0], cut_.at(cut_.length)[1]);
        set_heights(along, sheet.extent);
        add_clash(along, sheet);
        const bool other_before = add_profile(
            along, {&FaceSample::before, &FaceSample::first, faces_.upper, kUpperLine, kUpperGround}, sheet);
        const bool other_after =
            add_profile(along, {&FaceSample::after, &FaceSample::then, faces_.lower, kLowerLine, kLowerGround}, sheet);
        add_measure(sheet);
        add_numbers(along, sheet);
        const auto add_key = [&](std::string text, const SheetLook& look) {
            sheet.keys.push_back({std::move(text), look, geometry::SheetSign::None});
        };
        add_key(fmt::format("{} on {}", made_.upper, day_before()), kUpperLine);
        if (other_before) add_key("other ground then", kUpperGround);
        add_key(fmt::format("{} on {}", made_.lower, day_after()), kLowerLine);
        if (other_after) add_key("other ground then", kLowerGround);
        add_key(fmt::format("{} above {}", made_.upper, made_.lower), kClashArea);
        return made;
    }

    // Both lines with room for words; a deep pit beside them is cut off.
    void set_heights(const std::vector<FaceSample>& along, geometry::Extent& extent) const {
        constexpr double kRoom = 0.010; // above and below, on paper [m]
        constexpr double kMost = 0.022; // above and below the middle
        const double middle = 0.5 * (made_.z_upper + made_.z_lower);
        double low = made_.z_lower;
        double high = made_.z_upper;
        for (const FaceSample& s : along) {
            for (const float z : {s.before, s.after}) {
                if (std::isnan(z)) continue;
                low = std::min(low, static_cast<double>(z));
                high = std::max(high, static_cast<double>(z));
            }
        }
        low = std::max(low, std::min(middle - kMost * cut_.scale, made_.z_lower));
        high = std::min(high, std::max(middle + kMost * cut_.scale, made_.z_upper));
        extent.low = {0.0, low - kRoom * cut_.scale};
        extent.high = {cut_.length, high + kRoom * cut_.scale};
    }

    struct Profile {
        float FaceSample::*height;
        scans::UnitNumber FaceSample::*unit;
        scans::UnitNumber own = scans::kNobody;
        SheetLook own_look;
        SheetLook other_look;
    };

    // Thick along the unit's own part, thin along the rest. Gaps of a cell or two are drawn through. Returns whether
    // there is such a rest.
    static bool add_profile(const std::vector<FaceSample>& along, const Profile& profile, geometry::MapSheet& sheet) {
        constexpr std::size_t kGap = 3;      // cells
        constexpr double kNoMatter = 0.0005; // too little to be seen on paper [m]
        bool any_rest = false;
        geometry::Line3 line;
        bool is_own = false;
        std::size_t last = 0;
        const auto finish = [&] {
            if (line.size() > 1) {
                any_rest = any_rest || !is_own;
                sheet.lines.push_back(
                    {geometry::simplified(line, kNoMatter), is_own ? profile.own_look : profile.other_look});
            }
            line.clear();
        };
        for (std::size_t i = 0; i < along.size(); ++i) {
            const FaceSample& s = along[i];
            if (std::isnan(s.*profile.height)) continue;
            const geometry::Point3 here = {s.along, static_cast<double>(s.*profile.height), 0.0};
            const bool own = s.*profile.unit == profile.own;
            if (!line.empty() && i - last > kGap) finish();
            if (!line.empty() && own != is_own) { // both meet where one passes into the other
                const geometry::Point3 before = line.back();
                if (!is_own) line.push_back(here);
                finish();
                if (!own) line.push_back(before);
            }
            is_own = own;
            line.push_back(here);
            last = i;
        }
        finish();
        return any_rest;
    }

    void add_clash(const std::vector<FaceSample>& along, geometry::MapSheet& sheet) const {
        for (std::size_t i = 0; i < along.size();) {
            if (!along[i].clash) {
                ++i;
                continue;
            }
            geometry::Line3 top;
            geometry::Line3 bottom;
            for (; i < along.size() && along[i].clash; ++i) {
                top.push_back({along[i].along, static_cast<double>(along[i].before), 0.0});
                bottom.push_back({along[i].along, static_cast<double>(along[i].after), 0.0});
            }
            top.insert(top.end(), bottom.rbegin(), bottom.rend());
            sheet.shapes.push_back({{{top}}, kClashArea});
        }
    }

    // A dimension line at the worst place, with both heights.
    void add_measure(geometry::MapSheet& sheet) const {
        const double x = cut_.worst;
        const int digits =
            made_.z_upper - made_.z_lower < 0.1 ? 3 : 2; // so that the heights agree with what is between
        const double tick = 0.0012 * cut_.scale;
        sheet.lines.push_back({{{x, made_.z_lower, 0.0}, {x, made_.z_upper, 0.0}}, kMeasureLine});
        for (const double z : {made_.z_lower, made_.z_upper})
            sheet.lines.push_back({{{x - tick, z, 0.0}, {x + tick, z, 0.0}}, kMeasureLine});
        const double beside = cut_.length - x < 0.02 * cut_.scale ? -0.009 : 0.009; // left of it at the right end
        sheet.labels.push_back({x + beside * cut_.scale,
                                0.5 * (made_.z_lower + made_.z_upper),
                                fmt::format("{:.{}f} m", made_.z_upper - made_.z_lower, digits),
                                {}});
        sheet.marks.push_back(
            {x, made_.z_upper, geometry::SheetSign::Level, fmt::format("{:.{}f}", made_.z_upper, digits)});
        sheet.labels.push_back({x, made_.z_lower, {}, fmt::format("{:.{}f}", made_.z_lower, digits)});
    }

    // Every unit that a line meets over 12 mm on paper: those before above the lines, those after below.
    void add_numbers(const std::vector<FaceSample>& along, geometry::MapSheet& sheet) const {
        add_numbers(along, &FaceSample::before, &FaceSample::first, 0.0045 * cut_.scale, sheet);
        add_numbers(along, &FaceSample::after, &FaceSample::then, -0.0045 * cut_.scale, sheet);
    }

    void add_numbers(const std::vector<FaceSample>& along, float FaceSample::*height,
                     scans::UnitNumber FaceSample::*unit, double off, geometry::MapSheet& sheet) const {
        constexpr double kLeast = 0.012; // [m on paper]
        for (std::size_t i = 0; i < along.size();) {
            std::size_t end = i;
            while (end < along.size() && along[end].*unit == along[i].*unit) ++end;
            const double length = static_cast<double>(end - i) * frame_.cell;
            const FaceSample& middle = along[i + (end - i) * 2 / 5]; // beside the dimension line
            const scans::UnitNumber number = along[i].*unit;
            const double z = static_cast<double>(middle.*height) + off;
            if (number != scans::kNobody && length >= kLeast * cut_.scale && !std::isnan(z) &&
                z < sheet.extent.high[1] && z > sheet.extent.low[1])
                sheet.labels.push_back(
                    {middle.along, z, project_.index().name(faces_.units[static_cast<std::size_t>(number)].id), {}});
            i = end;
        }
    }

    Project& project_;
    const model::Record& record_;
    const ContradictingFaces& faces_;
    const scans::GridFrame& frame_;
    ContradictionSheet made_;
    FaceCut cut_;
};

const model::Diagnostic& problem_with(const DailyCheck& check, std::string_view id) {
    for (const auto* list : {&check.problems, &check.accepted}) {
        for (const model::Diagnostic& problem : *list) {
            if (problem.id != id) continue;
            if (problem.code == "height-contradiction") return problem;
            throw Error(ErrorCode::Usage,
                        fmt::format("{} is a {}; only a height-contradiction can be shown as faces and cross-section",
                                    id, problem.code));
        }
    }
    throw Error(ErrorCode::NotFound, fmt::format("no problem has the id {}; planum check lists them", id));
}

} // namespace

ContradictionSheet contradiction_sheet(Project& project, std::string_view id, const std::string& interpretation,
                                       Progress& progress) {
    const DailyCheck check = check_project(project, interpretation, progress);
    const model::Diagnostic& problem = problem_with(check, id);
    if (is_seen_in_section(problem)) return section_contradiction(project, problem, progress);
    const ContradictingFaces faces = contradicting_faces(project, problem, progress);
    return SheetMaker(project, faces).make(problem);
}

} // namespace planum::app
