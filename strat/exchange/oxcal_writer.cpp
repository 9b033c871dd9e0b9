// SPDX-License-Identifier: MIT
// A chronological model for OxCal 4 (CQL2): the dates, what the phases and the orders between dated units say.
#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/base/text.hpp"
#include "strat/exchange/write_support.hpp"
#include "strat/exchange/writers.hpp"
#include "strat/matrix/harris_matrix.hpp"

namespace planum::strat {

namespace {

using model::DatingKind;

// OxCal has no way to write a quotation mark inside a name.
std::string quoted(std::string_view name) {
    std::string out = "\"";
    for (const char c : text::clean_utf8(name).text) out += c == '"' || c == '\n' || c == '\t' ? ' ' : c;
    return out + "\"";
}

/// One date of a node as OxCal writes it.
struct Event {
    std::string name;
    std::string command; ///< `R_Date("A-101",3275,75)`, with a bound around it where it is only one
};

/// The place of a phase among phases: of its period, then its own.
using PhaseKey = std::tuple<std::int64_t, std::int64_t>;

class OxcalModel {
  public:
    explicit OxcalModel(const RecordNames& names)
        : names_(names), record_(names.record()), index_(record_), matrix_(HarrisMatrix::build(record_)) {
        for (const model::Dating& dating : record_.datings) add(dating);
        find_orders();
    }

    [[nodiscard]] Written write() {
        std::string out = fmt::format("// {}: {} dates of {} units\n", names_line(), count_, events_.size());
        out += "Plot()\n{\n";
        const auto sequence = phase_sequence();
        out += sequence ? *sequence : one_phase();
        for (const auto& [later, earlier] : orders_) {
            if (sequence && implied(later, earlier)) continue;
            out += fmt::format(" Sequence()\n {{\n{}{} }};\n", references(earlier), references(later));
        }
        out += "};\n";
        add_loss(lost_, undated_, "dates without a radiocarbon age or a year");
        add_loss(lost_, lonely_, "dates of no unit");
        lost_.emplace_back("units without dates: only the order that they make between dated ones");
        return {{{"", std::move(out)}}, std::move(lost_)};
    }

  private:
    [[nodiscard]] std::string names_line() const {
        return text::replace_all(text::clean_utf8(record_.settings.name).text, "\n", " ");
    }

    [[nodiscard]] UnitIndex unit_of(const model::Dating& dating) const {
        if (!dating.unit.is_nil()) return index_.find(dating.unit);
        const auto find = std::find_if(record_.finds.begin(), record_.finds.end(),
                                       [&](const model::Find& f) { return f.id == dating.find; });
        return find == record_.finds.end() || find->unit.is_nil() ? model::kNoUnit : index_.find(find->unit);
    }

    void add(const model::Dating& dating) {
        const UnitIndex unit = unit_of(dating);
        if (unit == model::kNoUnit) {
            ++lonely_;
            return;
        }
        const std::string unit_name = index_.name(unit);
        const std::string name = taken_.take(dating.label.empty() ? "unit " + unit_name : dating.label);
        const std::optional<std::string> command = command_of(dating, name);
        if (!command) {
            ++undated_;
            return;
        }
        events_[matrix_.node_of(unit)].push_back({name, *command});
        ++count_;
    }

    // "direct" events lie inside the time of the unit, "disjunct" ones before its end only: not earlier than.
    static std::optional<std::string> command_of(const model::Dating& dating, const std::string& name) {
        if (dating.bp) {
            const std::string date =
                fmt::format("R_Date({},{:.0f},{:.0f})", quoted(name), *dating.bp, dating.bp_error.value_or(0.0));
            if (dating.association == "disjunct") return fmt::format("After({},{})", quoted(name + " after"), date);
            if (dating.association == "disparate") return fmt::format("Before({},{})", quoted(name + " before"), date);
            return date;
        }
        switch (dating.kind) {
        case DatingKind::Typed:
            if (!dating.from || !dating.to) return std::nullopt;
            return fmt::format("Date({},U({},{}))", quoted(name), *dating.from, *dating.to);
        case DatingKind::Find:
        case DatingKind::Coin:
        case DatingKind::Radiocarbon:
        case DatingKind::PostQuem:
            if (!dating.from) return std::nullopt;
            return fmt::format("After({},C_Date({},{},1))", quoted(name + " after"), quoted(name), *dating.from);
        case DatingKind::AnteQuem:
            if (!dating.to) return std::nullopt;
            return fmt::format("Before({},C_Date({},{},1))", quoted(name + " before"), quoted(name), *dating.to);
        }
        return std::nullopt;
    }

    // Nodes below one that are dated, through undated ones too; cycles order nothing.
    [[nodiscard]] std::set<NodeIndex> dated_below(NodeIndex later) const {
        std::vector<NodeIndex> todo{later};
        std::vector<bool> seen(matrix_.node_count());
        std::set<NodeIndex> found;
        for (std::size_t i = 0; i < todo.size(); ++i) {
            for (const std::uint32_t order : matrix_.orders_below(todo[i])) {
                const NodeIndex next = matrix_.orders()[order].earlier;
                if (seen[next]) continue;
                seen[next] = true;
                todo.push_back(next);
                if (events_.contains(next) && matrix_.component_of(next) != matrix_.component_of(later)) {
                    found.insert(next);
                }
            }
        }
        return found;
    }

    // The orders among dated nodes that no third dated node implies.
    void find_orders() {
        std::map<NodeIndex, std::set<NodeIndex>> below;
        for (const auto& [node, events] : events_) below[node] = dated_below(node);
        for (const auto& [later, all] : below) {
            for (const NodeIndex earlier : all) {
                const bool between = std::any_of(all.begin(), all.end(),
                                                 [&](NodeIndex node) { return below.at(node).contains(earlier); });
                if (!between) orders_.emplace_back(later, earlier);
            }
        }
    }

    [[nodiscard]] const model::Phase* phase_of(NodeIndex node) const {
        for (const UnitIndex unit : matrix_.members(node)) {
            for (const model::Phase& phase : record_.phases) {
                if (phase.id == record_.units[unit].phase) return &phase;
            }
        }
        return nullptr;
    }

    [[nodiscard]] std::optional<PhaseKey> key_of(const model::Phase& phase) const {
        if (!phase.rank) return std::nullopt;
        if (phase.period.is_nil()) return PhaseKey{0, *phase.rank};
        for (const model::Period& period : record_.periods) {
            if (period.id == phase.period && period.rank) return PhaseKey{*period.rank, *phase.rank};
        }
        return std::nullopt;
    }

    [[nodiscard]] std::optional<PhaseKey> key_of(NodeIndex node) const {
        const model::Phase* phase = phase_of(node);
        return phase == nullptr ? std::nullopt : key_of(*phase);
    }

    [[nodiscard]] bool implied(NodeIndex later, NodeIndex earlier) const {
        const auto a = key_of(later);
        const auto b = key_of(earlier);
        return a && b && *a > *b;
    }

    [[nodiscard]] std::string dates(NodeIndex node) const {
        std::string out;
        for (const Event& event : events_.at(node)) out += fmt::format("   {};\n", event.command);
        return out;
    }

    [[nodiscard]] std::string references(NodeIndex node) const {
        std::string out = "  Phase()\n  {\n";
        for (const Event& event : events_.at(node)) out += fmt::format("   Date({});\n", quoted("=" + event.name));
        return out + "  };\n";
    }

    // Phases as a sequence, where their order is known for every dated unit and no observed order denies it.
    [[nodiscard]] std::optional<std::string> phase_sequence() {
        std::map<PhaseKey, std::vector<NodeIndex>> phases;
        std::map<PhaseKey, const model::Phase*> of_key;
        for (const auto& [node, events] : events_) {
            const auto key = key_of(node);
            if (!key) return std::nullopt;
            const model::Phase* phase = phase_of(node);
            if (!of_key.emplace(*key, phase).second && of_key[*key] != phase) return std::nullopt;
            phases[*key].push_back(node);
        }
        for (const auto& [later, earlier] : orders_) {
            if (*key_of(later) >= *key_of(earlier)) continue;
            lost_.push_back(fmt::format("phases: {} lies over {} though its phase is the earlier one",
                                        index_.name(matrix_.members(later).front()),
                                        index_.name(matrix_.members(earlier).front())));
            return std::nullopt;
        }
        if (phases.empty()) return std::nullopt;
        std::string out = " Sequence()\n {\n";
        for (const auto& [key, nodes] : phases) {
            out += bounded(nodes, "phase " + names_.phase(of_key[key]->id));
        }
        return out + " };\n";
    }

    [[nodiscard]] std::string one_phase() const {
        if (events_.empty()) return {};
        std::vector<NodeIndex> nodes;
        nodes.reserve(events_.size());
        for (const auto& [node, events] : events_) nodes.push_back(node);
        return " Sequence()\n {\n" + bounded(nodes, "site") + " };\n";
    }

    [[nodiscard]] std::string bounded(const std::vector<NodeIndex>& nodes, const std::string& name) const {
        std::string out = fmt::format("  Boundary({});\n  Phase({})\n  {{\n", quoted("start of " + name), quoted(name));
        for (const NodeIndex node : nodes) out += dates(node);
        return out + fmt::format("  }};\n  Boundary({});\n", quoted("end of " + name));
    }

    const RecordNames& names_;
    const model::Record& record_;
    model::RecordIndex index_;
    HarrisMatrix matrix_;
    UniqueNames taken_;
    std::map<NodeIndex, std::vector<Event>> events_;
    std::vector<std::pair<NodeIndex, NodeIndex>> orders_; ///< later, earlier
    std::vector<std::string> lost_;
    std::size_t count_ = 0;
    std::size_t undated_ = 0;
    std::size_t lonely_ = 0;
};

} // namespace

Written write_oxcal(const model::Record& record, const WriteOptions& /*options*/) {
    const RecordNames names(record);
    return OxcalModel(names).write();
}

} // namespace planum::strat
