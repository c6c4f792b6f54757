// A fixed pool of threads that run one body together, and a barrier for them to step in time.
#pragma once

#include <atomic>
#include <functional>
#include <memory>

namespace nuno {

class ThreadPool
{
  public:
    // `thread_count` counts the calling thread; 0 means one for each core.
    explicit ThreadPool(int thread_count);
    ~ThreadPool();
    ThreadPool(const ThreadPool&) = delete;
    ThreadPool& operator=(const ThreadPool&) = delete;

    int thread_count() const;

    // Calls body(thread) once on every thread, thread = 0 (the caller) .. thread_count - 1, and returns when all are
    // done. The first exception of a body is thrown again here, once all have ended; a body that holds others at a
    // barrier must not throw. The body must not call run.
    void run(const std::function<void(int thread)>& body);

    // For runs that wait for one another at a barrier, of which one thread alone makes the same. While another program
    // holds a core they stand still for most of their time: after some runs whose waiting_s says so, the next ones are
    // better done alone, more of them each time it is found again.
    bool take_next_alone();  // counts: to call once before every such run
    void note_run(double waiting_s, double run_s);

  private:
    struct Crew;
    std::unique_ptr<Crew> crew_;
    int runs_still_ = 0, runs_alone_ = 0, next_runs_alone_ = 0;
};

// Holds `thread_count` threads until all have arrived. Spins first, since substeps are microseconds apart, then yields.
class SpinBarrier
{
  public:
    explicit SpinBarrier(int thread_count) : thread_count_(thread_count) {}
    void arrive_and_wait();
    // Time [s] that threads have spent here after they began to yield, all of them together.
    double waiting_s() const { return 1e-9 * double(waiting_ns_.load(std::memory_order_relaxed)); }

  private:
    const int thread_count_;
    std::atomic<int> arrived_{0};
    std::atomic<int> phase_{0};
    std::atomic<long> waiting_ns_{0};
};

// The part of 0 .. count that `thread` of `thread_count` works on, in units of `grain`.
struct Range
{
    int begin, end;
};
Range part_of(int count, int grain, int thread, int thread_count);

}  // namespace nuno
