// SPDX-License-Identifier: MIT
#include "app/checks/daily_check.hpp"

#include <algorithm>
#include <unordered_set>

#include <fmt/format.h>

#include "core/base/error.hpp"

namespace planum::app {

std::vector<const model::Interpretation*> lineage(const model::Record& record, const std::string& name) {
    std::vector<const model::Interpretation*> line;
    const auto find = [&](auto matches) -> const model::Interpretation* {
        const auto it = std::find_if(record.interpretations.begin(), record.interpretations.end(), matches);
        return it == record.interpretations.end() ? nullptr : &*it;
    };
    const model::Interpretation* at = find([&](const auto& i) { return i.name == name; });
    if (at == nullptr) throw Error(ErrorCode::NotFound, fmt::format("no interpretation {}", name));
    while (at != nullptr && std::find(line.begin(), line.end(), at) == line.end()) {
        line.push_back(at);
        const model::InterpretationId parent = at->parent;
        at = parent.is_nil() ? nullptr : find([&](const auto& i) { return i.id == parent; });
    }
    return line;
}

model::Record interpreted(const model::Record& record, const std::string& interpretation) {
    model::Record result = record;
    if (interpretation.empty()) return result;
    std::vector<const model::Interpretation*> line = lineage(record, interpretation);
    std::reverse(line.begin(), line.end()); // the eldest speaks first
    for (const model::Interpretation* step : line) {
        const std::unordered_set<model::RelationId> dropped(step->dropped.begin(), step->dropped.end());
        std::erase_if(result.relations, [&](const auto& relation) { return dropped.contains(relation.id); });
        result.relations.insert(result.relations.end(), step->added.begin(), step->added.end());
    }
    model::sort_record(result);
    return result;
}

} // namespace planum::app
