// What accelerates a vertex of xpbd beside its constraints. Include after sim/forces.glsl.
#ifdef IN_ONE_GROUP
vec3 common_acceleration; // [m/s2] of every vertex, in this substep
#else
layout(location = LOCATION_COMMON) uniform vec3 common_acceleration; // [m/s2] of every vertex
#endif

vec3 free_acceleration(int vertex, float inverse_mass)
{
    precise vec3 a = common_acceleration;
#if CORNER_QUADS
    precise vec3 with_faces = a + inverse_mass * force_of_faces(vertex);
    a = with_faces;
#endif
    return a;
}
