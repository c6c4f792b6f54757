// Contact of many particles side by side with the rigid bodies of a scene, as shaders/sim/bodies.glsl has it for one.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <span>

#include "model/body_steps.h"
#include "model/formulas.h"

namespace nuno {

// What push_out_of_bodies reads in one substep.
struct BodyContacts
{
    const BodySteps& steps;
    std::span<const BodyStep> bodies;
    std::array<std::size_t, 4> ends;  // where planes, spheres, capsules and boxes end in `bodies`; then meshes
    float distance;                   // [m] that the cloth keeps
    float kinetic, resting;           // Coulomb coefficients, resting no less than kinetic
    float h;                          // [s]
};

template <int kCount>
NUNO_WIDE_INLINE WideVec<kCount> wide_of(const glm::vec4& a)
{
    return {Wide<kCount>(a.x), Wide<kCount>(a.y), Wide<kCount>(a.z)};
}

// Whether a is less than `limit` in any lane.
template <int kCount>
NUNO_WIDE_INLINE bool any_below(const Wide<kCount>& a, float limit)
{
    const auto mask = a.lanes < Wide<kCount>(limit).lanes;
    std::uint64_t halves[kCount / 2], any = 0;
    std::memcpy(halves, &mask, sizeof halves);
    for (const std::uint64_t half : halves) any |= half;
    return any != 0;
}

// The mesh's surface as particles at q (in the mesh's axes) see it; no gather where all are out of the reach [m].
template <int kCount>
NUNO_WIDE_INLINE typename WideFormulas<kCount>::Surface mesh_surface(const DistanceGrid& grid, WideVec<kCount> q,
                                                                     float reach)
{
    using F = WideFormulas<kCount>;
    using Real = Wide<kCount>;
    const Real cells[3] = {Real(float(grid.cells.x)), Real(float(grid.cells.y)), Real(float(grid.cells.z))};
    const typename F::GridPlace place =
        F::grid_place(q, {Real(grid.origin.x), Real(grid.origin.y), Real(grid.origin.z)}, Real(grid.cell),
                      Real(1 / grid.cell), {cells[0], cells[1], cells[2]});
    if (!any_below(place.beyond, reach)) return F::surface(q, Real(1e30f));
    const int row = grid.cells.x + 1, layer = row * (grid.cells.y + 1);
    float corner[8][kCount];
    for (int lane = 0; lane < kCount; ++lane) {
        const int node = (int(place.cell.z.lanes[lane]) * (grid.cells.y + 1) + int(place.cell.y.lanes[lane])) * row +
                         int(place.cell.x.lanes[lane]);
        const float* low = grid.values.data() + node;
        const float* const ends[4] = {low, low + row, low + layer, low + layer + row};
        for (int k = 0; k < 4; ++k) {
            corner[2 * k][lane] = ends[k][0];
            corner[2 * k + 1][lane] = ends[k][1];
        }
    }
    const typename F::CellCorners corners{{Real(corner[0]), Real(corner[1])},
                                          {Real(corner[2]), Real(corner[3])},
                                          {Real(corner[4]), Real(corner[5])},
                                          {Real(corner[6]), Real(corner[7])}};
    return F::grid_surface(place, corners);
}

// The surface of one body, seen from particles at d from its position.
template <int kCount>
NUNO_WIDE_INLINE typename WideFormulas<kCount>::Surface surface_of(const BodyContacts& c, std::size_t number,
                                                                   const WideVec<kCount>& d)
{
    using F = WideFormulas<kCount>;
    using Real = Wide<kCount>;
    const BodyStep& body = c.bodies[number];
    const WideVec<kCount> y_axis = wide_of<kCount>(body.axis[1]);
    if (number < c.ends[0]) return F::plane_surface(d, y_axis);
    if (number < c.ends[1]) return F::sphere_surface(d, Real(body.position.w), y_axis);
    const WideVec<kCount> x_axis = wide_of<kCount>(body.axis[0]);
    if (number < c.ends[2]) return F::capsule_surface(d, x_axis, y_axis, Real(body.axis[1].w), Real(body.position.w));
    const WideVec<kCount> z_axis = wide_of<kCount>(body.axis[2]);
    const WideVec<kCount> q = F::to_body(d, x_axis, y_axis, z_axis);
    typename F::Surface s = number < c.ends[3]
                                ? F::box_surface(q, {Real(body.axis[0].w), Real(body.axis[1].w), Real(body.axis[2].w)})
                                : mesh_surface<kCount>(*c.steps.grid(number), q, c.distance + CONTACT_SKIN);
    s.normal = F::to_world(s.normal, x_axis, y_axis, z_axis);
    return s;
}

// Whether a particle at d [m] from a body's position may be nearer to it than the distance kept. It only saves work:
// what it leaves out has no contact, by a margin for rounding.
template <int kCount>
NUNO_WIDE_INLINE bool may_touch(const BodyContacts& c, std::size_t number, const WideVec<kCount>& d)
{
    const float reach = (c.steps.bound(number) + c.distance) * 1.001f + 1e-4f;
    return any_below(WideFormulas<kCount>::dot_product(d, d), reach * reach);
}

// Contact of particles that were at `x_start` before the substep and have the motion of `held` after it with every
// body, one after another. False where none touches any: `held` is as it was. The caller leaves out pinned lanes.
template <int kCount>
NUNO_WIDE_INLINE bool push_out_of_bodies(const BodyContacts& c, const WideVec<kCount>& x_start,
                                         typename WideFormulas<kCount>::Contact& held)
{
    using F = WideFormulas<kCount>;
    using Real = Wide<kCount>;
    bool any = false;
    for (std::size_t number = 0; number < c.bodies.size(); ++number) {
        const WideVec<kCount> d = held.motion.position - wide_of<kCount>(c.bodies[number].position);
        // The surface of a plane costs no more than this test.
        if (number >= c.ends[0] && !may_touch<kCount>(c, number, d)) continue;
        typename F::Surface s = surface_of<kCount>(c, number, d);
        s.distance = s.distance - Real(c.distance);
        if (!any_below(s.distance, CONTACT_SKIN)) continue;
        const BodyStep& body = c.bodies[number];
        const WideVec<kCount> velocity =
            F::velocity_of_body(x_start, wide_of<kCount>(body.origin), wide_of<kCount>(body.velocity[0]),
                                wide_of<kCount>(body.velocity[1]), wide_of<kCount>(body.velocity[2]),
                                {Real(body.velocity[0].w), Real(body.velocity[1].w), Real(body.velocity[2].w)});
        const typename F::Contact next =
            F::push_out(x_start, held.motion, s, velocity, {Real(c.kinetic), Real(c.resting)}, Real(c.h));
        held.motion = next.motion;
        held.sticks = max_real(held.sticks, next.sticks);
        any = true;
    }
    return any;
}

// The same for particles that have the motion `m` after the substep.
template <int kCount>
NUNO_WIDE_INLINE typename WideFormulas<kCount>::Contact push_out_of_bodies(
    const BodyContacts& c, const WideVec<kCount>& x_start, const typename WideFormulas<kCount>::Motion& m)
{
    typename WideFormulas<kCount>::Contact held = WideFormulas<kCount>::free_of_contact(m);
    push_out_of_bodies<kCount>(c, x_start, held);
    return held;
}

}  // namespace nuno
