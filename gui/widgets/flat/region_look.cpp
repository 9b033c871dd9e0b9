// SPDX-License-Identifier: MIT
#include "gui/widgets/flat/region_look.hpp"

#include "gui/widgets/theme.hpp"

namespace planum::gui {

namespace {

QColor clear(unsigned rgb, float alpha) {
    QColor colour = theme().kind == ThemeKind::Dark ? QColor::fromRgb(rgb).lighter(120) : QColor::fromRgb(rgb);
    colour.setAlphaF(alpha);
    return colour;
}

} // namespace

RegionLook look_of(const RegionShape& shape) {
    RegionLook look;
    look.line = theme().ink;
    if (shape.category != model::RegionCategory::Unit) {
        look.fill = clear(0x8a8a8a, 0.45F);
        look.pattern = Qt::BDiagPattern;
        look.dashed = Qt::DotLine;
        return look;
    }
    switch (shape.kind) {
    case model::UnitKind::Cut:
        look.fill = clear(0x5f7f95, 0.22F);
        look.dashed = Qt::DashLine;
        return look;
    case model::UnitKind::Structure:
        look.fill = clear(0xa44a3f, 0.75F);
        look.pattern = Qt::DiagCrossPattern;
        return look;
    case model::UnitKind::Skeleton: look.fill = clear(0x6b5ca5, 0.45F); return look;
    case model::UnitKind::Natural:
        look.fill = clear(0x5d8a54, 0.5F);
        look.pattern = Qt::Dense5Pattern;
        return look;
    case model::UnitKind::Interface:
    case model::UnitKind::Void:
    case model::UnitKind::Unknown: look.fill = clear(0x9a958a, 0.25F); return look;
    case model::UnitKind::Feature: look.fill = clear(0x8a6fa8, 0.3F); return look;
    case model::UnitKind::Deposit:
        look.fill = shape.form == model::UnitForm::Fill ? clear(0xb9770e, 0.38F) : clear(0xd9b46a, 0.3F);
        return look;
    }
    return look;
}

} // namespace planum::gui
