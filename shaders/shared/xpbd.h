// Small-step XPBD (Macklin 2019): one spring's share of a substep as a correction of positions.

// 1 / sqrt(a) for a >= 0 to 6e-7 of its value, finite at 0, from operations that every machine rounds alike: a guess
// from the bits and two Newton steps, the constants of the first being those of J. Kadlec (2010), its factor 0.7039
// moved into those of the second.
SHARED_FN Real inverse_root(Real a)
{
    PRECISE Real guess = halved_bits_from(0x5f1ffff9u, a);
    PRECISE Real once = guess * (Real(2.38924456f) - a * guess * guess);
    PRECISE Real twice = Real(0.17442139f) * once * (Real(6.0538945f) - a * once * once);
    return twice;
}

// 1 - l0 / |d| for the vector d between the ends of a spring: the share of d that it is too long.
SHARED_FN Real spring_excess(Vec3 d, Real rest_length)
{
    PRECISE Real excess = Real(1.0f) - rest_length * inverse_root(dot_product(d, d));
    return excess;
}

// The same with a hard limit: what is beyond limit_length counts `hardness` times, so that one projection takes all of
// it away, as if the spring had no give there.
SHARED_FN Real limited_excess(Vec3 d, Real rest_length, Real limit_length, Real hardness)
{
    PRECISE Real per_length = inverse_root(dot_product(d, d));
    PRECISE Real excess = Real(1.0f) - rest_length * per_length;
    PRECISE Real beyond = hardness * (Real(1.0f) - limit_length * per_length);
    return max_real(excess, beyond);
}

// share times that excess, for share_length = share l0.
SHARED_FN Real spring_pull(Vec3 d, Real share, Real share_length)
{
    PRECISE Real pull = share - share_length * inverse_root(dot_product(d, d));
    return pull;
}

// The second-order backward difference (BDF2) of a motion x0, v0 with the motion before it, `last`, one substep h ago:
//     v1 = (4 v0 - v_last) / 3 + (2 h / 3) a - (2 h / 3) c v1,   x1 = (4 x0 - x_last) / 3 + (2 h / 3) v1
// with step = 2 h / 3 and keep = 1 / (1 + c step), c the drag [1/s].
SHARED_FN Motion predicted_motion(Motion m, Motion last, Vec3 a, Real keep, Real step)
{
    const Real third = Real(1.0f / 3.0f);
    PRECISE Vec3 v = m.velocity + third * (m.velocity - last.velocity);
    PRECISE Vec3 x = m.position + third * (m.position - last.position);
    PRECISE Vec3 v1 = keep * (v + step * a);
    PRECISE Vec3 x1 = x + step * v1;
    return motion(x1, v1);
}

// The motion before m that makes predicted_motion a step of (semi-implicit) Euler, x1 = x0 + h v1 to first order: where
// something that has no past, such as a collision, came between.
SHARED_FN Motion assumed_last(Motion m, Vec3 a, Real h)
{
    PRECISE Vec3 x = m.position - h * m.velocity;
    PRECISE Vec3 v = m.velocity - h * a;
    return motion(x, v);
}

// What to take for `last`, the motion before m, once bodies have changed the velocity of m, which was `free`: after a
// contact the motion before it says nothing about the one to come.
SHARED_FN Motion last_after_contact(Motion last, Motion m, Vec3 free, Vec3 a, Real h)
{
    PRECISE Vec3 lost = m.velocity - free;
    return select_motion(dot_product(lost, lost), assumed_last(m, a, h), last);
}

// The end of a substep: the velocity that includes what moved the particle from `predicted` to x; exactly v where
// nothing did. per_step = 1 / step.
SHARED_FN Vec3 corrected_velocity(Vec3 v, Vec3 predicted, Vec3 x, Real per_step)
{
    PRECISE Vec3 corrected = v + per_step * (x - predicted);
    return corrected;
}

// A tether: x, but not further from `anchor` than `length`.
SHARED_FN Vec3 tethered(Vec3 x, Vec3 anchor, Real length)
{
    PRECISE Vec3 d = x - anchor;
    PRECISE Real ratio = length * inverse_root(dot_product(d, d));
    PRECISE Vec3 at_end = anchor + ratio * d;
    return select_positive(Real(1.0f) - ratio, at_end, x);
}
