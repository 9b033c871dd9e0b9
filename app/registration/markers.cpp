// SPDX-License-Identifier: MIT
#include "app/registration/markers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/registration/import_markers.hpp"
#include "core/base/error.hpp"
#include "core/base/file.hpp"
#include "core/base/text.hpp"
#include "strat/exchange/delimited_table.hpp"

namespace planum::app {

using nlohmann::ordered_json;
using scans::Marker;

namespace {

constexpr std::uintmax_t kLargestFile = 64ULL << 20U;
constexpr double kSame = 5e-5; ///< [m]: half of what the files write
constexpr std::string_view kSite = "site";
constexpr std::array<std::string_view, 5> kColumns = {"scan", "marker", "x", "y", "z"};

/// Markers live in a registration run of their own, which places nothing.

// A comma may stand for the point where it does not separate.
std::string decimal_point(std::string number) {
    std::replace(number.begin(), number.end(), ',', '.');
    return number;
}

class MarkerReader {
  public:
    explicit MarkerReader(std::string file) : file_(std::move(file)) {}

    void header(const strat::TableRow& row) {
        const strat::TableHeader header(row);
        for (std::size_t k = 0; k < kColumns.size(); ++k) {
            column_[k] = header.find(kColumns[k]);
            if (column_[k]) continue;
            throw Error(ErrorCode::BadInput, fmt::format("{}: no column {}; a marker file begins with "
                                                         "scan,marker,x,y,z",
                                                         file_, kColumns[k]));
        }
    }

    void row(const strat::TableRow& row) {
        const std::int64_t number = row.line;
        const auto field = [&](std::size_t k) {
            if (*column_[k] >= row.cells.size()) fail(number, fmt::format("nothing under {}", kColumns[k]));
            return std::string(strat::cell(row, column_[k]));
        };
        Marker marker;
        marker.name = field(1);
        if (marker.name.empty()) fail(number, "a marker without a name");
        for (std::size_t k = 0; k < 3; ++k) {
            const auto value = text::parse_double(decimal_point(field(k + 2)));
            if (!value || !std::isfinite(*value) || std::abs(*value) > 1e8) {
                fail(number, fmt::format("“{}” is no {} coordinate", field(k + 2), kColumns[k + 2]));
            }
            marker.position[static_cast<Eigen::Index>(k)] = *value;
        }
        const std::string scan = field(0);
        if (scan.empty()) fail(number, "nothing under scan; rows of the survey say site there");
        if (!seen_.insert({scan, marker.name}).second) {
            fail(number, fmt::format("the marker {} of {} a second time", marker.name, scan));
        }
        (text::fold_case(scan) == kSite ? table.survey : table.in_scan[scan]).push_back(marker);
    }

    MarkerTable table;

  private:
    [[noreturn]] void fail(std::int64_t line, std::string_view what) const {
        throw Error(ErrorCode::BadInput, fmt::format("{}: line {}: {}", file_, line, what));
    }

    std::string file_;
    std::array<std::optional<std::size_t>, 5> column_;
    std::set<std::pair<std::string, std::string>> seen_;
};

const model::RegistrationRun* survey_of(const model::Record& record) {
    const auto it = std::find_if(record.runs.begin(), record.runs.end(),
                                 [](const model::RegistrationRun& run) { return run.state == kSurveyState; });
    return it == record.runs.end() ? nullptr : &*it;
}

ordered_json to_json(std::span<const Marker> markers) {
    ordered_json json = ordered_json::object();
    for (const Marker& marker : markers) {
        json[marker.name] = {marker.position.x(), marker.position.y(), marker.position.z()};
    }
    return json;
}

std::vector<Marker> markers_from(const ordered_json& json) {
    std::vector<Marker> markers;
    for (const auto& [name, place] : json.items()) {
        markers.push_back({name, {place.at(0).get<double>(), place.at(1).get<double>(), place.at(2).get<double>()}});
    }
    return markers;
}

void merge(std::vector<Marker>& there, std::span<const Marker> file, const std::string& scan,
           const MarkerImportOptions& options, MarkerImport& report) {
    for (const Marker& marker : file) {
        const auto it =
            std::find_if(there.begin(), there.end(), [&](const Marker& m) { return m.name == marker.name; });
        if (it == there.end()) {
            there.push_back(marker);
            ++report.added;
        } else if ((it->position - marker.position).cwiseAbs().maxCoeff() <= kSame) {
            ++report.same;
        } else if (options.update) {
            it->position = marker.position;
            ++report.updated;
        } else {
            report.conflicts.push_back(fmt::format("marker {} of {} is {:.1f} mm from where the file has it; kept "
                                                   "(--update takes the file's)",
                                                   marker.name, scan,
                                                   (it->position - marker.position).norm() * 1000.0));
        }
    }
    std::stable_sort(there.begin(), there.end(),
                     [](const Marker& a, const Marker& b) { return text::natural_order(a.name, b.name) < 0; });
}

void warn_about_names(const model::Record& record, const MarkerTable& table, MarkerImport& report) {
    std::set<std::string> scans;
    for (const auto& scan : record.scans) scans.insert(scan.name);
    std::set<std::string> surveyed;
    for (const auto& marker : table.survey) surveyed.insert(marker.name);
    for (const auto& [scan, markers] : table.in_scan) {
        if (!scans.contains(scan)) report.warnings.push_back(fmt::format("the project has no scan {} (yet)", scan));
        for (const auto& marker : markers) {
            if (surveyed.contains(marker.name)) continue;
            report.warnings.push_back(fmt::format("marker {} of {} was not surveyed", marker.name, scan));
        }
    }
}

} // namespace

std::size_t MarkerTable::size() const {
    std::size_t sum = survey.size();
    for (const auto& [scan, markers] : in_scan) sum += markers.size();
    return sum;
}

MarkerTable read_markers(const std::filesystem::path& file) {
    const strat::DelimitedTable csv = strat::parse_table(read_file(file, kLargestFile), file.string());
    MarkerReader reader(file.string());
    bool has_header = false;
    for (const strat::TableRow& row : csv.rows) {
        const auto is_blank = [](const std::string& cell) { return text::trim(cell).empty(); };
        if (std::all_of(row.cells.begin(), row.cells.end(), is_blank)) continue;
        if (has_header) {
            reader.row(row);
        } else {
            reader.header(row);
            has_header = true;
        }
    }
    if (!has_header)
        throw Error(ErrorCode::BadInput, file.string() + ": empty; a marker file begins with scan,marker,x,y,z");
    return std::move(reader.table);
}

MarkerImport import_markers(Project& project, const std::filesystem::path& file, const MarkerImportOptions& options) {
    const MarkerTable from_file = read_markers(file);
    MarkerTable table = project_markers(project.record());
    MarkerImport report;
    merge(table.survey, from_file.survey, "the survey", options, report);
    for (const auto& [scan, markers] : from_file.in_scan) merge(table.in_scan[scan], markers, scan, options, report);
    warn_about_names(project.record(), table, report);
    if (report.added + report.updated == 0) return report;
    ordered_json json;
    json["survey"] = to_json(table.survey);
    json["in_scan"] = ordered_json::object();
    for (const auto& [scan, markers] : table.in_scan) json["in_scan"][scan] = to_json(markers);
    model::RegistrationRun run;
    if (const auto* there = survey_of(project.record()); there != nullptr) run = *there;
    run.name = "markers";
    run.method = "markers";
    run.state = kSurveyState;
    run.made_at = project.clock().now();
    run.report = json.dump();
    project.change(fmt::format("Import {} markers", report.added + report.updated), [&] {
        if (run.id.is_nil()) {
            project.file().insert(run);
        } else {
            project.file().update(run);
        }
    });
    return report;
}

MarkerTable project_markers(const model::Record& record) {
    MarkerTable table;
    const model::RegistrationRun* run = survey_of(record);
    if (run == nullptr) return table;
    try {
        const ordered_json json = ordered_json::parse(run->report);
        table.survey = markers_from(json.at("survey"));
        for (const auto& [scan, markers] : json.at("in_scan").items()) table.in_scan[scan] = markers_from(markers);
    } catch (const nlohmann::json::exception&) {
        throw Error(ErrorCode::BadInput,
                    "the project's markers cannot be read: planum undo takes the change back that spoilt them");
    }
    return table;
}

} // namespace planum::app
