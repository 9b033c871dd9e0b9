// SPDX-License-Identifier: MIT
#include "strat/layout/drawn_graph.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <unordered_map>
#include <unordered_set>

#include "core/base/text.hpp"
#include "strat/layout/band_choice.hpp"
#include "strat/layout/box_label.hpp"
#include "strat/layout/drawing_style.hpp"
#include "strat/layout/graph_selection.hpp"
#include "strat/layout/inner_contradictions.hpp"
#include "strat/matrix/condensation.hpp"

namespace planum::strat {

namespace {

using model::UnitIndex;
using model::UnitKind;

std::string one_line(const std::string& words) { return text::on_one_line(words).text; }

class GraphMaker {
  public:
    explicit GraphMaker(const LayoutRequest& request)
        : request_(request), record_(request.record), index_(record_), selection_(select(request)),
          fold_keys_(fold_keys(request.record, request.options.fold)) {}

    DrawnGraph make() {
        collect_units();
        graph_.boxes.resize(selection_.box_count);
        for (std::uint32_t b = 0; b < selection_.box_count; ++b) fill_box(b);
        make_ids_unique();
        make_orders();
        make_contemporaries();
        choose_bands(record_, request_.options, graph_);
        choose_groups();
        place_previous();
        describe();
        mark_inner_contradictions(graph_, request_, selection_);
        return std::move(graph_);
    }

  private:
    void collect_units() {
        units_.resize(selection_.box_count);
        for (NodeIndex node = 0; node < request_.matrix.node_count(); ++node) {
            const std::uint32_t box = selection_.box_of[node];
            if (box == Selection::kLeftOut) continue;
            for (const UnitIndex unit : request_.matrix.members(node)) units_[box].push_back(unit);
        }
        for (std::size_t b = 0; b < units_.size(); ++b) {
            if (selection_.folded[b] >= 0) continue;
            std::stable_sort(units_[b].begin(), units_[b].end(), [&](UnitIndex u, UnitIndex v) {
                return text::natural_order(index_.name(u), index_.name(v)) < 0;
            });
        }
        for (const model::PhysicalRelation& r : record_.relations) {
            if (r.kind != model::RelationKind::SameAs || r.certainty != model::Certainty::Certain) continue;
            certainly_same_.emplace_back(index_.find(r.subject), index_.find(r.object));
        }
        for (const model::Find& find : record_.finds) with_finds_.insert(find.unit);
        for (const UnitMark& mark : request_.options.marks) unit_marks_.emplace(mark.unit, mark.mark);
    }

    void fill_box(std::uint32_t b) {
        GraphBox& out = graph_.boxes[b];
        DrawnBox& box = out.box;
        out.units = units_[b];
        const std::string first_title = one_line(record_.units[out.units.front()].title);
        out.name = one_line(index_.name(out.units.front()));
        box.mentioned_only = true;
        std::vector<std::string>& names = box.names;
        for (const UnitIndex u : out.units) {
            const model::StratigraphicUnit& unit = record_.units[u];
            box.units.push_back(unit.id);
            const std::string name = index_.name(u);
            names.push_back(one_line(name));
            box.unit_ids.push_back(xml_id("unit-", name));
            if (!request_.options.unit_link.empty()) {
                box.links.push_back(unit_link_of(request_.options.unit_link, name, unit.id));
            }
            box.has_finds = box.has_finds || with_finds_.contains(unit.id);
            box.mentioned_only = box.mentioned_only && unit.origin == model::UnitOrigin::Mentioned;
            if (box.shape == BoxShape::Unknown) box.shape = shape_of(unit);
            out.on_top = out.on_top || names_topsoil(unit);
            const auto mark = unit_marks_.find(unit.id);
            if (mark != unit_marks_.end()) box.mark = std::max(box.mark, mark->second);
        }
        if (selection_.folded[b] >= 0) {
            fold_box(out, selection_.folded[b]);
        } else {
            box.id = box.unit_ids.front();
            const std::vector<bool> doubtful = doubtfully_joined(out.units);
            box.lines = joined_names(names, doubtful, request_.text);
            for (std::size_t i = 0; i < names.size(); ++i)
                box.title += (i == 0 ? "" : doubtful[i] ? " =? " : " = ") + names[i];
            if (!first_title.empty()) box.title += ": " + first_title;
            if (request_.options.labels == Labels::NumbersAndTitles && !first_title.empty()) {
                for (std::string& line : broken_title(first_title, request_.text)) box.lines.push_back(std::move(line));
            }
        }
        out.at_bottom = box.shape == BoxShape::Natural;
        size_box(box, request_.text);
    }

    void fold_box(GraphBox& out, std::int32_t folded) {
        const auto key = static_cast<std::size_t>(folded);
        DrawnBox& box = out.box;
        std::string number;
        std::string title;
        switch (request_.options.fold) {
        case Fold::None: break;
        case Fold::Phases:
            number = record_.phases[key].number;
            title = record_.phases[key].title;
            break;
        case Fold::Periods:
            number = record_.periods[key].number;
            title = record_.periods[key].title;
            break;
        case Fold::Groups:
            number = record_.groups[key].number;
            title = record_.groups[key].title;
            break;
        }
        number = one_line(number);
        title = one_line(title);
        box.shape = BoxShape::Folded;
        box.mentioned_only = false;
        box.id = xml_id("folded-", number);
        out.name = number;
        box.lines = broken_title(title.empty() || title == number ? number : number + " " + title, request_.text);
        if (box.lines.empty()) box.lines.emplace_back("?");
        const std::size_t count = out.units.size();
        std::size_t all = 0; // merged units fold together, whatever else each of them belongs to
        for (NodeIndex node = 0; node < request_.matrix.node_count(); ++node) {
            const auto members = request_.matrix.members(node);
            if (fold_keys_[members.front()] == folded) all += members.size();
        }
        box.lines.push_back(counted(request_.options.words, count, all));
        box.title = fmt::format("{} {}: {}", number, title, counted({}, count, all));
    }

    // Which of the units of a box no certain statement makes the same as one before it.
    [[nodiscard]] std::vector<bool> doubtfully_joined(const std::vector<UnitIndex>& units) const {
        std::vector<bool> doubtful(units.size(), false);
        if (units.size() < 2) return doubtful;
        std::vector<std::size_t> first(units.size()); // of those that certain statements join
        std::iota(first.begin(), first.end(), std::size_t{0});
        for (const auto& [subject, object] : certainly_same_) {
            const auto a = std::find(units.begin(), units.end(), subject);
            const auto b = std::find(units.begin(), units.end(), object);
            if (a == units.end() || b == units.end()) continue;
            const auto [low, high] = std::minmax(first[static_cast<std::size_t>(a - units.begin())],
                                                 first[static_cast<std::size_t>(b - units.begin())]);
            std::replace(first.begin(), first.end(), std::size_t{high}, std::size_t{low});
        }
        for (std::size_t i = 1; i < units.size(); ++i) doubtful[i] = first[i] == i;
        return doubtful;
    }

    // Of a part of the matrix the units may be a part, too.
    static std::string counted(const DrawingWords& words, std::size_t count, std::size_t all) {
        if (count < all) return with_number(with_number(words.some_units, count), all);
        return count == 1 ? words.one_unit : with_number(words.units, count);
    }

    // Two areas may have names that give one id only if the record itself is damaged; a drawing must be
    // valid all the same.
    void make_ids_unique() {
        std::unordered_map<std::string, int> used;
        const auto make_unique = [&](std::string& id) {
            const int before = used[id]++;
            if (before > 0) id += fmt::format("_n{}", before + 1); // what no name gives
        };
        for (GraphBox& b : graph_.boxes) {
            for (std::string& id : b.box.unit_ids) make_unique(id);
            if (b.box.shape == BoxShape::Folded) {
                make_unique(b.box.id);
            } else {
                b.box.id = b.box.unit_ids.front();
            }
        }
    }

    void make_orders() {
        std::map<std::pair<model::UnitId, model::UnitId>, Mark> marks;
        for (const OrderMark& m : request_.options.order_marks) marks.emplace(std::pair{m.later, m.earlier}, m.mark);
        graph_.orders.reserve(selection_.pairs.size());
        for (GraphBox& b : graph_.boxes) b.box.isolated = true;
        for (const Selection::Pair& pair : selection_.pairs) {
            GraphOrder order{pair.later, pair.earlier, {}, {}};
            DrawnLine& line = order.line;
            line.later = pair.later;
            line.earlier = pair.earlier;
            line.in_cycle = pair.in_cycle;
            line.through = pair.through;
            explain(line);
            for (const UnitIndex u : units_[pair.later]) {
                for (const UnitIndex v : units_[pair.earlier]) {
                    if (marks.empty()) break;
                    const auto mark = marks.find({record_.units[u].id, record_.units[v].id});
                    if (mark != marks.end()) line.mark = std::max(line.mark, mark->second);
                }
            }
            for (const std::uint32_t end : {pair.later, pair.earlier}) {
                DrawnBox& box = graph_.boxes[end].box;
                box.isolated = false;
                box.in_cycle = box.in_cycle || pair.in_cycle;
            }
            graph_.orders.push_back(std::move(order));
        }
        forget_removed_cycles();
    }

    // An order that was removed, together with its correction, is a cycle that nobody recorded.
    void forget_removed_cycles() {
        std::vector<Order> standing;
        for (const GraphOrder& o : graph_.orders) {
            if (o.line.mark != Mark::Removed) standing.push_back({o.later, o.earlier});
        }
        if (standing.size() == graph_.orders.size()) return;
        const Condensation condensation = condense(graph_.boxes.size(), standing);
        for (GraphBox& b : graph_.boxes) b.box.in_cycle = false;
        for (GraphOrder& o : graph_.orders) {
            const bool together = condensation.component_of[o.later] == condensation.component_of[o.earlier];
            o.line.in_cycle = together && o.line.mark != Mark::Removed;
            if (!o.line.in_cycle) continue;
            graph_.boxes[o.later].box.in_cycle = true;
            graph_.boxes[o.earlier].box.in_cycle = true;
        }
    }

    // Why an order holds: the kinds and the certainty of its relations.
    void explain(DrawnLine& line) {
        const GraphBox& later = graph_.boxes[line.later];
        const GraphBox& earlier = graph_.boxes[line.earlier];
        line.id = "order-" + later.box.id + "--" + earlier.box.id;
        const NodeIndex from = request_.matrix.node_of(units_[line.later].front());
        const NodeIndex to = request_.matrix.node_of(units_[line.earlier].front());
        const std::size_t order = request_.matrix.find_order(from, to);
        const bool folded = later.box.shape == BoxShape::Folded || earlier.box.shape == BoxShape::Folded;
        if (folded || order == HarrisMatrix::npos) {
            line.title = fmt::format("{} is later than {}", later.name, earlier.name);
            line.kind = "later";
            return;
        }
        bool certain = false;
        std::vector<std::string> kinds;
        std::vector<Statement> statements;
        for (const RelationIndex r : request_.matrix.because(order)) {
            const model::PhysicalRelation& relation = record_.relations[r];
            certain = certain || relation.certainty == model::Certainty::Certain;
            add_once(kinds, std::string(model::to_word(relation.kind)));
            const auto said = std::find_if(statements.begin(), statements.end(), [&](const Statement& s) {
                return s.subject == relation.subject && s.object == relation.object;
            });
            Statement& statement =
                said != statements.end() ? *said : statements.emplace_back(relation.subject, relation.object);
            add_once(statement.phrases, std::string(model::phrase(relation.kind)));
        }
        line.uncertain = !certain;
        line.kind = text::join(kinds, " ");
        line.title = in_words(statements) + (line.uncertain ? " (uncertain)" : "");
    }

    // What is recorded between two units; a box of several can have more than one such pair with another.
    struct Statement {
        model::UnitId subject;
        model::UnitId object;
        std::vector<std::string> phrases;

        Statement(model::UnitId s, model::UnitId o) : subject(s), object(o) {}
    };

    static void add_once(std::vector<std::string>& words, std::string word) {
        if (std::find(words.begin(), words.end(), word) == words.end()) words.push_back(std::move(word));
    }

    [[nodiscard]] std::string in_words(const std::vector<Statement>& statements) const {
        std::vector<std::string> sentences;
        for (const Statement& s : statements) {
            sentences.push_back(fmt::format("{} {} {}", one_line(index_.name(index_.find(s.subject))),
                                            text::join(s.phrases, " and "),
                                            one_line(index_.name(index_.find(s.object)))));
        }
        return text::join(sentences, "; ");
    }

    void make_contemporaries() {
        for (const Order& pair : request_.matrix.contemporaries()) {
            const std::uint32_t a = selection_.box_of[pair.later];
            const std::uint32_t b = selection_.box_of[pair.earlier];
            if (a == Selection::kLeftOut || b == Selection::kLeftOut || a == b) continue;
            graph_.contemporaries.push_back({std::min(a, b), std::max(a, b)});
        }
        // One that is contemporary with another has a place beside it, orders or not.
        for (const Order& pair : graph_.contemporaries) {
            for (const std::uint32_t end : {pair.later, pair.earlier}) graph_.boxes[end].box.isolated = false;
        }
        std::sort(graph_.contemporaries.begin(), graph_.contemporaries.end());
        graph_.contemporaries.erase(std::unique(graph_.contemporaries.begin(), graph_.contemporaries.end()),
                                    graph_.contemporaries.end());
    }

    void choose_groups() {
        if (request_.options.frames == Frames::None || request_.options.fold == Fold::Groups) return;
        const std::vector<std::int32_t> keys = fold_keys(record_, Fold::Groups);
        std::map<std::int32_t, std::int32_t> used;
        for (GraphBox& b : graph_.boxes) {
            const std::int32_t key = shared_key(keys, b.units);
            if (key < 0) continue;
            const auto [it, fresh] = used.emplace(key, static_cast<std::int32_t>(graph_.groups.size()));
            if (fresh) {
                const model::UnitGroup& group = record_.groups[static_cast<std::size_t>(key)];
                const std::string heading = heading_with(group.number, group.title);
                graph_.groups.push_back({xml_id("group-", group.number), heading,
                                         request_.text.width(heading, style::kSmallText, FontWeight::Regular)});
            }
            b.group = it->second;
        }
    }

    void place_previous() {
        std::unordered_map<model::UnitId, DrawPoint> before;
        for (const PreviousPosition& p : request_.previous.units) before.emplace(p.unit, p.centre);
        if (before.empty()) return;
        for (GraphBox& b : graph_.boxes) {
            for (const model::UnitId unit : b.box.units) {
                const auto at = before.find(unit);
                if (at == before.end() || b.has_previous) continue;
                b.has_previous = true;
                b.previous = at->second;
            }
        }
        std::map<std::pair<model::UnitId, model::UnitId>, const std::vector<DrawPoint>*> lines;
        for (const PreviousLine& line : request_.previous.lines)
            lines.emplace(std::pair(line.later, line.earlier), &line.points);
        for (GraphOrder& o : graph_.orders) {
            for (const model::UnitId later : graph_.boxes[o.later].box.units) {
                for (const model::UnitId earlier : graph_.boxes[o.earlier].box.units) {
                    const auto at = lines.find({later, earlier});
                    if (at != lines.end() && o.previous.empty()) o.previous = *at->second;
                }
            }
        }
    }

    void describe() {
        const DrawingOptions& options = request_.options;
        const std::string& name = record_.settings.name;
        graph_.words = options.words;
        graph_.title = one_line(!options.title.empty() ? options.title : name.empty() ? options.words.untitled : name);
        graph_.subtitle = one_line(options.subtitle);
        std::size_t units = 0;
        for (const GraphBox& b : graph_.boxes) units += b.units.size();
        const DrawingWords& words = options.words;
        const auto number_of = [](std::size_t count, const std::string& one, const std::string& many) {
            return count == 1 ? one : with_number(many, count);
        };
        graph_.description = words.description;
        for (const std::string& counted :
             {number_of(units, words.one_unit, words.units), number_of(graph_.boxes.size(), words.one_box, words.boxes),
              number_of(graph_.orders.size(), words.one_order, words.orders)})
            graph_.description = with_word(graph_.description, counted);
        const auto in_cycles = std::count_if(graph_.orders.begin(), graph_.orders.end(),
                                             [](const GraphOrder& o) { return o.line.in_cycle; });
        if (in_cycles > 0) graph_.description += " " + with_number(words.cycles, static_cast<std::size_t>(in_cycles));
    }

    const LayoutRequest& request_;
    const model::Record& record_;
    model::RecordIndex index_;
    Selection selection_;
    std::vector<std::int32_t> fold_keys_;
    std::vector<std::vector<UnitIndex>> units_;
    std::vector<std::pair<UnitIndex, UnitIndex>> certainly_same_;
    std::unordered_set<model::UnitId> with_finds_;
    std::unordered_map<model::UnitId, Mark> unit_marks_;
    DrawnGraph graph_;
};

} // namespace

DrawnGraph make_drawn_graph(const LayoutRequest& request) { return GraphMaker(request).make(); }

MatrixDrawing drawing_without_places(const DrawnGraph& graph) {
    MatrixDrawing drawing;
    drawing.title = graph.title;
    drawing.description = graph.description;
    for (const GraphBox& b : graph.boxes) drawing.boxes.push_back(b.box);
    for (const GraphOrder& o : graph.orders) drawing.lines.push_back(o.line);
    return drawing;
}

} // namespace planum::strat
