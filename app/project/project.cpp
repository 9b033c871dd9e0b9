// SPDX-License-Identifier: MIT
#include "app/project/project.hpp"

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <utility>

#include <pwd.h>
#include <unistd.h>

#include <fmt/format.h>

#include "core/base/error.hpp"
#include "core/base/text.hpp"

namespace planum::app {

namespace {

std::string author_of_account() {
    if (const char* told = std::getenv("PLANUM_AUTHOR"); told != nullptr && *told != '\0') return told;
    if (const passwd* account = getpwuid(geteuid()); account != nullptr && account->pw_name != nullptr) {
        return account->pw_name;
    }
    return "unknown";
}

// Damerau-Levenshtein distance of exactly one: what a hand does wrong when it writes a number.
bool is_one_slip_apart(std::string_view a, std::string_view b) {
    if (a == b) return false;
    if (a.size() > b.size()) std::swap(a, b);
    if (b.size() - a.size() > 1) return false;
    std::size_t i = 0;
    while (i < a.size() && a[i] == b[i]) ++i;
    if (a.size() + 1 == b.size()) return a.substr(i) == b.substr(i + 1);
    if (a.substr(i + 1) == b.substr(i + 1)) return true;
    return i + 1 < a.size() && a[i] == b[i + 1] && a[i + 1] == b[i] && a.substr(i + 2) == b.substr(i + 2);
}

// Everything a file needs from outside, owned as long as the project lives.
struct Surroundings {
    std::unique_ptr<SystemClock> own_clock;
    std::unique_ptr<TimeOrderedUuids> own_uuids;
    store::Environment environment;

    explicit Surroundings(const Session& session) {
        own_clock = std::make_unique<SystemClock>();
        own_uuids = std::make_unique<TimeOrderedUuids>();
        environment.clock = session.clock != nullptr ? session.clock : own_clock.get();
        environment.uuids = session.uuids != nullptr ? session.uuids : own_uuids.get();
        environment.author = session.author.empty() ? author_of_account() : session.author;
    }
};

} // namespace

struct Project::State {
    State(store::ProjectFile opened, Surroundings around)
        : file(std::move(opened)), author(std::move(around.environment.author)), clock(around.environment.clock),
          uuids(around.environment.uuids), own_clock(std::move(around.own_clock)),
          own_uuids(std::move(around.own_uuids)) {}

    store::ProjectFile file;
    std::string author;
    const Clock* clock = nullptr;
    UuidSource* uuids = nullptr;
    std::unique_ptr<SystemClock> own_clock;
    std::unique_ptr<TimeOrderedUuids> own_uuids;
    std::optional<model::Record> record;
    std::optional<model::RecordIndex> index;

    void forget() {
        index.reset();
        record.reset();
    }
};

Project Project::create(const std::filesystem::path& file, const model::ProjectSettings& settings,
                        const Session& session) {
    Surroundings around(session);
    store::ProjectFile opened = store::ProjectFile::create(file, settings, around.environment);
    return Project(std::make_unique<State>(std::move(opened), std::move(around)));
}

Project Project::open(const std::filesystem::path& file, store::OpenMode mode, const Session& session) {
    Surroundings around(session);
    store::ProjectFile opened = store::ProjectFile::open(file, mode, around.environment);
    return Project(std::make_unique<State>(std::move(opened), std::move(around)));
}

Project::Project(std::unique_ptr<State> state) noexcept : state_(std::move(state)) {}

Project::Project(Project&&) noexcept = default;
Project& Project::operator=(Project&&) noexcept = default;
Project::~Project() = default;

const std::filesystem::path& Project::path() const noexcept { return state_->file.path(); }

const std::string& Project::author() const noexcept { return state_->author; }

const Clock& Project::clock() const noexcept { return *state_->clock; }

UuidSource& Project::uuids() noexcept { return *state_->uuids; }

const model::Record& Project::record() {
    if (!state_->record) state_->record = state_->file.load();
    return *state_->record;
}

const model::RecordIndex& Project::index() {
    if (!state_->index) state_->index.emplace(record());
    return *state_->index;
}

std::int64_t Project::change(std::string_view label, const std::function<void()>& work) {
    const std::int64_t number = state_->file.change(label, work);
    state_->forget();
    return number;
}

store::ChangeEntry Project::undo() {
    state_->forget();
    return state_->file.undo();
}

store::ChangeEntry Project::redo() {
    state_->forget();
    return state_->file.redo();
}

store::ProjectFile& Project::file() noexcept { return state_->file; }

const store::ProjectFile& Project::file() const noexcept { return state_->file; }

model::UnitIndex Project::unit_named(std::string_view name) {
    const std::vector<model::UnitIndex> hits = index().named(name);
    if (hits.size() == 1) return hits.front();
    if (hits.empty()) {
        const std::vector<std::string> near = near_numbers(record(), text::trim(name), 5);
        const std::string hint = near.empty() ? "" : fmt::format("; near it: {}", text::join(near, ", "));
        throw Error(ErrorCode::NotFound, fmt::format("no unit {}{}", name, hint));
    }
    std::vector<std::string> names;
    names.reserve(hits.size());
    for (const model::UnitIndex unit : hits) names.push_back(index().name(unit));
    throw Error(ErrorCode::Usage,
                fmt::format("unit {} is used in {} areas; say which: {}", name, hits.size(), text::join(names, ", ")));
}

std::vector<std::string> near_numbers(const model::Record& record, std::string_view number, std::size_t most) {
    std::vector<std::string> near;
    for (const model::StratigraphicUnit& unit : record.units) {
        if (is_one_slip_apart(unit.number, number)) near.push_back(unit.number);
    }
    std::sort(near.begin(), near.end(), text::NaturalLess{});
    near.erase(std::unique(near.begin(), near.end()), near.end());
    if (near.size() > most) near.resize(most);
    return near;
}

} // namespace planum::app
