/* SPDX-License-Identifier: MIT */
/* Polygon clipping by Sutherland and Hodgman in double precision, one plane after
 * another. */
#ifndef TP_REFERENCE_CLIP_H
#define TP_REFERENCE_CLIP_H
#include <math.h>

/* Vertex in scaled view coordinates, m: inside if z >= near and |x|, |y| <= band z. */
typedef struct {
    double x, y, z;
} ref_clip_corner;

static inline double ref_clip_inside(ref_clip_corner c, int side, double near,
                                     double band)
{
    switch (side) {
    case 0:  return c.z - near;
    case 1:  return band * c.z + c.x;
    case 2:  return band * c.z - c.x;
    case 3:  return band * c.z + c.y;
    default: return band * c.z - c.y;
    }
}

static inline int ref_clip_side(const ref_clip_corner *in, int count,
                                ref_clip_corner *out, int side, double near, double band)
{
    int kept = 0;

    for (int i = 0; i < count; i++) {
        const ref_clip_corner a = in[i], b = in[(i + 1) % count];
        const double da = ref_clip_inside(a, side, near, band);
        const double db = ref_clip_inside(b, side, near, band), way = da / (da - db);
        if (da >= 0)
            out[kept++] = a;
        if ((da >= 0) != (db >= 0))
            out[kept++] = (ref_clip_corner){ a.x + way * (b.x - a.x),
                                             a.y + way * (b.y - a.y),
                                             a.z + way * (b.z - a.z) };
    }
    return kept;
}

static inline int ref_clip(const ref_clip_corner in[3], ref_clip_corner out[8],
                           double near, double band)
{
    ref_clip_corner other[8];
    int count = ref_clip_side(in, 3, other, 0, near, band);

    count = ref_clip_side(other, count, out, 1, near, band);
    count = ref_clip_side(out, count, other, 2, near, band);
    count = ref_clip_side(other, count, out, 3, near, band);
    count = ref_clip_side(out, count, other, 4, near, band);
    for (int i = 0; i < count; i++)
        out[i] = other[i];
    return count;
}

/* Twice the area of the polygon on the screen, with vertices (x/z, y/z). */
static inline double ref_clip_area(const ref_clip_corner *c, int count)
{
    double sum = 0;

    for (int i = 0; i < count; i++) {
        const ref_clip_corner a = c[i], b = c[(i + 1) % count];
        sum += a.x / a.z * (b.y / b.z) - b.x / b.z * (a.y / a.z);
    }
    return sum;
}
#endif
