// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "core/model/ids.hpp"

namespace planum::model {

/// What a unit is (the closed list of the recording manuals).
enum class UnitKind { Unknown, Deposit, Cut, Feature, Structure, Interface, Skeleton, Natural, Void };

/// Which form of its kind. Words like "layer" or "masonry" mean kind plus form.
enum class UnitForm { None, Layer, Fill, Masonry, Timber, Burial };

enum class UnitStatus { Open, PartlyExcavated, Excavated, NotExcavated, Void };

/// Where the unit comes from: a sheet of its own, or only named in somebody's relation.
enum class UnitOrigin { Recorded, Mentioned };

/// One field of the full record: its column in the project file, its English label and the block of
/// the sheet it stands in. The first screen shows none of these.
struct UnitFieldInfo {
    std::string_view name;
    std::string_view label;
    std::string_view block;
};

/// The full record behind the first screen, after the ICCD, Field Desktop, English and German sheets.
inline constexpr std::array kUnitFields = {
    UnitFieldInfo{"site_code", "Site code", "header"},
    UnitFieldInfo{"sector", "Sector", "location"},
    UnitFieldInfo{"square", "Square", "location"},
    UnitFieldInfo{"room", "Room or functional unit", "location"},
    UnitFieldInfo{"position", "Position", "location"},
    UnitFieldInfo{"formation", "Formation (natural, artificial)", "formation"},
    UnitFieldInfo{"criteria_of_distinction", "Criteria of distinction", "formation"},
    UnitFieldInfo{"mode_of_formation", "Mode of formation", "formation"},
    UnitFieldInfo{"consistency", "Compaction or consistency", "material"},
    UnitFieldInfo{"colour", "Colour", "material"},
    UnitFieldInfo{"munsell", "Munsell colour", "material"},
    UnitFieldInfo{"composition", "Composition", "material"},
    UnitFieldInfo{"inclusions", "Inclusions", "material"},
    UnitFieldInfo{"organic_components", "Organic components", "material"},
    UnitFieldInfo{"inorganic_components", "Inorganic components", "material"},
    UnitFieldInfo{"thickness", "Thickness", "measurements"},
    UnitFieldInfo{"length", "Length", "measurements"},
    UnitFieldInfo{"width", "Width", "measurements"},
    UnitFieldInfo{"depth", "Depth", "measurements"},
    UnitFieldInfo{"shape_in_plan", "Shape in plan", "shape"},
    UnitFieldInfo{"profile", "Profile", "shape"},
    UnitFieldInfo{"corners", "Corners", "shape"},
    UnitFieldInfo{"break_of_slope", "Break of slope, top and base", "shape"},
    UnitFieldInfo{"sides", "Sides", "shape"},
    UnitFieldInfo{"base", "Base", "shape"},
    UnitFieldInfo{"orientation", "Orientation", "shape"},
    UnitFieldInfo{"borders", "Borders", "shape"},
    UnitFieldInfo{"truncation", "Truncation", "preservation"},
    UnitFieldInfo{"preservation", "Preservation", "preservation"},
    UnitFieldInfo{"disturbance", "Disturbance", "preservation"},
    UnitFieldInfo{"masonry_materials", "Masonry: materials, size, finish", "masonry"},
    UnitFieldInfo{"masonry_coursing", "Masonry: coursing and bond", "masonry"},
    UnitFieldInfo{"masonry_faces", "Masonry: form and faces", "masonry"},
    UnitFieldInfo{"masonry_bonding", "Masonry: bonding material", "masonry"},
    UnitFieldInfo{"timber_type", "Timber: type and setting", "timber"},
    UnitFieldInfo{"timber_conversion", "Timber: cross-section, conversion", "timber"},
    UnitFieldInfo{"timber_marks", "Timber: tool marks, joints", "timber"},
    UnitFieldInfo{"skeleton_position", "Skeleton: position", "skeleton"},
    UnitFieldInfo{"skeleton_completeness", "Skeleton: completeness, truncation", "skeleton"},
    UnitFieldInfo{"excavation_method", "Excavation method", "excavation"},
    UnitFieldInfo{"percent_excavated", "Per cent excavated", "excavation"},
    UnitFieldInfo{"conditions", "Conditions", "excavation"},
    UnitFieldInfo{"sieving", "Sieving", "excavation"},
    UnitFieldInfo{"flotation", "Flotation", "excavation"},
    UnitFieldInfo{"reliability", "Reliability of the stratigraphy", "assessment"},
    UnitFieldInfo{"activity", "Activity", "assessment"},
    UnitFieldInfo{"dating_evidence", "Dating evidence", "assessment"},
    UnitFieldInfo{"observations", "Observations", "assessment"},
    UnitFieldInfo{"director", "Scientific director", "signatures"},
    UnitFieldInfo{"checked_by", "Checked by", "signatures"},
    UnitFieldInfo{"checked_on", "Checked on", "signatures"},
    UnitFieldInfo{"revised_by", "Revised by", "signatures"},
    UnitFieldInfo{"revised_on", "Revised on", "signatures"},
    UnitFieldInfo{"custom", "Free fields (name=value lines)", "other"},
};

/// Fields of the full record that hold something, by field name (see kUnitFields).
using UnitDetails = std::map<std::string, std::string, std::less<>>;

/// One stratigraphic unit (context, US, Befund). Numbers are text: ` 16/9`, `1297+` and `B. 36` occur.
struct StratigraphicUnit {
    UnitId id;
    std::string number;
    AreaId area; ///< nil: the site has no areas, or none was given
    UnitKind kind = UnitKind::Unknown;
    UnitForm form = UnitForm::None;
    UnitStatus status = UnitStatus::Open;
    UnitOrigin origin = UnitOrigin::Recorded;
    std::string title; ///< short definition
    std::string description;
    std::string interpretation;
    std::string excavated_from; ///< ISO date or empty
    std::string excavated_on;   ///< ISO date it was finished, or empty
    std::string recorded_by;
    std::string recorded_on; ///< ISO date or empty
    PhaseId phase;
    PeriodId period;
    UnitId parent; ///< the feature this is a sub-unit of
    UnitDetails details;

    friend bool operator==(const StratigraphicUnit&, const StratigraphicUnit&) = default;
};

/// Words of the project file, the command line and the exports: `deposit`, `fill`, `open`, ….
[[nodiscard]] std::string_view to_word(UnitKind kind) noexcept;
[[nodiscard]] std::string_view to_word(UnitForm form) noexcept;
[[nodiscard]] std::string_view to_word(UnitStatus status) noexcept;
[[nodiscard]] std::string_view to_word(UnitOrigin origin) noexcept;

template<class Enum>
[[nodiscard]] std::optional<Enum> from_word(std::string_view word) noexcept;

template<>
std::optional<UnitKind> from_word<UnitKind>(std::string_view word) noexcept;
template<>
std::optional<UnitForm> from_word<UnitForm>(std::string_view word) noexcept;
template<>
std::optional<UnitStatus> from_word<UnitStatus>(std::string_view word) noexcept;
template<>
std::optional<UnitOrigin> from_word<UnitOrigin>(std::string_view word) noexcept;

struct KindAndForm {
    UnitKind kind = UnitKind::Unknown;
    UnitForm form = UnitForm::None;

    friend bool operator==(const KindAndForm&, const KindAndForm&) = default;
};

/// The kind and form a digger's word means, in English, German, Italian or French, without regard to
/// case: `layer`, `fill`, `masonry`, `Verfüllung`, `taglio`, `USM`. nullopt when the word is unknown.
[[nodiscard]] std::optional<KindAndForm> kind_from_any_word(std::string_view word);

} // namespace planum::model
