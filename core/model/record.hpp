// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "core/model/chronology.hpp"
#include "core/model/ids.hpp"
#include "core/model/interpretation.hpp"
#include "core/model/measured.hpp"
#include "core/model/place.hpp"
#include "core/model/relation.hpp"
#include "core/model/scan.hpp"
#include "core/model/source.hpp"
#include "core/model/unit.hpp"

namespace planum::model {

/// Whether a unit number is unique on the whole site or only within its area.
enum class NumberScope { Site, Area };

/// How strict the checks of kinds and closed sequences are.
enum class Strictness { Lenient, Normal, Strict };

/// What the project as a whole says.
struct ProjectSettings {
    std::string name;
    std::int64_t srs_id = -1; ///< EPSG code; -1 = local grid
    double tolerance = 0.02;  ///< the project's own height tolerance [m]
    DigMethod method = DigMethod::Stratigraphic;
    NumberScope numbers = NumberScope::Site;
    Strictness strictness = Strictness::Normal;

    friend bool operator==(const ProjectSettings&, const ProjectSettings&) = default;
};

/// The living part of a project in memory, without scans' points: what the checks, the matrix and the
/// exports work on. Units are sorted by area name, then number, naturally; everything that belongs to
/// units follows their order, so that equal projects give equal records.
struct Record {
    ProjectSettings settings;
    std::vector<Area> areas;
    std::vector<StratigraphicUnit> units;
    std::vector<PhysicalRelation> relations;
    std::vector<RelationStatement> statements; ///< grouped by relation, in the order of `relations`
    std::vector<Source> sources;
    std::vector<ImportNote> import_notes;
    std::vector<Period> periods;
    std::vector<Phase> phases;
    std::vector<UnitGroup> groups;
    std::vector<Dating> datings;
    std::vector<Level> levels;
    std::vector<Find> finds;
    std::vector<Sample> samples;
    std::vector<Document> documents;
    std::vector<Surface> surfaces;
    std::vector<Section> sections;
    std::vector<Region> regions;
    std::vector<Scan> scans;
    std::vector<ScanPose> poses;
    std::vector<RegistrationRun> runs;
    std::vector<Decision> decisions;
    std::vector<Interpretation> interpretations;
};

/// Position of a unit in Record::units; what algorithms count with instead of ids.
using UnitIndex = std::uint32_t;
inline constexpr UnitIndex kNoUnit = static_cast<UnitIndex>(-1);

/// Finds units of one record by id and by name. Keeps a reference: the record must outlive it, unchanged.
class RecordIndex {
  public:
    explicit RecordIndex(const Record& record);

    /// kNoUnit when the record has no such unit.
    [[nodiscard]] UnitIndex find(UnitId id) const noexcept;

    /// By `NUMBER` or `AREA::NUMBER`. All units that the text may mean: none, one, or several areas'.
    [[nodiscard]] std::vector<UnitIndex> named(std::string_view name) const;

    /// `NUMBER`, or `AREA::NUMBER` where the number alone is not unique.
    [[nodiscard]] std::string name(UnitIndex unit) const;
    [[nodiscard]] std::string name(UnitId id) const;

  private:
    const Record* record_;
    std::unordered_map<UnitId, UnitIndex> by_id_;
    std::unordered_map<std::string, std::vector<UnitIndex>> by_number_;
    std::unordered_map<AreaId, std::string> area_names_;
};

/// The pose that holds: that of the accepted run made last, of runs of one time the one with the larger name (10 after
/// 2). nullptr: the scan is not on the site grid.
[[nodiscard]] const ScanPose* pose_in_force(const Record& record, ScanId scan) noexcept;

/// Brings a record into the order that Record promises.
void sort_record(Record& record);

[[nodiscard]] std::string_view to_word(NumberScope scope) noexcept;
[[nodiscard]] std::string_view to_word(Strictness strictness) noexcept;
[[nodiscard]] std::optional<NumberScope> number_scope_from_word(std::string_view word) noexcept;
[[nodiscard]] std::optional<Strictness> strictness_from_word(std::string_view word) noexcept;

} // namespace planum::model
