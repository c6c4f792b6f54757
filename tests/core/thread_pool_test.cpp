// The thread pool runs everything once, in step.
#include "core/thread_pool.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>
#include <vector>

namespace nuno {
namespace {

TEST(ThreadPool, every_thread_runs_the_body_once_a_round)
{
    for (const int count : {1, 2, 3, 8}) {
        ThreadPool pool(count);
        ASSERT_EQ(pool.thread_count(), count);
        std::vector<int> runs(static_cast<std::size_t>(count));
        for (int round = 0; round < 200; ++round)
            pool.run([&](int thread) { ++runs[static_cast<std::size_t>(thread)]; });
        for (const int r : runs) EXPECT_EQ(r, 200);
    }
}

TEST(ThreadPool, an_exception_of_any_thread_reaches_the_caller_and_the_pool_works_on)
{
    ThreadPool pool(3);
    for (int thrower = 0; thrower < 3; ++thrower) {
        EXPECT_THROW(pool.run([&](int thread) { thread == thrower ? throw std::runtime_error("bad") : void(); }),
                     std::runtime_error);
        std::atomic<int> runs{0};
        pool.run([&](int) { ++runs; });
        EXPECT_EQ(runs, 3);
    }
}

TEST(ThreadPool, what_a_thread_wrote_before_the_barrier_is_seen_after_it)
{
    constexpr int kThreads = 3, kSteps = 300;
    ThreadPool pool(kThreads);
    std::vector<int> values(kThreads, 0), next(kThreads, 0);
    SpinBarrier barrier(kThreads);
    pool.run([&](int thread) {
        const auto t = static_cast<std::size_t>(thread);
        for (int step = 0; step < kSteps; ++step) {
            next[t] = values[(t + 1) % kThreads] + 1;
            barrier.arrive_and_wait();
            values[t] = next[t];
            barrier.arrive_and_wait();
        }
    });
    for (const int value : values) EXPECT_EQ(value, kSteps);
}

TEST(ThreadPool, runs_that_stand_still_are_done_alone_for_a_while_and_longer_each_time)
{
    ThreadPool pool(2);
    const auto alone = [&] {
        int count = 0;
        while (pool.take_next_alone()) ++count;
        return count;
    };
    pool.note_run(0.5, 1);
    EXPECT_EQ(alone(), 0) << "half of the time is not standing still";
    for (int k = 0; k < 2; ++k) {
        pool.note_run(0.9, 1);
        EXPECT_EQ(alone(), 0) << "once or twice may be chance";
    }
    pool.note_run(0.9, 1);
    const int first = alone();
    EXPECT_GT(first, 10);
    pool.note_run(0.9, 1);
    EXPECT_EQ(alone(), 2 * first);
    pool.note_run(0.1, 1);
    EXPECT_EQ(alone(), 0);
    for (int k = 0; k < 3; ++k) pool.note_run(0.9, 1);
    EXPECT_EQ(alone(), first);
}

TEST(ThreadPool, the_time_that_threads_wait_at_a_barrier_is_known)
{
    SpinBarrier barrier(2);
    ThreadPool pool(2);
    pool.run([&](int thread) {
        if (thread == 1) std::this_thread::sleep_for(std::chrono::milliseconds(20));
        barrier.arrive_and_wait();
    });
    EXPECT_GT(barrier.waiting_s(), 0.01);
}

TEST(ThreadPool, the_parts_cover_everything_once)
{
    for (const int count : {0, 1, 7, 64, 1000})
        for (const int grain : {1, 8, 64})
            for (const int threads : {1, 2, 3, 7}) {
                int next = 0;
                for (int thread = 0; thread < threads; ++thread) {
                    const Range part = part_of(count, grain, thread, threads);
                    EXPECT_EQ(part.begin, next);
                    EXPECT_TRUE(part.begin % grain == 0 || part.begin == count);
                    next = part.end;
                }
                EXPECT_EQ(next, count);
            }
}

}  // namespace
}  // namespace nuno
