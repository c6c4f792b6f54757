// What every program of one picture shares; the C++ side is src/render/view_block.h. Colours are linear light.
layout(std140, binding = BLOCK_VIEW) uniform View
{
    mat4 view_projection;
    vec4 eye;              // [m]
    vec4 ray_right;        // from the centre of the picture to its right side, for a ray of depth 1
    vec4 ray_up;           // the same to its top
    vec4 ray_forward;
    vec4 key_direction;    // towards the light
    vec4 key_light;        // w: the part of it that cloth lets through
    vec4 fill_direction;
    vec4 fill_light;
    vec4 sky_light;        // on a surface that faces up, from everywhere
    vec4 ground_light;     // on a surface that faces down
    vec4 zenith_colour;    // of the background
    vec4 horizon_colour;
    vec4 nadir_colour;
    vec4 tile_light;
    vec4 tile_dark;
    vec4 body_colour;
    vec4 floor_plane;      // unit normal n, offset: n . x = offset [m]
    vec4 floor_centre;     // under the camera's target; w: distance over which the floor fades [m]
    vec4 floor_across;     // unit vector along the floor; w: half side of the floor that is drawn [m]
    vec4 floor_along;
    vec4 shadow_centre;    // of the square of floor that can show a shadow; w: half its side [m], 0 for no shadow
};
