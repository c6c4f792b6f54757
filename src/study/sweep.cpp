// The points of a shard, in order.
#include "study/sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <optional>

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

SweepState sweep_state(const nlohmann::ordered_json& header, const std::vector<SweepPoint>& points,
                       const std::map<std::string, nlohmann::ordered_json>& results)
{
    SweepState state{header, points.size(), {}};
    for (const SweepPoint& point : points)
        if (results.count(point.id) == 0) state.missing.push_back(point.id);
    return state;
}

std::string missing_text(const SweepState& state, std::size_t most)
{
    if (state.missing.empty()) return "";
    std::string text = fmt::format("{} of {} points are missing: ", state.missing.size(), state.count);
    const std::size_t named = std::min(most, state.missing.size());
    for (std::size_t i = 0; i < named; ++i) text.append(i > 0 ? ", " : "").append(state.missing[i]);
    return named == state.missing.size() ? text : fmt::format("{} and {} more", text, state.missing.size() - named);
}

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
    std::atomic<bool> goes_on{true};
    for (std::size_t done = 0; done < open.size() && goes_on; done += at_once) {
        if (!progress(done, open.size())) return false;
        std::vector<std::optional<nlohmann::ordered_json>> results(std::min(at_once, open.size() - done));
        std::atomic<std::size_t> next{0};
        pool.run([&](int thread) {
            for (std::size_t i = next++; i < results.size(); i = next++) {
                if (thread == 0 && !progress(done + i, open.size())) goes_on = false;
                if (!goes_on) return;
                results[i] = open[done + i]->measure();
            }
        });
        for (std::size_t i = 0; i < results.size(); ++i)
            if (results[i]) store.add(open[done + i]->id, *results[i]);
    }
    return goes_on;
}

}  // namespace nuno
