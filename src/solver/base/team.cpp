// Teams of threads.
#include "solver/base/team.h"

#include "core/stopwatch.h"

namespace nuno {
namespace {

constexpr std::uint32_t kLeastVerticesForThreads = 2048;

}  // namespace

double Team::sum(std::span<const double> values) const
{
    wait();
    double total = 0;
    for (const double value : values) total += value;
    return total;
}

int team_size(const ThreadPool& pool, std::uint32_t vertex_count)
{
    return vertex_count < kLeastVerticesForThreads ? 1 : pool.thread_count();
}

void run_team(ThreadPool& pool, int thread_count, const std::function<void(const Team& team)>& body)
{
    if (thread_count == 1 || pool.take_next_alone()) return body(Team());
    SpinBarrier barrier(thread_count);
    const Stopwatch watch;
    pool.run([&](int thread) {
        if (thread < thread_count) body(Team(thread, thread_count, &barrier));
    });
    pool.note_run(barrier.waiting_s(), watch.elapsed_ms() / 1000);
}

}  // namespace nuno
