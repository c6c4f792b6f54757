// A fixed pool of threads.
#include "core/thread_pool.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "core/stopwatch.h"

namespace nuno {
namespace {

// Pauses of some tens of nanoseconds each before a waiting thread gives its core away: long enough for the substep of a
// neighbour that runs, short enough not to hold up one that does not, because something else has its core.
constexpr int kSpins = 300;

// Share of a run that its threads may spend waiting; where they wait for more, how many times in a row that may be
// chance, and how many runs are then done alone.
constexpr double kMostWaiting = 0.75;
constexpr int kRunsByChance = 2, kLeastRunsAlone = 50, kMostRunsAlone = 1000;

// One turn of a waiting loop: burn a moment while the wait is short, give the core away when it is not.
void wait_a_moment(int turn)
{
    if (turn < kSpins) {
#if defined(__x86_64__)
        __builtin_ia32_pause();
#endif
    } else {
        std::this_thread::yield();
    }
}

}  // namespace

struct ThreadPool::Crew
{
    std::vector<std::thread> threads;
    const std::function<void(int)>* body = nullptr;
    std::atomic<int> round{0};
    std::atomic<int> working{0};
    std::atomic<bool> stop{false};
    std::mutex mutex;
    std::exception_ptr error;  // the first of a round

    ~Crew()
    {
        stop = true;
        next_round();
        for (std::thread& thread : threads) thread.join();
    }
    void run_body(int thread)
    {
        try {
            (*body)(thread);
        } catch (...) {
            const std::lock_guard lock(mutex);
            if (!error) error = std::current_exception();
        }
    }
    void work(int thread)
    {
        for (int seen = 0;;) {
            for (int turn = 0; turn < kSpins && round.load(std::memory_order_acquire) == seen; ++turn)
                wait_a_moment(turn);
            round.wait(seen, std::memory_order_acquire);
            seen = round.load(std::memory_order_acquire);
            if (stop) return;
            run_body(thread);
            working.fetch_sub(1, std::memory_order_release);
        }
    }
    void next_round()
    {
        round.fetch_add(1, std::memory_order_release);
        round.notify_all();
    }
};

ThreadPool::ThreadPool(int thread_count) : crew_(std::make_unique<Crew>())
{
    if (thread_count <= 0) thread_count = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    for (int thread = 1; thread < thread_count; ++thread)
        crew_->threads.emplace_back([crew = crew_.get(), thread] { crew->work(thread); });
}

ThreadPool::~ThreadPool() = default;

int ThreadPool::thread_count() const { return static_cast<int>(crew_->threads.size()) + 1; }

void ThreadPool::run(const std::function<void(int)>& body)
{
    if (crew_->threads.empty()) return body(0);
    crew_->body = &body;
    crew_->working.store(static_cast<int>(crew_->threads.size()), std::memory_order_relaxed);
    crew_->next_round();
    crew_->run_body(0);
    for (int turn = 0; crew_->working.load(std::memory_order_acquire) > 0; ++turn) wait_a_moment(turn);
    if (const std::exception_ptr error = std::exchange(crew_->error, nullptr)) std::rethrow_exception(error);
}

bool ThreadPool::take_next_alone()
{
    if (runs_alone_ == 0) return false;
    --runs_alone_;
    return true;
}

void ThreadPool::note_run(double waiting_s, double run_s)
{
    runs_still_ = waiting_s > kMostWaiting * run_s ? runs_still_ + 1 : 0;
    const bool crowded = runs_still_ > 0 && (next_runs_alone_ > 0 || runs_still_ > kRunsByChance);
    next_runs_alone_ = crowded ? std::clamp(2 * next_runs_alone_, kLeastRunsAlone, kMostRunsAlone) : 0;
    runs_alone_ = next_runs_alone_;
}

void SpinBarrier::arrive_and_wait()
{
    const int phase = phase_.load(std::memory_order_relaxed);
    if (arrived_.fetch_add(1, std::memory_order_acq_rel) + 1 == thread_count_) {
        arrived_.store(0, std::memory_order_relaxed);
        phase_.store(phase + 1, std::memory_order_release);
        return;
    }
    const auto is_over = [&] { return phase_.load(std::memory_order_acquire) != phase; };
    for (int turn = 0; turn < kSpins; ++turn) {
        if (is_over()) return;
        wait_a_moment(turn);
    }
    const Stopwatch watch;
    while (!is_over()) wait_a_moment(kSpins);
    waiting_ns_.fetch_add(std::lround(1e6 * watch.elapsed_ms()), std::memory_order_relaxed);
}

Range part_of(int count, int grain, int thread, int thread_count)
{
    const long grains = (count + grain - 1) / grain;
    const auto edge = [&](int t) { return std::min(count, static_cast<int>(grains * t / thread_count) * grain); };
    return {edge(thread), edge(thread + 1)};
}

}  // namespace nuno
