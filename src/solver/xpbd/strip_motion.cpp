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
        const Vec3 a{Real(s.common[0]), Real(s.common[1]), Real(s.common[2])};
        return s.acceleration ? a + load(s.acceleration + at) : a;
    }

    static NUNO_WIDE_INLINE void predict(const StripMotion& s, std::size_t vector, std::size_t at, int lane)
    {
        const Real mobility(s.mobility + vector * kStrips + lane);
        const Vec3 x = load(s.positions + at + lane), v = load(s.velocities + at + lane);
        const Motion last = Formulas::motion(load(s.last_positions + at + lane), load(s.last_velocities + at + lane));
        Motion m = Formulas::predicted_motion(Formulas::motion(x, v), last, acceleration(s, at + lane), Real(s.keep),
                                              Real(s.step));
        store(s.last_positions + at + lane, x);
        store(s.last_velocities + at + lane, v);
        if (s.bodies) m = push_out_of_bodies<kLaneCount>(*s.bodies, x, m).motion;
        if (s.contacts) {
            const float* anchor = s.anchors + std::size_t(s.contacts->anchor_of[vector]) * kVec3Floats + lane;
            m = Formulas::held_back(m, load(anchor), Real(s.contacts->lengths.data() + vector * kStrips + lane));
        }
        m.position = select_positive(mobility, m.position, x);
        m.velocity = select_positive(mobility, m.velocity, v);
        store(s.velocities + at + lane, m.velocity);
        store(s.predicted + at + lane, m.position);
        Vec3 end = m.position;
        for (const StripTethers& tethers : s.tethers) {
            const float* anchor = s.anchors + std::size_t(tethers.anchor_of[vector]) * kVec3Floats + lane;
            end = Formulas::tethered(end, load(anchor), Real(tethers.lengths.data() + vector * kStrips + lane));
        }
        store(s.positions + at + lane, select_positive(mobility, end, x));
    }

    static NUNO_WIDE_INLINE void finish(const StripMotion& s, std::size_t vector, std::size_t at, int lane)
    {
        const Real mobility(s.mobility + vector * kStrips + lane);
        const Vec3 x = load(s.positions + at + lane), v = load(s.velocities + at + lane);
        const Vec3 end = Formulas::corrected_velocity(v, load(s.predicted + at + lane), x, Real(s.per_step));
        Motion m = Formulas::motion(x, end);
        if (s.bodies) {
            const auto contact = push_out_of_bodies<kLaneCount>(*s.bodies, load(s.last_positions + at + lane), m);
            m = contact.motion;
            store(s.positions + at + lane, select_positive(mobility, m.position, x));
            select_positive(mobility, contact.sticks, Real(0.0f)).store(s.sticking + vector * kStrips + lane);
            // After a contact the motion before it says nothing about the one to come.
            const Vec3 lost = m.velocity - end;
            const Real touched = Formulas::dot_product(lost, lost);
            const Motion last = Formulas::assumed_last(m, acceleration(s, at + lane), Real(s.h));
            store(s.last_positions + at + lane,
                  select_positive(touched, last.position, load(s.last_positions + at + lane)));
            store(s.last_velocities + at + lane,
                  select_positive(touched, last.velocity, load(s.last_velocities + at + lane)));
        }
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
