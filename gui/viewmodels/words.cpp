// SPDX-License-Identifier: MIT
#include "gui/viewmodels/words.hpp"

#include <QCoreApplication>
#include <QLocale>

#include <array>
#include <utility>

namespace planum::gui {

using model::RelationKind;
using model::UnitForm;
using model::UnitKind;

namespace {

QString translated(const char* text) { return QCoreApplication::translate("words", text); }

} // namespace

QString qt(std::string_view utf8) { return QString::fromUtf8(utf8.data(), static_cast<qsizetype>(utf8.size())); }

QString number_word(double value, int decimals) {
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    return locale.toString(value, 'f', decimals);
}

QString kind_word(UnitKind kind, UnitForm form) {
    switch (form) {
    case UnitForm::None: break;
    case UnitForm::Layer: return translated(QT_TRANSLATE_NOOP("words", "layer"));
    case UnitForm::Fill: return translated(QT_TRANSLATE_NOOP("words", "fill"));
    case UnitForm::Masonry: return translated(QT_TRANSLATE_NOOP("words", "masonry"));
    case UnitForm::Timber: return translated(QT_TRANSLATE_NOOP("words", "timber"));
    case UnitForm::Burial: return translated(QT_TRANSLATE_NOOP("words", "burial"));
    }
    switch (kind) {
    case UnitKind::Unknown: return {};
    case UnitKind::Deposit: return translated(QT_TRANSLATE_NOOP("words", "deposit"));
    case UnitKind::Cut: return translated(QT_TRANSLATE_NOOP("words", "cut"));
    case UnitKind::Feature: return translated(QT_TRANSLATE_NOOP("words", "feature"));
    case UnitKind::Structure: return translated(QT_TRANSLATE_NOOP("words", "structure"));
    case UnitKind::Interface: return translated(QT_TRANSLATE_NOOP("words", "interface"));
    case UnitKind::Skeleton: return translated(QT_TRANSLATE_NOOP("words", "skeleton"));
    case UnitKind::Natural: return translated(QT_TRANSLATE_NOOP("words", "natural"));
    case UnitKind::Void: return translated(QT_TRANSLATE_NOOP("words", "void number"));
    }
    return {};
}

QString status_word(model::UnitStatus status) {
    switch (status) {
    case model::UnitStatus::Open: return translated(QT_TRANSLATE_NOOP("words", "open"));
    case model::UnitStatus::PartlyExcavated: return translated(QT_TRANSLATE_NOOP("words", "partly excavated"));
    case model::UnitStatus::Excavated: return translated(QT_TRANSLATE_NOOP("words", "excavated"));
    case model::UnitStatus::NotExcavated: return translated(QT_TRANSLATE_NOOP("words", "not excavated"));
    case model::UnitStatus::Void: return translated(QT_TRANSLATE_NOOP("words", "void"));
    }
    return {};
}

QString relation_word(model::DirectedKind kind) {
    switch (kind.kind) {
    case RelationKind::Covers:
        return kind.inverse ? translated(QT_TRANSLATE_NOOP("words", "covered by"))
                            : translated(QT_TRANSLATE_NOOP("words", "covers"));
    case RelationKind::Cuts:
        return kind.inverse ? translated(QT_TRANSLATE_NOOP("words", "cut by"))
                            : translated(QT_TRANSLATE_NOOP("words", "cuts"));
    case RelationKind::Fills:
        return kind.inverse ? translated(QT_TRANSLATE_NOOP("words", "filled by"))
                            : translated(QT_TRANSLATE_NOOP("words", "fills"));
    case RelationKind::Abuts:
        return kind.inverse ? translated(QT_TRANSLATE_NOOP("words", "abutted by"))
                            : translated(QT_TRANSLATE_NOOP("words", "abuts"));
    case RelationKind::BondsWith: return translated(QT_TRANSLATE_NOOP("words", "bonds with"));
    case RelationKind::SameAs: return translated(QT_TRANSLATE_NOOP("words", "same as"));
    case RelationKind::Borders: return translated(QT_TRANSLATE_NOOP("words", "borders"));
    case RelationKind::Later:
        return kind.inverse ? translated(QT_TRANSLATE_NOOP("words", "earlier than"))
                            : translated(QT_TRANSLATE_NOOP("words", "later than"));
    case RelationKind::Contemporary: return translated(QT_TRANSLATE_NOOP("words", "contemporary with"));
    }
    return {};
}

QString severity_word(model::Severity severity) {
    switch (severity) {
    case model::Severity::Error: return translated(QT_TRANSLATE_NOOP("words", "error"));
    case model::Severity::Warning: return translated(QT_TRANSLATE_NOOP("words", "warning"));
    case model::Severity::Info: return translated(QT_TRANSLATE_NOOP("words", "remark"));
    }
    return {};
}

QString level_word(model::LevelRole role) {
    switch (role) {
    case model::LevelRole::Top: return translated(QT_TRANSLATE_NOOP("words", "top"));
    case model::LevelRole::Base: return translated(QT_TRANSLATE_NOOP("words", "base"));
    case model::LevelRole::Cut: return translated(QT_TRANSLATE_NOOP("words", "bottom of the cut"));
    case model::LevelRole::Other: return translated(QT_TRANSLATE_NOOP("words", "level"));
    }
    return {};
}

QString category_word(model::RegionCategory category) {
    using model::RegionCategory;
    switch (category) {
    case RegionCategory::Unit: return translated(QT_TRANSLATE_NOOP("words", "a unit"));
    case RegionCategory::Spoil: return translated(QT_TRANSLATE_NOOP("words", "spoil"));
    case RegionCategory::Slump: return translated(QT_TRANSLATE_NOOP("words", "slump"));
    case RegionCategory::Backfill: return translated(QT_TRANSLATE_NOOP("words", "backfill"));
    case RegionCategory::Water: return translated(QT_TRANSLATE_NOOP("words", "water"));
    case RegionCategory::Equipment: return translated(QT_TRANSLATE_NOOP("words", "equipment"));
    case RegionCategory::Baulk: return translated(QT_TRANSLATE_NOOP("words", "baulk"));
    case RegionCategory::Unexcavated: return translated(QT_TRANSLATE_NOOP("words", "not excavated yet"));
    }
    return {};
}

QString outline_word(const model::RecordIndex& index, const model::Region& region) {
    if (!region.unit.is_nil()) return qt(index.name(region.unit));
    if (!region.unit_as_drawn.empty()) return qt(region.unit_as_drawn);
    return region.category == model::RegionCategory::Unit ? QStringLiteral("?") : category_word(region.category);
}

QString shows_word(model::RegionShows shows) {
    using model::RegionShows;
    switch (shows) {
    case RegionShows::Top: return translated(QT_TRANSLATE_NOOP("words", "shows: its top"));
    case RegionShows::Level: return translated(QT_TRANSLATE_NOOP("words", "shows: a level inside it"));
    case RegionShows::Cut: return translated(QT_TRANSLATE_NOOP("words", "shows: the bare cut"));
    case RegionShows::Overdug: return translated(QT_TRANSLATE_NOOP("words", "shows: dug too deep"));
    case RegionShows::Machine: return translated(QT_TRANSLATE_NOOP("words", "shows: dug by machine"));
    case RegionShows::Face: return translated(QT_TRANSLATE_NOOP("words", "shows: a face"));
    case RegionShows::Nothing: return translated(QT_TRANSLATE_NOOP("words", "shows: nothing of it"));
    }
    return {};
}

QString check_title(std::string_view code) {
    static constexpr std::array<std::pair<std::string_view, const char*>, 33> kTitles = {{
        {"cycle", QT_TRANSLATE_NOOP("words", "Units above one another in a circle")},
        {"cycle-by-same-as", QT_TRANSLATE_NOOP("words", "Circle made by “same as”")},
        {"self-relation", QT_TRANSLATE_NOOP("words", "Unit above itself")},
        {"contradicting-pair", QT_TRANSLATE_NOOP("words", "Stated both ways")},
        {"contemporary-ordered", QT_TRANSLATE_NOOP("words", "Contemporary, yet ordered")},
        {"height-contradiction", QT_TRANSLATE_NOOP("words", "Surfaces contradict the relation")},
        {"level-contradiction", QT_TRANSLATE_NOOP("words", "Levels contradict the relation")},
        {"date-contradiction", QT_TRANSLATE_NOOP("words", "Dates contradict the order")},
        {"phase-contradiction", QT_TRANSLATE_NOOP("words", "Phases contradict the order")},
        {"dug-too-early", QT_TRANSLATE_NOOP("words", "Dug before what lay above it")},
        {"find-outside-unit", QT_TRANSLATE_NOOP("words", "Find outside its unit")},
        {"kind-mismatch", QT_TRANSLATE_NOOP("words", "Relation does not fit the kinds")},
        {"fill-without-cut", QT_TRANSLATE_NOOP("words", "Fill without a cut")},
        {"cut-without-fill", QT_TRANSLATE_NOOP("words", "Cut without a fill")},
        {"cut-cuts-nothing", QT_TRANSLATE_NOOP("words", "Cut that cuts nothing")},
        {"natural-not-lowest", QT_TRANSLATE_NOOP("words", "Something lies below the natural")},
        {"number-reused", QT_TRANSLATE_NOOP("words", "Number used twice")},
        {"number-outside-block", QT_TRANSLATE_NOOP("words", "Number outside its block")},
        {"duplicate-relation", QT_TRANSLATE_NOOP("words", "Relation stated twice on one sheet")},
        {"missing-reciprocal", QT_TRANSLATE_NOOP("words", "Stated on one sheet only")},
        {"dangling-unit", QT_TRANSLATE_NOOP("words", "Unit without a sheet")},
        {"unparsed", QT_TRANSLATE_NOOP("words", "Not understood on import")},
        {"isolated-unit", QT_TRANSLATE_NOOP("words", "Unit without relations")},
        {"unit-without-region", QT_TRANSLATE_NOOP("words", "Unit without an outline")},
        {"region-without-unit", QT_TRANSLATE_NOOP("words", "Outline without a unit")},
        {"scan-unregistered", QT_TRANSLATE_NOOP("words", "Scan not on the site grid")},
        {"scan-poorly-registered", QT_TRANSLATE_NOOP("words", "Scan placed with doubt")},
        {"surface-order", QT_TRANSLATE_NOOP("words", "Surfaces in the wrong order")},
        {"region-astray", QT_TRANSLATE_NOOP("words", "Outline far from all scans")},
        {"region-overlap", QT_TRANSLATE_NOOP("words", "Outlines on the same ground")},
        {"surface-changed-within", QT_TRANSLATE_NOOP("words", "Surface changed while it was scanned")},
        {"surface-rose", QT_TRANSLATE_NOOP("words", "Ground rose")},
        {"redundant-relation", QT_TRANSLATE_NOOP("words", "Relation that others imply")},
    }};
    for (const auto& [key, title] : kTitles) {
        if (key == code && !key.empty()) return translated(title);
    }
    return qt(code);
}

} // namespace planum::gui
