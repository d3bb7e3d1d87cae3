#version 330
// SPDX-License-Identifier: MIT
// One triangle over the whole picture, behind all geometry.
uniform mat4 rays;              // clip to world
out vec3 way;

void main()
{
    vec2 p = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
    gl_Position = vec4(p, 1.0, 1.0);
    way = (rays * vec4(p, 1.0, 0.0)).xyz;
}
