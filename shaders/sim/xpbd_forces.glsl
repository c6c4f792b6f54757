// What accelerates a vertex of xpbd beside its constraints. Include after sim/forces.glsl.
layout(location = LOCATION_COMMON) uniform vec3 common_acceleration; // [m/s2] of every vertex

vec3 free_acceleration(int vertex, float inverse_mass)
{
    precise vec3 a = common_acceleration;
#if CORNER_QUADS
    precise vec3 with_faces = a + inverse_mass * force_of_faces(vertex);
    a = with_faces;
#endif
    return a;
}
