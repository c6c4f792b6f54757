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

    static NUNO_WIDE_INLINE Vec3 acceleration(const StripMotion& s, const glm::vec3& common, std::size_t at)
    {
        const Vec3 a = wide(common);
        return s.acceleration ? a + load(s.acceleration + at) : a;
    }

    // Two substeps that follow one another: what the end of one leaves, and the start of the next takes.
    struct Past
    {
        Motion now, last;
    };

    static NUNO_WIDE_INLINE Past past(const StripMotion& s, std::size_t at)
    {
        return {Formulas::motion(load(s.positions + at), load(s.velocities + at)),
                Formulas::motion(load(s.last_positions + at), load(s.last_velocities + at))};
    }

    template <bool kBodies>
    static NUNO_WIDE_INLINE void predict(const StripMotion& s, std::size_t vector, std::size_t at, int lane,
                                         const Past& past)
    {
        const Real mobility(s.mobility + vector * kStrips + lane);
        const Motion start = past.now;
        Motion m = Formulas::predicted_motion(start, past.last, acceleration(s, s.common, at), Real(s.times.keep),
                                              Real(s.times.step));
        store(s.last_positions + at, start.position);
        store(s.last_velocities + at, start.velocity);
        if (kBodies && s.bodies) m = push_out_of_bodies<kLaneCount>(*s.bodies, start.position, m).motion;
        m = Formulas::select_motion(mobility, m, start);
        store(s.velocities + at, m.velocity);
        store(s.predicted + at, m.position);
        for (const StripTethers& tethers : s.tethers) {
            const float* anchor = s.anchors + std::size_t(tethers.anchor_of[vector]) * kVec3Floats + lane;
            m.position =
                Formulas::tethered(m.position, load(anchor), Real(tethers.lengths.data() + vector * kStrips + lane));
        }
        store(s.positions + at, select_positive(mobility, m.position, start.position));
    }

    template <bool kBodies>
    static NUNO_WIDE_INLINE Past finish(const StripMotion& s, std::size_t vector, std::size_t at, int lane)
    {
        const Real mobility(s.mobility + vector * kStrips + lane);
        Past past = Kernel::past(s, at);
        const Vec3 x = past.now.position, v = past.now.velocity;
        const Vec3 end = Formulas::corrected_velocity(v, load(s.predicted + at), x, Real(s.times.per_step));
        typename Formulas::Contact contact = Formulas::free_of_contact(Formulas::motion(x, end));
        if (kBodies && s.last_bodies && push_out_of_bodies<kLaneCount>(*s.last_bodies, past.last.position, contact))
            past.last = Formulas::last_after_contact(past.last, contact.motion, end, acceleration(s, s.last_common, at),
                                                     Real(s.times.h));
        if (s.sticking)
            select_positive(mobility, contact.sticks, Real(0.0f)).store(s.sticking + vector * kStrips + lane);
        past.now = Formulas::select_motion(mobility, contact.motion, past.now);
        return past;
    }

    template <bool kFinish, bool kPredict, bool kBodies>
    static NUNO_WIDE_INLINE void rows_with(const StripMotion& s, Range rows)
    {
        const StripLayout& layout = *s.layout;
        for (int j = rows.begin; j < rows.end; ++j)
            for (int c = 0; c < layout.width; ++c)
                for (int lane = 0; lane < kStrips; lane += kLaneCount) {
                    const std::size_t vector = std::size_t(j) * std::size_t(layout.width) + std::size_t(c);
                    const std::size_t at =
                        std::size_t(j) * std::size_t(layout.row_floats) + std::size_t(c * kVec3Floats + lane);
                    const Past past = kFinish ? finish<kBodies>(s, vector, at, lane) : Kernel::past(s, at);
                    if (kPredict)
                        predict<kBodies>(s, vector, at, lane, past);
                    else
                        put(s, at, past);
                }
    }

    template <bool kFinish, bool kPredict>
    static NUNO_WIDE_INLINE void rows(const StripMotion& s, Range rows)
    {
        if (s.bodies || s.last_bodies)
            rows_with<kFinish, kPredict, true>(s, rows);
        else
            rows_with<kFinish, kPredict, false>(s, rows);
    }

    static NUNO_WIDE_INLINE void put(const StripMotion& s, std::size_t at, const Past& past)
    {
        store(s.positions + at, past.now.position);
        store(s.velocities + at, past.now.velocity);
        store(s.last_positions + at, past.last.position);
        store(s.last_velocities + at, past.last.velocity);
    }
};

NUNO_BY_LANES(predict, (const StripMotion& motion, Range rows),
              (Kernel<kLaneCount>::template rows<false, true>(motion, rows)))
NUNO_BY_LANES(turn, (const StripMotion& motion, Range rows),
              (Kernel<kLaneCount>::template rows<true, true>(motion, rows)))
NUNO_BY_LANES(finish, (const StripMotion& motion, Range rows),
              (Kernel<kLaneCount>::template rows<true, false>(motion, rows)))

}  // namespace

void predict_rows(const StripMotion& motion, Range rows) { NUNO_PICK_LANES(predict, motion.lanes)(motion, rows); }
void turn_rows(const StripMotion& motion, Range rows) { NUNO_PICK_LANES(turn, motion.lanes)(motion, rows); }
void finish_rows(const StripMotion& motion, Range rows) { NUNO_PICK_LANES(finish, motion.lanes)(motion, rows); }

}  // namespace nuno
