// SPDX-License-Identifier: MIT
// Time and memory of the project file on generated records: one import, then opening and loading.
#include <sys/resource.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <random>

#include <fmt/format.h>

#include "core/base/error.hpp"
#include "core/store/project_file.hpp"

namespace {

using namespace planum;
using Seconds = std::chrono::duration<double>;

double processor_seconds() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const auto seconds = [](const timeval& t) {
        return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

/// Wall time and, for busy machines, processor time of all threads.
class Watch {
  public:
    [[nodiscard]] std::string read() const {
        const double wall = Seconds(std::chrono::steady_clock::now() - start_).count();
        return fmt::format("{:6.3f} s wall, {:6.3f} s processor", wall, processor_seconds() - processor_);
    }

  private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    double processor_ = processor_seconds();
};

long peak_megabytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss / 1024;
}

struct Size {
    std::size_t units;
    std::size_t relations;
    std::size_t statements;
};

void import_record(store::ProjectFile& project, const Size& size, std::mt19937& random) {
    std::vector<model::UnitId> units;
    std::vector<model::RelationId> relations;
    const model::SourceId source = project.insert(model::Source{{}, "bench.csv", "csv", "", "", true});
    for (std::size_t i = 0; i < size.units; ++i) {
        model::StratigraphicUnit unit;
        unit.number = std::to_string(i + 1);
        unit.kind = model::UnitKind::Deposit;
        unit.title = "layer of brown silt";
        units.push_back(project.insert(unit));
    }
    std::uniform_int_distribution<std::size_t> any(0, size.units - 1);
    for (std::size_t i = 0; i < size.relations; ++i) {
        model::PhysicalRelation relation;
        relation.subject = units[any(random)];
        relation.object = units[any(random)];
        relations.push_back(project.insert(relation));
    }
    for (std::size_t i = 0; i < size.statements; ++i) {
        model::RelationStatement statement;
        statement.relation = relations[i % relations.size()];
        statement.source = source;
        statement.line = static_cast<std::int64_t>(i + 1);
        statement.raw_text = "covers";
        project.insert(statement);
    }
}

int run(const Size& size) {
    const SystemClock clock;
    TimeOrderedUuids uuids;
    const store::Environment environment{&clock, &uuids, "bench"};
    const std::filesystem::path file = std::filesystem::temp_directory_path() / "planum-bench-store.gpkg";
    std::filesystem::remove(file);
    std::mt19937 random(1);
    {
        store::ProjectFile project = store::ProjectFile::create(file, {}, environment);
        const Watch watch;
        project.change("Import", [&] {
            import_record(project, size, random);
            fmt::print("  inserted   {}\n", watch.read());
        });
        fmt::print("import       {}  {} MB peak, file {} MB\n", watch.read(), peak_megabytes(),
                   std::filesystem::file_size(file) / 1'000'000);
    }
    {
        const Watch watch;
        const store::ProjectFile project = store::ProjectFile::open(file, store::OpenMode::ReadOnly, environment);
        fmt::print("open         {}\n", watch.read());
        const model::Record record = project.load();
        fmt::print("open + load  {}  {} units, {} relations, {} statements\n", watch.read(), record.units.size(),
                   record.relations.size(), record.statements.size());
    }
    store::ProjectFile project = store::ProjectFile::open(file, store::OpenMode::ReadWrite, environment);
    const Watch undo;
    (void)project.undo();
    fmt::print("undo         {}\n", undo.read());
    const Watch redo;
    (void)project.redo();
    fmt::print("redo         {}\n", redo.read());
    return 0;
}

/// Opening and loading alone, for the memory a check needs.
int load(const char* file) {
    const SystemClock clock;
    TimeOrderedUuids uuids;
    const Watch watch;
    const auto project = store::ProjectFile::open(file, store::OpenMode::ReadOnly, {&clock, &uuids, ""});
    fmt::print("open         {}\n", watch.read());
    const model::Record record = project.load();
    fmt::print("open + load  {}  {} MB peak, {} units\n", watch.read(), peak_megabytes(), record.units.size());
    return 0;
}

} // namespace

int main(int argc, char** argv) {
    try {
        if (argc == 3 && std::string_view{argv[1]} == "load") return load(argv[2]);
        const auto number = [&](int i, std::size_t otherwise) {
            return argc > i ? static_cast<std::size_t>(std::strtoul(argv[i], nullptr, 10)) : otherwise;
        };
        return run({number(1, 20'000), number(2, 100'000), number(3, 100'000)});
    } catch (const Error& e) {
        fmt::print(stderr, "{}\n", e.what());
        return exit_status(e.code());
    }
}
