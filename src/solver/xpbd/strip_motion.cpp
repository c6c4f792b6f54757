// Start and end of a substep of a sheet in strips.
#include "solver/xpbd/strip_motion.h"

#include "solver/xpbd/strip_lanes.h"

namespace nuno {
namespace {

template <int kLaneCount>
struct Kernel : StripLane<kLaneCount>
{
    using typename StripLane<kLaneCount>::Real;
    using typename StripLane<kLaneCount>::Vec3;
    using typename StripLane<kLaneCount>::Formulas;
    using StripLane<kLaneCount>::load;
    using StripLane<kLaneCount>::store;
    using StripLane<kLaneCount>::wide;
    using Motion = typename Formulas::Motion;

    static NUNO_WIDE_INLINE Vec3 acceleration(const StripMotion& s, std::size_t at)
    {
        const Vec3 a = wide(s.common);
        return s.acceleration ? a + load(s.acceleration + at) : a;
    }

    static NUNO_WIDE_INLINE void predict(const StripMotion& s, std::size_t vector, std::size_t at, int lane)
    {
        const Real mobility(s.mobility + vector * kStrips + lane);
        const Motion start = Formulas::motion(load(s.positions + at + lane), load(s.velocities + at + lane));
        const Motion last = Formulas::motion(load(s.last_positions + at + lane), load(s.last_velocities + at + lane));
        Motion m =
            Formulas::predicted_motion(start, last, acceleration(s, at + lane), Real(s.times.keep), Real(s.times.step));
        store(s.last_positions + at + lane, start.position);
        store(s.last_velocities + at + lane, start.velocity);
        if (s.bodies) m = push_out_of_bodies<kLaneCount>(*s.bodies, start.position, m).motion;
        if (s.contacts) {
            const float* anchor = s.anchors + std::size_t(s.contacts->anchor_of[vector]) * kVec3Floats + lane;
            m = Formulas::held_back(m, load(anchor), Real(s.contacts->lengths.data() + vector * kStrips + lane));
        }
        m = Formulas::select_motion(mobility, m, start);
        store(s.velocities + at + lane, m.velocity);
        store(s.predicted + at + lane, m.position);
        for (const StripTethers& tethers : s.tethers) {
            const float* anchor = s.anchors + std::size_t(tethers.anchor_of[vector]) * kVec3Floats + lane;
            m.position =
                Formulas::tethered(m.position, load(anchor), Real(tethers.lengths.data() + vector * kStrips + lane));
        }
        store(s.positions + at + lane, select_positive(mobility, m.position, start.position));
    }

    static NUNO_WIDE_INLINE void finish(const StripMotion& s, std::size_t vector, std::size_t at, int lane)
    {
        const Real mobility(s.mobility + vector * kStrips + lane);
        const Vec3 x = load(s.positions + at + lane), v = load(s.velocities + at + lane);
        const Vec3 end = Formulas::corrected_velocity(v, load(s.predicted + at + lane), x, Real(s.times.per_step));
        Motion m = Formulas::motion(x, end);
        typename Formulas::Contact contact = Formulas::free_of_contact(m);
        if (s.bodies && push_out_of_bodies<kLaneCount>(*s.bodies, load(s.last_positions + at + lane), contact)) {
            m = contact.motion;
            store(s.positions + at + lane, select_positive(mobility, m.position, x));
            Motion last = Formulas::motion(load(s.last_positions + at + lane), load(s.last_velocities + at + lane));
            last = Formulas::last_after_contact(last, m, end, acceleration(s, at + lane), Real(s.times.h));
            store(s.last_positions + at + lane, last.position);
            store(s.last_velocities + at + lane, last.velocity);
        }
        if (s.bodies) select_positive(mobility, contact.sticks, Real(0.0f)).store(s.sticking + vector * kStrips + lane);
        store(s.velocities + at + lane, select_positive(mobility, m.velocity, v));
    }

    static NUNO_WIDE_INLINE void rows(const StripMotion& s, Range rows, bool at_end)
    {
        const StripLayout& layout = *s.layout;
        for (int j = rows.begin; j < rows.end; ++j)
            for (int c = 0; c < layout.width; ++c)
                for (int lane = 0; lane < kStrips; lane += kLaneCount) {
                    const std::size_t vector = std::size_t(j) * std::size_t(layout.width) + std::size_t(c);
                    const std::size_t at =
                        std::size_t(j) * std::size_t(layout.row_floats) + std::size_t(c * kVec3Floats);
                    if (at_end)
                        finish(s, vector, at, lane);
                    else
                        predict(s, vector, at, lane);
                }
    }
};

NUNO_BY_LANES(predict, (const StripMotion& motion, Range rows), Kernel<kLaneCount>::rows(motion, rows, false))
NUNO_BY_LANES(finish, (const StripMotion& motion, Range rows), Kernel<kLaneCount>::rows(motion, rows, true))

}  // namespace

void predict_rows(const StripMotion& motion, Range rows) { NUNO_PICK_LANES(predict, motion.lanes)(motion, rows); }
void finish_rows(const StripMotion& motion, Range rows) { NUNO_PICK_LANES(finish, motion.lanes)(motion, rows); }

}  // namespace nuno
