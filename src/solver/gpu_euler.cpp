// Explicit and symplectic Euler in a compute shader.
#include "solver/gpu_euler.h"

#include <fmt/format.h>

#include <string>

#include "core/error.h"
#include "gl/barriers.h"
#include "shaders/shared/bindings.h"

namespace nuno {
namespace {

std::vector<Define> euler_defines(const SpringTable& table, const Colliders& colliders, Method method)
{
    const auto quads = [&](SpringKind kind) {
        const int k = static_cast<int>(kind);
        return std::to_string((table.first_slot[k + 1] - table.first_slot[k]) / 4);
    };
    return {{"EULER", method == Method::explicit_euler ? "explicit_euler" : "symplectic_euler"},
            {"STRUCTURAL_QUADS", quads(SpringKind::structural)},
            {"SHEAR_QUADS", quads(SpringKind::shear)},
            {"BEND_QUADS", quads(SpringKind::bend)},
            {"PLANE_COUNT", std::to_string(colliders.planes.size())},
            {"SPHERE_COUNT", std::to_string(colliders.spheres.size())}};
}

// The bodies of a scene as the kernel reads them: planes, one more, spheres, one more. Error where this device has no
// room for them.
std::vector<glm::vec4> collider_block(const Colliders& colliders)
{
    std::vector<glm::vec4> block;
    for (const Plane& plane : colliders.planes) block.emplace_back(plane.normal, plane.offset);
    block.emplace_back(0);
    for (const Sphere& sphere : colliders.spheres) block.emplace_back(sphere.centre, sphere.radius);
    block.emplace_back(0);
    GLint most_bytes = 0;
    glGetIntegerv(GL_MAX_UNIFORM_BLOCK_SIZE, &most_bytes);
    const std::size_t most = static_cast<std::size_t>(most_bytes) / sizeof(glm::vec4);
    if (block.size() > most)
        throw Error(
            fmt::format("scene: {} planes and spheres are too many for this device, which takes {}; use fewer, or "
                        "--backend cpu",
                        block.size() - 2, most - 2));
    return block;
}

// Every field is a 4-byte scalar, so std140 lays them out as the struct does.
static_assert(sizeof(SimParams) % 4 == 0 && std::is_trivially_copyable_v<SimParams>);

}  // namespace

VertexBuffer::VertexBuffer(std::uint32_t vertex_count)
    : buffer(vertex_count * sizeof(glm::vec4), nullptr, GL_DYNAMIC_COPY), texture(GL_RGBA32F)
{
    texture.view(buffer.id(), buffer.size_bytes());
}

GpuEuler::GpuEuler(const ClothModel& model, const Colliders& colliders, Method method)
    : method_(method),
      vertex_count_(model.vertex_count()),
      colliders_(make_buffer(collider_block(colliders), GL_STATIC_DRAW)),
      euler_(compute_program("sim/euler.comp", euler_defines(model.spring_table, colliders, method),
                             {{"generated/sim_params", glsl_fields(sim_param_table())}})),
      finite_(compute_program("sim/finite.comp")),
      positions_{VertexBuffer(vertex_count_), VertexBuffer(vertex_count_)},
      velocities_{VertexBuffer(vertex_count_), VertexBuffer(vertex_count_)},
      params_((sizeof(SimParams) + 15) / 16 * 16, nullptr, GL_DYNAMIC_DRAW),
      first_bad_(sizeof(std::uint32_t), nullptr, GL_DYNAMIC_READ),
      neighbour_texture_(GL_RGBA32I),
      rest_length_texture_(GL_RGBA32F)
{
    upload_springs(model.spring_table);
}

std::string_view GpuEuler::name() const
{
    return method_ == Method::explicit_euler ? "explicit_euler on gpu" : "symplectic_euler on gpu";
}

// Four slots a texel: texel (quad, vertex) is at quad * vertex_count + vertex, so that neighbouring invocations read
// neighbouring texels.
void GpuEuler::upload_springs(const SpringTable& table)
{
    const std::size_t n = vertex_count_, slots = static_cast<std::size_t>(table.slot_count());
    std::vector<std::int32_t> neighbours(slots * n);
    std::vector<float> rest_lengths(slots * n);
    for (std::size_t slot = 0; slot < slots; ++slot)
        for (std::size_t v = 0; v < n; ++v) {
            const std::size_t to = ((slot / 4) * n + v) * 4 + slot % 4;
            neighbours[to] = static_cast<std::int32_t>(table.neighbours[slot * n + v]);
            rest_lengths[to] = table.rest_lengths[slot * n + v];
        }
    neighbours_ = make_buffer(neighbours, GL_STATIC_DRAW);
    rest_lengths_ = make_buffer(rest_lengths, GL_STATIC_DRAW);
    neighbour_texture_.view(neighbours_.id(), neighbours_.size_bytes());
    rest_length_texture_.view(rest_lengths_.id(), rest_lengths_.size_bytes());
}

void GpuEuler::upload(const ClothState& state)
{
    barrier_compute_to_upload();
    positions_[current_].buffer.update(0, state.positions);
    velocities_[current_].buffer.update(0, state.velocities);
}

void GpuEuler::upload_velocities(std::span<const glm::vec4> velocities)
{
    barrier_compute_to_upload();
    velocities_[current_].buffer.update(0, std::as_bytes(velocities));
}

void GpuEuler::set_vertex(std::uint32_t vertex, glm::vec4 position)
{
    barrier_compute_to_upload();
    const glm::vec3 at_rest(0);
    positions_[current_].buffer.update(vertex * sizeof position, std::as_bytes(std::span(&position, 1)));
    velocities_[current_].buffer.update(vertex * sizeof position, std::as_bytes(std::span(&at_rest, 1)));
}

void GpuEuler::dispatch() const { glDispatchCompute((vertex_count_ + GROUP_SIZE - 1) / GROUP_SIZE, 1, 1); }

void GpuEuler::step(const StepInput& input)
{
    params_.update(0, std::as_bytes(std::span(&input.params, 1)));
    params_.bind_block(GL_UNIFORM_BUFFER, BLOCK_PARAMS);
    colliders_.bind_block(GL_UNIFORM_BUFFER, BLOCK_COLLIDERS);
    neighbour_texture_.bind(UNIT_NEIGHBOURS);
    rest_length_texture_.bind(UNIT_REST_LENGTHS);
    euler_.use();
    const float h = substep_s(input.params);
    euler_.set(LOCATION_SUBSTEP, h);
    euler_.set(LOCATION_VERTEX_COUNT, static_cast<std::int32_t>(vertex_count_));
    barrier_draw_to_compute();
    for (int k = 0; k < input.substep_count; ++k) {
        const int next = 1 - current_;
        euler_.set(LOCATION_WIND, wind_pressure(input.params, input.start_time_s + k * double(h)));
        positions_[current_].texture.bind(UNIT_POSITIONS);
        velocities_[current_].texture.bind(UNIT_VELOCITIES);
        positions_[next].buffer.bind_block(GL_SHADER_STORAGE_BUFFER, BLOCK_POSITIONS);
        velocities_[next].buffer.bind_block(GL_SHADER_STORAGE_BUFFER, BLOCK_VELOCITIES);
        dispatch();
        barrier_compute_to_compute();
        current_ = next;
    }
}

void GpuEuler::finish() { glFinish(); }

void GpuEuler::download_positions(std::span<glm::vec4> positions)
{
    readback_.begin(positions_[current_].buffer.id(), positions.size_bytes());
    readback_.finish(positions);
}

void GpuEuler::download_velocities(std::span<glm::vec4> velocities)
{
    readback_.begin(velocities_[current_].buffer.id(), velocities.size_bytes());
    readback_.finish(velocities);
}

std::optional<std::uint32_t> GpuEuler::first_not_finite()
{
    const std::uint32_t none = ~0u;
    std::uint32_t first = none;
    barrier_compute_to_upload();
    first_bad_.update(0, std::as_bytes(std::span(&none, 1)));
    finite_.use();
    finite_.set(LOCATION_VERTEX_COUNT, static_cast<std::int32_t>(vertex_count_));
    positions_[current_].texture.bind(UNIT_POSITIONS);
    velocities_[current_].texture.bind(UNIT_VELOCITIES);
    first_bad_.bind_block(GL_SHADER_STORAGE_BUFFER, BLOCK_FIRST_BAD);
    dispatch();
    readback_.begin(first_bad_.id(), sizeof first);
    readback_.finish(std::span(&first, 1));
    return first == none ? std::nullopt : std::optional(first);
}

}  // namespace nuno
