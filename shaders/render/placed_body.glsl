// A body of the scene: a mesh, placed by its pose and sizes (src/render/body_renderer.h).
layout(location = ATTRIBUTE_POSITION) in vec3 corner;
layout(location = ATTRIBUTE_NORMAL) in vec3 normal;
layout(location = ATTRIBUTE_BODY) in vec4 body;     // position, radius [m]
layout(location = ATTRIBUTE_BODY_X) in vec4 x_axis; // w: half size along it [m]
layout(location = ATTRIBUTE_BODY_Y) in vec4 y_axis;
layout(location = ATTRIBUTE_BODY_Z) in vec4 z_axis;

vec3 to_world(vec3 local)
{
    return local.x * x_axis.xyz + local.y * y_axis.xyz + local.z * z_axis.xyz;
}

vec3 placed_position()
{
    return body.xyz + to_world(body.w * normal + vec3(x_axis.w, y_axis.w, z_axis.w) * corner);
}
