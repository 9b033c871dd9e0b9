// SPDX-License-Identifier: MIT
#include "app/evidence/section_evidence.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "app/evidence/altered_ground.hpp"
#include "app/evidence/evidence.hpp"
#include "app/evidence/outline_overlaps.hpp"
#include "app/regions/region_layout.hpp"

namespace planum::app {

namespace {

using scans::SectionVerdict;

std::vector<SectionEvidence> of_section(const model::Record& record, const model::RecordIndex& index,
                                        const model::Section& section) {
    const ShownSection shown = shown_in_section(record, index, section);
    std::vector<SectionEvidence> found;
    for (const scans::SectionContact& contact : scans::section_contacts(shown.regions)) {
        const scans::KnownUnit& upper = shown.units[static_cast<std::size_t>(contact.upper)];
        const scans::KnownUnit& lower = shown.units[static_cast<std::size_t>(contact.lower)];
        found.push_back({section.id, upper.id, lower.id, contact, scans::judge_contact(contact, upper, lower)});
    }
    return found;
}

} // namespace

ShownSection shown_in_section(const model::Record& record, const model::RecordIndex& index,
                              const model::Section& section) {
    std::vector<const model::Region*> drawn = regions_on(record, section.id);
    std::erase_if(drawn, [&](const model::Region* region) {
        const model::UnitIndex unit = index.find(region->unit);
        return unit == model::kNoUnit || record.units[unit].kind == model::UnitKind::Cut;
    });
    ShownSection made;
    if (drawn.size() < 2) return made;
    for (const PlacedRegion& placed : layout_regions(drawn, &section).regions) {
        const auto known = std::find_if(made.units.begin(), made.units.end(),
                                        [&](const scans::KnownUnit& unit) { return unit.id == placed.region->unit; });
        const auto number = static_cast<scans::UnitNumber>(known - made.units.begin());
        if (known == made.units.end()) {
            const model::StratigraphicUnit& unit = record.units[index.find(placed.region->unit)];
            made.units.push_back({unit.id, unit.kind, unit.form});
        }
        made.regions.push_back({number, placed.shown, placed.region->sigma});
    }
    return made;
}

std::vector<SectionEvidence> section_evidence(const model::Record& record) {
    const model::RecordIndex index(record);
    std::vector<SectionEvidence> all;
    for (const model::Section& section : record.sections) {
        for (SectionEvidence& one : of_section(record, index, section)) all.push_back(std::move(one));
    }
    return all;
}

std::vector<SectionEvidence> proven_by_sections(const std::vector<SectionEvidence>& sections) {
    std::map<std::pair<model::UnitId, model::UnitId>, const SectionEvidence*> longest;
    for (const SectionEvidence& one : sections) {
        if (one.verdict.why != SectionVerdict::Why::LiesOn) continue;
        const SectionEvidence*& kept = longest[{one.upper, one.lower}];
        if (kept == nullptr || one.contact.length > kept->contact.length) kept = &one;
    }
    std::vector<SectionEvidence> proven;
    for (const auto& [pair, one] : longest) {
        if (!longest.contains({pair.second, pair.first})) proven.push_back(*one);
    }
    return proven;
}

std::vector<model::SurfaceEvidence> with_sections(std::vector<model::SurfaceEvidence> surfaces,
                                                  const model::Record& record) {
    for (const SectionEvidence& one : proven_by_sections(section_evidence(record))) {
        std::erase_if(surfaces, [&](const model::SurfaceEvidence& e) {
            const bool same =
                (e.upper == one.upper && e.lower == one.lower) || (e.upper == one.lower && e.lower == one.upper);
            return same && e.source == model::EvidenceSource::Levels;
        });
        model::SurfaceEvidence evidence;
        evidence.upper = one.upper;
        evidence.lower = one.lower;
        evidence.source = model::EvidenceSource::Section;
        evidence.length = one.contact.length;
        evidence.area = kSectionStrip * one.contact.length;
        evidence.contrary_area = kSectionStrip * one.contact.contrary;
        evidence.both_faces_own = true;
        surfaces.push_back(std::move(evidence));
    }
    return surfaces;
}

model::Measurements measured_evidence(Project& project, Progress& progress) {
    const std::vector<AreaEvidence> areas = gather_evidence(project, progress);
    return {with_sections(surface_evidence(areas), project.record()), altered_ground(project, areas, progress),
            outline_overlaps(project, progress)};
}

std::string reason_of(const model::Record& record, const model::RecordIndex& index, const SectionEvidence& evidence) {
    const auto section = std::find_if(record.sections.begin(), record.sections.end(),
                                      [&](const model::Section& s) { return s.id == evidence.section; });
    const std::string upper = index.name(evidence.upper);
    const std::string lower = index.name(evidence.lower);
    const std::string seen =
        fmt::format("in section {} {} lies on {} along {:.2f} m",
                    section == record.sections.end() ? "?" : section->name, upper, lower, evidence.contact.length);
    if (evidence.verdict.why != SectionVerdict::Why::ReachesBelow) return seen;
    return fmt::format(
        "{}, but {} also goes deeper than the top of {}: was {} put over it, or is {} undercut into it, or "
        "built through it?",
        seen, upper, lower, upper, lower);
}

} // namespace planum::app
