// SPDX-License-Identifier: MIT
#include "app/regions/region_import.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "app/regions/outline_files.hpp"
#include "app/regions/region_draft.hpp"
#include "app/regions/region_layout.hpp"
#include "app/regions/region_match.hpp"
#include "app/regions/region_names.hpp"
#include "app/regions/section_plane.hpp"
#include "app/scans/days_surface.hpp"
#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "core/geometry/polygon_overlay.hpp"
#include "core/model/astray.hpp"

namespace planum::app {

namespace {

using geometry::MultiPolygon;

constexpr double kSigmaOfMost = 100.0; ///< [m], the file's own limit

bool is_in(const std::vector<model::RegionId>& ids, model::RegionId id) {
    return std::find(ids.begin(), ids.end(), id) != ids.end();
}

MultiPolygon sound_shape(MultiPolygon shape, const DrawnOutline& drawn, const model::Section* section,
                         std::vector<std::string>& repairs) {
    if (section != nullptr && drawn.on_plane) {
        for (auto& rings : shape) {
            for (auto& ring : rings) {
                for (auto& point : ring) point[2] = 0.0; // on the plane itself
            }
        }
        shape = from_plane(shape, *section);
    }
    geometry::SoundPolygon made = sound_in_site(shape, section);
    repairs = std::move(made.repairs);
    return std::move(made.shape);
}

class Importer {
  public:
    Importer(const model::Record& record, const RegionImportOptions& options, UuidSource& ids)
        : options_(options), draft_(record, ids) {}

    void take(const DrawnOutline& drawn) {
        const RegionDraft::Mark before = draft_.mark();
        try {
            take_sound(with_defaults(drawn));
        } catch (const Error& e) {
            if (e.code() != ErrorCode::BadInput && e.code() != ErrorCode::NotFound && e.code() != ErrorCode::Usage) {
                throw;
            }
            draft_.back_to(before);
            report_.refused.push_back({drawn.where, e.what()});
        }
    }

    [[nodiscard]] std::size_t taken() const { return taken_; }

    [[nodiscard]] const RegionDraft& draft() const { return draft_; }

    RegionImportReport finish() {
        const model::Record& record = draft_.record();
        const model::RecordIndex index(record);
        for (const auto& [id, unknown] : unknown_) {
            for (const model::Region& region : record.regions) {
                if (region.id != id) continue;
                report_.unknown.push_back(unknown);
                report_.unknown.back().region = region_name(record, index, region);
            }
        }
        const auto names = [&](const auto& wanted, std::vector<std::string>& out) {
            for (const model::Region& region : record.regions) {
                if (wanted(region.id)) out.push_back(region_name(record, index, region));
            }
            std::sort(out.begin(), out.end(), text::NaturalLess{});
        };
        names([&](model::RegionId id) { return draft_.is_new(id); }, report_.fresh);
        names([&](model::RegionId id) { return is_in(redrawn_, id); }, report_.redrawn);
        names([&](model::RegionId id) { return is_in(named_, id); }, report_.named);
        for (const auto& made : draft_.new_areas()) report_.areas.push_back(made.name);
        for (const auto& made : draft_.new_surfaces()) report_.surfaces.push_back(surface_name(record, made));
        for (const auto& made : draft_.new_sections()) report_.sections.push_back(made.name);
        for (const auto& made : draft_.new_units()) report_.units.push_back(index.name(made.id));
        report_astray(index);
        report_overlaps(index);
        report_.changed = draft_.changes_anything();
        return std::move(report_);
    }

  private:
    [[nodiscard]] DrawnOutline with_defaults(DrawnOutline drawn) const {
        const bool surface_says_area = drawn.surface.find("::") != std::string::npos;
        if (drawn.area.empty() && !surface_says_area) drawn.area = options_.area;
        if (drawn.day.empty() && drawn.surface.empty()) drawn.day = options_.day;
        return drawn;
    }

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
        std::vector<std::string> repairs;
        model::Section section;
        if (drawn.section) section = draft_.section_of(drawn);
        MultiPolygon shape = drawn.shape;
        region.has_heights = settle_heights(shape) || drawn.section;
        region.outline = outline_of(sound_shape(std::move(shape), drawn, drawn.section ? &section : nullptr, repairs));
        const OutlinePlace place = draft_.place_of(drawn);
        region.surface = place.surface;
        region.section = place.section;
        if (!drawn.seen_in.empty()) {
            const model::StratigraphicUnit* cut = draft_.find_unit(drawn.seen_in, place.area);
            if (cut != nullptr) {
                region.seen_in = cut->id;
            } else {
                report_.notes.push_back({drawn.where, fmt::format("seen_in: no unit {}", drawn.seen_in)});
            }
        }
        merge(std::move(region), drawn, place);
        for (std::string& repair : repairs) report_.repaired.push_back({drawn.where, std::move(repair)});
        ++taken_;
    }

    void merge(model::Region region, const DrawnOutline& drawn, const OutlinePlace& place) {
        std::string number;
        if (!drawn.unit.empty()) {
            number = draft_.number_as_drawn(drawn, place);
            if (const auto* unit = draft_.find_unit(drawn.unit, place.area)) region.unit = unit->id;
        }
        model::Region* match = find_match(region, number);
        const bool named_by_hand = match != nullptr && !match->unit.is_nil();
        const bool may_make = options_.create_units && drawn.category == model::RegionCategory::Unit;
        if (!drawn.unit.empty() && region.unit.is_nil() && may_make && !named_by_hand) {
            region.unit = draft_.make_unit(drawn, place.area).id;
        }
        if (region.unit.is_nil()) region.unit_as_drawn = number;
        region.shows = drawn.shows.value_or(usual_shows(draft_.record(), region, drawn.kind.kind));
        if (match != nullptr) {
            matched_.push_back(match->id);
            update(*match, std::move(region), drawn);
            return;
        }
        region.part = free_part(draft_.record(), region);
        draft_.add(std::move(region));
        const model::Region& added = draft_.record().regions.back();
        matched_.push_back(added.id);
        note_unknown(added, drawn);
    }

    // The region that the project has of an outline already: of the same unit, or drawn with the same number and named
    // since, on the same lines or else drawn anew.
    [[nodiscard]] model::Region* find_match(const model::Region& region, const std::string& number) {
        model::Region* match = nullptr;
        for (model::Region& other : draft_.regions()) {
            if (other.surface != region.surface || other.section != region.section) continue;
            if (other.category != region.category || is_in(matched_, other.id)) continue;
            const bool same_unit = other.unit == region.unit && !region.unit.is_nil();
            const bool same_number = other.unit_as_drawn == number && (!number.empty() || other.unit.is_nil());
            if (!same_unit && !same_number) continue;
            if (same_lines(region, other)) return &other;
            if (match == nullptr && is_drawn_anew(draft_.record(), region, other)) match = &other;
        }
        return match;
    }

    void note_unknown(const model::Region& region, const DrawnOutline& drawn) {
        if (region.unit_as_drawn.empty() || !region.unit.is_nil()) return;
        unknown_.emplace_back(region.id, UnknownNumber{drawn.where, "", region.unit_as_drawn,
                                                       proposed_numbers(draft_.record(), region.unit_as_drawn)});
    }

    void update(model::Region& old, model::Region wished, const DrawnOutline& drawn) {
        wished.id = old.id;
        wished.part = old.part;
        if (wished.unit.is_nil()) wished.unit = old.unit; // somebody named it since
        if (wished.unit == old.unit) wished.unit_as_drawn = old.unit_as_drawn;
        note_unknown(wished, drawn);
        const bool now_named = old.unit.is_nil() && !wished.unit.is_nil();
        const bool moved = !same_lines(old, wished) || (wished.has_heights && !old.has_heights);
        if (!moved) {
            wished.outline = old.outline;
            wished.has_heights = old.has_heights;
        }
        if (wished.notes.empty()) wished.notes = old.notes;
        if (!drawn.shows) wished.shows = old.shows;
        if (!drawn.sigma) wished.sigma = old.sigma;
        if (drawn.seen_in.empty()) wished.seen_in = old.seen_in;
        wished.drawn_on = moved ? wished.drawn_on : old.drawn_on;
        model::Region named = old;
        if (now_named) {
            named.unit = wished.unit;
            named.unit_as_drawn = wished.unit_as_drawn;
            if (old.shows == usual_shows(draft_.record(), old)) {
                named.shows = wished.shows = drawn.shows.value_or(usual_shows(draft_.record(), wished));
            }
        }
        if (wished.unit != old.unit) named.part = wished.part = free_part(draft_.record(), wished);
        if (named.unit == old.unit) named.part = old.part;
        if (old.notes.empty()) named.notes = wished.notes;
        const bool differs = !(named == wished);
        if (differs && !options_.update) {
            report_.conflicts.push_back({drawn.where, difference_text(named, wished, moved)});
        }
        const model::Region& result = options_.update ? wished : named;
        if (result == old) {
            ++report_.same;
            return;
        }
        (now_named && !(differs && options_.update) ? named_ : redrawn_).push_back(old.id);
        draft_.set_changed(old.id);
        old = result;
    }

    [[nodiscard]] std::string difference_text(const model::Region& kept, const model::Region& offered,
                                              bool moved) const {
        std::vector<std::string> parts;
        if (kept.unit != offered.unit) {
            const model::RecordIndex index(draft_.record());
            parts.push_back(fmt::format("unit: {} (file: {})", index.name(kept.unit), index.name(offered.unit)));
        }
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

    void report_astray(const model::RecordIndex& index) {
        const model::ScannedBox scanned(draft_.record());
        for (const model::Region& region : draft_.record().regions) {
            if (!is_in(matched_, region.id) || !scanned.is_astray(region)) continue;
            report_.notes.push_back(
                {region_name(draft_.record(), index, region), "it " + model::astray_words(scanned.distance(region))});
        }
    }

    void report_overlaps(const model::RecordIndex& index) {
        const model::Record& record = draft_.record();
        const auto report = [&](const std::string& name, const std::vector<const model::Region*>& regions,
                                const model::Section* section) {
            const bool mine = std::any_of(regions.begin(), regions.end(),
                                          [&](const model::Region* region) { return is_in(matched_, region->id); });
            if (!mine) return;
            for (const RegionOverlap& overlap : layout_regions(regions, section).overlaps) {
                report_.overlaps.push_back({name, region_name(record, index, *overlap.first),
                                            region_name(record, index, *overlap.second), overlap.area});
            }
        };
        for (const model::Surface& surface : record.surfaces) {
            report(surface_name(record, surface), regions_on(record, surface.id), nullptr);
        }
        for (const model::Section& section : record.sections) {
            report(section.name, regions_on(record, section.id), &section);
        }
    }

    const RegionImportOptions& options_;
    RegionDraft draft_;
    RegionImportReport report_;
    std::size_t taken_ = 0;
    std::vector<model::RegionId> matched_; ///< taken by an outline of this file already
    std::vector<model::RegionId> redrawn_;
    std::vector<model::RegionId> named_;
    std::vector<std::pair<model::RegionId, UnknownNumber>> unknown_;
};

} // namespace

RegionImportReport import_outlines(Project& project, const OutlineFile& file, const RegionImportOptions& options) {
    if (!options.day.empty()) require_day("--day", options.day);
    Importer importer(project.record(), options, project.uuids());
    for (const DrawnOutline& drawn : file.outlines) importer.take(drawn);
    RegionImportReport report = importer.finish();
    report.notes.insert(report.notes.begin(), file.notes.begin(), file.notes.end());
    if (file.outlines.empty() && file.notes.empty()) {
        // As `region patches` writes them when there is nothing to draw.
        report.notes.push_back({"", "it holds no outline"});
        return report;
    }
    if (importer.taken() == 0) {
        std::vector<OutlineNote> reasons = report.refused;
        reasons.insert(reasons.end(), report.notes.begin(), report.notes.end());
        reasons.push_back({"", "it holds no outline"});
        const OutlineNote& first = reasons.front();
        throw Error(ErrorCode::BadInput, first.where.empty() ? first.message : first.where + ": " + first.message);
    }
    if (!options.dry_run && report.changed) {
        const std::string counted =
            fmt::format("Import {} outline{}", importer.taken(), importer.taken() == 1 ? "" : "s");
        project.change(options.label.empty() ? counted : options.label,
                       [&] { importer.draft().write(project.file()); });
    }
    return report;
}

RegionImportReport import_outline_files(Project& project, const std::vector<std::filesystem::path>& files,
                                        const RegionImportOptions& options, Progress& progress) {
    if (!options.day.empty()) require_day("--day", options.day);
    const OutlineFile all = read_outline_files(project, files, progress);
    try {
        return import_outlines(project, all, options);
    } catch (Error& e) {
        if (files.size() == 1) e.add_context(files.front().filename().string());
        throw;
    }
}

} // namespace planum::app
