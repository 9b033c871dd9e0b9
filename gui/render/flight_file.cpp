// SPDX-License-Identifier: MIT
#include "gui/render/flight_file.hpp"

#include <QByteArray>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QJsonParseError>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

#include <fmt/format.h>

#include "core/base/error.hpp"
#include "core/base/file.hpp"

namespace planum::gui {

namespace {

constexpr std::string_view kFormat = "planum-flight";
constexpr int kVersion = 1;
constexpr std::uintmax_t kMostBytes = 4'000'000;
constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kFarthest = 1e8; // [m] from the grid's origin: beyond that floats of no grid reach

struct Range {
    double low;
    double high;
};

double number_of(const QJsonValue& value, std::string_view key, Range range) {
    const double number = value.toDouble(std::nan(""));
    if (!value.isDouble() || !(number >= range.low && number <= range.high)) {
        throw Error(ErrorCode::BadInput,
                    fmt::format("{}: a number from {} to {} expected", key, range.low, range.high));
    }
    return number;
}

Eigen::Vector3d place_of(const QJsonValue& value) {
    const QJsonArray numbers = value.toArray();
    if (numbers.size() != 3) throw Error(ErrorCode::BadInput, "target: x, y and height expected");
    Eigen::Vector3d place;
    for (int axis = 0; axis < 3; ++axis) place(axis) = number_of(numbers[axis], "target", {-kFarthest, kFarthest});
    return place;
}

Camera camera_of(const QJsonValue& value) {
    if (!value.isObject()) throw Error(ErrorCode::BadInput, "an object expected");
    const QJsonObject object = value.toObject();
    const auto optional = [&](const char* key, double otherwise, Range range) {
        const QJsonValue given = object.value(QLatin1String(key));
        return given.isUndefined() ? otherwise : number_of(given, key, range);
    };
    Camera camera;
    camera.target = place_of(object.value(QLatin1String("target")));
    camera.distance = number_of(object.value(QLatin1String("distance")), "distance", {0.05, 5000.0});
    camera.yaw = optional("yaw_deg", camera.yaw / kDegree, {-36000.0, 36000.0}) * kDegree;
    camera.pitch = optional("pitch_deg", camera.pitch / kDegree, {-90.0, 90.0}) * kDegree;
    camera.opening = optional("opening_deg", camera.opening / kDegree, {1.0, 150.0}) * kDegree;
    const QJsonValue above = object.value(QLatin1String("from_above"));
    if (!above.isUndefined() && !above.isBool()) throw Error(ErrorCode::BadInput, "from_above: true or false expected");
    camera.from_above = above.toBool();
    return camera;
}

std::string number_text(double value, int places) {
    std::string text = fmt::format("{:.{}f}", value, places);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text == "-0" ? "0" : text;
}

} // namespace

std::filesystem::path flight_file_of(const std::filesystem::path& project) {
    std::filesystem::path file = project;
    return file.replace_extension(".flight.json");
}

std::string flight_text(const std::vector<Camera>& cameras) {
    std::string text =
        fmt::format("{{\n  \"format\": \"{}\",\n  \"version\": {},\n  \"cameras\": [", kFormat, kVersion);
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        const Camera& camera = cameras[i];
        const auto metres = [](double value) { return number_text(value, 4); };
        const auto degrees = [](double value) { return number_text(value / kDegree, 6); };
        text += fmt::format("{}\n    {{\"target\": [{}, {}, {}], \"distance\": {}, \"yaw_deg\": {}, \"pitch_deg\": {}, "
                            "\"opening_deg\": {}, \"from_above\": {}}}",
                            i == 0 ? "" : ",", metres(camera.target.x()), metres(camera.target.y()),
                            metres(camera.target.z()), metres(camera.distance), degrees(camera.yaw),
                            degrees(camera.pitch), degrees(camera.opening), camera.from_above);
    }
    return text + (cameras.empty() ? "]\n}\n" : "\n  ]\n}\n");
}

std::vector<Camera> flight_from(const std::string& text) {
    QJsonParseError trouble;
    const QJsonDocument document =
        QJsonDocument::fromJson(QByteArray::fromRawData(text.data(), static_cast<qsizetype>(text.size())), &trouble);
    if (trouble.error != QJsonParseError::NoError) {
        const auto line =
            1 + std::count(text.begin(), text.begin() + std::min(trouble.offset, static_cast<int>(text.size())), '\n');
        throw Error(ErrorCode::BadInput, fmt::format("line {}: {}", line, trouble.errorString().toStdString()));
    }
    const QJsonObject root = document.object();
    if (root.value(QLatin1String("format")).toString().toStdString() != kFormat)
        throw Error(ErrorCode::BadInput, fmt::format("no cameras of a flight (\"format\": \"{}\" expected)", kFormat));
    if (const int version = root.value(QLatin1String("version")).toInt(0); version != kVersion) {
        throw Error(ErrorCode::BadInput, fmt::format("version {}, this program knows {}", version, kVersion));
    }
    if (!root.value(QLatin1String("cameras")).isArray()) throw Error(ErrorCode::BadInput, "cameras: a list expected");
    const QJsonArray list = root.value(QLatin1String("cameras")).toArray();
    if (list.size() > static_cast<qsizetype>(kMostCameras))
        throw Error(ErrorCode::BadInput, fmt::format("{} cameras, at most {} are read", list.size(), kMostCameras));
    std::vector<Camera> cameras;
    for (const QJsonValue& value : list) {
        try {
            cameras.push_back(camera_of(value));
        } catch (Error& error) {
            error.add_context(fmt::format("camera {}", cameras.size() + 1));
            throw;
        }
    }
    return cameras;
}

std::vector<Camera> read_flight(const std::filesystem::path& file) {
    const std::string text = read_file(file, kMostBytes);
    try {
        return flight_from(text);
    } catch (Error& error) {
        error.add_context(file.string());
        throw;
    }
}

} // namespace planum::gui
