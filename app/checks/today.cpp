// SPDX-License-Identifier: MIT
#include "app/checks/today.hpp"

#include <utility>

#include "strat/checks/today.hpp"
#include "strat/matrix/harris_matrix.hpp"

namespace planum::app {

TodayList today_of(Project& project) {
    const model::RecordIndex& index = project.index();
    const strat::Today today = strat::today(project.record(), strat::HarrisMatrix::build(project.record()));
    TodayList list;
    for (const model::UnitIndex unit : today.open) list.open.push_back(index.name(unit));
    for (const model::UnitIndex unit : today.diggable) list.may_be_dug_next.push_back(index.name(unit));
    for (const strat::SheetGaps& gaps : today.gaps) {
        IncompleteSheet sheet;
        sheet.unit = index.name(gaps.unit);
        if (gaps.level) sheet.missing.emplace_back("level");
        if (gaps.description) sheet.missing.emplace_back("description");
        if (gaps.relation) sheet.missing.emplace_back("relation below");
        list.incomplete_sheets.push_back(std::move(sheet));
    }
    return list;
}

} // namespace planum::app
