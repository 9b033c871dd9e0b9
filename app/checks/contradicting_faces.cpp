// SPDX-License-Identifier: MIT
#include "app/checks/contradicting_faces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

#include "app/evidence/evidence.hpp"
#include "app/surfaces/surface_cache.hpp"
#include "core/base/error.hpp"
#include "scans/surface/label_grid.hpp"

namespace planum::app {

namespace {

struct Found {
    const AreaEvidence* area;
    const scans::Conclusion* conclusion;
};

// The strongest evidence against the relation: its object seen above its subject.
Found find_conclusion(const std::vector<AreaEvidence>& areas, const model::Diagnostic& problem) {
    Found found{nullptr, nullptr};
    for (const AreaEvidence& area : areas) {
        for (const scans::Conclusion& c : area.conclusions) {
            const bool asked = c.is_question && c.ground != scans::Ground::RoofOfHollow;
            if (asked || c.thin || problem.units.size() != 2) continue;
            if (area.units[static_cast<std::size_t>(c.unit)].id != problem.units[1] ||
                area.units[static_cast<std::size_t>(c.other)].id != problem.units[0])
                continue;
            if (found.conclusion == nullptr || c.area > found.conclusion->area) found = {&area, &c};
        }
    }
    if (found.conclusion == nullptr)
        throw Error(ErrorCode::Conflict, "scans and outlines do not show this contradiction any more; check again");
    return found;
}

const model::Surface& surface_with(const model::Record& record, model::SurfaceId id) {
    return *std::find_if(record.surfaces.begin(), record.surfaces.end(),
                         [&](const model::Surface& surface) { return surface.id == id; });
}

class Gatherer {
  public:
    Gatherer(Project& project, const AreaEvidence& area, Progress& progress)
        : project_(project), record_(project.record()), area_(area), progress_(progress) {}

    ContradictingFaces gather(const scans::Conclusion& c) {
        made_.units = area_.units;
        made_.upper = c.unit;
        made_.lower = c.other;
        made_.surface_before = &surface_with(record_, area_.surfaces[c.from]);
        made_.surface_after = &surface_with(record_, area_.surfaces[c.to]);
        made_.before = labelled(*made_.surface_before, heights(*made_.surface_before), c.unit, made_.face_before);
        made_.ground_after = heights(*made_.surface_after);
        made_.after = labelled(*made_.surface_after, made_.ground_after, c.other, made_.face_after);
        mark_clash(static_cast<float>(c.tolerance));
        find_worst();
        return std::move(made_);
    }

  private:
    [[nodiscard]] scans::SurfaceGrid heights(const model::Surface& surface) const {
        return seen_surface(project_, surface.id, area_.frame, surface_key(record_, surface.id, area_.frame),
                            progress_);
    }

    [[nodiscard]] scans::LabelledSurface labelled(const model::Surface& surface, const scans::SurfaceGrid& grid,
                                                  scans::UnitNumber own, geometry::MultiPolygon& face) const {
        std::vector<model::Region> regions;
        std::vector<scans::UnitNumber> units;
        for (const model::Region& region : record_.regions) {
            if (region.surface != surface.id || !region.section.is_nil()) continue;
            const auto known = std::find_if(area_.units.begin(), area_.units.end(),
                                            [&](const scans::KnownUnit& unit) { return unit.id == region.unit; });
            const bool is_unit = region.category == model::RegionCategory::Unit && known != area_.units.end();
            units.push_back(is_unit ? static_cast<scans::UnitNumber>(known - area_.units.begin()) : scans::kNobody);
            regions.push_back(region);
            if (units.back() != own) continue;
            const geometry::MultiPolygon shape = scans::shape_of(region);
            face.insert(face.end(), shape.begin(), shape.end());
        }
        scans::HeightTolerance tolerance;
        tolerance.project = record_.settings.tolerance;
        return scans::label_surface(grid, scans::label_cells(area_.frame, regions), regions, units, tolerance);
    }

    [[nodiscard]] bool is_of_pair(std::size_t cell) const {
        return made_.before.unit[cell] == made_.upper && made_.after.unit[cell] == made_.lower &&
               scans::is_clear_of_outlines(made_.before, made_.after, cell);
    }

    void mark_clash(float tolerance) {
        for (std::size_t cell = 0; cell < area_.frame.cells(); ++cell) {
            if (!is_of_pair(cell) || !(made_.before.height[cell] - made_.after.height[cell] > tolerance)) continue;
            made_.clash.push_back(cell);
            const auto columns = static_cast<std::size_t>(area_.frame.columns);
            made_.extent.add(area_.frame.x(static_cast<std::int32_t>(cell % columns)),
                             area_.frame.y(static_cast<std::int32_t>(cell / columns)));
        }
        if (made_.clash.empty())
            throw Error(ErrorCode::Conflict, "scans and outlines do not show this contradiction any more; check again");
    }

    // Median drop of the cells that contradict among 5 × 5, and how many they are. A single cell may err.
    [[nodiscard]] std::pair<std::size_t, float> drop_around(std::size_t cell) const {
        const scans::GridFrame& frame = area_.frame;
        const auto row = static_cast<std::int32_t>(cell / static_cast<std::size_t>(frame.columns));
        const auto column = static_cast<std::int32_t>(cell % static_cast<std::size_t>(frame.columns));
        std::vector<float> drops;
        for (std::int32_t r = std::max(0, row - 2); r <= std::min(frame.rows - 1, row + 2); ++r) {
            for (std::int32_t c = std::max(0, column - 2); c <= std::min(frame.columns - 1, column + 2); ++c) {
                const std::size_t near = frame.at(r, c);
                if (std::binary_search(made_.clash.begin(), made_.clash.end(), near))
                    drops.push_back(made_.before.height[near] - made_.after.height[near]);
            }
        }
        const auto middle = drops.begin() + static_cast<std::ptrdiff_t>(drops.size() / 2);
        std::nth_element(drops.begin(), middle, drops.end());
        return {drops.size(), *middle};
    }

    // Where a good half of the cells around contradict, if anywhere; of drops that are alike to a centimetre the one
    // nearest to the middle of all.
    void find_worst() {
        const auto columns = static_cast<std::size_t>(area_.frame.columns);
        const auto place = [&](std::size_t cell) {
            return std::array{static_cast<double>(cell % columns), static_cast<double>(cell / columns)};
        };
        std::array<double, 2> middle{};
        for (const std::size_t cell : made_.clash) {
            for (std::size_t k = 0; k < 2; ++k) middle[k] += place(cell)[k] / static_cast<double>(made_.clash.size());
        }
        std::tuple<std::size_t, long, double> best{0, -1, 0.0};
        for (const std::size_t cell : made_.clash) {
            const auto [around, drop] = drop_around(cell);
            const double off = std::hypot(place(cell)[0] - middle[0], place(cell)[1] - middle[1]);
            const std::tuple here{std::min<std::size_t>(around, 13), std::lround(100.0F * drop), -off};
            if (here <= best) continue;
            best = here;
            made_.worst = cell;
        }
    }

    Project& project_;
    const model::Record& record_;
    const AreaEvidence& area_;
    Progress& progress_;
    ContradictingFaces made_;
};

} // namespace

ContradictingFaces contradicting_faces(Project& project, const model::Diagnostic& problem, Progress& progress) {
    const std::vector<AreaEvidence> areas = gather_evidence(project, progress);
    const Found found = find_conclusion(areas, problem);
    return Gatherer(project, *found.area, progress).gather(*found.conclusion);
}

} // namespace planum::app
