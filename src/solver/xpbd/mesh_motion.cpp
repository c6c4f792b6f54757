// Start and end of a substep of any mesh.
#include "solver/xpbd/mesh_motion.h"

#include "solver/xpbd/by_lanes.h"
#include "solver/xpbd/vec4_lanes.h"

namespace nuno {
namespace {

template <int kLaneCount>
struct Kernel
{
    using Real = Wide<kLaneCount>;
    using Vec3 = WideVec<kLaneCount>;
    using Formulas = WideFormulas<kLaneCount>;
    using Motion = typename Formulas::Motion;
    using Positions = Vec4Lanes<kLaneCount>;

    static NUNO_WIDE_INLINE Vec3 acceleration(const MeshMotion& s, std::size_t at)
    {
        const Vec3 a{Real(s.common.x), Real(s.common.y), Real(s.common.z)};
        return s.acceleration ? a + Positions::load_run(s.acceleration + at).xyz : a;
    }

    static NUNO_WIDE_INLINE void predict(const MeshMotion& s, std::size_t first)
    {
        const std::size_t at = 4 * first;
        WideVec4<kLaneCount> x = Positions::load_run(s.positions + at), v = Positions::load_run(s.velocities + at);
        const Motion last = Formulas::motion(Positions::load_run(s.last_positions + at).xyz,
                                             Positions::load_run(s.last_velocities + at).xyz);
        const Motion start = Formulas::motion(x.xyz, v.xyz);
        Motion m = Formulas::predicted_motion(start, last, acceleration(s, at), Real(s.times.keep), Real(s.times.step));
        Positions::store_run(s.last_positions + at, x);
        Positions::store_run(s.last_velocities + at, v);
        if (s.bodies) m = push_out_of_bodies<kLaneCount>(*s.bodies, start.position, m).motion;
        m = Formulas::select_motion(x.w, m, start);
        x.xyz = m.position;
        v.xyz = m.velocity;
        Positions::store_run(s.velocities + at, v);
        Positions::store_run(s.predicted + at, x);
        for (const MeshTethers& tethers : s.tethers) {
            const Vec3 anchor = Positions::load(s.anchors, tethers.anchor_of.data() + first).xyz;
            m.position = Formulas::tethered(m.position, anchor, Real(tethers.lengths.data() + first));
        }
        x.xyz = select_positive(x.w, m.position, start.position);
        Positions::store_run(s.positions + at, x);
    }

    static NUNO_WIDE_INLINE void finish(const MeshMotion& s, std::size_t first)
    {
        const std::size_t at = 4 * first;
        WideVec4<kLaneCount> x = Positions::load_run(s.positions + at), v = Positions::load_run(s.velocities + at);
        const Vec3 end = Formulas::corrected_velocity(v.xyz, Positions::load_run(s.predicted + at).xyz, x.xyz,
                                                      Real(s.times.per_step));
        Motion m = Formulas::motion(x.xyz, end);
        WideVec4<kLaneCount> last_x = Positions::load_run(s.last_positions + at);
        typename Formulas::Contact contact = Formulas::free_of_contact(m);
        if (s.bodies && push_out_of_bodies<kLaneCount>(*s.bodies, last_x.xyz, contact)) {
            WideVec4<kLaneCount> last_v = Positions::load_run(s.last_velocities + at);
            m = contact.motion;
            x.xyz = select_positive(x.w, m.position, x.xyz);
            Positions::store_run(s.positions + at, x);
            const Motion last = Formulas::last_after_contact(Formulas::motion(last_x.xyz, last_v.xyz), m, end,
                                                             acceleration(s, at), Real(s.times.h));
            last_x.xyz = last.position;
            last_v.xyz = last.velocity;
            Positions::store_run(s.last_positions + at, last_x);
            Positions::store_run(s.last_velocities + at, last_v);
        }
        v.xyz = select_positive(x.w, m.velocity, v.xyz);
        Positions::store_run(s.velocities + at, v);
    }

    static NUNO_WIDE_INLINE void blocks(const MeshMotion& s, Range range, bool at_end)
    {
        for (int first = range.begin * kMeshBlock; first < range.end * kMeshBlock; first += kLaneCount)
            if (at_end)
                finish(s, static_cast<std::size_t>(first));
            else
                predict(s, static_cast<std::size_t>(first));
    }
};

NUNO_BY_LANES(predict, (const MeshMotion& motion, Range blocks), Kernel<kLaneCount>::blocks(motion, blocks, false))
NUNO_BY_LANES(finish, (const MeshMotion& motion, Range blocks), Kernel<kLaneCount>::blocks(motion, blocks, true))

}  // namespace

void predict_blocks(const MeshMotion& motion, Range blocks) { NUNO_PICK_LANES(predict, motion.lanes)(motion, blocks); }
void finish_blocks(const MeshMotion& motion, Range blocks) { NUNO_PICK_LANES(finish, motion.lanes)(motion, blocks); }

}  // namespace nuno
