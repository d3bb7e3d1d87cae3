#version 330
// SPDX-License-Identifier: MIT
// Complete water by the equations of the engine's exact stages (src/shade):
// distortion, three layers, a normal map in the surface's tangent space, Phong's terms,
// Schlick's share of a cube map, exposure.
in vec3 at;
in vec2 still, tilt;
uniform sampler2D layer0, layer1, layer2, bend, ripple;
uniform samplerCube sky;
uniform vec4 map0, map1, map2, map_bend, map_ripple;    // repeats a metre, offsets, level
uniform vec3 colour0, colour1, colour2, light, eye;
uniform float strength, bump, ambient, specular, shininess, reflection, exposure;
out vec4 colour;

float far;

vec4 look(sampler2D map, vec4 how, vec2 place)
{
    float level = floor(how.w + far + 0.5 * max(far, 0.0));
    return textureLod(map, place * how.x + how.yz, level);
}

vec2 bumped()
{
    vec3 m = (look(ripple, map_ripple, still).xyz * 255.0 - 128.0) / 128.0;
    m = vec3(m.xy * bump, max(m.z, 0.125));
    float a = sqrt(1.0 + tilt.x * tilt.x), w = sqrt(1.0 + dot(tilt, tilt));
    float up = a * m.z - tilt.y * m.y, side = a * m.y + tilt.y * m.z, along = w * m.x;
    float y = max(up + tilt.x * along, 0.125);
    return vec2(tilt.x * up - along, a * side) / y;
}

void main()
{
    far = 127.0 - float(floatBitsToInt(gl_FragCoord.w)) / 8388608.0;
    vec2 place = still + (look(bend, map_bend, still).xy * 255.0 - 128.0) / 128.0
                       * strength;
    vec3 c = look(layer0, map0, place).rgb * colour0;
    c = min(c + look(layer1, map1, place).rgb * colour1, 1.0);
    c = min(c + look(layer2, map2, place).rgb * colour2, 1.0);

    vec2  s = bumped();
    vec3  v = normalize(eye - at);
    float ny = inversesqrt(1.0 + dot(s, s));
    float seen = clamp((v.y - dot(s, v.xz)) * ny, 0.0, 1.0), nv = max(seen, 0.1);
    float nl = clamp((light.y - dot(s, light.xz)) * ny, 0.0, 1.0);
    float rv = max(2.0 * nl * seen - dot(light, v), 0.0);
    float up = min(2.0 * nv * ny - v.y, 1.0), k = up + v.y;
    float share = 0.0204 + 0.9796 * pow(1.0 - nv, 5.0);
    vec3  mirrored = texture(sky, vec3(-k * s.x - v.x, max(up, 0.0), -k * s.y - v.z)).rgb;

    c *= ambient + (1.0 - ambient) * nl;
    c = mix(c, mirrored, share * reflection * clamp(1.0 + 4.0 * up, 0.5, 1.0));
    if (nl > 0.0)
        c += min(specular * pow(rv, shininess), 1.0);
    c = min(c, 1.0);
    colour = vec4(exposure * c / (1.0 + (exposure - 1.0) * c), 1.0);
}
