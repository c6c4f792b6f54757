// Sharing of tasks among threads.
#include "core/task_share.h"

#include <atomic>

namespace nuno {

void share_tasks(ThreadPool& pool, int task_count, const std::function<void(int task, int thread)>& body)
{
    if (task_count <= 1 || pool.thread_count() == 1) {
        for (int task = 0; task < task_count; ++task) body(task, 0);
        return;
    }
    std::atomic<int> next{0};
    pool.run([&](int thread) {
        for (int task; (task = next.fetch_add(1, std::memory_order_relaxed)) < task_count;) body(task, thread);
    });
}

}  // namespace nuno
