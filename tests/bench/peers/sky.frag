#version 330
// SPDX-License-Identifier: MIT
in vec3 way;
uniform samplerCube sky;
uniform float exposure;
out vec4 colour;

void main()
{
    vec3 c = texture(sky, way).rgb;
    colour = vec4(exposure * c / (1.0 + (exposure - 1.0) * c), 1.0);
}
