// SPDX-License-Identifier: MIT
#include "app/demo/dig_files.hpp"

#include <cmath>
#include <cstdint>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace planum::app::demo {

namespace {

using nlohmann::ordered_json;

constexpr const char* kArea = "A";

// A number with four decimals; text of a scan is written a hundred million times.
void append_fixed(std::string& out, double value) {
    auto scaled = static_cast<std::int64_t>(std::llround(value * 1e4));
    if (scaled < 0) {
        out += '-';
        scaled = -scaled;
    }
    char digits[24];
    int n = 0;
    for (std::int64_t whole = scaled / 10000; whole > 0 || n == 0; whole /= 10)
        digits[n++] = static_cast<char>('0' + whole % 10);
    while (n > 0) out += digits[--n];
    out += '.';
    for (std::int64_t unit = 1000; unit > 0; unit /= 10) out += static_cast<char>('0' + scaled / unit % 10);
}

std::string csv_cell(std::string_view text) {
    if (text.find_first_of(",\"\n") == std::string_view::npos) return std::string{text};
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"') out += '"';
        out += c;
    }
    return out + '"';
}

std::string row(const std::vector<std::string>& cells) {
    std::string line;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        if (i > 0) line += ',';
        line += csv_cell(cells[i]);
    }
    return line + "\n";
}

std::string metres(double value) { return fmt::format("{:.3f}", value); }

std::string units_csv(const DigRecord& record) {
    std::string out = "unit,area,kind,form,status,title,excavated_from,excavated_on,recorded_by,phase,group\n";
    for (const RecordedUnit& u : record.units) {
        out += row({u.number, kArea, std::string{model::to_word(u.kind)}, std::string{model::to_word(u.form)},
                    std::string{model::to_word(u.status)}, u.title, u.excavated_from, u.excavated_on, u.recorded_by,
                    u.phase, u.group});
    }
    return out;
}

std::string relations_csv(const DigRecord& record) {
    std::string out = "unit,area,relation,other,certainty,person\n";
    for (const RecordedRelation& r : record.relations) {
        out += row({r.unit, kArea, r.relation, r.other, r.uncertain ? "uncertain" : "certain", r.person});
    }
    return out;
}

std::string levels_csv(const DigRecord& record) {
    std::string out = "unit,area,z,role,x,y,label\n";
    for (const RecordedLevel& l : record.levels) {
        out += row({l.unit, kArea, metres(l.at.z), std::string{model::to_word(l.role)}, metres(l.at.x), metres(l.at.y),
                    l.label});
    }
    return out;
}

std::string finds_csv(const DigRecord& record) {
    std::string out = "find,unit,area,x,y,z,type,material,count,weight,found_on\n";
    for (const RecordedFind& f : record.finds) {
        out += row({f.number, f.unit, kArea, metres(f.at.x), metres(f.at.y), metres(f.at.z), f.type, f.material,
                    fmt::format("{}", f.count), fmt::format("{:.0f}", f.weight), f.found_on});
    }
    return out;
}

std::string datings_csv(const DigRecord& record) {
    std::string out = "dating,unit,area,find,kind,from,to\n";
    for (const RecordedDating& d : record.datings) {
        const auto year = [](const std::optional<int>& y) { return y ? fmt::format("{}", *y) : std::string{}; };
        out += row({d.label, d.unit, kArea, d.find, std::string{model::to_word(d.kind)}, year(d.from), year(d.to)});
    }
    return out;
}

std::string phases_csv(const std::vector<RecordedPhase>& phases, bool periods) {
    std::string out = periods ? "period,title,from,to,rank\n" : "phase,title,period,from,to,rank\n";
    int rank = 0;
    for (const RecordedPhase& p : phases) {
        std::vector<std::string> cells = {p.number, p.title};
        if (!periods) cells.push_back(p.period);
        cells.insert(cells.end(), {fmt::format("{}", p.from), fmt::format("{}", p.to), fmt::format("{}", ++rank)});
        out += row(cells);
    }
    return out;
}

std::string groups_csv(const DigRecord& record) {
    std::string out = "group,type,title\n";
    for (const RecordedGroup& g : record.groups) out += row({g.number, g.type, g.title});
    return out;
}

ordered_json ring_json(const model::Ring& ring) {
    ordered_json points = ordered_json::array();
    for (const auto& p : ring) points.push_back({p[0], p[1], p[2]});
    if (!ring.empty()) points.push_back({ring[0][0], ring[0][1], ring[0][2]}); // GeoJSON repeats the first
    return points;
}

} // namespace

std::string ptx_text(const ScanImage& image) {
    std::string out = fmt::format("{}\n{}\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n",
                                  image.columns, image.rows);
    out.reserve(out.size() + image.returns.size() * 32);
    for (int column = 0; column < image.columns; ++column) {
        for (int r = 0; r < image.rows; ++r) {
            const Return& back = image.returns[static_cast<std::size_t>(column) * static_cast<std::size_t>(image.rows) +
                                               static_cast<std::size_t>(r)];
            if (back.range <= 0.0F) {
                out += "0 0 0 0.5\n";
                continue;
            }
            const Vec3 x = static_cast<double>(back.range) * image.direction_in_scan(column, r);
            for (const double v : {x.x, x.y, x.z}) {
                append_fixed(out, v);
                out += ' ';
            }
            append_fixed(out, static_cast<double>(back.intensity));
            out += '\n';
        }
    }
    return out;
}

std::vector<std::pair<std::string, std::string>> record_tables(const DigRecord& record, const DigPlan& plan) {
    const std::string area = fmt::format("area,title,method\n{},trench A,{}\n", kArea, model::to_word(plan.method));
    return {{"areas.csv", area},
            {"datings.csv", datings_csv(record)},
            {"finds.csv", finds_csv(record)},
            {"groups.csv", groups_csv(record)},
            {"levels.csv", levels_csv(record)},
            {"periods.csv", phases_csv(record.periods, true)},
            {"phases.csv", phases_csv(record.phases, false)},
            {"relations.csv", relations_csv(record)},
            {"units.csv", units_csv(record)}};
}

std::string outlines_geojson(const DemoDig& dig, SurfaceNo surface) {
    ordered_json features = ordered_json::array();
    const std::string& day = dig.plan.days[static_cast<std::size_t>(surface)];
    for (const DrawnRegion& region : dig.regions) {
        if (region.surface != surface) continue;
        ordered_json rings = ordered_json::array();
        rings.push_back(ring_json(region.outline.outer));
        for (const model::Ring& hole : region.outline.holes) rings.push_back(ring_json(hole));
        ordered_json unit = nullptr;
        if (region.unit != kAir) unit = dig.formation.units()[static_cast<std::size_t>(region.unit)].number;
        features.push_back({{"type", "Feature"},
                            {"properties",
                             {{"unit", unit},
                              {"area", kArea},
                              {"day", day},
                              {"surface", day},
                              {"category", model::to_word(region.category)},
                              {"shows", model::to_word(region.shows)},
                              {"notes", region.notes}}},
                            {"geometry", {{"type", "Polygon"}, {"coordinates", rings}}}});
    }
    const ordered_json all = {{"type", "FeatureCollection"}, {"name", "outlines " + day}, {"features", features}};
    return all.dump(1) + "\n";
}

} // namespace planum::app::demo
