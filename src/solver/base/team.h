// The threads that work on one step together, each on its own part, in time with one another.
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "core/thread_pool.h"

namespace nuno {

// A team as one of its threads sees it. What a team computes must not depend on how many threads it has.
class Team
{
  public:
    Team() = default;  // one thread alone
    Team(int thread, int thread_count, SpinBarrier* barrier)
        : thread_(thread), thread_count_(thread_count), barrier_(barrier)
    {
    }

    bool leads() const { return thread_ == 0; }
    // This thread's part of 0 .. count, and of a range.
    Range part(int count) const { return part_of(count, 1, thread_, thread_count_); }
    Range part(Range all) const
    {
        const Range own = part(all.end - all.begin);
        return {all.begin + own.begin, all.begin + own.end};
    }
    // Returns once all threads are here.
    void wait() const
    {
        if (barrier_) barrier_->arrive_and_wait();
    }
    // Sum of what all have put in, in order, once all have; nothing of it may be written again before the next wait.
    double sum(std::span<const double> values) const;

  private:
    int thread_ = 0, thread_count_ = 1;
    SpinBarrier* barrier_ = nullptr;
};

// Threads of the pool that are worth waking for this many vertices: all, or one.
int team_size(const ThreadPool& pool, std::uint32_t vertex_count);

// Calls body on each thread of a team; thread_count at most that of the pool.
void run_team(ThreadPool& pool, int thread_count, const std::function<void(const Team& team)>& body);

}  // namespace nuno
