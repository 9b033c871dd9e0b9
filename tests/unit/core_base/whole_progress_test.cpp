// SPDX-License-Identifier: MIT
#include "core/base/whole_progress.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "tests/support/catch.hpp"

using namespace planum;

namespace {

struct Listener : Progress {
    using Progress::Progress;

    std::vector<std::string> steps;
    std::vector<double> told;

    void step(std::string_view name) override { steps.emplace_back(name); }

    void fraction(double done) override { told.push_back(done); }
};

} // namespace

TEST_CASE("Many steps are told as one whose share grows to the end and never back") {
    Listener listener;
    WholeProgress whole(listener, "adding 2 scans");
    whole.part(0.2);
    whole.step("looking");
    whole.fraction(0.5);
    CHECK(listener.told.back() == Approx(0.1));
    whole.part(1.0, 2);
    whole.fraction(0.5);
    CHECK(listener.told.back() == Approx(0.4));
    whole.step("sorting");
    CHECK(listener.told.back() == Approx(0.6));
    whole.fraction(0.25);
    CHECK(listener.told.back() == Approx(0.7));
    whole.fraction(0.1);
    CHECK(listener.told.back() == Approx(0.7));
    whole.step("one step more than was expected");
    whole.fraction(1.0);
    CHECK(listener.told.back() == Approx(1.0));
    CHECK(std::is_sorted(listener.told.begin(), listener.told.end()));
    CHECK(listener.steps == std::vector<std::string>{"adding 2 scans"});
}

TEST_CASE("Wholes stand inside wholes, and stop when the outermost stops") {
    std::stop_source stop;
    Listener listener(stop.get_token());
    WholeProgress outer(listener, "making a dig");
    outer.part(0.5);
    outer.part(1.0);
    WholeProgress inner(outer, "adding scans");
    inner.part(0.5);
    inner.fraction(1.0);
    CHECK(listener.told.back() == Approx(0.75));
    stop.request_stop();
    CHECK_THROWS(inner.check());
}
