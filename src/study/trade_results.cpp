// The front of a trade, and its tables.
#include "study/trade_results.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace nuno {
namespace {

using Json = nlohmann::ordered_json;

TradePoint point_of(const Json& result)
{
    TradePoint point;
    for (const auto& [name, value] : result.at("set").items()) {
        point.set.emplace_back(name, value.get<std::string>());
        if (name == "substeps") continue;
        point.variant +=
            (point.variant.empty() ? "" : ", ") + (name == "method" ? "" : name + " ") + value.get<std::string>();
    }
    point.substeps = result.value("substeps", 0);
    point.is_measured = result.contains("ms_per_second");
    if (!point.is_measured) {
        point.failure =
            result.value("failure", std::string(result.value("too_slow", false) ? "too slow" : "ended early"));
        return point;
    }
    point.ms_per_second = result.at("ms_per_second");
    point.error_share = result.at("error_share");
    point.energy_share = result.at("energy_share");
    point.largest_strain = result.at("largest_strain");
    point.largest_share = result.at("largest_m").get<double>() * point.error_share /
                          std::max(result.at("rms_m").get<double>(), std::numeric_limits<double>::min());
    return point;
}

}  // namespace

const TradePoint* TradeScene::pick(double error_share) const
{
    const TradePoint* best = nullptr;
    for (const TradePoint& point : time)
        if (point.is_measured && point.error_share <= error_share &&
            (best == nullptr || point.ms_per_second < best->ms_per_second))
            best = &point;
    return best;
}

void mark_front(std::span<TradePoint> points)
{
    std::vector<TradePoint*> by_cost;
    for (TradePoint& point : points) {
        point.is_on_front = false;
        if (point.is_measured) by_cost.push_back(&point);
    }
    std::stable_sort(by_cost.begin(), by_cost.end(), [](const TradePoint* a, const TradePoint* b) {
        return a->ms_per_second != b->ms_per_second ? a->ms_per_second < b->ms_per_second
                                                    : a->error_share < b->error_share;
    });
    double least = std::numeric_limits<double>::infinity();
    for (TradePoint* point : by_cost)
        if (point->error_share < least) {
            point->is_on_front = true;
            least = point->error_share;
        }
}

std::vector<TradeScene> trade_scenes(const std::map<std::string, Json>& results)
{
    std::map<std::string, TradeScene> scenes;
    for (const auto& [id, result] : results) {
        const std::size_t slash = id.find('/');
        const std::string name = id.substr(0, slash);
        const std::string kind = id.substr(slash + 1, id.find('/', slash + 1) - slash - 1);
        TradeScene& scene = scenes[name];
        scene.name = name;
        if (kind == "scene")
            scene.scene_class = result;
        else if (kind == "time")
            scene.time.push_back(point_of(result));
        else
            scene.others[kind].push_back(result);
    }
    std::vector<TradeScene> list;
    for (auto& [name, scene] : scenes) {
        std::stable_sort(scene.time.begin(), scene.time.end(), [](const TradePoint& a, const TradePoint& b) {
            return a.variant != b.variant ? a.variant < b.variant : a.substeps < b.substeps;
        });
        mark_front(scene.time);
        list.push_back(std::move(scene));
    }
    return list;
}

std::string trade_table(const TradeScene& scene)
{
    std::string table =
        fmt::format("{}: the cheapest setting for an error, in percent of the size of the cloth\n", scene.name);
    table += fmt::format("{:>8} {:>10} {:>12}  {}\n", "asked", "measured", "ms a second", "setting");
    for (const double target : kTradeTargets) {
        const TradePoint* point = scene.pick(target);
        if (point == nullptr)
            table += fmt::format("{:>7g}% {:>10} {:>12}  none of those tried\n", 100 * target, "-", "-");
        else
            table += fmt::format("{:>7g}% {:>9.2g}% {:>12.3g}  {}\n", 100 * target, 100 * point->error_share,
                                 point->ms_per_second, setting_text(point->set));
    }
    return table;
}

std::string trade_csv(const std::vector<TradeScene>& scenes)
{
    std::string csv =
        "scene,setting,substeps,ms_per_second,error_share,largest_share,energy_share,largest_strain,"
        "on_front,failure\n";
    for (const TradeScene& scene : scenes)
        for (const TradePoint& p : scene.time) {
            const std::string numbers = p.is_measured ? fmt::format("{},{},{},{},{}", p.ms_per_second, p.error_share,
                                                                    p.largest_share, p.energy_share, p.largest_strain)
                                                      : ",,,,";
            csv += fmt::format("{},{},{},{},{},\"{}\"\n", scene.name, setting_text(p.set), p.substeps, numbers,
                               int(p.is_on_front), p.failure);
        }
    return csv;
}

Json trade_json(const std::vector<TradeScene>& scenes)
{
    Json list = Json::array();
    for (const TradeScene& scene : scenes) {
        Json points = Json::array();
        for (const TradePoint& p : scene.time) {
            Json point{{"set", setting_json(p.set)}, {"substeps", p.substeps}, {"on_front", p.is_on_front}};
            if (p.is_measured)
                point.update({{"ms_per_second", p.ms_per_second},
                              {"error_share", p.error_share},
                              {"largest_share", p.largest_share},
                              {"energy_share", p.energy_share},
                              {"largest_strain", p.largest_strain}});
            else
                point["failure"] = p.failure;
            points.push_back(std::move(point));
        }
        Json entry{{"scene", scene.name}, {"class", scene.scene_class}, {"time", points}};
        for (const auto& [kind, results] : scene.others) entry[kind] = results;
        list.push_back(std::move(entry));
    }
    return list;
}

}  // namespace nuno
