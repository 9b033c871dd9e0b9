// SPDX-License-Identifier: MIT
#include "strat/matrix/harris_matrix.hpp"

#include <string>
#include <vector>

#include "tests/support/catch.hpp"
#include "tests/support/record_builder.hpp"

using namespace planum;
using model::RelationKind;
using strat::HarrisMatrix;
using strat::Order;
using test::a_record;

namespace {

std::vector<Order> reduced_orders(const HarrisMatrix& matrix) {
    std::vector<Order> orders;
    for (const auto at : matrix.reduced()) orders.push_back(matrix.orders()[at]);
    return orders;
}

} // namespace

TEST_CASE("Only immediate orders stay after reduction, the redundant one is counted") {
    const auto record = a_record().covers("1", "2").covers("2", "3").covers("1", "3").record();
    const auto matrix = HarrisMatrix::build(record);
    CHECK(reduced_orders(matrix) == std::vector<Order>{{0, 1}, {1, 2}});
    CHECK(matrix.stats().redundant == 1);
    CHECK(matrix.stats().reduced_from == 3);
    CHECK(matrix.stats().depth == 3);
}

TEST_CASE("A cycle is one component, its orders are kept and counted, the rest is still reduced") {
    const auto record =
        a_record().covers("1", "2").covers("2", "3").covers("3", "2").covers("3", "4").covers("1", "4").record();
    const auto matrix = HarrisMatrix::build(record);
    CHECK(matrix.stats().cycle_groups == 1);
    CHECK(matrix.stats().largest_cycle_group == 2);
    CHECK(matrix.stats().orders_in_cycles == 2);
    CHECK(matrix.stats().mutual == 1);
    CHECK(reduced_orders(matrix) == std::vector<Order>{{0, 1}, {1, 2}, {2, 1}, {2, 3}});
    CHECK(matrix.is_later(1, 1));
    CHECK_FALSE(matrix.is_later(0, 0));
    CHECK(matrix.is_later(0, 3));
    CHECK_FALSE(matrix.is_later(3, 0));
}

TEST_CASE("Units joined by same_as are one node, and a relation between them is no order") {
    const auto record = a_record().covers("1", "2").same_as("2", "5").covers("5", "7").covers("2", "5").record();
    const auto matrix = HarrisMatrix::build(record);
    REQUIRE(matrix.node_count() == 3);
    CHECK(matrix.node_of(1) == matrix.node_of(2));
    CHECK(matrix.stats().merged == 1);
    CHECK(matrix.stats().orders == 3);
    CHECK(matrix.orders().size() == 2);
    strat::MatrixOptions apart;
    apart.merge_same_as = false;
    CHECK(HarrisMatrix::build(record, apart).node_count() == 4);
}

TEST_CASE("Every order says which relations justify it") {
    const auto record =
        a_record().covers("1", "2").cuts("1", "2").relation("2", RelationKind::Contemporary, "1").record();
    const auto matrix = HarrisMatrix::build(record);
    REQUIRE(matrix.orders().size() == 1);
    CHECK(matrix.because(0).size() == 2);
    CHECK(matrix.stats().orders == 1);
    CHECK(matrix.stats().contemporary == 1);
}

TEST_CASE("A unit above itself is counted, and is no order") {
    const auto matrix = HarrisMatrix::build(a_record().covers("6", "6").record());
    CHECK(matrix.stats().self == 1);
    CHECK(matrix.stats().orders == 0);
    CHECK(matrix.orders().empty());
}

TEST_CASE("The shortest path from a node to itself is the shortest cycle through it") {
    const auto record = a_record().covers("1", "2").covers("2", "3").covers("3", "1").covers("2", "1").record();
    const auto matrix = HarrisMatrix::build(record);
    CHECK(matrix.shortest_path(0, 0).size() == 2);
    CHECK(matrix.shortest_path(2, 2).size() == 3);
    CHECK(matrix.shortest_path(0, 2).size() == 2);
}

TEST_CASE("Relations left out by an interpretation make no orders") {
    const auto record = a_record().covers("1", "2").covers("2", "3").record();
    const std::vector<strat::RelationIndex> without = {1};
    strat::MatrixOptions options;
    options.without = without;
    CHECK(HarrisMatrix::build(record, options).orders().size() == 1);
}

TEST_CASE("A unit that is the same as an ordered one is not isolated") {
    const auto record =
        a_record().covers("1", "2").same_as("2", "3").unit("4").same_as("5", "6").covers("7", "7").record();
    CHECK(HarrisMatrix::build(record).stats().isolated == 3); // 4, 5 = 6, and 7 which is only above itself
}

TEST_CASE("An empty record has an empty matrix") {
    const auto matrix = HarrisMatrix::build(model::Record{});
    CHECK(matrix.node_count() == 0);
    CHECK(matrix.stats() == strat::MatrixStats{});
}
