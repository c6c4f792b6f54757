// A point against a face: the foot of the perpendicular of the seed paper, section 2.5.1.2.
struct FaceFoot
{
    Vec3 weights;   // of the corners in the foot, sum 1
    Vec3 normal;    // of the face, unit, by the winding of its corners
    Real distance;  // [m] from foot to point, negative on the side that the normal points away from
};

// The seed's system for the point x3 and the corners x0, x1, x2, with x_ij = x_j - x_i:
//     x20.x23 = w0 x20.x20 + w1 x20.x21
//     x21.x23 = w0 x21.x20 + w1 x21.x21,     w0 + w1 + w2 = 1
// by Cramer's rule, its determinants as products of area vectors, (a x b).(c x d) = (a.c)(b.d) - (a.d)(b.c), which
// round less where the face is thin. The distance is |x3 - x4| to the foot x4 itself, equal to the seed's |n.x23| but
// for rounding: so a point at distance d is within d of the weighted corners even where a thin face leaves n and the
// weights inexact. A face without area (|sin| of the angle at x2 below 1e-6, or |c| below 1e-15 m2) gets weights and a
// distance that no test of nearness accepts; so does one whose c.c a float does not hold.
SHARED_FN FaceFoot face_foot(Vec3 x3, Vec3 x0, Vec3 x1, Vec3 x2)
{
    PRECISE Vec3 x20 = x0 - x2;
    PRECISE Vec3 x21 = x1 - x2;
    PRECISE Vec3 x23 = x3 - x2;
    PRECISE Vec3 c = area_vector(x20, x21);
    PRECISE Real det = dot_product(c, c);
    PRECISE Real area_sq = det - Real(1e-12f) * dot_product(x20, x20) * dot_product(x21, x21) - Real(1e-30f);
    PRECISE Real has_area = select_positive(Real(1e37f) - det, area_sq, Real(-1.0f));
    PRECISE Real divisor = max_real(det, Real(1e-30f));

    PRECISE Real w0 = dot_product(area_vector(x23, x21), c) / divisor;
    PRECISE Real w1 = dot_product(area_vector(x20, x23), c) / divisor;
    PRECISE Vec3 x43 = x23 - w0 * x20 - w1 * x21;
    PRECISE Real height = vector_length(x43);

    FaceFoot foot;
    foot.weights = select_positive(has_area, Vec3(w0, w1, Real(1.0f) - w0 - w1), Vec3(Real(-1e30f)));
    foot.normal = c / sqrt_real(divisor);
    foot.distance = select_positive(has_area, select_positive(dot_product(c, x43), height, -height), Real(1e30f));
    return foot;
}
