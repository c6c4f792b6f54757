// Every method of time integration, and where it runs.
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "core/thread_pool.h"
#include "solver/base/cloth_solver.h"

namespace nuno {

// What a solver is made of; all of it must outlive the solver.
struct SolverInput
{
    const ClothModel& model;
    const Bodies& bodies;
    const SimParams& params;  // resolved (solver/method_choice.h)
    ThreadPool& pool;
};

struct MethodInfo
{
    using Make = std::unique_ptr<ClothSolver> (*)(const SolverInput&);

    Method method;
    std::string_view name;
    int order;                // of the error in the substep
    Make make_cpu, make_gpu;  // null where the backend lacks the method
    bool takes_continuum;     // internal_model = continuum
    bool takes_tethers;       // tethers and strain_limit
    bool takes_dampers;       // stiffness_damping

    bool on(Backend backend) const { return (backend == Backend::cpu ? make_cpu : make_gpu) != nullptr; }
};

std::span<const MethodInfo> method_table();
const MethodInfo& method_info(Method method);  // of a method of the table

// A solver for params.method on params.backend. On gpu a context must be current, and stay so for the solver's life.
// Error where the backend lacks the method, or the method the internal model, tethers or strain limit that are asked
// for; it lists those that are there.
std::unique_ptr<ClothSolver> make_solver(const ClothModel& model, const Bodies& bodies, const SimParams& params,
                                         ThreadPool& pool);

}  // namespace nuno
