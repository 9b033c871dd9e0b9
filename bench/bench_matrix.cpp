// SPDX-License-Identifier: MIT
//
// ./dev bench matrix [--quick]: generated records of 500 to 20,000 units, imported, checked and reduced, beside
// Graphviz's tred and Boost's transitive_reduction on the same orders in the same run.

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <random>
#include <string>
#include <unordered_map>
#include <vector>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/transitive_reduction.hpp>

#include <fmt/format.h>

#include "app/demo/record_generator.hpp"
#include "bench/bench_support.hpp"
#include "strat/matrix/condensation.hpp"
#include "strat/matrix/harris_matrix.hpp"

using namespace planum;
using bench::Measured;

namespace {

// A record as lists of a planum-csv file: numbers, kinds, and who covers whom.
struct Lists {
    std::string name;
    std::vector<std::string> units; ///< lines of units.csv
    std::vector<std::string> relations;
};

Lists lists_of(const model::Record& record, const std::string& name) {
    Lists lists;
    lists.name = name;
    std::unordered_map<model::UnitId, const model::StratigraphicUnit*> by_id;
    std::unordered_map<model::AreaId, std::string> areas;
    for (const auto& area : record.areas) areas[area.id] = area.name;
    for (const auto& unit : record.units) {
        by_id[unit.id] = &unit;
        const auto word = unit.form == model::UnitForm::None ? to_word(unit.kind) : to_word(unit.form);
        lists.units.push_back(unit.number + "," + std::string(word) + "," + areas[unit.area]);
    }
    std::unordered_map<model::RelationId, const model::PhysicalRelation*> relations;
    for (const auto& relation : record.relations) relations[relation.id] = &relation;
    for (const auto& relation : record.relations) {
        lists.relations.push_back(by_id[relation.subject]->number + "," + std::string(to_word(relation.kind)) + "," +
                                  by_id[relation.object]->number);
    }
    return lists;
}

// With 30 % redundant relations, as real records have them, a generated one has 1.9 relations a unit at least; the
// sparse lists of other records come from people who left the redundant ones out.
Lists generated(std::size_t units, double relations_per_unit) {
    app::RecordOptions options;
    options.seed = 20250601;
    options.units = units;
    options.relations_per_unit = relations_per_unit;
    if (relations_per_unit < 1.5) options.redundant = 0.0;
    const model::Record record = app::generate_record(options).record;
    const double rate = static_cast<double>(record.relations.size()) / static_cast<double>(units);
    return lists_of(record, fmt::format("{} units, {:.1f} a unit", units, rate));
}

// Groups of a chain, random shortcuts downwards, and one relation back from the last unit to the first: what one
// reversed statement does to a deep sequence. Filled up to 20,000 units and 100,000 relations.
Lists with_cycle_groups(std::size_t groups, std::size_t size, const std::string& name) {
    constexpr std::size_t kUnits = 20000;
    constexpr std::size_t kRelations = 100000;
    Lists lists;
    lists.name = name;
    std::mt19937_64 random(7);
    for (std::size_t u = 0; u < kUnits; ++u) lists.units.push_back(std::to_string(u) + ",layer,");
    const auto covers = [&](std::size_t a, std::size_t b) {
        lists.relations.push_back(std::to_string(a) + ",covers," + std::to_string(b));
    };
    for (std::size_t g = 0; g < groups; ++g) {
        const std::size_t first = g * size;
        for (std::size_t i = 0; i + 1 < size; ++i) covers(first + i, first + i + 1);
        covers(first + size - 1, first);
    }
    while (lists.relations.size() < kRelations) {
        const std::size_t a = random() % (kUnits - 1);
        const std::size_t b = a + 1 + random() % 30;
        const bool same_group = a / size == b / size || a >= groups * size;
        if (b < kUnits && same_group) covers(a, b);
    }
    std::sort(lists.relations.begin(), lists.relations.end());
    lists.relations.erase(std::unique(lists.relations.begin(), lists.relations.end()), lists.relations.end());
    return lists;
}

void write(const std::filesystem::path& file, const std::string& header, const std::vector<std::string>& lines) {
    std::ofstream out(file);
    out << header << '\n';
    for (const std::string& line : lines) out << line << '\n';
}

// The orders between cycle groups as a graph without cycles, for the reductions.
strat::Adjacency acyclic_part(const Lists& lists) {
    std::unordered_map<std::string, std::uint32_t> place;
    for (const std::string& line : lists.units) {
        place.emplace(line.substr(0, line.find(',')), static_cast<std::uint32_t>(place.size()));
    }
    std::vector<strat::Order> orders;
    for (const std::string& line : lists.relations) {
        const auto first = line.find(',');
        const auto second = line.find(',', first + 1);
        const std::string kind = line.substr(first + 1, second - first - 1);
        const auto word = model::relation_kind_from_word(kind);
        if (!word || model::time_meaning(*word) != model::TimeMeaning::SubjectLater) continue;
        const strat::Order order{place.at(line.substr(0, first)), place.at(line.substr(second + 1))};
        if (order.later != order.earlier) orders.push_back(order);
    }
    std::sort(orders.begin(), orders.end());
    orders.erase(std::unique(orders.begin(), orders.end()), orders.end());
    return strat::condense(place.size(), orders).below;
}

double boost_reduction(const strat::Adjacency& below, double limit) {
    using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS>;
    if (below.rows() > 25000) return limit;
    Graph graph(below.rows());
    for (std::uint32_t from = 0; from < below.rows(); ++from) {
        for (const std::uint32_t to : below.row(from)) boost::add_edge(from, to, graph);
    }
    return bench::median_seconds(1, [&] {
        Graph reduced;
        std::vector<Graph::vertex_descriptor> map(below.rows());
        std::vector<std::size_t> index(below.rows());
        for (std::size_t i = 0; i < index.size(); ++i) index[i] = i;
        boost::transitive_reduction(graph, reduced,
                                    boost::make_iterator_property_map(map.begin(), get(boost::vertex_index, graph)),
                                    get(boost::vertex_index, graph));
    });
}

Measured tred(const strat::Adjacency& below, const std::filesystem::path& file, double limit) {
    std::ofstream out(file);
    out << "digraph g {\n";
    for (std::uint32_t from = 0; from < below.rows(); ++from) {
        for (const std::uint32_t to : below.row(from)) out << from << " -> " << to << ";\n";
    }
    out << "}\n";
    out.close();
    return bench::run_child({"tred", file.string()}, limit);
}

void run(const Lists& lists, const std::string& planum) {
    const bench::Scratch scratch;
    const std::string site = scratch / "site.gpkg";
    write(scratch / "units.csv", "unit,kind,area", lists.units);
    write(scratch / "relations.csv", "unit,relation,other", lists.relations);
    bench::run_child({planum, "new", site}, 10);
    const Measured import =
        bench::run_child({planum, "import", site, scratch / "units.csv", scratch / "relations.csv"}, 600);
    Measured check;
    std::vector<double> walls;
    for (int i = 0; i < 3; ++i) {
        check = bench::run_child({planum, "check", "--json", site}, 600);
        walls.push_back(check.wall);
    }
    std::sort(walls.begin(), walls.end());
    const strat::Adjacency below = acyclic_part(lists);
    std::size_t redundant = 0;
    const double reduction = bench::median_seconds(5, [&] {
        const auto gone = strat::redundant_pairs(below);
        redundant = static_cast<std::size_t>(std::count(gone.begin(), gone.end(), true));
    });
    const Measured graphviz = tred(below, scratch / "orders.dot", 60);
    const double boost = boost_reduction(below, 60);
    std::printf("| %s | %zu | %.2f s, %.0f MB%s | %.3f s, %.0f MB%s | %.4f s | %zu of %zu | %.2f s | %s%.2f s |\n",
                lists.name.c_str(), lists.relations.size(), import.wall, import.peak_mb,
                import.status == 0 ? "" : " FAILED", walls[1], check.peak_mb, check.status <= 1 ? "" : " FAILED",
                reduction, redundant, below.values.size(), boost, graphviz.timed_out ? "> " : "", graphviz.wall);
    std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv) {
    const bool quick = argc > 1 && std::strcmp(argv[1], "--quick") == 0;
    const std::string planum = bench::program_folder() / "planum";
    std::printf("%s\n\n", bench::machine().c_str());
    std::printf(
        "| record | relations | planum import | planum check (median of 3) | reduction in process | redundant | "
        "Boost transitive_reduction | tred |\n|---|---|---|---|---|---|---|---|\n");
    for (const std::size_t units : {500U, 2000U, 5000U, 20000U}) {
        if (quick && units > 2000) break;
        for (const double rate : {1.2, 1.9, 5.0}) run(generated(units, rate), planum);
    }
    if (quick) return 0;
    run(with_cycle_groups(1, 10000, "20000 units, one cycle group of 10000"), planum);
    run(with_cycle_groups(200, 20, "20000 units, 200 cycle groups of 20"), planum);
    return 0;
}
