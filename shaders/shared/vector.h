// Vector sums written out in one order, so that every compiler rounds them alike (GLSL's dot and length do not promise
// it).
SHARED_FN Real dot_product(Vec3 a, Vec3 b)
{
    PRECISE Real sum = a.x * b.x + a.y * b.y + a.z * b.z;
    return sum;
}

SHARED_FN Real vector_length(Vec3 a) { return sqrt_real(dot_product(a, a)); }

// e1 x e2: the normal of the face with these two edges, as long as twice its area [m2].
SHARED_FN Vec3 area_vector(Vec3 e1, Vec3 e2)
{
    PRECISE Vec3 product = Vec3(e1.y * e2.z - e1.z * e2.y, e1.z * e2.x - e1.x * e2.z, e1.x * e2.y - e1.y * e2.x);
    return product;
}
