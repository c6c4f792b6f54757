// Explicit and symplectic Euler on CPU threads.
#include "solver/cpu_euler.h"

#include <bit>

#include "model/formulas.h"

namespace nuno {
namespace {

// Fewer vertices than this are not worth waking a second thread for.
constexpr std::uint32_t kLeastVerticesForThreads = 2048;

struct Lanes3
{
    float *x, *y, *z;
};

// All that a substep reads and writes, as plain pointers and numbers.
struct Substep
{
    const SpringBlocks& springs;
    const Colliders& colliders;
    Lanes3 from, to, velocity;
    const float *inverse_mass, *area;
    float stiffness[kSpringKindCount];
    glm::vec3 gravity;
    float h, damping, areal_density, wind, distance, friction;
    Method method;
};

NUNO_WIDE_INLINE WideVec3 load(const Lanes3& lanes, std::int32_t first)
{
    return {WideFloat(lanes.x + first), WideFloat(lanes.y + first), WideFloat(lanes.z + first)};
}

NUNO_WIDE_INLINE void store(const Lanes3& lanes, std::int32_t first, const WideVec3& a)
{
    a.x.store(lanes.x + first);
    a.y.store(lanes.y + first);
    a.z.store(lanes.z + first);
}

NUNO_WIDE_INLINE WideVec3 gather(const Lanes3& lanes, const std::uint32_t* vertices)
{
    WideVec3 a;
    for (int lane = 0; lane < kLanes; ++lane) {
        a.x.lanes[lane] = lanes.x[vertices[lane]];
        a.y.lanes[lane] = lanes.y[vertices[lane]];
        a.z.lanes[lane] = lanes.z[vertices[lane]];
    }
    return a;
}

NUNO_WIDE_INLINE WideVec3 wide(glm::vec3 a) { return {WideFloat(a.x), WideFloat(a.y), WideFloat(a.z)}; }

NUNO_WIDE_INLINE WideVec3 spring_forces(const Substep& s, std::uint32_t block, const WideVec3& x)
{
    WideVec3 sum(0.0f);
    for (std::uint32_t slot = s.springs.first_slot[block]; slot < s.springs.first_slot[block + 1]; ++slot) {
        const SpringBlockSlot info = s.springs.slots[slot];
        const WideFloat rest_length(&s.springs.rest_lengths[slot * kLanes]);
        const WideFloat stiffness =
            select_positive(rest_length - WideFloat(kNoSpring), WideFloat(s.stiffness[info.kind]), WideFloat(0.0f));
        const WideVec3 other = info.run == SpringBlocks::kGather ? gather(s.from, &s.springs.neighbours[slot * kLanes])
                                                                 : load(s.from, info.run);
        sum = sum + formulas_wide::spring_force(other - x, rest_length, stiffness);
    }
    return sum;
}

NUNO_WIDE_INLINE formulas_wide::Motion push_out_of_all(const Substep& s, formulas_wide::Motion m)
{
    const WideFloat distance(s.distance), friction(s.friction);
    for (const Plane& plane : s.colliders.planes)
        m = formulas_wide::push_out_of_plane(m, wide(plane.normal), WideFloat(plane.offset), distance, friction);
    for (const Sphere& sphere : s.colliders.spheres)
        m = formulas_wide::push_out_of_sphere(m, wide(sphere.centre), WideFloat(sphere.radius), distance, friction);
    return m;
}

// One substep of the vertices of blocks.begin .. blocks.end.
NUNO_SIMD_CLONES void substep_blocks(const Substep& s, Range blocks)
{
    for (int block = blocks.begin; block < blocks.end; ++block) {
        const std::int32_t i = block * kLanes;
        const WideVec3 x = load(s.from, i), v = load(s.velocity, i);
        const WideFloat inverse_mass(s.inverse_mass + i), area(s.area + i);
        const WideVec3 springs = spring_forces(s, static_cast<std::uint32_t>(block), x);
        const WideVec3 a =
            formulas_wide::acceleration(inverse_mass, area * WideFloat(s.areal_density), wide(s.gravity),
                                        area * WideFloat(s.damping), v, springs, area * WideFloat(s.wind));
        const formulas_wide::Motion free = s.method == Method::explicit_euler
                                               ? formulas_wide::explicit_euler(x, v, a, WideFloat(s.h))
                                               : formulas_wide::symplectic_euler(x, v, a, WideFloat(s.h));
        const formulas_wide::Motion held = push_out_of_all(s, free);
        store(s.to, i, select_positive(inverse_mass, held.position, free.position));
        store(s.velocity, i, select_positive(inverse_mass, held.velocity, free.velocity));
    }
}

Lanes3 lanes_of(PaddedVec3& a) { return {a.x.first(), a.y.first(), a.z.first()}; }

void put(PaddedVec3& to, std::uint32_t i, const glm::vec4& a)
{
    to.x.first()[i] = a.x;
    to.y.first()[i] = a.y;
    to.z.first()[i] = a.z;
}

}  // namespace

PaddedLane::PaddedLane(std::uint32_t count) : values_(kPad + (count + kLanes - 1) / kLanes * kLanes + kPad, 0.0f) {}

CpuEuler::CpuEuler(const ClothModel& model, const Colliders& colliders, Method method, ThreadPool& pool)
    : colliders_(colliders),
      method_(method),
      pool_(pool),
      vertex_count_(model.vertex_count()),
      springs_(make_spring_blocks(model.spring_table)),
      positions_{PaddedVec3(vertex_count_), PaddedVec3(vertex_count_)},
      velocities_(vertex_count_),
      inverse_mass_(vertex_count_),
      area_(vertex_count_)
{
}

std::string_view CpuEuler::name() const
{
    return method_ == Method::explicit_euler ? "explicit_euler on cpu" : "symplectic_euler on cpu";
}

void CpuEuler::upload(const ClothState& state)
{
    for (std::uint32_t i = 0; i < vertex_count_; ++i) {
        put(positions_[current_], i, state.positions[i]);
        put(velocities_, i, state.velocities[i]);
        inverse_mass_.first()[i] = state.positions[i].w;
        area_.first()[i] = state.velocities[i].w;
    }
}

void CpuEuler::upload_velocities(std::span<const glm::vec4> velocities)
{
    for (std::uint32_t i = 0; i < vertex_count_; ++i) put(velocities_, i, velocities[i]);
}

void CpuEuler::set_vertex(std::uint32_t vertex, glm::vec4 position)
{
    put(positions_[current_], vertex, position);
    put(velocities_, vertex, glm::vec4(0));
    inverse_mass_.first()[vertex] = position.w;
}

void CpuEuler::step(const StepInput& input)
{
    const int block_count = static_cast<int>(springs_.first_slot.size()) - 1;
    const int thread_count = vertex_count_ < kLeastVerticesForThreads ? 1 : pool_.thread_count();
    if (thread_count == 1) {
        step_part(input, {0, block_count}, nullptr);
    } else {
        SpinBarrier barrier(thread_count);
        pool_.run([&](int thread) { step_part(input, part_of(block_count, 1, thread, thread_count), &barrier); });
    }
    current_ = (current_ + input.substep_count) % 2;
}

void CpuEuler::step_part(const StepInput& input, Range blocks, SpinBarrier* barrier)
{
    const SimParams& p = input.params;
    Substep s{springs_,
              colliders_,
              {},
              {},
              lanes_of(velocities_),
              inverse_mass_.first(),
              area_.first(),
              {p.structural_stiffness, p.shear_stiffness, p.bend_stiffness},
              {p.gravity_x, p.gravity_y, p.gravity_z},
              substep_s(p),
              p.damping,
              p.areal_density,
              0,
              p.thickness,
              p.friction,
              method_};
    for (int k = 0; k < input.substep_count; ++k) {
        s.from = lanes_of(positions_[(current_ + k) % 2]);
        s.to = lanes_of(positions_[(current_ + k + 1) % 2]);
        s.wind = wind_pressure(p, input.start_time_s + k * double(s.h));
        substep_blocks(s, blocks);
        if (barrier) barrier->arrive_and_wait();
    }
}

void CpuEuler::download_positions(std::span<glm::vec4> positions)
{
    const Lanes3 x = lanes_of(positions_[current_]);
    for (std::uint32_t i = 0; i < vertex_count_; ++i) positions[i] = {x.x[i], x.y[i], x.z[i], inverse_mass_.first()[i]};
}

void CpuEuler::download_velocities(std::span<glm::vec4> velocities)
{
    const Lanes3 v = lanes_of(velocities_);
    for (std::uint32_t i = 0; i < vertex_count_; ++i) velocities[i] = {v.x[i], v.y[i], v.z[i], area_.first()[i]};
}

std::optional<std::uint32_t> CpuEuler::first_not_finite()
{
    constexpr std::uint32_t exponent = 0x7f800000u;
    const Lanes3 x = lanes_of(positions_[current_]), v = lanes_of(velocities_);
    for (std::uint32_t i = 0; i < vertex_count_; ++i)
        for (const float a : {x.x[i], x.y[i], x.z[i], v.x[i], v.y[i], v.z[i]})
            if ((std::bit_cast<std::uint32_t>(a) & exponent) == exponent) return i;
    return std::nullopt;
}

}  // namespace nuno
