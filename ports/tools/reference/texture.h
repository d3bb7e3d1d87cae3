/* SPDX-License-Identifier: MIT */
/* Plain texture sampling: places in repeats, wrapped along both axes. */
#ifndef TP_TOOLS_REFERENCE_TEXTURE_H
#define TP_TOOLS_REFERENCE_TEXTURE_H
#include <math.h>
#include "shading.h"
#include "tidepool/assets.h"

static inline int ref_side(int log2, int level)
{
    return log2 > level ? 1 << (log2 - level) : 1;
}

static inline uint32_t ref_texel(const tp_texture *t, int level, int x, int y)
{
    const int w = ref_side(t->log2_w, level), h = ref_side(t->log2_h, level);
    return t->level[level][((y % h + h) % h) * w + (x % w + w) % w];
}

/* Texel that contains the place. */
static inline uint32_t ref_nearest(const tp_texture *t, int level, double s, double v)
{
    return ref_texel(t, level, (int)floor(s * ref_side(t->log2_w, level)),
                     (int)floor(v * ref_side(t->log2_h, level)));
}

/* Bilinear sample of the four texels whose centres surround the place. */
static inline ref_colour ref_linear(const tp_texture *t, int level, double s, double v)
{
    const double x = s * ref_side(t->log2_w, level) - 0.5;
    const double y = v * ref_side(t->log2_h, level) - 0.5;
    const int i = (int)floor(x), j = (int)floor(y);
    const ref_colour above =
        ref_mix(ref_colour_unpack(ref_texel(t, level, i, j)),
                ref_colour_unpack(ref_texel(t, level, i + 1, j)), x - i);
    const ref_colour below =
        ref_mix(ref_colour_unpack(ref_texel(t, level, i, j + 1)),
                ref_colour_unpack(ref_texel(t, level, i + 1, j + 1)), x - i);
    return ref_mix(above, below, y - j);
}

/* Slopes after a normal map's texel (nx, ny, nz), green up the picture, on a surface with
 * slopes sx and sz: T along (1, sx, 0), N the normal, B = (0, sz, 1) made orthogonal to
 * both. */
static inline void ref_turned(double sx, double sz, const double n[3], double slope[2])
{
    const ref_dir up = ref_normal(sx, sz), along = ref_unit((ref_dir){ 1, sx, 0 });
    const double slip = sz * along.y;
    const ref_dir down = ref_unit((ref_dir){ -slip * along.x, sz - slip * along.y, 1 });
    const double x = n[0] * along.x - n[1] * down.x + n[2] * up.x;
    const double y = n[0] * along.y - n[1] * down.y + n[2] * up.y;
    const double z = n[0] * along.z - n[1] * down.z + n[2] * up.z;
    const double steep = sqrt((1 + sx * sx) * (1 + sx * sx + sz * sz));
    const double held = fmax(y, 1 / (8 * steep));      /* clamped like in the stage */

    slope[0] = -x / held;
    slope[1] = -z / held;
}

/* Tones of a texel: saturation, clamp and colour. */
static inline ref_colour ref_grade(ref_colour a, double saturation, double clamp,
                                   ref_colour colour)
{
    const double grey = .3008 * a.c[0] + .5859 * a.c[1] + .1133 * a.c[2];
    ref_colour r;
    for (int i = 0; i < 3; i++) {
        const double v = ref_clamp(grey + (a.c[i] - grey) * saturation, 0, 255) / 255;
        r.c[i] = fmax(0, (v - clamp) / (1 - clamp)) * colour.c[i];
    }
    return r;
}
#endif
