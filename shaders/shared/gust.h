// Gusts: a field of value noise. On a lattice of whole numbers, periodic over 256 along each axis, every point has
// three random numbers in -1 .. 1; between them the field is blended so that two derivatives are continuous.
#define GUST_PERIOD 256

// The random numbers of a lattice point: its coordinates (modulo the period) and a seed, mixed by multiplications and
// shifts (lowbias32 of C. Wellons), ten bits a number.
SHARED_FN Vec3 lattice_gust(Bits i, Bits j, Bits k, Bits seed)
{
    Bits hash = ((i & 255u) * 0x8da6b343u) ^ ((j & 255u) * 0xd8163841u) ^ ((k & 255u) * 0xcb1ab31fu) ^ seed;
    hash = (hash ^ (hash >> 16)) * 0x7feb352du;
    hash = (hash ^ (hash >> 15)) * 0x846ca68bu;
    hash = hash ^ (hash >> 16);
    const Real scale = Real(1.0f / 511.5f), one = Real(1.0f);
    PRECISE Real x = scale * real_of_bits(hash & 1023u) - one;
    PRECISE Real y = scale * real_of_bits((hash >> 10) & 1023u) - one;
    PRECISE Real z = scale * real_of_bits((hash >> 20) & 1023u) - one;
    return Vec3(x, y, z);
}

// From 0 to 1 as t does, its first and second derivative 0 at both ends: t^3 (t (6 t - 15) + 10).
SHARED_FN Real ease(Real t)
{
    PRECISE Real eased = t * t * t * (t * (Real(6.0f) * t - Real(15.0f)) + Real(10.0f));
    return eased;
}

SHARED_FN Vec3 blend(Vec3 a, Vec3 b, Real part)
{
    PRECISE Vec3 blended = a + part * (b - a);
    return blended;
}

// Places further out than a million lattice cells are taken for those at a million: cloth does not get there whole.
SHARED_FN Real within_lattice(Real a) { return max_real(min_real(a, Real(1e6f)), Real(-1e6f)); }

// The field at q, in lattice cells: each component within -1 .. 1.
SHARED_FN Vec3 gust_at(Vec3 q, Bits seed)
{
    const Real x = within_lattice(q.x), y = within_lattice(q.y), z = within_lattice(q.z);
    const Real cell_x = floor_real(x), cell_y = floor_real(y), cell_z = floor_real(z);
    PRECISE Real part_x = ease(x - cell_x);
    PRECISE Real part_y = ease(y - cell_y);
    PRECISE Real part_z = ease(z - cell_z);
    const Bits i = bits_of_whole(cell_x), j = bits_of_whole(cell_y), k = bits_of_whole(cell_z);
    const Bits i1 = i + 1u, j1 = j + 1u, k1 = k + 1u;
    const Vec3 low_low = blend(lattice_gust(i, j, k, seed), lattice_gust(i1, j, k, seed), part_x);
    const Vec3 high_low = blend(lattice_gust(i, j1, k, seed), lattice_gust(i1, j1, k, seed), part_x);
    const Vec3 low_high = blend(lattice_gust(i, j, k1, seed), lattice_gust(i1, j, k1, seed), part_x);
    const Vec3 high_high = blend(lattice_gust(i, j1, k1, seed), lattice_gust(i1, j1, k1, seed), part_x);
    return blend(blend(low_low, high_low, part_y), blend(low_high, high_high, part_y), part_z);
}

// Where x [m] is in the lattice (src/model/wind_field.h).
SHARED_FN Vec3 gust_place(Vec3 x, Vec3 offset, Real per_size)
{
    PRECISE Vec3 q = per_size * x + offset;
    return q;
}

// Velocity of the air [m/s]: the mean wind and the gust at q.
SHARED_FN Vec3 gusty_air(Vec3 wind, Real gust_speed, Vec3 q, Bits seed)
{
    PRECISE Vec3 velocity = wind + gust_speed * gust_at(q, seed);
    return velocity;
}
