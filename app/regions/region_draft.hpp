// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "app/project/project.hpp"
#include "app/regions/outline.hpp"

namespace planum::app {

/// Where an outline lies, and whose number series holds there.
struct OutlinePlace {
    model::SurfaceId surface; ///< nil: on the section
    model::SectionId section;
    model::AreaId area; ///< as the outline says it, else that of the surface or section; nil: nobody says it
};

/// The record as an import of outlines will leave it: a copy that changes along, so that outlines of one file see each
/// other. Areas, surfaces, sections and units are made as outlines ask for them; nothing is written before write().
class RegionDraft {
  public:
    RegionDraft(const model::Record& record, UuidSource& ids);

    [[nodiscard]] const model::Record& record() const noexcept { return record_; }

    /// What the draft has made so far; back_to() forgets what was made since.
    struct Mark {
        std::size_t areas = 0;
        std::size_t surfaces = 0;
        std::size_t sections = 0;
        std::size_t units = 0;
    };

    [[nodiscard]] Mark mark() const noexcept;
    void back_to(const Mark& mark);

    /// The surface or section of an outline, made where there is none yet. Throws BadInput, Usage.
    OutlinePlace place_of(DrawnOutline drawn);

    /// The section as it is or would be made, its id nil then. Throws BadInput.
    [[nodiscard]] model::Section section_of(const DrawnOutline& drawn) const;

    /// The unit that a number means in an area: that area's; without area the only one that has it, and where several
    /// have it BadInput, naming them. nullptr: none. `AREA::NUMBER` says its area itself.
    [[nodiscard]] const model::StratigraphicUnit* find_unit(const std::string& number, model::AreaId area) const;

    /// The unit of an outline, of the kind that its category says.
    const model::StratigraphicUnit& make_unit(const DrawnOutline& drawn, model::AreaId area);

    /// The number of an outline as a region keeps it while no unit has it: with its area where the place does not
    /// say it.
    [[nodiscard]] std::string number_as_drawn(const DrawnOutline& drawn, const OutlinePlace& place) const;

    [[nodiscard]] std::vector<model::Region>& regions() noexcept { return record_.regions; }

    void add(model::Region region);       ///< sets its id
    void set_changed(model::RegionId id); ///< it will be written

    [[nodiscard]] bool is_new(model::RegionId id) const;
    [[nodiscard]] bool is_changed(model::RegionId id) const;

    [[nodiscard]] bool changes_anything() const noexcept { return !new_regions_.empty() || !changed_regions_.empty(); }

    [[nodiscard]] std::span<const model::Area> new_areas() const;
    [[nodiscard]] std::span<const model::Surface> new_surfaces() const;
    [[nodiscard]] std::span<const model::Section> new_sections() const;
    [[nodiscard]] std::span<const model::StratigraphicUnit> new_units() const;

    /// Inside Project::change() only.
    void write(store::ProjectFile& file) const;

  private:
    model::AreaId area_for(const std::string& name);
    const model::Surface& surface_of(const DrawnOutline& drawn, model::AreaId area);
    [[nodiscard]] const model::Surface* known_surface(model::AreaId area, const std::string& name,
                                                      const std::string& day) const;
    [[nodiscard]] std::string qualified(const model::StratigraphicUnit& unit) const;

    UuidSource& ids_;
    model::Record record_;
    Mark first_new_;
    std::vector<model::RegionId> new_regions_;
    std::vector<model::RegionId> changed_regions_;
};

} // namespace planum::app
