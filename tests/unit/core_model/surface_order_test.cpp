// SPDX-License-Identifier: MIT
#include "core/model/surface_order.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/catch.hpp"

using namespace planum;
using model::clashes_of_order;

namespace {

model::Surface surface(std::uint64_t id, std::string first_day, std::int64_t order, std::string last_day = {}) {
    model::Surface made;
    made.id = model::SurfaceId{Uuid{3, id}};
    made.first_day = std::move(first_day);
    made.last_day = std::move(last_day);
    made.order = order;
    return made;
}

std::vector<std::uint64_t> in_clash(const model::Record& record) {
    std::vector<std::uint64_t> ids;
    const auto clashes = clashes_of_order(record);
    for (std::uint64_t id = 1; id <= record.surfaces.size(); ++id) {
        if (model::is_in_clash(clashes, model::SurfaceId{Uuid{3, id}})) ids.push_back(id);
    }
    return ids;
}

} // namespace

TEST_CASE("Surfaces in the order of their days do not clash") {
    model::Record record;
    record.surfaces = {surface(1, "2025-06-01", 1), surface(2, "2025-06-01", 2), surface(3, "2025-06-02", 2),
                       surface(4, "", 0)};
    CHECK(clashes_of_order(record).empty());
}

TEST_CASE("Two surfaces that were exchanged clash with each other and with all between them") {
    model::Record record;
    record.surfaces = {surface(1, "2025-06-01", 1), surface(2, "2025-06-02", 4), surface(3, "2025-06-03", 3),
                       surface(4, "2025-06-04", 2), surface(5, "2025-06-05", 5)};
    CHECK(in_clash(record) == std::vector<std::uint64_t>{2, 3, 4});
    const auto clashes = clashes_of_order(record);
    REQUIRE(clashes.size() == 2);
    CHECK(clashes[0].earlier->first_day == "2025-06-03");
    CHECK(clashes[0].later->first_day == "2025-06-02");
    CHECK(clashes[1].earlier->first_day == "2025-06-04");
    CHECK(clashes[1].later->first_day == "2025-06-02");
}

TEST_CASE("Whatever was mixed up, surfaces in no clash stand in the order of their days") {
    const std::vector<std::string> days = {"2025-06-01", "2025-06-02", "2025-06-03", "2025-06-04", "2025-06-05"};
    std::vector<std::size_t> order = {0, 1, 2, 3, 4};
    do {
        model::Record record;
        for (std::size_t i = 0; i < order.size(); ++i)
            record.surfaces.push_back(surface(i + 1, days[order[i]], static_cast<std::int64_t>(i)));
        const std::vector<std::uint64_t> wrong = in_clash(record);
        std::string last;
        for (std::uint64_t id = 1; id <= order.size(); ++id) {
            if (std::find(wrong.begin(), wrong.end(), id) != wrong.end()) continue;
            CHECK(record.surfaces[id - 1].first_day > last);
            last = record.surfaces[id - 1].first_day;
        }
        CHECK(wrong.empty() == std::is_sorted(order.begin(), order.end()));
    } while (std::next_permutation(order.begin(), order.end()));
}

TEST_CASE("Surfaces of several days may overlap, and areas are apart") {
    model::Record record;
    record.surfaces = {surface(1, "2025-06-02", 1, "2025-06-05"), surface(2, "2025-06-01", 2, "2025-06-06")};
    CHECK(clashes_of_order(record).empty());
    record.surfaces[1].last_day = "2025-06-04";
    CHECK(clashes_of_order(record).size() == 1);
    record.surfaces[1].area = model::AreaId{Uuid{4, 1}};
    CHECK(clashes_of_order(record).empty());
}
