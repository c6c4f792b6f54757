// Contact of two pieces of cloth, a vertex with a face or an edge with an edge, with Coulomb friction. The four
// vertices are x0 (vertex), x1 x2 x3 (face), or x0 x1 (one edge), x2 x3 (the other). Side A is what comes first, side B
// the other.

#define CONTACT_VERTEX_FACE 0.0f
#define CONTACT_EDGE_EDGE 1.0f

SHARED_FN ClosestPoints closest_of_layers(Real kind, Vec3 x0, Vec3 x1, Vec3 x2, Vec3 x3)
{
    if (kind == Real(CONTACT_VERTEX_FACE)) return closest_vertex_face(x0, x1, x2, x3);
    return closest_edge_edge(x0, x1, x2, x3);
}

// The least of normal.(a - b) over the vertices a of side A and b of side B [m]: planes across `normal` keep the sides
// at least that far apart.
SHARED_FN Real layer_gap(Real kind, Vec3 normal, Vec3 x0, Vec3 x1, Vec3 x2, Vec3 x3)
{
    PRECISE Real g02 = dot_product(normal, x0 - x2);
    PRECISE Real g03 = dot_product(normal, x0 - x3);
    PRECISE Real first = min_real(g02, g03);
    if (kind == Real(CONTACT_VERTEX_FACE)) return min_real(first, dot_product(normal, x0 - x1));
    PRECISE Real g12 = dot_product(normal, x1 - x2);
    PRECISE Real g13 = dot_product(normal, x1 - x3);
    return min_real(first, min_real(g12, g13));
}

// The least share of the cosine between old and new normal at which the new one is taken: it may turn, not flip, so
// that a contact remembers its side.
#define CONTACT_LEAST_TURN 0.2f
// Of the way to the whole thickness that a substep gives back to layers that are nearer, and the speed [m/s] at which it
// does so at most: more would throw them apart.
#define CONTACT_RECOVERY 0.1f
#define CONTACT_RECOVERY_SPEED 0.05f
// The least effective inverse mass over the largest of its vertices: pins that bear nearly all of a contact would
// otherwise let an impulse throw the rest any distance.
#define CONTACT_LEAST_MOBILITY 0.1f

SHARED_FN Vec3 contact_normal(Vec3 old_normal, Vec3 separation)
{
    PRECISE Real d = vector_length(separation);
    if (dot_product(old_normal, separation) > Real(CONTACT_LEAST_TURN) * d && d > Real(1e-7f)) return separation / d;
    return old_normal;
}

// sum w^2 inverse_mass, not too small [1/kg]; 0 where nothing can move. Of inverse masses m0..m3.
SHARED_FN Real contact_mobility(ClosestPoints c, Real m0, Real m1, Real m2, Real m3)
{
    PRECISE Real sum = c.w0 * c.w0 * m0 + c.w1 * c.w1 * m1 + c.w2 * c.w2 * m2 + c.w3 * c.w3 * m3;
    PRECISE Real largest = max_real(max_real(m0, m1), max_real(m2, m3));
    return max_real(sum, Real(CONTACT_LEAST_MOBILITY) * largest);
}

// How far the closest points went relative to each other, A less B, where the vertices went y0..y3 [m].
SHARED_FN Vec3 contact_way(ClosestPoints c, Vec3 y0, Vec3 y1, Vec3 y2, Vec3 y3)
{
    PRECISE Vec3 way = c.w0 * y0 + c.w1 * y1 + c.w2 * y2 + c.w3 * y3;
    return way;
}

struct ContactTerms
{
    Real thickness;  // [m]
    Real h;          // length of the substep [s]
    Friction friction;
};

// What each side is to be moved by, times weight and inverse mass of a vertex [m kg], so that after a substep in which
// the closest points went `way` [m] relative to each other and stand `gap` [m] apart along `normal`,
//     gap >= target = min(thickness, g0 + min(CONTACT_RECOVERY (thickness - g0), CONTACT_RECOVERY_SPEED h)),
//     g0 = max(gap - normal.way, 0), h the length of the substep [s],
// with what Coulomb takes of the way across: all of it where that is less than resting times what is pushed, else
// kinetic times as much. 0 where the gap is wide enough.
SHARED_FN Vec3 contact_push(Vec3 normal, Real gap, Vec3 way, ContactTerms terms, Real mobility)
{
    const Real zero = Real(0.0f), one = Real(1.0f);
    PRECISE Real along = dot_product(normal, way);
    PRECISE Real start = max_real(gap - along, zero);
    PRECISE Real recovery =
        min_real(Real(CONTACT_RECOVERY) * (terms.thickness - start), Real(CONTACT_RECOVERY_SPEED) * terms.h);
    PRECISE Real target = min_real(terms.thickness, start + recovery);
    PRECISE Real depth = target - gap;
    if (depth <= zero || mobility <= zero) return Vec3(zero);
    PRECISE Vec3 across = way - along * normal;
    PRECISE Real length = max_real(vector_length(across), Real(1e-12f));
    PRECISE Real kept = max_real(one - terms.friction.kinetic * depth / length, zero);
    if (length <= terms.friction.resting * depth) kept = zero;
    PRECISE Vec3 push = (depth * normal - (one - kept) * across) / mobility;
    return push;
}

// A vertex at x of this weight and inverse mass, moved by a push.
SHARED_FN Vec3 contact_position(Vec3 x, Vec3 push, Real weight, Real inverse_mass)
{
    PRECISE Vec3 moved = x + (weight * inverse_mass) * push;
    return moved;
}
