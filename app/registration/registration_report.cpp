// SPDX-License-Identifier: MIT
#include "app/registration/registration_report.hpp"

#include <nlohmann/json.hpp>

#include "core/base/error.hpp"

namespace planum::app {

using nlohmann::ordered_json;

namespace {

ordered_json to_json(const ReportedScan& scan) {
    const bool placed = scan.site_from_scan.has_value();
    const auto known = [&](double value) { return placed ? ordered_json(value) : ordered_json(nullptr); };
    ordered_json markers = ordered_json::array();
    for (const auto& marker : scan.markers) {
        markers.push_back({{"marker", marker.name},
                           {"used", marker.is_used},
                           {"residual_m", marker.residual},
                           {"reason", marker.reason}});
    }
    return {{"scan", scan.scan},
            {"day", scan.day},
            {"points", scan.points},
            {"status", scan.status},
            {"method", scan.method},
            {"site_from_scan", placed ? ordered_json(*scan.site_from_scan) : ordered_json(nullptr)},
            {"rms_m", known(scan.rms)},
            {"overlap", known(scan.overlap)},
            {"sigma_position_m", known(scan.sigma_position)},
            {"sigma_rotation_deg", known(scan.sigma_rotation_deg)},
            {"sigma_to_others_m", known(scan.sigma_to_others)},
            {"covariance", placed ? ordered_json(scan.covariance) : ordered_json(nullptr)},
            {"links", scan.links},
            {"poor", scan.is_poor},
            {"verdict", scan.verdict},
            {"markers", markers}};
}

ordered_json to_json(const ReportedLink& link) {
    return {{"from", link.from},
            {"to", link.to},
            {"from_from_to", link.from_from_to},
            {"covariance", link.covariance},
            {"rms_m", link.rms},
            {"overlap", link.overlap},
            {"accepted", link.is_accepted},
            {"matches", link.matches},
            {"inliers", link.inliers},
            {"sigma_position_m", link.sigma_position},
            {"sigma_rotation_deg", link.sigma_rotation_deg},
            {"error_before", link.error_before},
            {"error_after", link.error_after},
            {"shift_m", link.shift},
            {"turn_deg", link.turn_deg},
            {"patches",
             {{"stable", link.stable_patches}, {"changed", link.changed_patches}, {"shifted", link.shifted_patches}}},
            {"verdict", link.verdict}};
}

double number(const ordered_json& json, const char* key) {
    const ordered_json& value = json.at(key);
    return value.is_null() ? 0.0 : value.get<double>();
}

ReportedScan scan_from(const ordered_json& json) {
    ReportedScan scan;
    json.at("scan").get_to(scan.scan);
    json.at("day").get_to(scan.day);
    json.at("points").get_to(scan.points);
    json.at("status").get_to(scan.status);
    json.at("method").get_to(scan.method);
    if (!json.at("site_from_scan").is_null()) {
        scan.site_from_scan = json.at("site_from_scan").get<std::array<double, 16>>();
        scan.covariance = json.at("covariance").get<std::array<double, 36>>();
    }
    scan.rms = number(json, "rms_m");
    scan.overlap = number(json, "overlap");
    scan.sigma_position = number(json, "sigma_position_m");
    scan.sigma_rotation_deg = number(json, "sigma_rotation_deg");
    scan.sigma_to_others = number(json, "sigma_to_others_m");
    json.at("links").get_to(scan.links);
    json.at("poor").get_to(scan.is_poor);
    json.at("verdict").get_to(scan.verdict);
    for (const auto& marker : json.at("markers")) {
        scan.markers.push_back({marker.at("marker").get<std::string>(), marker.at("used").get<bool>(),
                                marker.at("residual_m").get<double>(), marker.at("reason").get<std::string>()});
    }
    return scan;
}

ReportedLink link_from(const ordered_json& json) {
    ReportedLink link;
    json.at("from").get_to(link.from);
    json.at("to").get_to(link.to);
    json.at("from_from_to").get_to(link.from_from_to);
    json.at("covariance").get_to(link.covariance);
    json.at("accepted").get_to(link.is_accepted);
    link.rms = number(json, "rms_m");
    link.overlap = number(json, "overlap");
    json.at("matches").get_to(link.matches);
    json.at("inliers").get_to(link.inliers);
    link.sigma_position = number(json, "sigma_position_m");
    link.sigma_rotation_deg = number(json, "sigma_rotation_deg");
    link.error_before = number(json, "error_before");
    link.error_after = number(json, "error_after");
    link.shift = number(json, "shift_m");
    link.turn_deg = number(json, "turn_deg");
    json.at("patches").at("stable").get_to(link.stable_patches);
    json.at("patches").at("changed").get_to(link.changed_patches);
    json.at("patches").at("shifted").get_to(link.shifted_patches);
    json.at("verdict").get_to(link.verdict);
    return link;
}

} // namespace

ordered_json to_json(const RegistrationReport& report) {
    ordered_json scans = ordered_json::array();
    for (const auto& scan : report.scans) scans.push_back(to_json(scan));
    ordered_json links = ordered_json::array();
    for (const auto& link : report.links) links.push_back(to_json(link));
    return {{"run", report.run},
            {"method", report.method},
            {"state", report.state},
            {"scans", scans},
            {"links", links},
            {"pairs_tried", report.pairs_tried},
            {"loops_before", report.loops_before},
            {"loops_after", report.loops_after},
            {"notes", report.notes}};
}

RegistrationReport registration_report(const std::string& json) {
    try {
        const ordered_json all = ordered_json::parse(json);
        RegistrationReport report;
        all.at("run").get_to(report.run);
        all.at("method").get_to(report.method);
        all.at("state").get_to(report.state);
        for (const auto& scan : all.at("scans")) report.scans.push_back(scan_from(scan));
        for (const auto& link : all.at("links")) report.links.push_back(link_from(link));
        all.at("pairs_tried").get_to(report.pairs_tried);
        report.loops_before = number(all, "loops_before");
        report.loops_after = number(all, "loops_after");
        all.at("notes").get_to(report.notes);
        return report;
    } catch (const nlohmann::json::exception&) {
        throw Error(ErrorCode::BadInput, "the report of a registration run cannot be read; discard the run");
    }
}

} // namespace planum::app
