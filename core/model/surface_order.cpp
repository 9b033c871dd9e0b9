// SPDX-License-Identifier: MIT
#include "core/model/surface_order.hpp"

#include <algorithm>

namespace planum::model {

namespace {

bool clash(const Surface& a, const Surface& b) {
    return a.area == b.area && a.order < b.order && !a.first_day.empty() && !b.first_day.empty() &&
           a.first_day > b.first_day && last_day_of(a) > last_day_of(b);
}

} // namespace

std::vector<OrderClash> clashes_of_order(const Record& record) {
    std::vector<OrderClash> clashes;
    for (const Surface& surface : record.surfaces) {
        const Surface* first = nullptr;
        for (const Surface& other : record.surfaces) {
            if (clash(surface, other) && (first == nullptr || other.first_day < first->first_day)) first = &other;
        }
        if (first != nullptr) clashes.push_back({&surface, first});
    }
    return clashes;
}

bool is_in_clash(const std::vector<OrderClash>& clashes, SurfaceId surface) {
    return std::any_of(clashes.begin(), clashes.end(), [&](const OrderClash& clash) {
        return clash.earlier->id == surface || clash.later->id == surface;
    });
}

} // namespace planum::model
