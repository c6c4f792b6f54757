#version 430 core
// One triangle over the whole picture, behind everything; `corner` runs from -1 to 1.
out vec2 corner;

void main()
{
    corner = vec2((gl_VertexID & 1) * 4 - 1, (gl_VertexID >> 1) * 4 - 1);
    gl_Position = vec4(corner, 1.0, 1.0);
}
