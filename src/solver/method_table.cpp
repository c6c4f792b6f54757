// Every method of time integration, and where it runs.
#include "solver/method_table.h"

#include <fmt/format.h>

#include <vector>

#include "core/error.h"
#include "core/text.h"
#include "model/formulas.h"
#include "solver/cpu_euler.h"
#include "solver/gpu_euler.h"

namespace nuno {
namespace {

constexpr MethodInfo kMethods[] = {
    {Method::explicit_euler, "explicit_euler", 1, true, true},
    {Method::symplectic_euler, "symplectic_euler", 1, true, true},
};

}  // namespace

std::span<const MethodInfo> method_table() { return kMethods; }

std::unique_ptr<ClothSolver> make_solver(const ClothModel& model, const Colliders& colliders, const SimParams& params,
                                         ThreadPool& pool)
{
    const bool gpu = params.backend == Backend::gpu;
    std::vector<std::string_view> available;
    for (const MethodInfo& info : kMethods) {
        const bool here = gpu ? info.on_gpu : info.on_cpu;
        if (here) available.push_back(info.name);
        if (!here || info.method != params.method) continue;
        if (gpu) return std::make_unique<GpuEuler>(model, colliders, params.method);
        return std::make_unique<CpuEuler>(model, colliders, params.method, pool);
    }
    throw Error(fmt::format("method: {} does not run on {}; choose {}",
                            choice_names(Method{})[std::size_t(params.method)],
                            choice_names(Backend{})[std::size_t(params.backend)], join_choices(available)));
}

float wind_pressure(const SimParams& params, double time_s)
{
    return static_cast<float>(double(params.wind_mean) +
                              formulas_f64::sines_wind(double(params.wind_strength), time_s));
}

}  // namespace nuno
