// Cloth at the extremes.
#include "solver/extremes.h"

#include <algorithm>

namespace nuno {

std::vector<Extreme> stable_on(Backend backend)
{
    std::vector<Extreme> all{{backend, {Method::automatic}}};
    for (const MethodAndSweep& each : methods_and_sweeps()) {
        const bool any_substep = !is_explicit(each.method) && each.method != Method::reference;
        const bool here =
            method_info(each.method).on(backend) && !(backend == Backend::gpu && each.sweep == Sweep::rows);
        if (any_substep && here) all.push_back({backend, each});
    }
    return all;
}

ExtremesTest::ExtremesTest()
{
    params_.backend = GetParam().backend;
    params_.method = GetParam().method.method;
    params_.sweep = GetParam().method.sweep;
    params_.substeps = params_.method == Method::automatic ? 0 : 2;
    if (params_.backend == Backend::gpu) context_ = make_headless_context();
}

ExtremesTest::~ExtremesTest()
{
    if (!context_) return;
    for (const std::string& error : take_gl_errors()) ADD_FAILURE() << error;
}

ExtremesTest::Run ExtremesTest::start(const ClothModel& model, const ClothState& state)
{
    Run run{resolve_params(model, {}, params_), std::make_unique<ThreadPool>(1), nullptr};
    run.solver = make_solver(model, kNoBodies, run.params, *run.pool);
    run.solver->upload(state);
    return run;
}

ClothState ExtremesTest::finish(Run& run, const ClothModel& model, int frames, const char* what)
{
    for (int frame = 0; frame < frames; ++frame) {
        run.solver->step({run.params, frame / double(run.params.frame_rate), run.params.substeps});
        if (run.solver->first_lost()) {
            ADD_FAILURE() << what << ": not finite in frame " << frame;
            break;
        }
    }
    return state_of(*run.solver, model);
}

void ExtremesTest::expect_no_energy_is_made(const ClothModel& model, const ClothState& state, int frames,
                                            const char* what)
{
    Run run = start(model, state);
    const Diagnostics before = measure(model, state, run.params);
    const Diagnostics after = measure(model, finish(run, model, frames, what), run.params);
    expect_less_energy(run.params, before, after, frames, what);
}

void ExtremesTest::expect_less_energy(const SimParams& params, const Diagnostics& before, const Diagnostics& after,
                                      int frames, const char* what)
{
    const double held = before.kinetic_j + before.elastic_j + before.gravity_j - after.gravity_j;
    const double swing = is_explicit(params.method) ? 1.1 : 1.02;
    const double rounding = 3e-7 / double(substep_s(params)), mass = 0.2;
    const double slack = 2e-3 + 0.5 * mass * rounding * rounding * frames * params.substeps;
    EXPECT_LE(after.kinetic_j, swing * std::max(held, 0.0) + slack) << what << ", strain " << after.max_strain;
}

}  // namespace nuno
