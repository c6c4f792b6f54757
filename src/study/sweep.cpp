// The points of a shard, in order.
#include "study/sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <charconv>

#include "core/error.h"

namespace nuno {

Shard parse_shard(std::string_view text)
{
    Shard shard{0, 0};
    const char* const end = text.data() + text.size();
    const auto index = std::from_chars(text.data(), end, shard.index);
    const bool has_slash = index.ec == std::errc() && index.ptr != end && *index.ptr == '/';
    const auto count = has_slash ? std::from_chars(index.ptr + 1, end, shard.count) : index;
    if (!has_slash || count.ec != std::errc() || count.ptr != end || shard.index < 1 || shard.index > shard.count)
        throw Error(fmt::format("--shard {}: is no part of a sweep; give K/N with K from 1 to N, as 2/8", text));
    return shard;
}

namespace {

std::vector<const SweepPoint*> open_points(const std::vector<SweepPoint>& points, Shard shard, const PointStore& store)
{
    std::vector<const SweepPoint*> open;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (shard.takes(i) && !store.holds(points[i].id)) open.push_back(&points[i]);
    return open;
}

}  // namespace

bool run_sweep(const std::vector<SweepPoint>& points, Shard shard, PointStore& store, const SweepProgress& progress)
{
    const std::vector<const SweepPoint*> open = open_points(points, shard, store);
    for (std::size_t done = 0; done < open.size(); ++done) {
        if (!progress(done, open.size())) return false;
        store.add(open[done]->id, open[done]->measure());
    }
    return true;
}

bool run_sweep(const std::vector<SweepPoint>& points, Shard shard, PointStore& store, ThreadPool& pool,
               const SweepProgress& progress)
{
    const std::vector<const SweepPoint*> open = open_points(points, shard, store);
    const auto at_once = std::size_t(pool.thread_count()) * 16;
    for (std::size_t done = 0; done < open.size();) {
        if (!progress(done, open.size())) return false;
        std::vector<nlohmann::ordered_json> results(std::min(at_once, open.size() - done));
        std::atomic<std::size_t> next{0};
        pool.run([&](int) {
            for (std::size_t i = next++; i < results.size(); i = next++) results[i] = open[done + i]->measure();
        });
        for (const nlohmann::ordered_json& result : results) store.add(open[done++]->id, result);
    }
    return true;
}

}  // namespace nuno
