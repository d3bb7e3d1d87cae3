#version 330
// SPDX-License-Identifier: MIT
// A texture with light. The mipmap level comes from the depth, by the engine's rule: the
// bits of 1 / depth are its logarithm, linear between powers of two.
in vec2 still;
in float lit;
uniform sampler2D layer0;
uniform vec4 map0;              // repeats a metre, offsets, level at 1 m
out vec4 colour;

void main()
{
    float far = 127.0 - float(floatBitsToInt(gl_FragCoord.w)) / 8388608.0;
    float level = floor(map0.w + far + 0.5 * max(far, 0.0));
    colour = vec4(textureLod(layer0, still * map0.x + map0.yz, level).rgb * lit, 1.0);
}
