// The classic Runge-Kutta method in a compute shader.
#include "solver/explicit/gpu_rk4.h"

#include "gl/barriers.h"
#include "shaders/shared/bindings.h"
#include "solver/base/gpu_program.h"

namespace nuno {
namespace {

constexpr int kStages = 4;

}  // namespace

GpuRk4::GpuRk4(const ClothModel& model, const Bodies& bodies, const SimParams& params)
    : GpuSolver(model),
      forces_(model),
      bodies_(bodies, model),
      stage_positions_{VertexBuffer(vertex_count_), VertexBuffer(vertex_count_)},
      stage_velocities_{VertexBuffer(vertex_count_), VertexBuffer(vertex_count_)},
      velocity_sums_(vertex_count_ * sizeof(glm::vec4), nullptr, GL_DYNAMIC_COPY),
      acceleration_sums_(vertex_count_ * sizeof(glm::vec4), nullptr, GL_DYNAMIC_COPY)
{
    forces_.refresh(params);
    compile();
}

void GpuRk4::compile()
{
    const auto variant = [&](const char* first, const char* last) {
        Program program =
            gpu_program("sim/rk4.comp", {forces_.defines(), bodies_.defines(), {{"FIRST", first}, {"LAST", last}}});
        program.set(LOCATION_VERTEX_COUNT, static_cast<std::int32_t>(vertex_count_));
        return program;
    };
    first_ = variant("1", "0");
    middle_ = variant("0", "0");
    last_ = variant("0", "1");
}

void GpuRk4::step(const StepInput& input)
{
    if (forces_.refresh(input.params)) compile();
    bind_params(input.params);
    forces_.bind();
    bodies_.plan(input);
    velocity_sums_.bind_block(GL_SHADER_STORAGE_BUFFER, BLOCK_POSITION_SUMS);
    acceleration_sums_.bind_block(GL_SHADER_STORAGE_BUFFER, BLOCK_VELOCITY_SUMS);
    barrier_draw_to_compute();
    for (int k = 0; k < input.substep_count; ++k) {
        for (int number = 0; number < kStages; ++number) stage(input, k, number);
        if (bodies_.moves_pins()) {
            bodies_.place_pins(k);
            barrier_compute_to_compute();
        }
        current_ = 1 - current_;
    }
}

void GpuRk4::stage(const StepInput& input, int substep, int number)
{
    const auto read = static_cast<std::size_t>(number % 2), write = 1 - read;
    const bool first = number == 0, last = number + 1 == kStages;
    const VertexBuffer& x = first ? positions_[current_] : stage_positions_[read];
    const VertexBuffer& v = first ? velocities_[current_] : stage_velocities_[read];
    const VertexBuffer& next_x = last ? positions_[1 - current_] : stage_positions_[write];
    const VertexBuffer& next_v = last ? velocities_[1 - current_] : stage_velocities_[write];
    x.texture.bind(UNIT_POSITIONS);
    v.texture.bind(UNIT_VELOCITIES);
    positions_[current_].texture.bind(UNIT_START_POSITIONS);
    velocities_[current_].texture.bind(UNIT_START_VELOCITIES);
    next_x.buffer.bind_block(GL_SHADER_STORAGE_BUFFER, BLOCK_POSITIONS);
    next_v.buffer.bind_block(GL_SHADER_STORAGE_BUFFER, BLOCK_VELOCITIES);

    const float h = substep_s(input.params);
    const int halves = (number + 1) / 2;  // of the substep: 0, 1, 1, 2
    const double part = 0.5 * halves;
    const double time_s = input.start_time_s + (substep + part) * double(h);
    forces_.run_face_pass(time_s);
    const Program& program = first ? first_ : last ? last_ : middle_;
    program.set(LOCATION_SUBSTEP, h);
    program.set(LOCATION_WIND, wind_pressure(input.params, time_s));
    program.set(LOCATION_STAGE_STEP, number < 2 ? 0.5f * h : h);
    program.set(LOCATION_STAGE_WEIGHT, first || last ? 1.0f : 2.0f);
    if (last) bodies_.set_substep(program, substep);
    program.use();
    dispatch();
    barrier_compute_to_compute();
}

}  // namespace nuno
