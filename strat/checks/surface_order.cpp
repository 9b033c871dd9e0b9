// SPDX-License-Identifier: MIT
#include "core/model/surface_order.hpp"

#include <string>

#include <fmt/format.h>

#include "strat/checks/families.hpp"
#include "strat/checks/finish.hpp"

namespace planum::strat {

namespace {

std::string called(const model::Surface& surface) { return surface.name.empty() ? surface.first_day : surface.name; }

} // namespace

void check_surface_order(const CheckContext& context, Findings& findings) {
    if (context.record.scans.empty()) return;
    for (const model::OrderClash& clash : model::clashes_of_order(context.record)) {
        const std::string earlier = called(*clash.earlier);
        const std::string later = called(*clash.later);
        auto d = make_diagnostic(model::Severity::Warning, "surface-order",
                                 fmt::format("surface {} of {} stands before {} of {} in the order of surfaces, though "
                                             "its day is later: nothing is concluded from either until they are put "
                                             "in their order (planum surface set --order)",
                                             earlier, clash.earlier->first_day, later, clash.later->first_day));
        d.evidence["surface"] = earlier;
        d.evidence["since"] = later;
        findings.push_back(std::move(d));
    }
}

} // namespace planum::strat
