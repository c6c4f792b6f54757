// Every method of time integration, and where it runs.
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "core/thread_pool.h"
#include "solver/cloth_solver.h"

namespace nuno {

struct MethodInfo
{
    Method method;
    std::string_view name;
    int order;  // of the error in the substep
    bool on_cpu, on_gpu;
};

std::span<const MethodInfo> method_table();

// A solver for params.method on params.backend. On gpu a context must be current, and stay so for the solver's life.
// `model`, `colliders` and `pool` must outlive it. Error where the backend lacks the method; it lists those that are
// there.
std::unique_ptr<ClothSolver> make_solver(const ClothModel& model, const Colliders& colliders, const SimParams& params,
                                         ThreadPool& pool);

}  // namespace nuno
