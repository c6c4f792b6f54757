// What the tests of explicit methods share: a run on the CPU, and the smallest cloth there is.
#pragma once

#include "model/oscillator.h"
#include "solver/method_table.h"
#include "support/sheets.h"

namespace nuno {

inline SimParams on_cpu(Method method)
{
    SimParams params;
    params.backend = Backend::cpu;
    params.method = method;
    params.tethers = Tethers::none;
    params.frame_rate = 1;
    params.substeps = 1;
    return params;
}

inline ClothState run(const ClothModel& model, const SimParams& params, ClothState state, int substeps)
{
    const Bodies no_bodies;
    ThreadPool pool(1);
    const auto solver = make_solver(model, no_bodies, params, pool);
    solver->upload(state);
    solver->step({params, 0, substeps});
    solver->download_positions(state.positions);
    solver->download_velocities(state.velocities);
    return state;
}

inline std::vector<Method> explicit_methods()
{
    std::vector<Method> methods;
    for (const MethodInfo& info : method_table())
        if (is_explicit(info.method)) methods.push_back(info.method);
    return methods;
}

inline int order_of(Method method) { return method_info(method).order; }

// A triangle whose upper corners are pinned; its lower one swings in y on two springs.
inline ClothModel pendulum_triangle(float half_width, float depth)
{
    SheetSource source;
    source.mesh.positions = {{-half_width, 0, 0}, {half_width, 0, 0}, {0, -depth, 0}};
    source.mesh.uvs.resize(3);
    source.mesh.faces = {{0, 2, 1}};
    source.pins = {0, 1};
    return build_cloth_model(std::span(&source, 1), MassLumping::equal);
}

}  // namespace nuno
