#version 330
// SPDX-License-Identifier: MIT
// Points of the water; for plain water also the light, as in other renderers.
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 rest;
layout(location = 2) in vec2 slope;
uniform mat4 view;              // world to clip
uniform vec3 light;
uniform float ambient;
out vec3 at;
out vec2 still, tilt;
out float lit;

void main()
{
    vec3 n = normalize(vec3(-slope.x, 1.0, -slope.y));
    gl_Position = view * vec4(place, 1.0);
    at = place;
    still = rest;
    tilt = slope;
    lit = ambient + (1.0 - ambient) * max(dot(n, light), 0.0);
}
