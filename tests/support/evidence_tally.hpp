// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "scans/surface/conclusions.hpp"
#include "tests/support/demo_surfaces.hpp"

namespace planum::test {

/// How the proposals compare with the truth of a dig.
struct EvidenceTally {
    int digs = 0;
    int relations = 0;
    int inverted = 0; ///< the earlier one was called the later
    int physical = 0; ///< covers, cuts, fills
    int contacts = 0; ///< of these, real contacts
    int questions = 0;
    int idle_questions = 0; ///< whose answer the proposals imply already
    int visible = 0;        ///< real contacts seen with 0.1 m² and more
    int recalled = 0;       ///< of these proposed, implied or asked
    int faint = 0;          ///< with 0.02 to 0.1 m²
    int faint_recalled = 0;
    std::vector<std::pair<int, int>> missed; ///< later, earlier; of one dig

    EvidenceTally& operator+=(const EvidenceTally& o) {
        digs += o.digs;
        relations += o.relations;
        inverted += o.inverted;
        physical += o.physical;
        contacts += o.contacts;
        questions += o.questions;
        idle_questions += o.idle_questions;
        visible += o.visible;
        recalled += o.recalled;
        faint += o.faint;
        faint_recalled += o.faint_recalled;
        return *this;
    }

    [[nodiscard]] static double share(int part, int whole) { return whole == 0 ? 1.0 : double(part) / whole; }

    [[nodiscard]] double precision() const { return share(relations - inverted, relations); }

    [[nodiscard]] double contact_share() const { return share(contacts, physical); }

    [[nodiscard]] double recall() const { return share(recalled, visible); }

    [[nodiscard]] double faint_recall() const { return share(faint_recalled, faint); }

    [[nodiscard]] double questions_per_relation() const { return share(questions, relations); }

    void print(const std::string& name) const {
        std::printf(
            "%-24s digs %3d  relations %5d  inverted %d  contacts %5.1f %%  recall %5.1f %% of %d  faint %5.1f %% "
            "of %d  questions %d (%.2f a relation)\n",
            name.c_str(), digs, relations, inverted, 100.0 * contact_share(), 100.0 * recall(), visible,
            100.0 * faint_recall(), faint, questions, questions_per_relation());
    }
};

/// Where something was measured of units that came and went between two surfaces.
inline std::vector<std::size_t> hidden_cells(const app::demo::DemoDig& dig, const scans::GridFrame& frame,
                                             app::demo::SurfaceNo lower) {
    std::set<std::string> drawn;
    for (const app::demo::DrawnRegion& region : dig.regions) {
        if (region.unit != app::demo::kAir)
            drawn.insert(dig.formation.units()[static_cast<std::size_t>(region.unit)].number);
    }
    std::set<std::string> hidden;
    for (const app::demo::RecordedUnit& unit : dig.record.units) {
        if (!drawn.contains(unit.number) && unit.excavated_on == dig.plan.days[static_cast<std::size_t>(lower)])
            hidden.insert(unit.number);
    }
    std::vector<std::size_t> cells;
    for (const app::demo::RecordedLevel& level : dig.record.levels) {
        if (!hidden.contains(level.unit)) continue;
        const auto column = static_cast<std::int32_t>(std::floor(level.at.x / frame.cell) - double(frame.west));
        const auto row = static_cast<std::int32_t>(std::floor(level.at.y / frame.cell) - double(frame.south));
        if (column >= 0 && row >= 0 && column < frame.columns && row < frame.rows)
            cells.push_back(frame.at(row, column));
    }
    return cells;
}

/// What was seen of a dig, gathered from surfaces and outlines.
inline scans::AreaHistory history_of(const app::demo::DemoDig& dig, const GroundNoise& noise = {}) {
    scans::AreaHistory history;
    scans::LabelledSurface last;
    std::vector<float> floor;
    const scans::HeightTolerance tolerance;
    for (app::demo::SurfaceNo s = 0; s < dig.plan.surfaces; ++s) {
        const scans::SurfaceGrid grid = surface_of(dig, s, noise);
        const std::vector<model::Region> regions = regions_of(dig, s, noise);
        std::vector<scans::UnitNumber> units;
        for (const model::Region& region : regions) {
            units.push_back(region.unit.is_nil() ? scans::kNobody
                                                 : static_cast<scans::UnitNumber>(region.unit.value.low) - 1);
        }
        auto here = scans::label_surface(grid, scans::label_cells(grid.frame, regions), regions, units, tolerance);
        history.methods.push_back(dig.options.method);
        history.summaries.push_back(scans::summarise(here));
        if (s > 0) {
            const auto hidden = hidden_cells(dig, grid.frame, s);
            history.steps.push_back(scans::step_between(last, here, tolerance, hidden, floor));
        }
        last = std::move(here);
    }
    return history;
}

/// Compares conclusions with the truth. Says what is inverted on stdout when `loud`.
inline EvidenceTally tally_of(const app::demo::DemoDig& dig, const std::vector<scans::Conclusion>& conclusions,
                              bool loud = false) {
    const std::size_t n = dig.formation.units().size();
    const auto name = [&](int u) { return dig.formation.units()[static_cast<std::size_t>(u)].number; };
    EvidenceTally tally;
    tally.digs = 1;
    std::set<std::pair<int, int>> contacts;
    for (const app::demo::Contact& c : dig.contacts) contacts.emplace(c.later, c.earlier);
    std::vector<std::vector<char>> above(n, std::vector<char>(n, 0));
    std::set<std::pair<int, int>> asked;
    for (const scans::Conclusion& c : conclusions) {
        if (c.is_question) {
            ++tally.questions;
            if (loud) {
                const bool real = std::any_of(dig.contacts.begin(), dig.contacts.end(), [&](const auto& k) {
                    return std::max(c.unit, c.other) == k.later && std::min(c.unit, c.other) == k.earlier;
                });
                std::printf("  question ground %d %s %s area %.3f seed %d %s %s\n", static_cast<int>(c.ground),
                            real ? "contact" : "none", c.unit > c.other ? "upright" : "reversed", c.area,
                            static_cast<int>(dig.options.seed), name(c.unit).c_str(), name(c.other).c_str());
            }
            asked.emplace(std::max(c.unit, c.other), std::min(c.unit, c.other));
            continue;
        }
        ++tally.relations;
        above[static_cast<std::size_t>(c.unit)][static_cast<std::size_t>(c.other)] = 1;
        const auto& formed = dig.formation.units();
        const bool same = formed[static_cast<std::size_t>(c.unit)].twin == c.other ||
                          formed[static_cast<std::size_t>(c.unit)].bonded == c.other ||
                          formed[static_cast<std::size_t>(c.other)].twin == c.unit ||
                          formed[static_cast<std::size_t>(c.other)].bonded == c.unit;
        if (c.unit < c.other || same) {
            ++tally.inverted;
            if (loud) {
                std::printf("  seed %d INVERTED %s > %s ground %d area %.3f surfaces %zu > %zu\n",
                            static_cast<int>(dig.options.seed), name(c.unit).c_str(), name(c.other).c_str(),
                            static_cast<int>(c.ground), c.area, c.from, c.to);
            }
        }
        if (c.kind == model::RelationKind::Later) continue;
        ++tally.physical;
        const bool real = contacts.contains({c.unit, c.other});
        tally.contacts += real ? 1 : 0;
        if (!real && loud) {
            std::printf("  seed %d no contact %s/%d %s %s/%d ground %d area %.3f surfaces %zu > %zu\n",
                        static_cast<int>(dig.options.seed), name(c.unit).c_str(),
                        static_cast<int>(formed[static_cast<std::size_t>(c.unit)].form),
                        std::string(model::to_word(c.kind)).c_str(), name(c.other).c_str(),
                        static_cast<int>(formed[static_cast<std::size_t>(c.other)].form), static_cast<int>(c.ground),
                        c.area, c.from, c.to);
        }
    }
    for (std::size_t k = 0; k < n; ++k) {
        for (std::size_t i = 0; i < n; ++i) {
            if (above[i][k] == 0) continue;
            for (std::size_t j = 0; j < n; ++j) above[i][j] |= above[k][j];
        }
    }
    for (const app::demo::Contact& c : dig.contacts) {
        const auto seen = dig.seen.find({c.later, c.earlier});
        if (seen == dig.seen.end() || seen->second.area < 0.02) continue;
        if (model::time_meaning(c.kind) != model::TimeMeaning::SubjectLater) continue;
        const bool found = above[static_cast<std::size_t>(c.later)][static_cast<std::size_t>(c.earlier)] != 0 ||
                           asked.contains({c.later, c.earlier});
        const bool visible = seen->second.area >= 0.1;
        ++(visible ? tally.visible : tally.faint);
        if (found) ++(visible ? tally.recalled : tally.faint_recalled);
        if (!found) tally.missed.emplace_back(c.later, c.earlier);
        if (!found && loud) {
            std::printf("  seed %d missed %s %s %s seen %.3f surfaces %d > %d\n", static_cast<int>(dig.options.seed),
                        name(c.later).c_str(), std::string(model::to_word(c.kind)).c_str(), name(c.earlier).c_str(),
                        seen->second.area, seen->second.from, seen->second.to);
        }
    }
    return tally;
}

inline app::demo::DemoDig demo_dig(std::uint64_t seed, model::DigMethod method,
                                   app::demo::DemoSize size = app::demo::DemoSize::Medium) {
    app::demo::SimulationOptions options;
    options.seed = seed;
    options.size = size;
    options.method = method;
    return app::demo::simulate(options, Progress::none());
}

} // namespace planum::test
