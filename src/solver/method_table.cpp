// Every method of time integration, and where it runs.
#include "solver/method_table.h"

#include <fmt/format.h>

#include <vector>

#include "core/error.h"
#include "core/text.h"
#include "model/formulas.h"
#include "solver/cpu_euler.h"
#include "solver/cpu_implicit.h"
#include "solver/cpu_jacobi.h"
#include "solver/cpu_reference.h"
#include "solver/cpu_rk4.h"
#include "solver/cpu_vbd.h"
#include "solver/cpu_verlet.h"
#include "solver/cpu_xpbd.h"
#include "solver/gpu_euler.h"
#include "solver/gpu_rk4.h"
#include "solver/gpu_vbd.h"
#include "solver/gpu_verlet.h"
#include "solver/gpu_xpbd.h"

namespace nuno {
namespace {

template <class Solver>
std::unique_ptr<ClothSolver> cpu(const SolverInput& in)
{
    return std::make_unique<Solver>(in.model, in.bodies, in.params, in.pool);
}

template <class Solver>
std::unique_ptr<ClothSolver> gpu(const SolverInput& in)
{
    return std::make_unique<Solver>(in.model, in.bodies, in.params);
}

std::unique_ptr<ClothSolver> cpu_xpbd(const SolverInput& in)
{
    return in.params.sweep == Sweep::jacobi ? cpu<CpuJacobi>(in) : cpu<CpuXpbd>(in);
}

// Method, name, order, on the CPU, on the GPU, continuum, tethers.
constexpr MethodInfo kMethods[] = {
    {Method::explicit_euler, "explicit_euler", 1, cpu<CpuEuler>, gpu<GpuEuler>, true, false},
    {Method::symplectic_euler, "symplectic_euler", 1, cpu<CpuEuler>, gpu<GpuEuler>, true, false},
    {Method::verlet, "verlet", 2, cpu<CpuVerlet>, gpu<GpuVerlet>, true, false},
    {Method::rk4, "rk4", 4, cpu<CpuRk4>, gpu<GpuRk4>, true, false},
    {Method::xpbd, "xpbd", 2, cpu_xpbd, gpu<GpuXpbd>, false, true},
    {Method::vbd, "vbd", 1, cpu<CpuVbd>, gpu<GpuVbd>, false, true},
    {Method::implicit_euler, "implicit_euler", 1, cpu<CpuImplicit>, nullptr, false, false},
    {Method::sdirk2, "sdirk2", 2, cpu<CpuImplicit>, nullptr, false, false},
    {Method::reference, "reference", 5, cpu<CpuReference>, nullptr, true, false},
};

// The names of the methods for which `fits` holds, as a choice.
template <class Fits>
std::string choices(Fits fits)
{
    std::vector<std::string_view> names;
    for (const MethodInfo& info : kMethods)
        if (fits(info)) names.push_back(info.name);
    return join_choices(names);
}

void check(const MethodInfo* info, const SimParams& params)
{
    const std::string_view method = choice_names(Method{})[std::size_t(params.method)];
    const auto here = [&](const MethodInfo& m) { return m.on(params.backend); };
    if (!info || !here(*info))
        throw Error(fmt::format("method: {} does not run on {}; choose {}", method,
                                choice_names(Backend{})[std::size_t(params.backend)], choices(here)));
    if (params.internal_model == InternalModel::continuum && !info->takes_continuum)
        throw Error(
            fmt::format("internal_model: {} has no continuum; choose internal_model fabric_springs or springs, "
                        "or method {}",
                        method, choices([&](const MethodInfo& m) { return here(m) && m.takes_continuum; })));
    const bool tethered = params.tethers != Tethers::none && params.tethers != Tethers::automatic;
    if ((tethered || params.strain_limit > 0) && !info->takes_tethers)
        throw Error(fmt::format("{}: {} has none; choose {}, or method {}", tethered ? "tethers" : "strain_limit",
                                method, tethered ? "none" : "0",
                                choices([&](const MethodInfo& m) { return here(m) && m.takes_tethers; })));
}

const MethodInfo* find(Method method)
{
    for (const MethodInfo& info : kMethods)
        if (info.method == method) return &info;
    return nullptr;
}

}  // namespace

std::span<const MethodInfo> method_table() { return kMethods; }

const MethodInfo& method_info(Method method) { return *find(method); }

std::unique_ptr<ClothSolver> make_solver(const ClothModel& model, const Bodies& bodies, const SimParams& params,
                                         ThreadPool& pool)
{
    const MethodInfo* info = find(params.method);
    check(info, params);
    const MethodInfo::Make make = params.backend == Backend::cpu ? info->make_cpu : info->make_gpu;
    return make({model, bodies, params, pool});
}

float wind_pressure(const SimParams& params, double time_s)
{
    if (params.wind_model == WindModel::aero) return 0;
    return static_cast<float>(double(params.wind_mean) +
                              formulas_f64::sines_wind(double(params.wind_strength), time_s));
}

}  // namespace nuno
