// What the tests of solvers share: parameters on the CPU, a run from one state to another, and the lists of methods
// that tests go through, so that a new method is tested without being named.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "model/oscillator.h"
#include "solver/method_table.h"
#include "support/measures.h"
#include "support/sheets.h"

namespace nuno {

inline const Bodies kNoBodies;

// A frame of a second in one substep, without tethers; the sweep is xpbd's.
inline SimParams on_cpu(Method method, Sweep sweep = Sweep::automatic)
{
    SimParams params;
    params.backend = Backend::cpu;
    params.method = method;
    params.sweep = sweep;
    params.tethers = Tethers::none;
    params.frame_rate = 1;
    params.substeps = 1;
    return params;
}

inline ClothState state_of(ClothSolver& solver, const ClothModel& model)
{
    ClothState state{std::vector<glm::vec4>(model.vertex_count()), std::vector<glm::vec4>(model.vertex_count())};
    solver.download_positions(state.positions);
    solver.download_velocities(state.velocities);
    return state;
}

// `substeps` of a solver made for it, from `state` at time 0.
inline ClothState run(const ClothModel& model, const SimParams& params, const ClothState& state, int substeps,
                      int threads = 1)
{
    ThreadPool pool(threads);
    const auto solver = make_solver(model, kNoBodies, params, pool);
    solver->upload(state);
    solver->step({params, 0, substeps});
    return state_of(*solver, model);
}

template <class Fits>
std::vector<Method> methods_that(Fits fits)
{
    std::vector<Method> methods;
    for (const MethodInfo& info : method_table())
        if (info.on(Backend::cpu) && fits(info)) methods.push_back(info.method);
    return methods;
}

inline std::vector<Method> explicit_methods()
{
    return methods_that([](const MethodInfo& info) { return is_explicit(info.method); });
}

// A method, and of xpbd the order of its constraints.
struct MethodAndSweep
{
    Method method;
    Sweep sweep = Sweep::automatic;
};

// All on the CPU, xpbd in each of its orders.
inline std::vector<MethodAndSweep> methods_and_sweeps()
{
    std::vector<MethodAndSweep> all;
    for (const Method method : methods_that([](const MethodInfo&) { return true; })) {
        if (method != Method::xpbd) all.push_back({method});
        if (method == Method::xpbd)
            for (const Sweep sweep : {Sweep::rows, Sweep::coloured, Sweep::jacobi}) all.push_back({method, sweep});
    }
    return all;
}

inline std::string name_of(Method method) { return std::string(choice_names(method)[std::size_t(method)]); }

inline std::string name_of(const MethodAndSweep& each)
{
    if (each.sweep == Sweep::automatic) return name_of(each.method);
    return name_of(each.method) + "_" + std::string(choice_names(each.sweep)[std::size_t(each.sweep)]);
}

inline std::string name_of(Sweep sweep) { return std::string(choice_names(sweep)[std::size_t(sweep)]); }

// What GoogleTest prints of a parameter.
inline void PrintTo(Method method, std::ostream* out) { *out << name_of(method); }
inline void PrintTo(Sweep sweep, std::ostream* out) { *out << name_of(sweep); }
inline void PrintTo(const MethodAndSweep& each, std::ostream* out) { *out << name_of(each); }

// The name of an instance of a test.
inline constexpr auto kMethodName = [](const auto& test) { return name_of(test.param); };

inline int order_of(Method method) { return method_info(method).order; }

// A vertex held at the origin and, at x = 1, one of 1 m2 on a spring of 1 m. No faces.
inline ClothModel one_spring()
{
    ClothModel model;
    model.rest_positions = model.start_positions = {{0, 0, 0}, {1, 0, 0}};
    model.areas = {1, 1};
    model.uvs.resize(2);
    model.pinned = {1, 0};
    model.springs = {{0, 1, 1, SpringKind::edge}};
    model.spring_table = make_spring_table(model.springs, 2);
    model.sheets.push_back({"pair", 0, 2, 0, 0, 0, 0, {}});
    return model;
}

}  // namespace nuno
