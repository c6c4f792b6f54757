// Explicit and symplectic Euler in a compute shader.
#include "solver/explicit/gpu_euler.h"

#include "gl/barriers.h"
#include "shaders/shared/bindings.h"
#include "solver/base/gpu_program.h"

namespace nuno {

GpuEuler::GpuEuler(const ClothModel& model, const Bodies& bodies, const SimParams& params)
    : GpuSolver(model), method_(params.method), forces_(model), bodies_(bodies, model)
{
    forces_.refresh(params);
    compile();
}

std::string_view GpuEuler::name() const
{
    return method_ == Method::explicit_euler ? "explicit_euler on gpu" : "symplectic_euler on gpu";
}

void GpuEuler::compile()
{
    const char* const formula = method_ == Method::explicit_euler ? "explicit_euler" : "symplectic_euler";
    euler_ = gpu_program("sim/euler.comp", {forces_.defines(), bodies_.defines(), {{"EULER", formula}}});
}

void GpuEuler::step(const StepInput& input)
{
    if (forces_.refresh(input.params)) compile();
    bind_params(input.params);
    forces_.bind();
    bodies_.plan(input);
    const float h = substep_s(input.params);
    euler_.set(LOCATION_SUBSTEP, h);
    euler_.set(LOCATION_VERTEX_COUNT, static_cast<std::int32_t>(vertex_count_));
    barrier_draw_to_compute();
    for (int k = 0; k < input.substep_count; ++k) {
        const double time_s = input.start_time_s + k * double(h);
        euler_.set(LOCATION_WIND, wind_pressure(input.params, time_s));
        bodies_.set_substep(euler_, k);
        bind_state(current_, 1 - current_);
        forces_.run_face_pass(time_s);
        euler_.use();
        dispatch();
        barrier_compute_to_compute();
        if (bodies_.moves_pins()) {
            bodies_.place_pins(k);
            barrier_compute_to_compute();
        }
        current_ = 1 - current_;
    }
}

}  // namespace nuno
