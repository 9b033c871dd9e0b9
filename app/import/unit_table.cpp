// SPDX-License-Identifier: MIT
#include "app/import/unit_table.hpp"

#include <algorithm>

#include "core/base/text.hpp"

namespace planum::app {

UnitTable::UnitTable(const model::Record& current, model::NumberScope scope, UuidSource& ids)
    : scope_(scope), method_(current.settings.method), ids_(&ids) {
    for (const model::Area& area : current.areas) {
        area_ids_.emplace(area.name, area.id);
        area_names_.emplace(area.id, area.name);
    }
    entries_.reserve(current.units.size());
    for (const model::StratigraphicUnit& unit : current.units) {
        const std::size_t position = entries_.size();
        entries_.push_back({unit, false, false});
        by_key_.emplace(key(area_name(unit.area), unit.number), position);
        by_number_[unit.number].push_back(position);
    }
}

std::string UnitTable::key(const std::string& area, const std::string& number) const {
    return scope_ == model::NumberScope::Site ? number : area + '\x1F' + number;
}

std::size_t UnitTable::of_sheet(const strat::UnitName& raw) {
    const strat::UnitName name{std::string(text::trim(raw.area)), std::string(text::trim(raw.number))};
    const auto it = by_key_.find(key(name.area, name.number));
    if (it == by_key_.end()) return add(name, model::UnitOrigin::Recorded);
    Entry& entry = entries_[it->second];
    if (entry.unit.origin == model::UnitOrigin::Mentioned) {
        entry.unit.origin = model::UnitOrigin::Recorded;
        entry.is_changed = true;
    }
    return it->second;
}

std::size_t UnitTable::mentioned(const strat::UnitName& raw, const std::string& from_area) {
    const strat::UnitName name{std::string(text::trim(raw.area)), std::string(text::trim(raw.number))};
    if (const auto it = by_key_.find(key(name.area, name.number)); it != by_key_.end()) return it->second;
    if (name.area.empty()) {
        const auto in_area = by_key_.find(key(from_area, name.number));
        if (in_area != by_key_.end()) return in_area->second;
        const auto anywhere = by_number_.find(name.number);
        if (anywhere != by_number_.end() && anywhere->second.size() == 1) return anywhere->second.front();
    }
    const bool speaks_of_own_area = name.area.empty() && scope_ == model::NumberScope::Area;
    return add({speaks_of_own_area ? from_area : name.area, name.number}, model::UnitOrigin::Mentioned);
}

std::size_t UnitTable::add(const strat::UnitName& name, model::UnitOrigin origin) {
    Entry entry;
    entry.unit.id = model::UnitId{ids_->next()};
    entry.unit.number = name.number;
    entry.unit.area = area(name.area);
    entry.unit.origin = origin;
    entry.is_new = true;
    const std::size_t position = entries_.size();
    entries_.push_back(std::move(entry));
    by_key_.emplace(key(name.area, name.number), position);
    by_number_[name.number].push_back(position);
    return position;
}

model::AreaId UnitTable::area(const std::string& name) {
    if (name.empty()) return {};
    if (const auto it = area_ids_.find(name); it != area_ids_.end()) return it->second;
    model::Area area;
    area.id = model::AreaId{ids_->next()};
    area.name = name;
    area.method = method_;
    area_ids_.emplace(name, area.id);
    area_names_.emplace(area.id, name);
    new_areas_.push_back(area);
    return area.id;
}

void UnitTable::offer(const model::Area& offered) {
    const model::AreaId id = area(offered.name);
    const auto made = std::find_if(new_areas_.begin(), new_areas_.end(), [&](const auto& a) { return a.id == id; });
    if (made == new_areas_.end()) return;
    if (made->title.empty()) made->title = offered.title;
    if (made->first_number.empty()) made->first_number = offered.first_number;
    if (made->last_number.empty()) made->last_number = offered.last_number;
    // Readers give stratigraphic where their source is silent.
    if (offered.method != model::DigMethod::Stratigraphic) made->method = offered.method;
}

std::string UnitTable::area_name(model::AreaId id) const {
    const auto it = area_names_.find(id);
    return it == area_names_.end() ? std::string{} : it->second;
}

std::string UnitTable::display_of(model::UnitId id) const {
    for (std::size_t position = 0; position < entries_.size(); ++position) {
        if (entries_[position].unit.id == id) return display(position);
    }
    return {};
}

std::string UnitTable::display(std::size_t position) const {
    const model::StratigraphicUnit& unit = entries_[position].unit;
    const std::string area = area_name(unit.area);
    return scope_ == model::NumberScope::Site || area.empty() ? unit.number : area + "::" + unit.number;
}

} // namespace planum::app
