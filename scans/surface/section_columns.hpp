// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/geometry/gpb.hpp"
#include "core/model/relation.hpp"
#include "scans/surface/surface_step.hpp"

namespace planum::scans {

/// What a section shows of a unit: x along the section, y the height [m].
struct SectionRegion {
    UnitNumber unit = kNobody;
    geometry::MultiPolygon shape;
    double sigma = 0.03; ///< of its outline [m]
};

/// Two units that lie one upon the other in a section; `upper < lower` does not hold, each pair stands once.
struct SectionContact {
    UnitNumber upper = kNobody; ///< the one that is above along the greater length
    UnitNumber lower = kNobody;
    double length = 0.0;   ///< along the section, where `upper` lies on `lower` [m]
    double contrary = 0.0; ///< where `lower` lies on `upper` [m]
    double from = 0.0;     ///< where along the section the two begin to touch, and end [m]
    double to = 0.0;
    bool upper_reaches_below = false; ///< somewhere `upper` goes deeper than the top of `lower`
};

/// Walks the section in columns of `column` [m] from its lowest to its highest place: two regions touch in a column
/// where the lower end of one and the upper end of the next lie no farther apart than twice the σ of both. Where
/// regions overlap by more, they do not touch. Sorted by upper, lower.
[[nodiscard]] std::vector<SectionContact> section_contacts(std::span<const SectionRegion> regions,
                                                           double column = 0.02);

/// A contact in one column of a section [m].
struct ContactColumn {
    double along = 0.0;
    double bottom = 0.0; ///< of the piece below
    double lower = 0.0;  ///< where that ends
    double upper = 0.0;  ///< where the piece above begins; lines of two hands leave a gap, or overlap
    double top = 0.0;    ///< of the piece above

    /// Height of the contact: between both lines.
    [[nodiscard]] double height() const noexcept { return 0.5 * (lower + upper); }

    friend bool operator==(const ContactColumn&, const ContactColumn&) = default;
};

/// The columns in which `upper` lies on `lower`, as section_contacts() counts them; ascending.
[[nodiscard]] std::vector<ContactColumn> contact_columns(std::span<const SectionRegion> regions, UnitNumber upper,
                                                         UnitNumber lower, double column = 0.02);

/// What a contact says by the rules of docs/evidence.md.
struct SectionVerdict {
    enum class Why {
        LiesOn,       ///< a relation
        BothWays,     ///< nothing: each lies on the other somewhere
        ReachesBelow, ///< question: a fill or a structure comes out from under what also goes deeper than it
        TooShort      ///< nothing
    };

    Why why = Why::TooShort;
    model::RelationKind kind = model::RelationKind::Covers; ///< of LiesOn
    bool direct = false;                                    ///< they touch; false for an order alone
};

/// Shorter contacts prove nothing [m].
inline constexpr double kLeastContact = 0.1;

[[nodiscard]] SectionVerdict judge_contact(const SectionContact& contact, const KnownUnit& upper,
                                           const KnownUnit& lower);

} // namespace planum::scans
