// Every method of time integration, and where it runs.
#include "solver/method_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <vector>

#include "core/error.h"
#include "core/text.h"
#include "model/formulas.h"
#include "solver/explicit/cpu_euler.h"
#include "solver/explicit/cpu_reference.h"
#include "solver/explicit/cpu_rk4.h"
#include "solver/explicit/cpu_verlet.h"
#include "solver/explicit/gpu_euler.h"
#include "solver/explicit/gpu_rk4.h"
#include "solver/explicit/gpu_verlet.h"
#include "solver/implicit/cpu_implicit.h"
#include "solver/vbd/cpu_vbd.h"
#include "solver/vbd/gpu_vbd.h"
#include "solver/xpbd/cpu_jacobi.h"
#include "solver/xpbd/cpu_xpbd.h"
#include "solver/xpbd/gpu_xpbd.h"

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

// Method, name, order, on the CPU, on the GPU, continuum, tethers, dampers.
constexpr MethodInfo kMethods[] = {
    {Method::explicit_euler, "explicit_euler", 1, cpu<CpuEuler>, gpu<GpuEuler>, true, false, true},
    {Method::symplectic_euler, "symplectic_euler", 1, cpu<CpuEuler>, gpu<GpuEuler>, true, false, true},
    {Method::verlet, "verlet", 2, cpu<CpuVerlet>, gpu<GpuVerlet>, true, false, true},
    {Method::rk4, "rk4", 4, cpu<CpuRk4>, gpu<GpuRk4>, true, false, true},
    {Method::xpbd, "xpbd", 2, cpu_xpbd, gpu<GpuXpbd>, false, true, false},
    {Method::vbd, "vbd", 1, cpu<CpuVbd>, gpu<GpuVbd>, false, true, true},
    {Method::implicit_euler, "implicit_euler", 1, cpu<CpuImplicit>, nullptr, false, false, true},
    {Method::sdirk2, "sdirk2", 2, cpu<CpuImplicit>, nullptr, false, false, true},
    {Method::reference, "reference", 5, cpu<CpuReference>, nullptr, true, false, true},
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
    const auto name = [](Backend backend) { return choice_names(Backend{})[std::size_t(backend)]; };
    const Backend other = params.backend == Backend::cpu ? Backend::gpu : Backend::cpu;
    if (!info || !here(*info))
        throw Error(fmt::format("method: {} does not run on {}; choose {}, or backend {}", method, name(params.backend),
                                choices(here), name(other)));
    const bool continuum = params.internal_model == InternalModel::continuum, damped = params.stiffness_damping > 0;
    const bool tethered = params.tethers != Tethers::none && params.tethers != Tethers::automatic;
    const bool bounded = tethered || params.strain_limit > 0;
    // Pins may be what auto has become, with a method that takes them.
    const bool asked = bounded && (!info->takes_tethers || params.tethers != Tethers::pins || params.strain_limit > 0);
    const std::string others = choices([&](const MethodInfo& m) {
        return here(m) && (m.takes_continuum || !continuum) && (m.takes_dampers || !damped) &&
               (m.takes_tethers || !asked);
    });
    const std::string or_method = others.empty() ? "" : ", or method " + others;
    if (continuum && !info->takes_continuum)
        throw Error(
            fmt::format("internal_model: {} has no continuum; choose internal_model fabric_springs or springs{}",
                        method, or_method));
    if (damped && !info->takes_dampers)
        throw Error(fmt::format("stiffness_damping: {} has none; choose 0{}", method, or_method));
    if (bounded && !info->takes_tethers) {
        const auto takes = [&](const MethodInfo& m) { return here(m) && m.takes_tethers; };
        const std::string or_less =
            !others.empty() ? or_method
                            : fmt::format(", or method {} with {}", choices(takes),
                                          continuum ? "internal_model fabric_springs" : "stiffness_damping 0");
        throw Error(fmt::format("{}: {} has none; choose {}{}", tethered ? "tethers" : "strain_limit", method,
                                tethered ? "none" : "0", or_less));
    }
}

// Cloth would be tied to where a body was.
void check_contacts(const Bodies& bodies, const SimParams& params)
{
    const auto moves = [](const auto& shapes) {
        return std::any_of(shapes.begin(), shapes.end(), [](const auto& shape) { return shape.motion.moves(); });
    };
    if (params.tethers == Tethers::contacts && (moves(bodies.planes) || moves(bodies.spheres) ||
                                                moves(bodies.capsules) || moves(bodies.boxes) || moves(bodies.meshes)))
        throw Error(
            "tethers: contacts needs bodies that stand still; choose pins or none, or take their keyframes away, or "
            "restart where a hand moved them");
}

// What only some orders of xpbd's constraints have.
void check_sweep(const SimParams& params)
{
    const bool on_gpu = params.backend == Backend::gpu, xpbd = params.method == Method::xpbd;
    if (xpbd && on_gpu && params.sweep == Sweep::rows)
        throw Error("sweep: rows does not run on gpu; choose auto, coloured or jacobi");
    if (xpbd && params.sweep == Sweep::jacobi && bends(params))
        throw Error("sweep: jacobi has no bending_warp, bending_weft and bending_bias; choose coloured, or 0 for them");
    const bool in_rows = xpbd && !on_gpu && (params.sweep == Sweep::rows || params.sweep == Sweep::automatic);
    if (params.tethers == Tethers::contacts && !in_rows)
        throw Error(
            "tethers: contacts needs method xpbd on backend cpu with sweep rows or auto; choose these, pins or none");
}

const MethodInfo* find(Method method)
{
    for (const MethodInfo& info : kMethods)
        if (info.method == method) return &info;
    return nullptr;
}

}  // namespace

std::span<const MethodInfo> method_table() { return kMethods; }

const MethodInfo& method_info(Method method)
{
    const MethodInfo* info = find(method);
    assert(info);
    return *info;
}

std::unique_ptr<ClothSolver> make_solver(const ClothModel& model, const Bodies& bodies, const SimParams& params,
                                         ThreadPool& pool)
{
    const MethodInfo* info = find(params.method);
    check(info, params);
    check_sweep(params);
    check_contacts(bodies, params);
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
