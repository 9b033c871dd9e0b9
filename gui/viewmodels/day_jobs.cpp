// SPDX-License-Identifier: MIT
#include "gui/viewmodels/day_jobs.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <string_view>
#include <utility>

#include "app/import/import_service.hpp"
#include "app/regions/region_import.hpp"
#include "app/registration/import_markers.hpp"
#include "app/registration/register_scans.hpp"
#include "app/registration/registration_runs.hpp"
#include "app/scans/add_scans.hpp"
#include "app/survey/survey_import.hpp"
#include "core/base/text.hpp"
#include "gui/viewmodels/change_labels.hpp"
#include "gui/viewmodels/log_words.hpp"
#include "gui/viewmodels/service_sentences.hpp"
#include "gui/viewmodels/words.hpp"

namespace planum::gui {

namespace {

constexpr int kMostLines = 500; // of a preview; the rest is counted

void add(QStringList& lines, const QString& line) {
    if (lines.size() < kMostLines) lines << line;
}

ImportPreview in_words(const app::ImportReport& report) {
    ImportPreview preview;
    preview.changes = report.changed;
    for (const app::ImportedFiles& reading : report.readings) {
        QStringList names;
        for (const std::string& file : reading.files) names << qt(file);
        add(preview.fresh,
            DayJobs::tr("%1: read as %2").arg(names.join(QStringLiteral(", ")), service_sentence(reading.title)));
        if (!reading.note.empty()) add(preview.not_understood, service_sentence(reading.note));
    }
    const auto count = [&](const QString& text, std::int64_t number) {
        if (number > 0) add(preview.fresh, text.arg(number));
    };
    count(DayJobs::tr("%1 new units"), report.new_units);
    count(DayJobs::tr("%1 of them only mentioned"), report.mentioned_units);
    count(DayJobs::tr("%1 units with fields filled"), report.filled_units);
    count(DayJobs::tr("%1 new relations"), report.new_relations);
    count(DayJobs::tr("%1 new statements"), report.new_statements);
    count(DayJobs::tr("%1 new levels, finds, phases and others"), report.new_others);
    for (const app::MergeConflict& conflict : report.conflicts) {
        add(preview.changed, DayJobs::tr("%1, %2: “%3” stands, the file says “%4”")
                                 .arg(thing_word(conflict.what), stored_field_label(conflict.field),
                                      stored_value_word(conflict.field, conflict.kept),
                                      stored_value_word(conflict.field, conflict.offered)));
    }
    for (const std::string& warning : report.warnings) add(preview.not_understood, service_sentence(warning));
    for (const strat::ReadNote& note : report.notes) {
        add(preview.not_understood,
            DayJobs::tr("%1, line %2: %3").arg(qt(note.file)).arg(note.line).arg(service_sentence(note.message)));
    }
    return preview;
}

QStringList in_words(const app::RegistrationReport& report) {
    // Where each scan stands is in the list of scans; here is what wants attention.
    QStringList lines;
    const auto placed = std::count_if(report.scans.begin(), report.scans.end(),
                                      [](const app::ReportedScan& scan) { return scan.status == "registered"; });
    if (!report.scans.empty()) {
        lines << DayJobs::tr("%1 of %2 scans placed on the site grid").arg(placed).arg(report.scans.size());
    }
    for (const app::ReportedScan& scan : report.scans) {
        if (scan.status == "registered" && !scan.is_poor) continue;
        const QString line =
            scan.status == "registered" ? DayJobs::tr("%1: placed with doubt. %2") : DayJobs::tr("%1: not placed. %2");
        lines << line.arg(qt(scan.scan), service_sentence(scan.verdict));
    }
    for (const std::string& note : report.notes) lines << service_sentence(note);
    return lines;
}

} // namespace

FileUse use_of(const std::filesystem::path& file) {
    if (std::filesystem::is_directory(file)) return FileUse::Scans;
    const std::string ending = text::fold_case(file.extension().string());
    if (ending == ".gpkg") return FileUse::Project;
    if (ending == ".geojson") return FileUse::Outlines;
    constexpr std::array<std::string_view, 9> kScans = {".ptx", ".e57", ".las", ".laz", ".ply",
                                                        ".pts", ".xyz", ".pcd", ".3d"};
    for (const std::string_view scan : kScans) {
        if (ending == scan) return FileUse::Scans;
    }
    return FileUse::Lists;
}

DayJobs::DayJobs(Workspace& workspace, QObject* parent) : QObject(parent), workspace_(workspace) {}

void DayJobs::preview_import(const Files& files, bool update) {
    workspace_.read(
        QStringLiteral("import preview"), tr("Reading what would be imported"),
        [this, files, update](app::Project& project, Progress& progress) -> JobRunner::Done {
            app::ImportOptions options;
            options.update = update;
            options.dry_run = true;
            const ImportPreview preview = in_words(app::import_files(project, files, options, progress));
            return [this, preview] { emit previewed(preview); };
        },
        [this](const QString& sentence) {
            workspace_.say(sentence);
            emit notPreviewed(sentence);
        });
}

void DayJobs::run(const QString& title, Said work) {
    auto sentence = std::make_shared<QString>();
    workspace_.work(
        title,
        [work = std::move(work), sentence](app::Project& project, Progress& progress) {
            *sentence = work(project, progress);
        },
        [this, sentence] { emit done(*sentence); });
}

void DayJobs::import(const Files& files, bool update) {
    run(tr("Importing"), [files, update](app::Project& project, Progress& progress) {
        app::ImportOptions options;
        options.update = update;
        const app::ImportReport report = app::import_files(project, files, options, progress);
        return report.changed
                   ? tr("imported: %1 new units, %2 new relations").arg(report.new_units).arg(report.new_relations)
                   : tr("nothing in the files is new");
    });
}

void DayJobs::add_scans(const Files& inputs, const std::string& day) {
    run(tr("Adding scans"), [inputs, day](app::Project& project, Progress& progress) {
        app::AddScansOptions options;
        options.day = day;
        const app::AddScansReport report = app::add_scans(project, inputs, options, progress);
        return tr("%1 scans added, %2 there already").arg(report.added.size()).arg(report.there_already.size());
    });
}

void DayJobs::import_outlines(const Files& files) {
    run(tr("Taking outlines in"), [files](app::Project& project, Progress& progress) {
        app::RegionImportOptions options;
        options.create_units = true;
        const auto report = app::import_outline_files(project, files, options, progress);
        return tr("%1 new outlines, %2 refused").arg(report.fresh.size()).arg(report.refused.size());
    });
}

void DayJobs::import_survey(const Files& files) {
    run(tr("Taking measured points in"), [files](app::Project& project, Progress&) {
        const app::SurveyReport report = app::import_survey(project, files, {});
        return tr("%1 points: %2 new levels, %3 new finds")
            .arg(report.points)
            .arg(report.new_levels)
            .arg(report.new_finds);
    });
}

void DayJobs::import_markers(const std::filesystem::path& file) {
    run(tr("Taking markers in"), [file](app::Project& project, Progress&) {
        const app::MarkerImport report = app::import_markers(project, file, {});
        return tr("%1 markers added, %2 as they were").arg(report.added).arg(report.same);
    });
}

// Places are worked out on a connection that only reads; the run is written by the thread that holds the file, which
// knows what was changed meanwhile.
void DayJobs::register_scans(const std::string& day) {
    if (!workspace_.read_only_because().isEmpty()) {
        workspace_.say(tr("Nothing was changed: %1.").arg(workspace_.read_only_because()));
        return;
    }
    workspace_.read(
        QStringLiteral("registration"), tr("Registering scans"),
        [this, day](app::Project& project, Progress& progress) -> JobRunner::Done {
            app::RegisterOptions options;
            options.day = day;
            auto report =
                std::make_shared<app::RegistrationReport>(app::compute_registration(project, options, progress));
            return [this, report] { keep_registration(report); };
        },
        {}, Job::Kind::Asked);
}

void DayJobs::keep_registration(const std::shared_ptr<app::RegistrationReport>& report) {
    if (report->scans.empty()) {
        emit registered(in_words(*report));
        return;
    }
    workspace_.edit(
        tr("Keeping the places of the scans"),
        [report](app::Project& project, Progress&) { app::keep_run(project, *report, app::Acceptance::WhenGood); },
        [this, report] { emit registered(in_words(*report)); });
}

void DayJobs::backup(const std::filesystem::path& target) {
    workspace_.read(QStringLiteral("backup"), tr("Making a backup"),
                    [this, target](app::Project& project, Progress& progress) -> JobRunner::Done {
                        project.file().backup(target, progress);
                        return [this, target] { emit done(tr("backup written to %1").arg(qt(target.string()))); };
                    });
}

} // namespace planum::gui
