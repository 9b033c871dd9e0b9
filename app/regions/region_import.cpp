// SPDX-License-Identifier: MIT
#include "app/regions/region_import.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "app/regions/geojson_outlines.hpp"
#include "app/regions/pixel_outlines.hpp"
#include "app/regions/region_layout.hpp"
#include "app/regions/region_names.hpp"
#include "app/scans/days_surface.hpp"
#include "core/base/error.hpp"
#include "core/base/file.hpp"
#include "core/base/text.hpp"
#include "core/geometry/polygon_overlay.hpp"
#include "core/geometry/polygons.hpp"

namespace planum::app {

namespace {

using geometry::MultiPolygon;

constexpr double kSameLine = 5e-4;     ///< points closer than this were not redrawn [m]
constexpr double kSameRegion = 0.5;    ///< share of the smaller that lies on the other: one region, drawn anew
constexpr double kSigmaOfMost = 100.0; ///< [m], the file's own limit

bool same_lines(const MultiPolygon& a, const MultiPolygon& b) {
    if (a.size() != b.size()) return false;
    for (std::size_t part = 0; part < a.size(); ++part) {
        if (a[part].size() != b[part].size()) return false;
        for (std::size_t ring = 0; ring < a[part].size(); ++ring) {
            const bool same = std::equal(a[part][ring].begin(), a[part][ring].end(), b[part][ring].begin(),
                                         b[part][ring].end(), [](const auto& p, const auto& q) {
                                             return std::abs(p[0] - q[0]) < kSameLine &&
                                                    std::abs(p[1] - q[1]) < kSameLine &&
                                                    std::abs(p[2] - q[2]) < kSameLine;
                                         });
            if (!same) return false;
        }
    }
    return true;
}

// What an import would write, with ids set.
struct Plan {
    std::vector<model::Area> areas;
    std::vector<model::Surface> surfaces;
    std::vector<model::Section> sections;
    std::vector<model::StratigraphicUnit> units;
    std::vector<model::RegionId> new_regions;
    std::vector<model::RegionId> changed_regions;
};

bool is_in(const std::vector<model::RegionId>& ids, model::RegionId id) {
    return std::find(ids.begin(), ids.end(), id) != ids.end();
}

// Works on a copy of the record that changes along, so that outlines of one file see each other; writes nothing.
class Importer {
  public:
    Importer(const model::Record& record, const RegionImportOptions& options, UuidSource& ids)
        : ids_(ids), options_(options), record_(record) {}

    void take(const DrawnOutline& drawn) {
        try {
            take_sound(drawn);
        } catch (const Error& e) {
            if (e.code() != ErrorCode::BadInput && e.code() != ErrorCode::NotFound) throw;
            report_.refused.push_back({drawn.where, e.what()});
        }
    }

    [[nodiscard]] std::size_t taken() const { return taken_; }

    RegionImportReport finish() {
        const model::RecordIndex index(record_);
        for (const auto& [id, unknown] : unknown_) {
            for (const model::Region& region : record_.regions) {
                if (region.id != id) continue;
                report_.unknown.push_back(unknown);
                report_.unknown.back().region = region_name(record_, index, region);
            }
        }
        const auto names = [&](const std::vector<model::RegionId>& ids, std::vector<std::string>& out) {
            for (const model::Region& region : record_.regions) {
                if (is_in(ids, region.id)) out.push_back(region_name(record_, index, region));
            }
            std::sort(out.begin(), out.end(), text::NaturalLess{});
        };
        names(plan_.new_regions, report_.fresh);
        names(redrawn_, report_.redrawn);
        names(named_, report_.named);
        for (const model::Surface& made : plan_.surfaces) report_.surfaces.push_back(surface_name(record_, made));
        report_overlaps(index);
        report_.changed = !plan_.new_regions.empty() || !plan_.changed_regions.empty();
        return std::move(report_);
    }

    // Inside change() only.
    void write(store::ProjectFile& file) const {
        for (const model::Area& area : plan_.areas) file.insert(area);
        for (const model::Surface& surface : plan_.surfaces) file.insert(surface);
        for (const model::Section& section : plan_.sections) file.insert(section);
        for (const model::StratigraphicUnit& unit : plan_.units) file.insert(unit);
        for (const model::Region& region : record_.regions) {
            if (is_in(plan_.new_regions, region.id)) {
                file.insert(region);
            } else if (is_in(plan_.changed_regions, region.id)) {
                file.update(region);
            }
        }
    }

  private:
    void take_sound(const DrawnOutline& drawn) {
        model::Region region;
        region.category = drawn.category;
        region.notes = drawn.notes;
        region.drawn_on = drawn.drawn_on;
        if (drawn.sigma) {
            if (!(*drawn.sigma >= 0.0 && *drawn.sigma <= kSigmaOfMost)) {
                throw Error(ErrorCode::BadInput, fmt::format("sigma: {} is no uncertainty in metres", *drawn.sigma));
            }
            region.sigma = *drawn.sigma;
        }
        // The shape first: an outline that is refused must leave no area, surface or unit behind.
        std::vector<std::string> repairs;
        model::Section section;
        if (drawn.section) section = section_for(drawn);
        region.outline = outline_of(sound(drawn, drawn.section ? &section : nullptr, repairs));
        const model::AreaId area = area_for(drawn.area.empty() ? options_.area : drawn.area);
        model::DigMethod method = model::DigMethod::Stratigraphic;
        if (drawn.section) {
            region.section = section.id.is_nil() ? insert_section(section, area) : section.id;
        } else {
            const model::Surface& surface = surface_of(drawn, area);
            region.surface = surface.id;
            method = surface.method;
        }
        const model::StratigraphicUnit* unit = unit_for(drawn, area, region);
        region.shows = drawn.shows.value_or(default_shows(
            region.category, unit != nullptr ? unit->kind : drawn.kind.kind, method, drawn.section.has_value()));
        if (!drawn.seen_in.empty()) {
            const model::StratigraphicUnit* cut = find_unit(drawn.seen_in, area);
            if (cut == nullptr) {
                report_.notes.push_back({drawn.where, fmt::format("seen_in: no unit {}", drawn.seen_in)});
            } else {
                region.seen_in = cut->id;
            }
        }
        for (std::string& repair : repairs) report_.repaired.push_back({drawn.where, std::move(repair)});
        ++taken_;
        merge(std::move(region), drawn);
    }

    static MultiPolygon sound(const DrawnOutline& drawn, const model::Section* section,
                              std::vector<std::string>& repairs) {
        MultiPolygon shape = drawn.shape;
        if (section != nullptr && !drawn.on_plane) shape = onto_plane(shape, *section);
        if (section != nullptr && drawn.on_plane) {
            for (auto& rings : shape) {
                for (auto& ring : rings) {
                    for (auto& point : ring) point[2] = 0.0; // on the plane itself
                }
            }
        }
        geometry::SoundPolygon made = geometry::make_sound(shape);
        repairs = std::move(made.repairs);
        return section == nullptr ? std::move(made.shape) : from_plane(made.shape, *section);
    }

    model::AreaId area_for(const std::string& name) {
        if (name.empty()) return record_.areas.size() == 1 ? record_.areas.front().id : model::AreaId{};
        for (const model::Area& area : record_.areas) {
            if (area.name == name) return area.id;
        }
        model::Area area;
        area.name = name;
        area.method = record_.settings.method;
        area.id = {ids_.next()};
        record_.areas.push_back(area);
        plan_.areas.push_back(area);
        report_.areas.push_back(name);
        return area.id;
    }

    const model::Surface& surface_of(const DrawnOutline& drawn, model::AreaId area) {
        for (const model::Surface& surface : record_.surfaces) {
            if (!drawn.on_surface.is_nil() && surface.id == drawn.on_surface) return surface;
        }
        std::string day = drawn.day;
        if (day.empty() && drawn.surface.empty()) day = options_.day;
        if (day.empty()) day = day_in(drawn.surface);
        if (day.empty() && drawn.surface.empty()) {
            throw Error(ErrorCode::BadInput, "it names neither a surface nor a day; give --day");
        }
        const std::string name = drawn.surface == day ? std::string{} : drawn.surface;
        if (const model::Surface* known = known_surface(area, name, day)) return *known;
        // Scans that came before the site had areas lie on surfaces without one.
        if (const model::Surface* known = known_surface({}, name, day)) return *known;
        if (day.empty()) throw Error(ErrorCode::BadInput, fmt::format("surface {} is new and has no day", name));
        model::Surface surface = surface_for_day(record_, record_.surfaces, area, day);
        surface.name = name;
        surface.id = {ids_.next()};
        plan_.surfaces.push_back(surface);
        record_.surfaces.push_back(std::move(surface));
        return record_.surfaces.back();
    }

    [[nodiscard]] const model::Surface* known_surface(model::AreaId area, const std::string& name,
                                                      const std::string& day) const {
        if (name.empty()) return surface_on_day(record_.surfaces, area, day);
        for (const model::Surface& surface : record_.surfaces) {
            if (surface.area == area && (surface.name == name || surface_name(record_, surface) == name))
                return &surface;
        }
        return nullptr;
    }

    // `2025-06-01.2` says its day itself.
    static std::string day_in(const std::string& name) {
        const std::string head = name.substr(0, 10);
        return is_day(head) && (name.size() == 10 || name[10] == '.') ? head : std::string{};
    }

    [[nodiscard]] model::Section section_for(const DrawnOutline& drawn) const {
        for (const model::Section& section : record_.sections) {
            if (section.name == drawn.section->name) return section;
        }
        if (!drawn.section->line) {
            throw Error(ErrorCode::BadInput,
                        fmt::format("section {} is new: say its two ends, from and to [x, y]", drawn.section->name));
        }
        model::Section section;
        section.name = drawn.section->name;
        section.from_in_site = drawn.section->line->at(0);
        section.to_in_site = drawn.section->line->at(1);
        section.day = drawn.day.empty() ? options_.day : drawn.day;
        return section;
    }

    model::SectionId insert_section(model::Section section, model::AreaId area) {
        section.area = area;
        section.id = {ids_.next()};
        record_.sections.push_back(section);
        plan_.sections.push_back(section);
        report_.sections.push_back(section.name);
        return section.id;
    }

    [[nodiscard]] const model::StratigraphicUnit* find_unit(const std::string& number, model::AreaId area) const {
        const model::StratigraphicUnit* elsewhere = nullptr;
        std::size_t hits = 0;
        for (const model::StratigraphicUnit& unit : record_.units) {
            if (unit.number != number && qualified(unit) != number) continue;
            if (unit.area == area || area.is_nil()) return &unit;
            elsewhere = &unit;
            ++hits;
        }
        const bool site_wide = record_.settings.numbers == model::NumberScope::Site;
        return hits == 1 && (site_wide || elsewhere->area.is_nil()) ? elsewhere : nullptr;
    }

    [[nodiscard]] std::string qualified(const model::StratigraphicUnit& unit) const {
        for (const model::Area& area : record_.areas) {
            if (area.id == unit.area) return area.name + "::" + unit.number;
        }
        return unit.number;
    }

    // The unit, made where that is wished; nullptr leaves the number on the region.
    const model::StratigraphicUnit* unit_for(const DrawnOutline& drawn, model::AreaId area, model::Region& region) {
        if (drawn.unit.empty()) return nullptr;
        const model::StratigraphicUnit* unit = find_unit(drawn.unit, area);
        if (unit == nullptr && options_.create_units && drawn.category == model::RegionCategory::Unit) {
            unit = &make_unit(drawn, area);
        }
        if (unit == nullptr) {
            region.unit_as_drawn = drawn.unit;
        } else {
            region.unit = unit->id;
        }
        return unit;
    }

    const model::StratigraphicUnit& make_unit(const DrawnOutline& drawn, model::AreaId area) {
        model::StratigraphicUnit unit;
        unit.number = drawn.unit;
        unit.area = area;
        unit.kind = drawn.kind.kind;
        unit.form = drawn.kind.form;
        unit.origin = model::UnitOrigin::Mentioned; // it has no sheet yet
        if (unit.kind == model::UnitKind::Unknown && drawn.shows == model::RegionShows::Cut) {
            unit.kind = model::UnitKind::Cut;
        }
        unit.id = {ids_.next()};
        record_.units.push_back(unit);
        plan_.units.push_back(unit);
        report_.units.push_back(unit.number);
        return record_.units.back();
    }

    [[nodiscard]] bool same_label(const model::Region& a, const model::Region& b) const {
        if (a.surface != b.surface || a.section != b.section || a.category != b.category) return false;
        return label_of(a) == label_of(b);
    }

    [[nodiscard]] std::string label_of(const model::Region& region) const {
        for (const model::StratigraphicUnit& unit : record_.units) {
            if (unit.id == region.unit) return unit.number;
        }
        return region.unit_as_drawn;
    }

    void merge(model::Region region, const DrawnOutline& drawn) {
        model::Region* match = nullptr;
        const MultiPolygon shape = shape_of(region.outline);
        std::int64_t last_part = 0;
        for (model::Region& other : record_.regions) {
            if (!same_label(region, other)) continue;
            last_part = std::max(last_part, other.part);
            if (is_in(matched_, other.id)) continue;
            if (same_lines(shape, shape_of(other.outline))) {
                match = &other;
                break;
            }
            if (match == nullptr && is_redrawn(region, other)) match = &other;
        }
        if (match == nullptr) {
            region.part = last_part + 1;
            region.id = {ids_.next()};
            matched_.push_back(region.id);
            plan_.new_regions.push_back(region.id);
            note_unknown(region, drawn);
            record_.regions.push_back(std::move(region));
            return;
        }
        matched_.push_back(match->id);
        region.id = match->id;
        region.part = match->part;
        update(*match, std::move(region), drawn);
    }

    [[nodiscard]] bool is_redrawn(const model::Region& region, const model::Region& other) const {
        if (region.surface.is_nil()) return false; // planes overlap in plan, always
        MultiPolygon older;
        try {
            older = geometry::make_sound(shape_of(other.outline)).shape;
        } catch (const Error&) {
            return false;
        }
        const MultiPolygon newer = shape_of(region.outline);
        if (!geometry::extent(newer).meets(geometry::extent(older))) return false;
        const double both = geometry::area(geometry::intersection(newer, older));
        return both > kSameRegion * std::min(geometry::area(newer), geometry::area(older));
    }

    void note_unknown(const model::Region& region, const DrawnOutline& drawn) {
        if (region.unit_as_drawn.empty()) return;
        unknown_.emplace_back(region.id, UnknownNumber{drawn.where, "", region.unit_as_drawn,
                                                       proposed_numbers(record_, region.unit_as_drawn)});
    }

    void update(model::Region& old, model::Region wished, const DrawnOutline& drawn) {
        note_unknown(wished, drawn);
        const bool now_named = old.unit.is_nil() && !wished.unit.is_nil();
        const bool moved = !same_lines(shape_of(old.outline), shape_of(wished.outline));
        if (!moved) wished.outline = old.outline;
        if (wished.notes.empty()) wished.notes = old.notes;
        if (!drawn.shows) wished.shows = old.shows;
        if (!drawn.sigma) wished.sigma = old.sigma;
        if (drawn.seen_in.empty()) wished.seen_in = old.seen_in;
        wished.drawn_on = moved ? wished.drawn_on : old.drawn_on;
        model::Region named = old;
        named.unit = wished.unit;
        named.unit_as_drawn = wished.unit_as_drawn;
        if (now_named && old.shows == default_shows(old.category, model::UnitKind::Unknown, method_of(old), false)) {
            named.shows = wished.shows = drawn.shows.value_or(shows_by_default(wished));
        }
        if (old.notes.empty()) named.notes = wished.notes;
        const bool differs = !(named == wished);
        if (differs && !options_.update)
            report_.conflicts.push_back({drawn.where, difference_text(named, wished, moved)});
        const model::Region& result = options_.update ? wished : named;
        if (result == old) {
            ++report_.same;
            return;
        }
        (now_named && !(differs && options_.update) ? named_ : redrawn_).push_back(old.id);
        plan_.changed_regions.push_back(old.id);
        old = result;
    }

    [[nodiscard]] model::DigMethod method_of(const model::Region& region) const {
        for (const model::Surface& surface : record_.surfaces) {
            if (surface.id == region.surface) return surface.method;
        }
        return model::DigMethod::Stratigraphic;
    }

    [[nodiscard]] model::RegionShows shows_by_default(const model::Region& region) const {
        model::UnitKind kind = model::UnitKind::Unknown;
        for (const model::StratigraphicUnit& unit : record_.units) {
            if (unit.id == region.unit) kind = unit.kind;
        }
        return default_shows(region.category, kind, method_of(region), region.surface.is_nil());
    }

    static std::string difference_text(const model::Region& kept, const model::Region& offered, bool moved) {
        std::vector<std::string> parts;
        if (moved) parts.emplace_back("the outline is drawn otherwise");
        if (kept.shows != offered.shows) {
            parts.push_back(fmt::format("shows: {} (file: {})", to_word(kept.shows), to_word(offered.shows)));
        }
        if (kept.sigma != offered.sigma) {
            parts.push_back(fmt::format("sigma: {} (file: {})", kept.sigma, offered.sigma));
        }
        if (kept.notes != offered.notes) parts.emplace_back("the notes differ");
        if (kept.seen_in != offered.seen_in) parts.emplace_back("seen_in differs");
        return text::join(parts, ", ") + "; kept, --update takes the file's";
    }

    void report_overlaps(const model::RecordIndex& index) {
        std::vector<const model::Surface*> touched;
        for (const model::Surface& surface : record_.surfaces) {
            const bool mine = std::any_of(record_.regions.begin(), record_.regions.end(), [&](const auto& region) {
                return region.surface == surface.id && is_in(matched_, region.id);
            });
            if (mine) touched.push_back(&surface);
        }
        for (const model::Surface* surface : touched) {
            const RegionLayout layout = layout_regions(regions_on(record_, surface->id));
            for (const RegionOverlap& overlap : layout.overlaps) {
                report_.overlaps.push_back({surface_name(record_, *surface),
                                            region_name(record_, index, *overlap.first),
                                            region_name(record_, index, *overlap.second), overlap.area});
            }
        }
    }

    UuidSource& ids_;
    const RegionImportOptions& options_;
    model::Record record_;
    RegionImportReport report_;
    std::size_t taken_ = 0;
    std::vector<model::RegionId> matched_; ///< taken by an outline of this file already
    std::vector<model::RegionId> redrawn_;
    std::vector<model::RegionId> named_;
    Plan plan_;
    std::vector<std::pair<model::RegionId, UnknownNumber>> unknown_;
};

OutlineFile read_outlines(Project& project, const std::filesystem::path& file, Progress& progress) {
    constexpr std::uintmax_t kLargest = 256ULL << 20U;
    const std::string bytes = read_file(file, kLargest);
    return is_pixel_outlines(bytes) ? outlines_from_pixels(project, read_pixel_outlines(bytes), progress)
                                    : read_geojson_outlines(bytes);
}

// Of several files every place has to be said with its file.
void say_file(OutlineFile& outlines, const std::string& name) {
    const auto with_name = [&](std::string& where) { where = where.empty() ? name : name + ", " + where; };
    for (DrawnOutline& outline : outlines.outlines) with_name(outline.where);
    for (OutlineNote& note : outlines.notes) with_name(note.where);
}

} // namespace

std::vector<std::string> proposed_numbers(const model::Record& record, const std::string& drawn) {
    constexpr std::size_t kMost = 5;
    std::vector<std::string> near = near_numbers(record, drawn, kMost);
    if (!near.empty()) return near;
    const auto wanted = text::parse_integer(drawn);
    if (!wanted) return near;
    std::vector<std::pair<long long, std::string>> by_distance;
    for (const model::StratigraphicUnit& unit : record.units) {
        const auto value = text::parse_integer(unit.number);
        if (value) by_distance.emplace_back(*value > *wanted ? *value - *wanted : *wanted - *value, unit.number);
    }
    std::sort(by_distance.begin(), by_distance.end());
    for (std::size_t i = 0; i < std::min<std::size_t>(2, by_distance.size()); ++i)
        near.push_back(by_distance[i].second);
    return near;
}

RegionImportReport import_outlines(Project& project, const OutlineFile& file, const RegionImportOptions& options) {
    Importer importer(project.record(), options, project.uuids());
    for (const DrawnOutline& drawn : file.outlines) importer.take(drawn);
    RegionImportReport report = importer.finish();
    report.notes.insert(report.notes.begin(), file.notes.begin(), file.notes.end());
    if (importer.taken() == 0) {
        std::vector<OutlineNote> reasons = report.refused;
        reasons.insert(reasons.end(), report.notes.begin(), report.notes.end());
        reasons.push_back({"", "it holds no outline"});
        const OutlineNote& first = reasons.front();
        throw Error(ErrorCode::BadInput, first.where.empty() ? first.message : first.where + ": " + first.message);
    }
    if (!options.dry_run && report.changed) {
        project.change(fmt::format("Import {} outlines", importer.taken()), [&] { importer.write(project.file()); });
    }
    return report;
}

RegionImportReport import_outline_files(Project& project, const std::vector<std::filesystem::path>& files,
                                        const RegionImportOptions& options, Progress& progress) {
    OutlineFile all;
    for (const std::filesystem::path& file : files) {
        const std::string name = file.filename().string();
        try {
            OutlineFile one = read_outlines(project, file, progress);
            if (files.size() > 1) say_file(one, name);
            std::move(one.outlines.begin(), one.outlines.end(), std::back_inserter(all.outlines));
            std::move(one.notes.begin(), one.notes.end(), std::back_inserter(all.notes));
        } catch (Error& e) {
            e.add_context(name);
            throw;
        }
    }
    try {
        return import_outlines(project, all, options);
    } catch (Error& e) {
        if (files.size() == 1) e.add_context(files.front().filename().string());
        throw;
    }
}

} // namespace planum::app
