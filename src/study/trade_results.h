// What a trade study found: the points of each scene, the front, and what to pick.
#pragma once

#include <array>
#include <map>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "study/setting.h"

namespace nuno {

// Errors asked for, as shares of the size of the cloth.
inline constexpr std::array<double, 5> kTradeTargets{0.1, 0.03, 0.01, 0.003, 0.001};

// A setting of kind `time`.
struct TradePoint
{
    Setting set;
    std::string variant;  // the setting without its substeps: one curve of the picture
    int substeps = 0;
    double ms_per_second = 0;                    // of wall time a simulated second
    double error_share = 0;                      // rms distance from the reference over the size of the cloth
    double largest_share = 0, energy_share = 0;  // largest distance of a vertex; as in TrajectoryError
    double largest_strain = 0;
    bool is_measured = false;  // it ran to its end
    bool is_on_front = false;
    std::string failure;  // else why not
};

struct TradeScene
{
    std::string name;
    nlohmann::ordered_json scene_class;  // null where its point is missing, as in a part of a sweep
    std::vector<TradePoint> time;
    std::map<std::string, std::vector<nlohmann::ordered_json>> others;  // results of the other kinds, by kind

    // The cheapest point that is no more wrong than this; null where none is.
    const TradePoint* pick(double error_share) const;
};

// Marks the points that no other one beats in both cost and error.
void mark_front(std::span<TradePoint> points);

// By scene; `results` by id, as a point store has them.
std::vector<TradeScene> trade_scenes(const std::map<std::string, nlohmann::ordered_json>& results);

// Tables for a terminal: what to pick for what.
std::string trade_table(const TradeScene& scene);

std::string trade_csv(const std::vector<TradeScene>& scenes);
nlohmann::ordered_json trade_json(const std::vector<TradeScene>& scenes);

}  // namespace nuno
