// Where the surface of a rigid body is, seen from a particle at `d` [m] from the body's position. `x_axis`, `y_axis`,
// `z_axis`: the body's own axes in the world, unit.
struct Surface
{
    Vec3 normal;    // unit, outwards
    Real distance;  // [m] from the surface, negative inside
};

SHARED_FN Surface surface(Vec3 normal, Real distance)
{
    Surface s;
    s.normal = normal;
    s.distance = distance;
    return s;
}

// Half-space under the plane through the position.
SHARED_FN Surface plane_surface(Vec3 d, Vec3 y_axis) { return surface(y_axis, dot_product(d, y_axis)); }

// Ball. A particle at its very centre leaves along `way_out`.
SHARED_FN Surface sphere_surface(Vec3 d, Real radius, Vec3 way_out)
{
    PRECISE Real length = vector_length(d);
    PRECISE Real per_length = Real(1.0f) / max_real(length, Real(1e-12f));
    PRECISE Vec3 normal = select_positive(length, per_length * d, way_out);
    return surface(normal, length - radius);
}

// All points within `radius` of the piece of the y axis from -half_length to half_length.
SHARED_FN Surface capsule_surface(Vec3 d, Vec3 x_axis, Vec3 y_axis, Real half_length, Real radius)
{
    PRECISE Real along = dot_product(d, y_axis);
    PRECISE Real foot = max_real(min_real(along, half_length), -half_length);
    PRECISE Vec3 from_line = d - foot * y_axis;
    return sphere_surface(from_line, radius, x_axis);
}

// Box of half sides `half_size`; `q` is the particle in the box's own axes, and so is the normal. Outside, the distance
// is that to the nearest face, edge or corner; inside, that to the nearest face.
SHARED_FN Surface box_surface(Vec3 q, Vec3 half_size)
{
    const Real zero = Real(0.0f), one = Real(1.0f);
    PRECISE Vec3 side =
        Vec3(select_positive(q.x, one, -one), select_positive(q.y, one, -one), select_positive(q.z, one, -one));
    PRECISE Vec3 a = Vec3(side.x * q.x - half_size.x, side.y * q.y - half_size.y, side.z * q.z - half_size.z);
    PRECISE Vec3 past =
        Vec3(select_positive(a.x, a.x, zero), select_positive(a.y, a.y, zero), select_positive(a.z, a.z, zero));
    PRECISE Real outside = vector_length(past);
    PRECISE Real per_length = one / max_real(outside, Real(1e-12f));
    PRECISE Vec3 out_normal = per_length * Vec3(side.x * past.x, side.y * past.y, side.z * past.z);
    PRECISE Real y_or_z = max_real(a.y, a.z);
    PRECISE Vec3 face_y = Vec3(zero, side.y, zero);
    PRECISE Vec3 face_z = Vec3(zero, zero, side.z);
    PRECISE Vec3 y_or_z_normal = select_positive(a.z - a.y, face_z, face_y);
    PRECISE Vec3 in_normal = select_positive(a.x - y_or_z, Vec3(side.x, zero, zero), y_or_z_normal);
    return surface(select_positive(outside, out_normal, in_normal),
                   select_positive(outside, outside, max_real(a.x, y_or_z)));
}

// A place in a grid of distances (src/model/distance_grid.h).
struct GridPlace
{
    Vec3 cell;    // whole numbers: the cell's first node
    Vec3 part;    // of the cell, 0 .. 1 along each axis
    Real beyond;  // [m] from the grid, 0 within it
};

SHARED_FN Real clamp_to_cells(Real a, Real cells) { return max_real(min_real(a, cells), Real(0.0f)); }

// Of the point `q` in the grid's axes; `cells` is their number along each axis.
SHARED_FN GridPlace grid_place(Vec3 q, Vec3 origin, Real cell_size, Real per_metre, Vec3 cells)
{
    PRECISE Vec3 a = per_metre * (q - origin);
    PRECISE Vec3 b = Vec3(clamp_to_cells(a.x, cells.x), clamp_to_cells(a.y, cells.y), clamp_to_cells(a.z, cells.z));
    const Real one = Real(1.0f);
    GridPlace place;
    place.cell = Vec3(min_real(floor_real(b.x), cells.x - one), min_real(floor_real(b.y), cells.y - one),
                      min_real(floor_real(b.z), cells.z - one));
    place.part = b - place.cell;
    place.beyond = cell_size * vector_length(a - b);
    return place;
}

// Distances [m] at the corners of a cell, the x axis first.
struct CellCorners
{
    Real low_low[2];   // y low, z low
    Real high_low[2];  // y high, z low
    Real low_high[2];
    Real high_high[2];
};

SHARED_FN Real mix_real(Real a, Real b, Real part)
{
    PRECISE Real mixed = a + part * (b - a);
    return mixed;
}

// Trilinear distance, and its gradient as the normal, in the grid's axes.
SHARED_FN Surface grid_surface(GridPlace place, CellCorners c)
{
    const Real x = place.part.x, y = place.part.y, z = place.part.z;
    PRECISE Real low = mix_real(mix_real(c.low_low[0], c.low_low[1], x), mix_real(c.high_low[0], c.high_low[1], x), y);
    PRECISE Real high =
        mix_real(mix_real(c.low_high[0], c.low_high[1], x), mix_real(c.high_high[0], c.high_high[1], x), y);
    PRECISE Real across_x = mix_real(mix_real(c.low_low[1] - c.low_low[0], c.high_low[1] - c.high_low[0], y),
                                     mix_real(c.low_high[1] - c.low_high[0], c.high_high[1] - c.high_high[0], y), z);
    PRECISE Real across_y = mix_real(mix_real(c.high_low[0] - c.low_low[0], c.high_low[1] - c.low_low[1], x),
                                     mix_real(c.high_high[0] - c.low_high[0], c.high_high[1] - c.low_high[1], x), z);
    PRECISE Vec3 gradient = Vec3(across_x, across_y, high - low);
    PRECISE Real steepness = vector_length(gradient);
    PRECISE Real per_steepness = Real(1.0f) / max_real(steepness, Real(1e-12f));
    PRECISE Vec3 normal =
        select_positive(steepness, per_steepness * gradient, Vec3(Real(0.0f), Real(1.0f), Real(0.0f)));
    return surface(normal, mix_real(low, high, z) + place.beyond);
}

// A vector of the body's own axes in the world, and the other way.
SHARED_FN Vec3 to_world(Vec3 q, Vec3 x_axis, Vec3 y_axis, Vec3 z_axis)
{
    PRECISE Vec3 d = q.x * x_axis + q.y * y_axis + q.z * z_axis;
    return d;
}

SHARED_FN Vec3 to_body(Vec3 d, Vec3 x_axis, Vec3 y_axis, Vec3 z_axis)
{
    return Vec3(dot_product(d, x_axis), dot_product(d, y_axis), dot_product(d, z_axis));
}
