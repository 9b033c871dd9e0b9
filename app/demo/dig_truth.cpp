// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <nlohmann/json.hpp>

#include "app/demo/dig_files.hpp"
#include "core/model/relation.hpp"

namespace planum::app::demo {

namespace {

using nlohmann::ordered_json;

// Short in the file: nlohmann prints the shortest text that reads back, so round to the decimals that count.
ordered_json metres(double value) { return std::round(value * 1e4) / 1e4; }

ordered_json amount(double value) { return std::round(value * 1e5) / 1e5; }

ordered_json point(const Vec3& p) { return {metres(p.x), metres(p.y), metres(p.z)}; }

class TruthWriter {
  public:
    explicit TruthWriter(const DemoDig& dig) : dig_(dig) {}

    std::string write(const std::vector<ScanTruth>& scans) const {
        ordered_json truth;
        truth["format"] = "planum demo truth 1";
        truth["seed"] = dig_.options.seed;
        truth["size"] = size_word();
        truth["method"] = model::to_word(dig_.options.method);
        const Bounds& t = dig_.site.trench;
        truth["trench"] = {{metres(t.low.x), metres(t.low.y)}, {metres(t.high.x), metres(t.high.y)}};
        truth["scans"] = scans_json(scans);
        truth["surfaces"] = surfaces();
        truth["units"] = units();
        truth["order"] = order();
        truth["contacts"] = contacts();
        truth["seen"] = seen();
        truth["volumes"] = volumes();
        truth["special"] = special();
        truth["mistakes"] = mistakes();
        return truth.dump(1) + "\n";
    }

  private:
    [[nodiscard]] const std::string& number(UnitNo unit) const {
        return dig_.formation.units()[static_cast<std::size_t>(unit)].number;
    }

    [[nodiscard]] const std::string& day(SurfaceNo surface) const {
        return dig_.plan.days[static_cast<std::size_t>(surface)];
    }

    [[nodiscard]] const char* size_word() const {
        switch (dig_.options.size) {
        case DemoSize::Tiny: return "tiny";
        case DemoSize::Small: return "small";
        case DemoSize::Medium: return "medium";
        case DemoSize::Large: return "large";
        }
        return "";
    }

    [[nodiscard]] ordered_json scans_json(const std::vector<ScanTruth>& scans) const {
        ordered_json all = ordered_json::array();
        for (const ScanTruth& scan : scans) {
            const auto& r = scan.station.pose.rotation;
            const Vec3& o = scan.station.pose.origin;
            all.push_back({{"scan", scan.station.name},
                           {"day", day(scan.station.surface)},
                           {"site_from_scan",
                            {r[0], r[1], r[2], o.x, r[3], r[4], r[5], o.y, r[6], r[7], r[8], o.z, 0.0, 0.0, 0.0, 1.0}},
                           {"points", scan.points},
                           {"mixed_pixels", scan.mixed},
                           {"people_or_vehicles", scan.people},
                           {"markers", scan.markers}});
        }
        return all;
    }

    [[nodiscard]] ordered_json surfaces() const {
        ordered_json all = ordered_json::array();
        for (SurfaceNo s = 0; s < dig_.plan.surfaces; ++s) {
            std::map<UnitNo, std::size_t> cells;
            for (const SurfaceCell& cell : dig_.maps[static_cast<std::size_t>(s)]) {
                if (cell.unit != kAir) ++cells[cell.unit];
            }
            ordered_json bare = ordered_json::array();
            const double area = dig_.grid->cell() * dig_.grid->cell();
            for (const auto& [unit, count] : cells) {
                bare.push_back({{"unit", number(unit)}, {"area_m2", amount(static_cast<double>(count) * area)}});
            }
            all.push_back({{"surface", day(s)}, {"day", day(s)}, {"bare", bare}});
        }
        return all;
    }

    [[nodiscard]] ordered_json units() const {
        ordered_json all = ordered_json::array();
        std::set<UnitNo> shown;
        for (const SurfaceMap& map : dig_.maps) {
            for (const SurfaceCell& cell : map) {
                if (cell.unit != kAir) shown.insert(cell.unit);
            }
        }
        std::map<UnitNo, double> dug;
        for (const auto& [key, volume] : dig_.volumes) dug[key.first] += volume;
        for (std::size_t u = 0; u < dig_.formation.units().size(); ++u) {
            const FormedUnit& unit = dig_.formation.units()[u];
            const auto no = static_cast<UnitNo>(u);
            ordered_json entry = {{"unit", unit.number},
                                  {"kind", model::to_word(unit.kind)},
                                  {"form", model::to_word(unit.form)},
                                  {"dug_m3", amount(dug[no])},
                                  {"bare_on_some_surface", shown.contains(no)}};
            if (unit.cut != kAir) entry["of_cut"] = number(unit.cut);
            all.push_back(std::move(entry));
        }
        return all;
    }

    // Earliest first. Units that formed at one time (twins, bonded walls) stand in one entry.
    [[nodiscard]] ordered_json order() const {
        ordered_json all = ordered_json::array();
        const auto& units = dig_.formation.units();
        std::set<UnitNo> done;
        for (std::size_t u = 0; u < units.size(); ++u) {
            const auto no = static_cast<UnitNo>(u);
            if (!done.insert(no).second) continue;
            ordered_json together = {units[u].number};
            for (const UnitNo other : {units[u].twin, units[u].bonded}) {
                if (other != kAir && done.insert(other).second) together.push_back(number(other));
            }
            all.push_back(std::move(together));
        }
        return all;
    }

    [[nodiscard]] ordered_json contacts() const {
        ordered_json all = ordered_json::array();
        for (const Contact& contact : dig_.contacts) {
            const auto found = dig_.seen.find({contact.later, contact.earlier});
            const bool is_seen = found != dig_.seen.end() && found->second.area > 0.0;
            ordered_json entry = {
                {"unit", number(contact.later)},
                {"kind", model::to_word(contact.kind)},
                {"other", number(contact.earlier)},
                {"plan_area_m2", amount(contact.plan_area)},
                {"side_area_m2", amount(contact.side_area)},
                {"visible_m2", amount(is_seen ? found->second.area : 0.0)},
                {"shared_outline_m", metres(found != dig_.seen.end() ? found->second.shared_outline : 0.0)}};
            entry["surfaces"] = ordered_json::array();
            if (is_seen) entry["surfaces"] = {day(found->second.from), day(found->second.to)};
            all.push_back(std::move(entry));
        }
        return all;
    }

    // Every pair of units that lay bare one after the other, direct contact or not.
    [[nodiscard]] ordered_json seen() const {
        ordered_json all = ordered_json::array();
        for (const auto& [pair, contact] : dig_.seen) {
            if (contact.area <= 0.0) continue;
            all.push_back({{"first", number(pair.first)},
                           {"then", number(pair.second)},
                           {"area_m2", amount(contact.area)},
                           {"surfaces", {day(contact.from), day(contact.to)}}});
        }
        return all;
    }

    [[nodiscard]] ordered_json volumes() const {
        ordered_json by_unit = ordered_json::array();
        std::vector<double> by_surface(static_cast<std::size_t>(dig_.plan.surfaces), 0.0);
        double total = 0.0;
        for (const auto& [key, volume] : dig_.volumes) {
            by_unit.push_back(
                {{"unit", number(key.first)}, {"gone_on", day(key.second)}, {"volume_m3", amount(volume)}});
            by_surface[static_cast<std::size_t>(key.second)] += volume;
            total += volume;
        }
        ordered_json surfaces = ordered_json::array();
        for (SurfaceNo s = 0; s < dig_.plan.surfaces; ++s) {
            surfaces.push_back({{"surface", day(s)}, {"volume_m3", amount(by_surface[static_cast<std::size_t>(s)])}});
            if (s > 0) surfaces.back()["from_above_m3"] = amount(from_above(s));
        }
        return {{"total_m3", amount(total)}, {"by_surface", surfaces}, {"by_unit", by_unit}};
    }

    // By how much the ground that lies bare sank since the surface before: all that heights can show. What went from
    // under an overhang is not in it; what fell from the side is, until it is carried off.
    [[nodiscard]] double from_above(SurfaceNo surface) const {
        const SurfaceMap& before = dig_.maps[static_cast<std::size_t>(surface) - 1];
        const SurfaceMap& after = dig_.maps[static_cast<std::size_t>(surface)];
        double sum = 0.0;
        for (std::size_t i = 0; i < after.size(); ++i)
            sum += static_cast<double>(before[i].z) - static_cast<double>(after[i].z);
        return sum * dig_.grid->cell() * dig_.grid->cell();
    }

    [[nodiscard]] ordered_json special() const {
        const DigPlan& plan = dig_.plan;
        ordered_json special = ordered_json::object();
        if (plan.baulk_low < plan.baulk_high) {
            special["baulk"] = {{"x_from", metres(plan.baulk_low)},
                                {"x_to", metres(plan.baulk_high)},
                                {"gone_on", day(plan.surfaces - 1)}};
        }
        if (plan.half.cut != kAir) {
            const HalfSection& half = plan.half;
            special["half_section"] = {{"cut", number(half.cut)},
                                       {"through", {metres(half.x), metres(half.y)}},
                                       {"normal", {amount(half.normal_x), amount(half.normal_y)}},
                                       {"first_half_gone_on", day(half.first)},
                                       {"second_half_gone_on", day(std::min(half.first + 1, plan.surfaces - 1))}};
        }
        if (plan.overdug.made) {
            special["overdug"] = {{"surface", day(plan.overdug.surface)},
                                  {"centre", point(plan.overdug.centre)},
                                  {"radii", point(plan.overdug.radii)}};
        }
        if (plan.slump.fell) {
            special["slump"] = {{"surface", day(plan.slump.surface)},
                                {"foot", {metres(plan.slump.x), metres(plan.slump.y), metres(plan.slump.floor)}},
                                {"height", metres(plan.slump.height)}};
        }
        special["recognised_late"] = ordered_json::array();
        for (const UnitNo cut : plan.late) special["recognised_late"].push_back(number(cut));
        return special;
    }

    [[nodiscard]] ordered_json mistakes() const {
        ordered_json all = ordered_json::array();
        for (const Mistake& m : dig_.mistakes) {
            all.push_back({{"kind", m.kind},
                           {"file", "with-mistakes/" + m.table},
                           {"about", m.unit},
                           {"was", m.was},
                           {"is", m.is},
                           {"surfaces_show_it", m.visible}});
        }
        return all;
    }

    const DemoDig& dig_;
};

} // namespace

std::string truth_json(const DemoDig& dig, const std::vector<ScanTruth>& scans) {
    return TruthWriter(dig).write(scans);
}

} // namespace planum::app::demo
