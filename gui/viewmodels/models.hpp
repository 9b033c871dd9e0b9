// SPDX-License-Identifier: MIT
#pragma once

#include "gui/viewmodels/day_jobs.hpp"
#include "gui/viewmodels/inquiry.hpp"
#include "gui/viewmodels/outline_edit.hpp"
#include "gui/viewmodels/outline_tool.hpp"
#include "gui/viewmodels/patch_model.hpp"
#include "gui/viewmodels/problem_list_model.hpp"
#include "gui/viewmodels/relation_entry_model.hpp"
#include "gui/viewmodels/section_line.hpp"
#include "gui/viewmodels/section_model.hpp"
#include "gui/viewmodels/time_model.hpp"
#include "gui/viewmodels/unit_card_model.hpp"
#include "gui/viewmodels/unit_list_model.hpp"
#include "gui/viewmodels/workspace.hpp"

namespace planum::gui {

/// What every view of one window may use. A view with a model of its own makes it itself.
struct Models {
    explicit Models(const app::Session& session = {}) : workspace(session) {
        QObject::connect(&problems, &ProblemListModel::checked, &units,
                         [this] { units.set_problems(problems.check().problems); });
    }

    Workspace workspace;
    UnitListModel units{workspace};
    UnitCardModel card{workspace};
    RelationEntryModel entry{workspace};
    ProblemListModel problems{workspace};
    TimeModel time{workspace};
    SectionLine section_line{workspace};
    OutlineTool outline{workspace};
    OutlineEdit edit{workspace};
    SectionModel sections{workspace};
    PatchModel patches{workspace, time, outline};
    DayJobs day{workspace};
    Inquiry inquiry{workspace};
};

} // namespace planum::gui
