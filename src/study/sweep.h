// A sweep: independent points with stable ids, run one after another, or a share of them.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/thread_pool.h"
#include "study/point_store.h"

namespace nuno {

// Part `index` of `count`, from 1 on: every count-th point.
struct Shard
{
    int index = 1, count = 1;

    bool takes(std::size_t point) const { return point % std::size_t(count) + 1 == std::size_t(index); }
};

// "2/8". Error where it is no part of a whole.
Shard parse_shard(std::string_view text);

struct SweepPoint
{
    std::string id;  // the same in every run of this version
    std::function<nlohmann::ordered_json()> measure;
};

// How far a sweep has come.
struct SweepState
{
    nlohmann::ordered_json header;     // of its store
    std::size_t count = 0;             // of all points
    std::vector<std::string> missing;  // ids of those without a result
};
SweepState sweep_state(const nlohmann::ordered_json& header, const std::vector<SweepPoint>& points,
                       const std::map<std::string, nlohmann::ordered_json>& results);

// "3 of 8 points are missing: a, b and 1 more", naming `most` of them; empty where none is.
std::string missing_text(const SweepState& state, std::size_t most);

// Called before each point that is measured; false ends the sweep with what is done.
using SweepProgress = std::function<bool(std::size_t done, std::size_t total)>;

// Measures the points of the shard that the store lacks. Whether all of them are in there now.
bool run_sweep(const std::vector<SweepPoint>& points, Shard shard, PointStore& store, const SweepProgress& progress);

// The same on all threads of a pool, for points whose results are no times; they are written in the order of the
// points, some at once. `progress` is asked on one thread alone, as often as that begins a point.
bool run_sweep(const std::vector<SweepPoint>& points, Shard shard, PointStore& store, ThreadPool& pool,
               const SweepProgress& progress);

}  // namespace nuno
