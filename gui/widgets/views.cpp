// SPDX-License-Identifier: MIT
#include "gui/widgets/view.hpp"

#include <QCoreApplication>

#include <array>

#include "gui/widgets/card/card_panel.hpp"
#include "gui/widgets/history/history_panel.hpp"
#include "gui/widgets/matrix/matrix_view.hpp"
#include "gui/widgets/panorama/panorama_view.hpp"
#include "gui/widgets/plan/plan_view.hpp"
#include "gui/widgets/problems/problem_panel.hpp"
#include "gui/widgets/records/records_view.hpp"
#include "gui/widgets/scans/scans_view.hpp"
#include "gui/widgets/section/section_view.hpp"
#include "gui/widgets/space/space_view.hpp"
#include "gui/widgets/suggestions/suggestion_panel.hpp"
#include "gui/widgets/today/today_panel.hpp"
#include "gui/widgets/units/unit_panel.hpp"

namespace planum::gui {

namespace {

template<class View>
QWidget* make(Models& models) {
    return new View(models);
}

constexpr std::array kViews = {
    ViewEntry{"units", QT_TRANSLATE_NOOP("views", "Units"), Place::Left, "Ctrl+1", make<UnitPanel>},
    ViewEntry{"matrix", QT_TRANSLATE_NOOP("views", "Matrix"), Place::Centre, "Ctrl+2", make<MatrixView>},
    ViewEntry{"panorama", QT_TRANSLATE_NOOP("views", "Panorama"), Place::Centre, "Ctrl+3", make<PanoramaView>},
    ViewEntry{"plan", QT_TRANSLATE_NOOP("views", "Plan"), Place::Centre, "Ctrl+4", make<PlanView>},
    ViewEntry{"section", QT_TRANSLATE_NOOP("views", "Section"), Place::Centre, "Ctrl+5", make<SectionView>},
    ViewEntry{"3d", QT_TRANSLATE_NOOP("views", "3D"), Place::Centre, "Ctrl+7", make<SpaceView>},
    ViewEntry{"records", QT_TRANSLATE_NOOP("views", "Finds and lists"), Place::Centre, "Ctrl+6", make<RecordsView>},
    ViewEntry{"card", QT_TRANSLATE_NOOP("views", "Record card"), Place::Right, "Ctrl+0", make<CardPanel>},
    ViewEntry{"problems", QT_TRANSLATE_NOOP("views", "Problems"), Place::Bottom, "Ctrl+9", make<ProblemPanel>},
    ViewEntry{"suggestions", QT_TRANSLATE_NOOP("views", "Suggestions"), Place::Bottom, "Ctrl+G", make<SuggestionPanel>},
    ViewEntry{"scans", QT_TRANSLATE_NOOP("views", "Scans"), Place::Bottom, "Ctrl+8", make<ScansView>},
    ViewEntry{"today", QT_TRANSLATE_NOOP("views", "Today"), Place::Bottom, "Ctrl+T", make<TodayPanel>},
    ViewEntry{"history", QT_TRANSLATE_NOOP("views", "History"), Place::Bottom, "Ctrl+H", make<HistoryPanel>},
};

} // namespace

std::span<const ViewEntry> all_views() noexcept { return kViews; }

QString view_title(const ViewEntry& view) { return QCoreApplication::translate("views", view.title); }

} // namespace planum::gui
