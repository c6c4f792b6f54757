// Sharing of tasks among threads.
#include "collision/task_loop.h"

#include <atomic>

namespace nuno {

void run_tasks(ThreadPool& pool, int task_count, const std::function<void(int task)>& body)
{
    if (task_count <= 1 || pool.thread_count() == 1) {
        for (int task = 0; task < task_count; ++task) body(task);
        return;
    }
    std::atomic<int> next{0};
    pool.run([&](int) {
        for (int task; (task = next.fetch_add(1, std::memory_order_relaxed)) < task_count;) body(task);
    });
}

}  // namespace nuno
