// SPDX-License-Identifier: MIT
#include "strat/checks/decisions.hpp"

#include <unordered_map>

namespace planum::strat {

namespace {

constexpr double kGrownByHalf = 1.5;

bool still_holds(const model::Decision& decision, const model::Diagnostic& diagnostic) {
    if (decision.evidence_hash != diagnostic.evidence_hash) return false;
    return decision.area <= 0.0 || evidence_area(diagnostic) <= kGrownByHalf * decision.area;
}

} // namespace

double evidence_area(const model::Diagnostic& diagnostic) noexcept {
    const auto it = diagnostic.evidence.find("area_m2");
    if (it == diagnostic.evidence.end()) return 0.0;
    const auto* area = std::get_if<double>(&it->second);
    return area == nullptr ? 0.0 : *area;
}

std::vector<ReviewedDiagnostic> review(std::vector<model::Diagnostic> diagnostics,
                                       std::span<const model::Decision> decisions) {
    std::unordered_map<std::string, const model::Decision*> last;
    std::string signed_at;
    for (const model::Decision& decision : decisions) {
        if (decision.kind == "sign-off") {
            signed_at = std::max(signed_at, decision.made_at);
        } else if (decision.kind == "diagnostic") {
            const model::Decision*& held = last[decision.subject_id];
            if (held == nullptr || held->made_at <= decision.made_at) held = &decision;
        }
    }
    std::unordered_map<std::string, const model::Decision*> known;
    for (const model::Decision& decision : decisions) {
        if (decision.kind == "sign-off" && decision.made_at == signed_at) known[decision.subject_id] = &decision;
    }
    std::vector<ReviewedDiagnostic> reviewed;
    reviewed.reserve(diagnostics.size());
    for (model::Diagnostic& diagnostic : diagnostics) {
        ReviewedDiagnostic r;
        if (const auto it = last.find(diagnostic.id); it != last.end() && it->second->verdict == "accepted") {
            r.accepted = still_holds(*it->second, diagnostic);
            r.reopened = !r.accepted;
            r.because = it->second->because;
        }
        const auto seen = known.find(diagnostic.id);
        r.is_new = seen == known.end() || !still_holds(*seen->second, diagnostic);
        r.diagnostic = std::move(diagnostic);
        reviewed.push_back(std::move(r));
    }
    return reviewed;
}

model::Decision accept(const model::Diagnostic& diagnostic, std::string because) {
    model::Decision decision;
    decision.subject_id = diagnostic.id;
    decision.kind = "diagnostic";
    decision.verdict = "accepted";
    decision.because = std::move(because);
    decision.evidence_hash = diagnostic.evidence_hash;
    decision.area = evidence_area(diagnostic);
    return decision;
}

std::vector<model::Decision> sign_off(std::span<const model::Diagnostic> diagnostics, const std::string& made_at) {
    std::vector<model::Decision> decisions(1);
    for (const model::Diagnostic& diagnostic : diagnostics) {
        decisions.push_back(accept(diagnostic, {}));
    }
    for (model::Decision& decision : decisions) {
        decision.kind = "sign-off";
        decision.verdict = "seen";
        decision.made_at = made_at;
    }
    return decisions;
}

} // namespace planum::strat
