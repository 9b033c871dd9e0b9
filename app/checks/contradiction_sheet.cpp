// SPDX-License-Identifier: MIT
#include "app/checks/contradiction_sheet.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "app/checks/contradicting_faces.hpp"
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

geometry::MultiPolygon box(const geometry::Extent& e) {
    return {{{{e.low[0], e.low[1], 0.0},
              {e.high[0], e.low[1], 0.0},
              {e.high[0], e.high[1], 0.0},
              {e.low[0], e.high[1], 0.0}}}};
}

// What a cross-section meets, cell by cell.
struct Sample {
    double along = 0.0; // [m]
    float before = 0.0F;
    float after = 0.0F;
    scans::UnitNumber first = scans::kNobody;
    scans::UnitNumber then = scans::kNobody;
    bool clash = false;
};

// From A, `length` long, in the direction given.
struct Cut {
    std::array<double, 2> from{}; // [m, site]
    std::array<double, 2> way{};  // unit vector
    double length = 0.0;

    [[nodiscard]] std::array<double, 2> at(double along) const {
        return {from[0] + along * way[0], from[1] + along * way[1]};
    }
};

class SheetMaker {
  public:
    SheetMaker(Project& project, const ContradictingFaces& faces)
        : project_(project), record_(project.record()), faces_(faces), frame_(faces.before.frame) {}

    ContradictionSheet make(const model::Diagnostic& problem) {
        made_.upper = project_.index().name(faces_.units[static_cast<std::size_t>(faces_.upper)].id);
        made_.lower = project_.index().name(faces_.units[static_cast<std::size_t>(faces_.lower)].id);
        made_.before = surface_name(record_, *faces_.surface_before);
        made_.after = surface_name(record_, *faces_.surface_after);
        made_.area = static_cast<double>(faces_.clash.size()) * frame_.cell * frame_.cell;
        const std::size_t worst = faces_.worst;
        made_.x = frame_.x(static_cast<std::int32_t>(worst % static_cast<std::size_t>(frame_.columns)));
        made_.y = frame_.y(static_cast<std::int32_t>(worst / static_cast<std::size_t>(frame_.columns)));
        made_.z_upper = static_cast<double>(faces_.before.height[worst]);
        made_.z_lower = static_cast<double>(faces_.after.height[worst]);
        choose_cut();
        std::string text = problem.message;
        if (!text.empty() && text.back() != '.') text += '.';
        made_.group.title = fmt::format("{} or {}: which lay above?", made_.upper, made_.lower);
        made_.group.text = std::move(text);
        made_.group.site = record_.settings.name;
        made_.group.sheets.push_back(plan());
        made_.group.sheets.push_back(section());
        return std::move(made_);
    }

  private:
    [[nodiscard]] std::string day_before() const { return day_words(last_day_of(*faces_.surface_before)); }

    [[nodiscard]] std::string day_after() const { return day_words(last_day_of(*faces_.surface_after)); }

    [[nodiscard]] std::optional<std::size_t> cell_at(const std::array<double, 2>& p) const {
        const double column = std::floor(p[0] / frame_.cell) - static_cast<double>(frame_.west);
        const double row = std::floor(p[1] / frame_.cell) - static_cast<double>(frame_.south);
        if (!(column >= 0.0 && row >= 0.0 && column < frame_.columns && row < frame_.rows)) return std::nullopt;
        return frame_.at(static_cast<std::int32_t>(row), static_cast<std::int32_t>(column));
    }

    [[nodiscard]] std::vector<Sample> samples(const Cut& cut) const {
        std::vector<Sample> all;
        for (double along = 0.5 * frame_.cell; along < cut.length; along += frame_.cell) {
            Sample s;
            s.along = along;
            s.before = s.after = std::nanf("");
            if (const auto cell = cell_at(cut.at(along))) {
                s.before = faces_.before.height[*cell];
                s.after = faces_.after.height[*cell];
                s.first = faces_.before.unit[*cell];
                s.then = faces_.after.unit[*cell];
                s.clash = std::binary_search(faces_.clash.begin(), faces_.clash.end(), *cell);
            }
            all.push_back(s);
        }
        return all;
    }

    // Through the worst place, in the direction in which both faces are met most; as large as it can be with both
    // lines apart on paper.
    void choose_cut() {
        constexpr double kApart = 0.008; // [m on paper]
        constexpr int kDirections = 16;
        const double thickness = made_.z_upper - made_.z_lower;
        scale_ = kContradictionScales.front();
        for (const double scale : kContradictionScales) {
            if (scale <= 20.0 && thickness / scale >= kApart) scale_ = scale;
        }
        double best = -1.0;
        for (int i = 0; i < kDirections; ++i) {
            const double angle = std::numbers::pi * i / kDirections;
            Cut cut;
            cut.way = {std::cos(angle), std::sin(angle)};
            if (cut.way[0] < -1e-9) cut.way = {-cut.way[0], -cut.way[1]}; // west or south on the left
            cut.length = kContradictionWidth * scale_;
            for (std::size_t k = 0; k < 2; ++k) cut.from[k] = place()[k] - 0.5 * cut.length * cut.way[k];
            double score = 0.0;
            for (const Sample& s : samples(cut)) {
                if (s.clash) score += 1.0;
                if (s.first == faces_.upper || s.then == faces_.lower) score += 0.5;
                if (s.first == faces_.lower || s.then == faces_.upper) score += 0.25;
            }
            if (score <= best + 1e-9) continue;
            best = score;
            cut_ = cut;
        }
    }

    [[nodiscard]] std::array<double, 2> place() const { return {made_.x, made_.y}; }

    [[nodiscard]] geometry::ScaledSheet plan() const {
        geometry::ScaledSheet made;
        geometry::MapSheet& sheet = made.sheet;
        geometry::Extent seen = geometry::extent(box(faces_.extent));
        for (const double along : {0.0, cut_.length}) seen.add(cut_.at(along)[0], cut_.at(along)[1]);
        const double wide = 1.12 * (seen.high[0] - seen.low[0]);
        const double high = 1.12 * (seen.high[1] - seen.low[1]);
        made.scale = kContradictionScales.back();
        for (const double scale : kContradictionScales) {
            if (wide > kContradictionWidth * scale || high > kContradictionHeight * scale) continue;
            made.scale = scale;
            break;
        }
        const std::array half = {0.5 * kContradictionWidth * made.scale,
                                 0.5 * std::max(high, 0.6 * kContradictionHeight * made.scale)};
        for (std::size_t k = 0; k < 2; ++k) {
            const double middle = 0.5 * (seen.low[k] + seen.high[k]);
            sheet.extent.low[k] = middle - half[k];
            sheet.extent.high[k] = middle + half[k];
        }
        sheet.title = "Both faces in plan";
        sheet.subtitle = fmt::format("ground of {} as relief", day_after());
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
        const double letter = 0.0035 * plan.scale;
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
        made.scale = scale_;
        geometry::MapSheet& sheet = made.sheet;
        const std::vector<Sample> along = samples(cut_);
        sheet.is_section = true;
        sheet.title = "Cross-section A–B through the worst place";
        sheet.subtitle =
            fmt::format("from {:.2f} {:.2f} to {:.2f} {:.2f}; heights and lengths in metres, not exaggerated",
                        cut_.at(0.0)[0], cut_.at(0.0)[1], cut_.at(cut_.length)[0], cut_.at(cut_.length)[1]);
        set_heights(along, sheet.extent);
        add_clash(along, sheet);
        add_profile(along, &Sample::before, {kUpperGround, kUpperLine}, faces_.upper, &Sample::first, sheet);
        add_profile(along, &Sample::after, {kLowerGround, kLowerLine}, faces_.lower, &Sample::then, sheet);
        add_measure(sheet);
        add_numbers(along, sheet);
        sheet.keys = {{fmt::format("{} on {}", made_.upper, day_before()), kUpperLine, geometry::SheetSign::None},
                      {"other ground then", kUpperGround, geometry::SheetSign::None},
                      {fmt::format("{} on {}", made_.lower, day_after()), kLowerLine, geometry::SheetSign::None},
                      {"other ground then", kLowerGround, geometry::SheetSign::None},
                      {fmt::format("{} above {}", made_.upper, made_.lower), kClashArea, geometry::SheetSign::None}};
        return made;
    }

    // Both lines with room for words; a deep pit beside them is cut off.
    void set_heights(const std::vector<Sample>& along, geometry::Extent& extent) const {
        constexpr double kRoom = 0.012; // above and below, on paper [m]
        constexpr double kMost = 0.035; // above and below the middle
        const double middle = 0.5 * (made_.z_upper + made_.z_lower);
        double low = made_.z_lower;
        double high = made_.z_upper;
        for (const Sample& s : along) {
            for (const float z : {s.before, s.after}) {
                if (std::isnan(z)) continue;
                low = std::min(low, static_cast<double>(z));
                high = std::max(high, static_cast<double>(z));
            }
        }
        low = std::max(low, std::min(middle - kMost * scale_, made_.z_lower));
        high = std::min(high, std::max(middle + kMost * scale_, made_.z_upper));
        extent.low = {0.0, low - kRoom * scale_};
        extent.high = {cut_.length, high + kRoom * scale_};
    }

    struct ProfileLook {
        SheetLook thin;
        SheetLook thick;
    };

    // The whole line thin, the unit's own part thick over it. Gaps of a cell or two are drawn through.
    void add_profile(const std::vector<Sample>& along, float Sample::*height, const ProfileLook& look,
                     scans::UnitNumber own, scans::UnitNumber Sample::*unit, geometry::MapSheet& sheet) const {
        constexpr std::size_t kGap = 3;      // cells
        constexpr double kNoMatter = 0.0005; // too little to be seen on paper [m]
        for (const bool thick : {false, true}) {
            geometry::Line3 line;
            std::size_t last = 0;
            const auto finish = [&] {
                if (line.size() > 1)
                    sheet.lines.push_back({geometry::simplified(line, kNoMatter), thick ? look.thick : look.thin});
                line.clear();
            };
            for (std::size_t i = 0; i < along.size(); ++i) {
                const Sample& s = along[i];
                if (std::isnan(s.*height) || (thick && s.*unit != own)) continue;
                if (!line.empty() && i - last > kGap) finish();
                line.push_back({s.along, static_cast<double>(s.*height), 0.0});
                last = i;
            }
            finish();
        }
    }

    void add_clash(const std::vector<Sample>& along, geometry::MapSheet& sheet) const {
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
        const double x = 0.5 * cut_.length;
        const int digits =
            made_.z_upper - made_.z_lower < 0.1 ? 3 : 2; // so that the heights agree with what is between
        const double tick = 0.0012 * scale_;
        sheet.lines.push_back({{{x, made_.z_lower, 0.0}, {x, made_.z_upper, 0.0}}, kMeasureLine});
        for (const double z : {made_.z_lower, made_.z_upper})
            sheet.lines.push_back({{{x - tick, z, 0.0}, {x + tick, z, 0.0}}, kMeasureLine});
        sheet.labels.push_back({x + 0.009 * scale_,
                                0.5 * (made_.z_lower + made_.z_upper),
                                fmt::format("{:.{}f} m", made_.z_upper - made_.z_lower, digits),
                                {}});
        sheet.marks.push_back(
            {x, made_.z_upper, geometry::SheetSign::Level, fmt::format("{:.{}f}", made_.z_upper, digits)});
        sheet.labels.push_back({x, made_.z_lower, {}, fmt::format("{:.{}f}", made_.z_lower, digits)});
    }

    // Every unit that a line meets over 12 mm on paper: those before above the lines, those after below.
    void add_numbers(const std::vector<Sample>& along, geometry::MapSheet& sheet) const {
        add_numbers(along, &Sample::before, &Sample::first, 0.0045 * scale_, sheet);
        add_numbers(along, &Sample::after, &Sample::then, -0.0045 * scale_, sheet);
    }

    void add_numbers(const std::vector<Sample>& along, float Sample::*height, scans::UnitNumber Sample::*unit,
                     double off, geometry::MapSheet& sheet) const {
        constexpr double kLeast = 0.012; // [m on paper]
        for (std::size_t i = 0; i < along.size();) {
            std::size_t end = i;
            while (end < along.size() && along[end].*unit == along[i].*unit) ++end;
            const double length = static_cast<double>(end - i) * frame_.cell;
            const Sample& middle = along[i + (end - i) * 2 / 5]; // beside the dimension line
            const scans::UnitNumber number = along[i].*unit;
            const double z = static_cast<double>(middle.*height) + off;
            if (number != scans::kNobody && length >= kLeast * scale_ && !std::isnan(z) && z < sheet.extent.high[1] &&
                z > sheet.extent.low[1])
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
    Cut cut_;
    double scale_ = 10.0; // of the section
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
