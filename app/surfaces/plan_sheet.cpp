// SPDX-License-Identifier: MIT
#include "app/surfaces/plan_sheet.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "app/regions/region_layout.hpp"
#include "app/regions/region_names.hpp"
#include "app/scans/days_surface.hpp"
#include "app/scans/surface_scans.hpp"
#include "app/surfaces/recorded_surface.hpp"
#include "app/surfaces/sheet_looks.hpp"
#include "app/surfaces/surface_cache.hpp"
#include "app/surfaces/surface_picture.hpp"
#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "core/geometry/polygon_overlay.hpp"
#include "core/model/astray.hpp"
#include "scans/surface/label_grid.hpp"

namespace planum::app {

namespace {

using geometry::SheetDash;
using geometry::SheetLook;
using model::RegionCategory;
using model::UnitForm;
using model::UnitKind;

constexpr double kSpare = 0.3;       // around outlines [m]
constexpr double kOverPhoto = 0.6;   // width of lines at least [mm]
constexpr double kUnseenArea = 0.02; // [m²]
constexpr double kHair = 1e-6;
constexpr double kRound = 0.1; // edges of a sheet are whole decimetres
constexpr SheetLook kNoUnit{0x5d5a54, 0.25, SheetDash::Dotted, 0x8a8a8a, 0.25};
constexpr SheetLook kUnseen{0x9a958a, 0.2, SheetDash::Solid, 0xffffff, 1.0};

geometry::Extent sheet_extent(const geometry::Extent& content, double spare) {
    geometry::Extent extent;
    if (content.is_empty()) return extent;
    for (std::size_t k = 0; k < 2; ++k) {
        extent.low[k] = std::floor((content.low[k] - spare) / kRound + kHair) * kRound;
        extent.high[k] = std::ceil((content.high[k] + spare) / kRound - kHair) * kRound;
    }
    return extent;
}

// Ground that scans saw.
geometry::Extent seen_extent(const scans::SurfaceGrid& grid) {
    geometry::Extent extent;
    for (std::int32_t row = 0; row < grid.frame.rows; ++row) {
        for (std::int32_t column = 0; column < grid.frame.columns; ++column) {
            if (grid.state[grid.frame.at(row, column)] != scans::CellState::Unseen)
                extent.add(grid.frame.x(column), grid.frame.y(row));
        }
    }
    return extent;
}

std::optional<double> height_at(const scans::SurfaceGrid& grid, double x, double y) {
    const auto column = static_cast<std::int64_t>(std::floor(x / grid.frame.cell)) - grid.frame.west;
    const auto row = static_cast<std::int64_t>(std::floor(y / grid.frame.cell)) - grid.frame.south;
    if (column < 0 || row < 0 || column >= grid.frame.columns || row >= grid.frame.rows) return std::nullopt;
    const std::size_t cell = grid.frame.at(static_cast<std::int32_t>(row), static_cast<std::int32_t>(column));
    if (grid.state[cell] == scans::CellState::Unseen) return std::nullopt;
    return static_cast<double>(grid.height[cell]);
}

struct KindWords {
    UnitKind kind;
    UnitForm form;
    std::string_view words;
};

constexpr std::array<KindWords, 8> kKindWords = {{{UnitKind::Deposit, UnitForm::Layer, "layer"},
                                                  {UnitKind::Deposit, UnitForm::Fill, "fill"},
                                                  {UnitKind::Cut, UnitForm::None, "cut"},
                                                  {UnitKind::Structure, UnitForm::None, "structure"},
                                                  {UnitKind::Skeleton, UnitForm::None, "skeleton"},
                                                  {UnitKind::Feature, UnitForm::None, "feature"},
                                                  {UnitKind::Natural, UnitForm::None, "natural"},
                                                  {UnitKind::Unknown, UnitForm::None, "kind not known"}}};

class PlanMaker {
  public:
    PlanMaker(Project& project, const PlanRequest& request, Progress& progress)
        : project_(project), record_(project.record()), request_(request), progress_(progress), scanned_(record_) {}

    PlanSheet make() {
        sheet().site = record_.settings.name;
        if (!request_.over.empty()) {
            make_over();
        } else {
            make_surface();
        }
        if (sheet().extent.is_empty())
            throw Error(ErrorCode::BadInput, fmt::format("{}: there are neither outlines nor registered scans to show",
                                                         plan_.surface.empty() ? request_.over : plan_.surface));
        return std::move(plan_);
    }

  private:
    geometry::MapSheet& sheet() { return plan_.sheet; }

    [[nodiscard]] const model::Surface& wanted_surface() const {
        if (!request_.surface.empty()) return known_surface(record_, request_.surface);
        const model::Surface* last = nullptr;
        for (const model::Surface& surface : record_.surfaces) {
            if (last == nullptr || std::tie(surface.first_day, surface.order) > std::tie(last->first_day, last->order))
                last = &surface;
        }
        if (last == nullptr)
            throw Error(ErrorCode::NotFound,
                        "the project has no surface yet; planum scan add or region import make them");
        return *last;
    }

    void make_surface() {
        const model::Surface& surface = wanted_surface();
        plan_.surface = surface_name(record_, surface);
        sheet().title = "Plan of " + plan_.surface;
        const std::vector<const model::Region*> regions = near_regions(surface);
        geometry::Extent outlines;
        for (const model::Region* region : regions) outlines.add(geometry::extent(scans::shape_of(*region)));
        lay_ground(surface, outlines);
        add_regions(regions);
        add_levels(regions);
        add_finds(surface);
        add_keys(regions);
        sheet().subtitle = std::string(to_word(surface.method)) + (ground_.empty() ? "" : " · " + ground_);
    }

    // Without those that would make a plan of kilometres.
    [[nodiscard]] std::vector<const model::Region*> near_regions(const model::Surface& surface) {
        std::vector<const model::Region*> regions = regions_on(record_, surface.id);
        std::erase_if(regions, [&](const model::Region* region) {
            if (!scanned_.is_astray(*region)) return false;
            plan_.notes.push_back(fmt::format("{} lies more than {:.0f} m from all scans and was left out",
                                              region_name(record_, project_.index(), *region),
                                              model::kFarthestOutline));
            return true;
        });
        return regions;
    }

    static std::string scans_of(const RecordedSurface& made) {
        return made.scans.size() == 1 ? "one scan" : fmt::format("{} scans", made.scans.size());
    }

    // The picture from the scans, and what the sheet shows.
    void lay_ground(const model::Surface& surface, const geometry::Extent& outlines) {
        sheet().extent = sheet_extent(outlines, kSpare);
        if (!is_seen(record_, surface)) {
            plan_.notes.push_back(
                fmt::format("{}: no registered scan shows it; the plan has outlines only", plan_.surface));
            return;
        }
        RecordedSurface made = recorded_surface(project_, surface, request_.cell, progress_);
        for (const std::string& scan : made.raw) plan_.notes.push_back(scan + " is not registered and was left out");
        if (outlines.is_empty()) sheet().extent = sheet_extent(seen_extent(made.grid), 0.0);
        if (request_.colour) {
            Orthophoto photo = orthophoto(made.grid, surface_scans(project_, surface.id, progress_), progress_);
            is_photo_ = true;
            ground_ = (photo.is_colour ? "colour of " : "reflectance of ") + scans_of(made);
            sheet().pictures.push_back(std::move(photo.picture));
        } else {
            ground_ = "shaded relief from " + scans_of(made);
            sheet().pictures.push_back(shaded_relief(made.grid));
        }
        grid_ = std::move(made.grid);
    }

    [[nodiscard]] SheetLook look_of(const model::Region& region) const {
        if (region.category != RegionCategory::Unit) return on_ground(kNoUnit);
        const auto index = project_.index().find(region.unit);
        if (index == model::kNoUnit) return on_ground(unit_look(UnitKind::Unknown, UnitForm::None));
        return on_ground(unit_look(record_.units[index].kind, record_.units[index].form));
    }

    // A thin fill over a photograph has no colour that the legend could show: there the lines are coloured instead.
    [[nodiscard]] SheetLook on_ground(SheetLook look) const {
        if (!is_photo_) return look;
        look.line = look.fill;
        look.width = std::max(look.width, kOverPhoto);
        look.opacity = 0.0;
        return look;
    }

    void add_regions(const std::vector<const model::Region*>& regions) {
        const RegionLayout layout = layout_regions(regions);
        std::vector<const PlacedRegion*> by_size;
        for (const PlacedRegion& placed : layout.regions) by_size.push_back(&placed);
        std::stable_sort(by_size.begin(), by_size.end(), [](const PlacedRegion* a, const PlacedRegion* b) {
            return geometry::area(a->drawn) > geometry::area(b->drawn);
        });
        std::set<std::string> units;
        for (const PlacedRegion* placed : by_size) {
            const std::string label = region_label(record_, project_.index(), *placed->region);
            // The fill belongs to what is shown only: a region inside another cuts its own hole.
            add_outline(sheet(), placed->shown.empty() ? placed->drawn : placed->shown, look_of(*placed->region));
            add_label(placed->shown.empty() ? placed->drawn : placed->shown, label, *placed->region);
            if (!placed->region->unit.is_nil()) units.insert(label);
        }
        plan_.units.assign(units.begin(), units.end());
        std::sort(plan_.units.begin(), plan_.units.end(), text::NaturalLess());
        for (const model::Region* region : layout.unusable)
            plan_.notes.push_back(region_name(record_, project_.index(), *region) +
                                  " has no valid outline and was left out");
    }

    void add_label(const geometry::MultiPolygon& shape, const std::string& label, const model::Region& region) {
        if (shape.empty()) return;
        const auto [x, y] = geometry::inner_place(shape);
        std::string below;
        if (grid_ && region.category == RegionCategory::Unit && !has_level(region.unit)) {
            if (const auto z = height_at(*grid_, x, y)) below = fmt::format("{:.2f}", *z);
        }
        sheet().labels.push_back({x, y, label, below});
    }

    [[nodiscard]] bool has_level(model::UnitId unit) const {
        return std::any_of(record_.levels.begin(), record_.levels.end(), [&](const model::Level& level) {
            return level.unit == unit && level.x && level.y && shows_here(level);
        });
    }

    // Levels have no day: the base of a unit comes out only when it is gone.
    [[nodiscard]] bool shows_here(const model::Level& level) const {
        const bool inside = level.x && level.y && *level.x >= sheet().extent.low[0] &&
                            *level.x <= sheet().extent.high[0] && *level.y >= sheet().extent.low[1] &&
                            *level.y <= sheet().extent.high[1];
        return inside && level.role != model::LevelRole::Base;
    }

    [[nodiscard]] const geometry::MapSheet& sheet() const { return plan_.sheet; }

    void add_levels(const std::vector<const model::Region*>& regions) {
        bool any = false;
        for (const model::Level& level : record_.levels) {
            const bool bare = std::any_of(regions.begin(), regions.end(),
                                          [&](const model::Region* region) { return region->unit == level.unit; });
            if (!bare || !shows_here(level)) continue;
            sheet().marks.push_back({*level.x, *level.y, geometry::SheetSign::Level, fmt::format("{:.2f}", level.z)});
            any = true;
        }
        if (any) signs_.push_back({"level [m]", {}, geometry::SheetSign::Level});
    }

    void add_finds(const model::Surface& surface) {
        bool any = false;
        for (const model::Find& find : record_.finds) {
            if (!find.x || !find.y || !holds_day(surface, find.found_on)) continue;
            sheet().marks.push_back({*find.x, *find.y, geometry::SheetSign::Find, find.number});
            any = true;
        }
        if (any) signs_.push_back({"find of these days", {}, geometry::SheetSign::Find});
    }

    void add_keys(const std::vector<const model::Region*>& regions) {
        for (const KindWords& known : kKindWords) {
            const SheetLook look = on_ground(unit_look(known.kind, known.form));
            const bool used = std::any_of(regions.begin(), regions.end(),
                                          [&](const model::Region* region) { return look_of(*region) == look; });
            if (used) sheet().keys.push_back({std::string(known.words), look, geometry::SheetSign::None});
        }
        if (std::any_of(regions.begin(), regions.end(),
                        [&](const auto* r) { return r->category != RegionCategory::Unit; }))
            sheet().keys.push_back({"no unit", on_ground(kNoUnit), geometry::SheetSign::None});
        add_unseen_key();
        sheet().keys.insert(sheet().keys.end(), signs_.begin(), signs_.end());
    }

    // Holes up to 10 cm across are closed in the picture, so what is clear is worth a word.
    void add_unseen_key() {
        if (sheet().pictures.empty()) return;
        const geometry::SheetPicture& picture = sheet().pictures.front();
        const auto& [low, high] = sheet().extent;
        double area = (high[0] - low[0]) * (high[1] - low[1]);
        for (std::size_t i = 0; 4 * i < picture.rgba.size(); ++i) {
            if (picture.rgba[4 * i + 3] == 0) continue;
            const auto width = static_cast<std::size_t>(picture.width);
            const double x = picture.left + (static_cast<double>(i % width) + 0.5) * picture.pixel;
            const double y = picture.top - (static_cast<double>(i / width) + 0.5) * picture.pixel;
            if (x > low[0] && x < high[0] && y > low[1] && y < high[1]) area -= picture.pixel * picture.pixel;
        }
        if (area < kUnseenArea) return;
        const bool is_filled = std::any_of(sheet().shapes.begin(), sheet().shapes.end(),
                                           [](const geometry::SheetShape& shape) { return shape.look.opacity > 0.0; });
        sheet().keys.push_back({is_filled ? "white or pale: ground that no scan saw" : "white: ground that no scan saw",
                                kUnseen, geometry::SheetSign::None});
    }

    void make_over() {
        const model::StratigraphicUnit& unit = record_.units[project_.unit_named(request_.over)];
        const std::string name = project_.index().name(unit.id);
        std::vector<std::pair<const model::Surface*, const model::Region*>> outlines;
        geometry::Extent extent;
        for (const model::Region& region : record_.regions) {
            if (region.unit != unit.id || !region.section.is_nil() || scanned_.is_astray(region)) continue;
            for (const model::Surface& surface : record_.surfaces) {
                if (surface.id == region.surface) outlines.emplace_back(&surface, &region);
            }
            extent.add(geometry::extent(scans::shape_of(region)));
        }
        if (outlines.empty())
            throw Error(ErrorCode::BadInput, fmt::format("unit {} has no outline on any surface", name));
        std::stable_sort(outlines.begin(), outlines.end(), [](const auto& a, const auto& b) {
            return std::tie(a.first->order, a.first->first_day) < std::tie(b.first->order, b.first->first_day);
        });
        sheet().title = fmt::format("{} from surface to surface", name);
        sheet().subtitle = unit.title;
        sheet().extent = sheet_extent(extent, kSpare);
        plan_.units = {name};
        if (!request_.surface.empty()) {
            const model::Surface& surface = known_surface(record_, request_.surface);
            plan_.surface = surface_name(record_, surface);
            lay_ground(surface, extent);
        }
        add_successive(outlines);
    }

    void add_successive(const std::vector<std::pair<const model::Surface*, const model::Region*>>& outlines) {
        std::vector<const model::Surface*> surfaces;
        for (const auto& [surface, region] : outlines) {
            if (surfaces.empty() || surfaces.back() != surface) surfaces.push_back(surface);
        }
        for (std::size_t i = 0; i < surfaces.size(); ++i) {
            SheetLook look;
            look.line = colour_in_time(i, surfaces.size());
            // Earlier lines are broader, so that they show below later ones that fall on them.
            look.width = std::min(1.4, 0.4 + 0.3 * static_cast<double>(surfaces.size() - 1 - i));
            for (const auto& [surface, region] : outlines) {
                if (surface == surfaces[i]) sheet().shapes.push_back({scans::shape_of(*region), look});
            }
            sheet().keys.push_back({surface_name(record_, *surfaces[i]), look, geometry::SheetSign::None});
        }
        add_unseen_key();
    }

    Project& project_;
    const model::Record& record_;
    const PlanRequest& request_;
    Progress& progress_;
    model::ScannedBox scanned_;
    PlanSheet plan_;
    std::string ground_; ///< what the picture is
    bool is_photo_ = false;
    std::optional<scans::SurfaceGrid> grid_;
    std::vector<geometry::SheetKey> signs_;
};

} // namespace

PlanSheet plan_sheet(Project& project, const PlanRequest& request, Progress& progress) {
    return PlanMaker(project, request, progress).make();
}

} // namespace planum::app
