// The floor hides what is below it from an eye above it: drawn into a layer of its own, that is cut off at the floor.
void cut_at_floor(vec3 p)
{
    gl_ClipDistance[0] = dot(floor_plane.xyz, p) - floor_plane.w;
}
