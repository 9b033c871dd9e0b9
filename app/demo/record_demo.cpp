// SPDX-License-Identifier: MIT
#include "app/demo/record_demo.hpp"

#include <optional>

#include "app/checks/daily_check.hpp"
#include "app/demo/record_generator.hpp"
#include "app/demo/record_mistakes.hpp"
#include "app/drawing/draw_matrix.hpp"
#include "app/import/import_service.hpp"
#include "app/reports/report.hpp"
#include "core/base/error.hpp"
#include "core/base/file.hpp"
#include "strat/exchange/writer.hpp"
#include "strat/layout/svg_writer.hpp"

namespace planum::app {

namespace {

std::size_t units_of(const std::string& size) {
    if (size == "medium") return 300;
    return size == "large" ? 1500 : 60;
}

// One mistake of each kind that closes a cycle somewhere; small records do not have room for all.
GeneratedRecord with_mistakes(std::uint64_t seed, const std::string& size) {
    RecordOptions options;
    options.seed = seed;
    options.units = units_of(size);
    GeneratedRecord generated = generate_record(options);
    MistakeOptions mistake;
    mistake.seed = seed;
    mistake.least_cycle = 4;
    for (const MistakeKind kind : {MistakeKind::Reversed, MistakeKind::Transposed, MistakeKind::SwappedLevels}) {
        static_cast<void>(seed_mistake(generated, kind, mistake));
        ++mistake.seed;
    }
    return generated;
}

std::vector<std::filesystem::path> write_tables(const model::Record& record, const std::filesystem::path& folder) {
    std::filesystem::create_directories(folder);
    std::vector<std::filesystem::path> files;
    for (const strat::WrittenFile& file : strat::writer_for("planum-csv").write(record, {}).files) {
        files.push_back(folder / file.name);
        write_file_atomically(files.back(), file.bytes);
    }
    return files;
}

} // namespace

RecordDemo make_record_demo(const std::filesystem::path& folder, std::uint64_t seed, const std::string& size,
                            const Session& session, const strat::TextMeasure& measure, Progress& progress) {
    RecordDemo demo;
    demo.project = folder / "demo.gpkg";
    if (std::filesystem::exists(demo.project)) {
        throw Error(ErrorCode::Conflict, demo.project.string() + ": exists already; take another folder");
    }
    progress.step("making a record");
    const GeneratedRecord generated = with_mistakes(seed, size);
    const std::vector<std::filesystem::path> tables = write_tables(generated.record, folder / "record");

    model::ProjectSettings settings = generated.record.settings;
    settings.name = "Sample dig";
    Project project = Project::create(demo.project, settings, session);
    import_files(project, tables, {}, progress);
    demo.units = project.record().units.size();
    const DailyCheck check = check_project(project, {}, progress);
    demo.errors = check.count(model::Severity::Error);
    demo.warnings = check.count(model::Severity::Warning);

    demo.files = {folder / "matrix.svg", folder / "report.html", folder / "report.xml"};
    write_file_atomically(demo.files[0], strat::write_svg(draw_matrix(project, {}, measure, progress)));
    write_report(project, demo.files[1], {}, measure, progress);
    write_report(project, demo.files[2], {}, measure, progress);
    return demo;
}

} // namespace planum::app
