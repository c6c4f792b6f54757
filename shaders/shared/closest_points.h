// Where two pieces of cloth are closest: a point and a face, or two edges. Of the four vertices x0..x3 side A has x0
// (the point) or x0 x1 (one edge), side B the rest.

// The closest points of the two sides: weights w0..w3 of the vertices, 1 in sum for A and -1 for B, so that
// separation = w0 x0 + w1 x1 + w2 x2 + w3 x3 goes from B to A.
struct ClosestPoints
{
    Real w0, w1, w2, w3;
    Vec3 separation;  // [m]
};

SHARED_FN Real clamp_to_unit(Real a) { return min_real(max_real(a, Real(0.0f)), Real(1.0f)); }

SHARED_FN ClosestPoints closest_points(Real w0, Real w1, Real w2, Real w3, Vec3 separation)
{
    ClosestPoints c;
    c.w0 = w0;
    c.w1 = w1;
    c.w2 = w2;
    c.w3 = w3;
    c.separation = separation;
    return c;
}

// Of the point p and the face a, b, c, by the region of the face that p lies over (C. Ericson, Real-Time Collision
// Detection, 2005, 5.1.5). Of a face without area the points need not be the closest.
SHARED_FN ClosestPoints closest_vertex_face(Vec3 p, Vec3 a, Vec3 b, Vec3 c)
{
    const Real zero = Real(0.0f), one = Real(1.0f);
    PRECISE Vec3 ab = b - a;
    PRECISE Vec3 ac = c - a;
    PRECISE Vec3 ap = p - a;
    PRECISE Vec3 bp = p - b;
    PRECISE Vec3 cp = p - c;
    PRECISE Real d1 = dot_product(ab, ap);
    PRECISE Real d2 = dot_product(ac, ap);
    if (d1 <= zero && d2 <= zero) return closest_points(one, -one, zero, zero, ap);
    PRECISE Real d3 = dot_product(ab, bp);
    PRECISE Real d4 = dot_product(ac, bp);
    if (d3 >= zero && d4 <= d3) return closest_points(one, zero, -one, zero, bp);
    PRECISE Real vc = d1 * d4 - d3 * d2;
    if (vc <= zero && d1 >= zero && d3 <= zero && d1 > d3) {
        PRECISE Real v = d1 / (d1 - d3);
        PRECISE Vec3 r = ap - v * ab;
        return closest_points(one, v - one, -v, zero, r);
    }
    PRECISE Real d5 = dot_product(ab, cp);
    PRECISE Real d6 = dot_product(ac, cp);
    if (d6 >= zero && d5 <= d6) return closest_points(one, zero, zero, -one, cp);
    PRECISE Real vb = d5 * d2 - d1 * d6;
    if (vb <= zero && d2 >= zero && d6 <= zero && d2 > d6) {
        PRECISE Real w = d2 / (d2 - d6);
        PRECISE Vec3 r = ap - w * ac;
        return closest_points(one, w - one, zero, -w, r);
    }
    PRECISE Real va = d3 * d6 - d5 * d4;
    PRECISE Real d43 = d4 - d3;
    PRECISE Real d56 = d5 - d6;
    PRECISE Real whole = va + vb + vc;
    if ((va <= zero && d43 >= zero && d56 >= zero && d43 + d56 > zero) || whole <= zero) {
        PRECISE Real w = d43 / max_real(d43 + d56, Real(1e-30f));
        PRECISE Vec3 r = bp - w * (c - b);
        return closest_points(one, zero, w - one, -w, r);
    }
    PRECISE Real v = vb / whole;
    PRECISE Real w = vc / whole;
    PRECISE Vec3 r = ap - v * ab - w * ac;
    return closest_points(one, v + w - one, -v, -w, r);
}

// Of the edges a0 a1 and b0 b1 (Ericson 2005, 5.1.9). Edges that are nearly parallel meet at the end of one of them.
SHARED_FN ClosestPoints closest_edge_edge(Vec3 a0, Vec3 a1, Vec3 b0, Vec3 b1)
{
    const Real zero = Real(0.0f), one = Real(1.0f), tiny = Real(1e-30f);
    PRECISE Vec3 da = a1 - a0;
    PRECISE Vec3 db = b1 - b0;
    PRECISE Vec3 r = a0 - b0;
    PRECISE Real aa = dot_product(da, da);
    PRECISE Real bb = dot_product(db, db);
    PRECISE Real ab = dot_product(da, db);
    PRECISE Real ar = dot_product(da, r);
    PRECISE Real br = dot_product(db, r);
    PRECISE Real det = aa * bb - ab * ab;
    PRECISE Real s = zero;
    if (det > Real(1e-6f) * aa * bb) s = clamp_to_unit((ab * br - ar * bb) / det);
    PRECISE Real t = clamp_to_unit((ab * s + br) / max_real(bb, tiny));
    s = clamp_to_unit((ab * t - ar) / max_real(aa, tiny));
    PRECISE Vec3 separation = r + s * da - t * db;
    return closest_points(one - s, s, t - one, -t, separation);
}
