// SPDX-License-Identifier: MIT
#include "gui/viewmodels/inquiry.hpp"

#include <functional>
#include <memory>
#include <set>
#include <utility>

#include "app/checks/interpretation_diff.hpp"
#include "app/project/clean.hpp"
#include "app/regions/ready_patches.hpp"
#include "app/regions/region_names.hpp"
#include "app/regions/region_ply.hpp"
#include "app/registration/registration_report.hpp"
#include "app/registration/registration_runs.hpp"
#include "app/scans/verify_scans.hpp"
#include "gui/viewmodels/change_labels.hpp"
#include "gui/viewmodels/sentences.hpp"
#include "gui/viewmodels/service_sentences.hpp"
#include "gui/viewmodels/words.hpp"

namespace planum::gui {

namespace {

const QString kRecord = QStringLiteral("record"); // as the command line names it

QStringList differences(const app::InterpretationDiff& diff, const QString& first, const QString& second) {
    const auto name = [&](app::Reading in) { return in == app::Reading::First ? first : second; };
    QStringList lines;
    for (const app::DifferingRelation& r : diff.relations) {
        const QString line = r.contradicted
                                 ? Inquiry::tr("only in %1: %2 %3 %4; the other orders them the other way round")
                                 : Inquiry::tr("only in %1: %2 %3 %4");
        lines << line.arg(name(r.in), qt(r.unit), relation_word({r.kind, false}), qt(r.other));
    }
    for (const app::DifferingOrder& o : diff.orders) {
        const QString line = o.reversed ? Inquiry::tr("order of %1: %2 later than %3; the other says the opposite")
                                        : Inquiry::tr("order of %1: %2 later than %3; the other does not order them");
        lines << line.arg(name(o.in), qt(o.later), qt(o.earlier));
    }
    for (const app::DifferingProblem& p : diff.problems) {
        lines << Inquiry::tr("contradicted in %1 only: %2").arg(name(p.in), in_window_language(p.problem.message));
    }
    if (lines.isEmpty()) lines << Inquiry::tr("%1 and %2 say the same").arg(first, second);
    return lines;
}

QStringList moves(const app::RunComparison& comparison) {
    QStringList lines;
    for (const app::ComparedScan& scan : comparison.scans) {
        if (!scan.in_first || !scan.in_second) {
            lines << Inquiry::tr("%1: only in run %2")
                         .arg(qt(scan.scan), qt(scan.in_first ? comparison.first : comparison.second));
            continue;
        }
        lines << Inquiry::tr("%1: moves %2 mm, turns %3° (known within %4 and %5 mm)")
                     .arg(qt(scan.scan))
                     .arg(number_word(scan.shift * 1e3, 1))
                     .arg(number_word(scan.turn_deg, 3))
                     .arg(number_word(scan.sigma_first * 1e3, 1))
                     .arg(number_word(scan.sigma_second * 1e3, 1));
    }
    if (lines.isEmpty()) lines << Inquiry::tr("neither run placed a scan");
    return lines;
}

QStringList patch_lines(const app::ReadyPatches& found) {
    QStringList lines;
    for (const app::ReadyPatch& patch : found.patches) {
        const QString unit = patch.proposed.empty() ? Inquiry::tr("unit not known") : qt(patch.proposed);
        lines << Inquiry::tr("%1: %2 m², %3 m since the surface before; %4: %5")
                     .arg(qt(patch.surface))
                     .arg(number_word(patch.area, 2))
                     .arg(number_word(patch.change, 2))
                     .arg(unit, in_window_language(patch.because));
    }
    if (found.patches.empty()) lines << Inquiry::tr("all ground that changed is outlined");
    if (found.outside > 0) {
        lines << Inquiry::tr("%n patch(es) outside all outlines left out", nullptr, static_cast<int>(found.outside));
    }
    for (const std::string& note : found.notes) lines << service_sentence(note);
    return lines;
}

} // namespace

Inquiry::Inquiry(Workspace& workspace, QObject* parent) : QObject(parent), workspace_(workspace) {}

QStringList Inquiry::readings() const {
    QStringList names{kRecord};
    if (!workspace_.is_open()) return names;
    for (const model::Interpretation& reading : workspace_.snapshot()->record().interpretations) {
        names << qt(reading.name);
    }
    return names;
}

QStringList Inquiry::runs() const {
    QStringList names;
    if (!workspace_.is_open()) return names;
    for (const std::string& name : app::run_names(workspace_.snapshot()->record())) names << qt(name);
    return names;
}

QStringList Inquiry::days() const {
    std::set<std::string, std::greater<>> days;
    if (workspace_.is_open()) {
        const model::Record& record = workspace_.snapshot()->record();
        for (const model::Scan& scan : record.scans) days.insert(scan.day);
        for (const model::Surface& surface : record.surfaces) {
            days.insert(surface.first_day);
            days.insert(surface.last_day);
        }
        for (const store::ChangeEntry& change : workspace_.snapshot()->changes)
            days.insert(change.made_at.substr(0, 10));
    }
    QStringList names;
    for (const std::string& day : days) {
        if (!day.empty()) names << qt(day);
    }
    return names;
}

void Inquiry::ask(const QString& title, Asked question) {
    workspace_.read(
        QStringLiteral("inquiry"), title,
        [this, title, question = std::move(question)](app::Project& project, Progress& progress) -> JobRunner::Done {
            Answer answer = question(project, progress);
            answer.title = title;
            return [this, answer] { emit answered(answer); };
        },
        {}, Job::Kind::Asked);
}

void Inquiry::verify() {
    ask(tr("Verifying the project"), [](app::Project& project, Progress& progress) {
        Answer answer;
        const auto add = [&](const std::string& where, const std::string& what) {
            answer.lines << QStringLiteral("%1: %2").arg(thing_word(where), service_sentence(what));
        };
        for (const auto& problem : project.file().verify(progress)) add(problem.where, problem.what);
        for (const app::ScanProblem& problem : app::verify_scans(project, progress)) add(problem.where, problem.what);
        if (answer.lines.isEmpty()) answer.lines << tr("no problem found in the file, its scans and their points");
        return answer;
    });
}

// What looks useless in a damaged project may be what a rescue needs: that is left alone.
void Inquiry::clean() {
    auto answer = std::make_shared<Answer>();
    answer->title = tr("Cleaning the project");
    workspace_.work(
        answer->title,
        [answer](app::Project& project, Progress& progress) {
            for (const auto& problem : project.file().verify(progress)) {
                answer->lines << QStringLiteral("%1: %2").arg(thing_word(problem.where),
                                                              service_sentence(problem.what));
            }
            if (!answer->lines.isEmpty()) {
                answer->lines << tr("nothing was removed: the project file itself is not sound");
                return;
            }
            const app::Cleaned cleaned = app::clean_project(project, {}, progress);
            answer->lines << tr("%n file(s) removed, %1 MB", nullptr, static_cast<int>(cleaned.removed.size()))
                                 .arg(number_word(static_cast<double>(cleaned.removed_bytes) / 1e6, 1));
            answer->lines << tr("the project file is %1 MB shorter")
                                 .arg(number_word(static_cast<double>(cleaned.freed_bytes) / 1e6, 1));
            for (const auto& file : cleaned.removed) answer->lines << qt(file.string());
        },
        [this, answer] { emit answered(*answer); });
}

QStringList Inquiry::regions() const {
    QStringList names;
    if (!workspace_.is_open()) return names;
    const app::Snapshot& now = *workspace_.snapshot();
    for (const std::size_t at : app::regions_in_order(now.record(), now.index())) {
        names << qt(app::region_name(now.record(), now.index(), now.record().regions[at]));
    }
    return names;
}

void Inquiry::write_region_points(const QString& region, const std::filesystem::path& ply) {
    ask(tr("Points of %1").arg(region), [region, ply](app::Project& project, Progress& progress) {
        const model::Region found = app::region_named(project, region.toStdString());
        const std::int64_t points = app::write_region_points(project, found, ply, progress);
        return Answer{{}, {tr("wrote %1: %2 points").arg(qt(ply.string())).arg(points)}, {}, {}};
    });
}

void Inquiry::compare_readings(const QString& first, const QString& second) {
    ask(tr("%1 and %2").arg(first, second), [first, second](app::Project& project, Progress& progress) {
        const app::InterpretationDiff diff =
            app::diff_interpretations(project, first.toStdString(), second.toStdString(), progress);
        return Answer{{}, differences(diff, first, second), {}, {}};
    });
}

void Inquiry::compare_runs(const QString& first, const QString& second) {
    ask(tr("Registration %1 and %2").arg(first, second), [first, second](app::Project& project, Progress&) {
        return Answer{{}, moves(app::compare_runs(project, first.toStdString(), second.toStdString())), {}, {}};
    });
}

void Inquiry::find_patches(const QString& surface) {
    ask(tr("Ground not outlined yet"), [surface](app::Project& project, Progress& progress) {
        app::PatchQuery query;
        query.surface = surface.toStdString();
        const app::ReadyPatches found = app::ready_patches(project, query, progress);
        Answer answer{{}, patch_lines(found), {}, tr("Outlines (*.geojson)")};
        if (!found.patches.empty()) answer.file = app::patches_geojson(project.record(), found);
        return answer;
    });
}

void Inquiry::accept_run(const QString& run) {
    workspace_.edit(tr("Accept registration %1").arg(run),
                    [name = run.toStdString()](app::Project& project, Progress&) {
                        static_cast<void>(app::accept_run(project, name));
                    });
}

void Inquiry::discard_run(const QString& run) {
    workspace_.edit(tr("Discard registration %1").arg(run),
                    [name = run.toStdString()](app::Project& project, Progress&) {
                        static_cast<void>(app::discard_run(project, name));
                    });
}

} // namespace planum::gui
