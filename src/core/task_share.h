// Shares numbered tasks out among the threads of a pool, each of which has things of its own to work with.
#pragma once

#include <functional>

#include "core/thread_pool.h"

namespace nuno {

// Calls body(task, thread) once for every task = 0 .. task_count - 1, on whichever thread is free; a single task runs
// on the caller. The result does not depend on the number of threads where a task writes only what is its own.
void share_tasks(ThreadPool& pool, int task_count, const std::function<void(int task, int thread)>& body);

}  // namespace nuno
