// Explicit and symplectic Euler in a compute shader.
#include "solver/explicit/gpu_euler.h"

#include <algorithm>
#include <string>
#include <vector>

#include "gl/barriers.h"
#include "shaders/shared/bindings.h"
#include "solver/base/gpu_program.h"

namespace nuno {
namespace {

// A work group has room for so many invocations on every device. For a cloth of that size or less, a dispatch by itself
// costs as much as a substep or more: measured on software, 17 x 17 vertices take 7 us a substep in one group and 12 to
// 75 in a dispatch each, 32 x 32 take 22 and 28 or more.
constexpr std::uint32_t kSmallVertices = 1024;
constexpr std::uint32_t kSmallGrain = 32;  // invocations of a group are a multiple
constexpr int kMostSubsteps = 256;         // of a dispatch, which a display waits for

std::size_t shown_count(std::uint32_t vertex_count) { return vertex_count <= kSmallVertices ? 2 * vertex_count : 0; }

}  // namespace

GpuEuler::GpuEuler(const ClothModel& model, const Bodies& bodies, const SimParams& params)
    : GpuSolver(model),
      method_(params.method),
      forces_(model),
      bodies_(bodies, model),
      winds_(GL_R32F),
      shown_positions_(shown_count(vertex_count_)),
      shown_velocities_(shown_count(vertex_count_))
{
    forces_.refresh(params);
    compile();
}

std::string_view GpuEuler::name() const
{
    return method_ == Method::explicit_euler ? "explicit_euler on gpu" : "symplectic_euler on gpu";
}

bool GpuEuler::is_small() const
{
    return vertex_count_ <= kSmallVertices && !forces_.on_faces() && !bodies_.moves_pins();
}

void GpuEuler::compile()
{
    const char* const formula = method_ == Method::explicit_euler ? "explicit_euler" : "symplectic_euler";
    const std::uint32_t group = (vertex_count_ + kSmallGrain - 1) / kSmallGrain * kSmallGrain;
    const std::vector<Define> own{{"EULER", formula}, {"SMALL_GROUP", std::to_string(group)}};
    euler_ = gpu_program(is_small() ? "sim/euler_small.comp" : "sim/euler.comp",
                         {forces_.defines(), bodies_.defines(), own});
}

void GpuEuler::step(const StepInput& input)
{
    if (forces_.refresh(input.params)) compile();
    bind_params(input.params);
    forces_.bind();
    bodies_.plan(input);
    euler_.set(LOCATION_SUBSTEP, substep_s(input.params));
    euler_.set(LOCATION_VERTEX_COUNT, static_cast<std::int32_t>(vertex_count_));
    barrier_draw_to_compute();
    if (is_small()) return run_small(input);
    for (int k = 0; k < input.substep_count; ++k) run_substep(input, k);
}

void GpuEuler::run_small(const StepInput& input)
{
    shown_positions_.texture.bind_image(IMAGE_SHOWN_POSITIONS);
    shown_velocities_.texture.bind_image(IMAGE_SHOWN_VELOCITIES);
    shown_positions_.buffer.bind_block(GL_SHADER_STORAGE_BUFFER, BLOCK_SHOWN_POSITIONS);
    shown_velocities_.buffer.bind_block(GL_SHADER_STORAGE_BUFFER, BLOCK_SHOWN_VELOCITIES);
    euler_.use();
    euler_.set(LOCATION_BODIES_A_SUBSTEP, bodies_.bodies_a_substep());
    const double h = double(substep_s(input.params));
    std::vector<float> winds;
    for (int first = 0; first < input.substep_count; first += kMostSubsteps) {
        const int count = std::min(kMostSubsteps, input.substep_count - first);
        winds.clear();
        for (int k = first; k < first + count; ++k)
            winds.push_back(wind_pressure(input.params, input.start_time_s + k * h));
        winds_.upload(winds);
        winds_.bind(UNIT_WINDS);
        euler_.set(LOCATION_SUBSTEP_COUNT, count);
        bodies_.set_substep(euler_, first);
        bind_state(current_, 1 - current_);
        glDispatchCompute(1, 1, 1);
        barrier_compute_to_compute();
        current_ = 1 - current_;
    }
}

void GpuEuler::run_substep(const StepInput& input, int k)
{
    const double time_s = input.start_time_s + k * double(substep_s(input.params));
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

}  // namespace nuno
