/* SPDX-License-Identifier: MIT */
/* Objects over the mirrored sky: a look into their mirrored picture, bent by the slope.
 *
 * The picture shows the image of each object in level water, below it.  Let d be the
 * view's ray with 1 along the camera's axis, so that water at depth z lies at eye + z d.
 * A normal (-sx, 1, -sz) turns the reflected ray, and after t the image moves to first
 * order by 2 t (dy sx, -(sx dx + sz dz), dy sz): twice the slope.  Seen at the image's
 * depth zm that is a way on the screen of focal x share, share = t / zm = 1 - z / zm: at
 * an object's foot the mirror stays under it, and high masts are bent most.  zm is taken
 * by columns of the picture: an object's image lies below it, at its own depth.
 *
 * Water that stands h above the level has its image 2 h higher: the look goes down by
 * 2 h / zm, and h / zm = eye / zm + dy z / zm.
 *
 * Where a column has several objects, water mirrors its nearest as far as that stands and
 * an eighth farther; water beyond mirrors the farthest, and beyond that none: its rays go
 * on from there.
 *
 * Ways are linear in the slopes, with factors worked out at every 16th column. */
#include "features/reflection/mirror.h"
#include "shade/depth.h"
#include "shade/half.h"

/* Ways on the screen, 28.4 pixels: of a slope of 1 with a share of 1, of h / zm = 1. */
typedef struct {
    int32_t xu, xv, zu, zv, hu, hv;
    int32_t dy;                 /* of the ray, Q16 */
} push;

typedef struct {
    int32_t x, y, z;            /* Q16 */
} axis;

static axis axis_of(tp_dir3 d, int sign)
{
    return (axis){ sign * (d.x >> 14), sign * (d.y >> 14), sign * (d.z >> 14) };
}

/* Held within 2^20: 65536 pixels. */
static int32_t way(int64_t q16, int32_t focal)
{
    return (int32_t)tp_limit(q16 * focal >> 16, 1 << 20);
}

static int32_t ray_of(const tp_shade *shade, int32_t sixteenths)
{
    TP_ASSERT(shade->per_focal > 0);
    return (int32_t)tp_limit(tp_over_focal(shade, sixteenths), 1 << 27);
}

/* a b - c d in the format of one of them. */
TP_ALWAYS_INLINE int64_t crossed(int32_t a, int32_t b, int32_t c, int32_t d)
{
    return ((int64_t)a * b - (int64_t)c * d) >> 16;
}

/* Wide views have rays up to 300: 2^25 in Q16.  Held at 2048, so that cross products with
 * an axis stay below 2^30 and the products of two below 2^58. */
static push push_at(const tp_shade *shade, int32_t x, int32_t y)
{
    const tp_view_axes *axes = &shade->world;
    const axis r = axis_of(axes->right, 1), up = axis_of(axes->up, 1),
               a = axis_of(axes->back, -1);
    const int32_t qu = ray_of(shade, 16 * x + 8 - shade->u0);
    const int32_t qv = ray_of(shade, shade->v0 - 16 * y - 8);
    const int32_t dx = a.x + (int32_t)crossed(qu, r.x, -qv, up.x);
    const int32_t dy = a.y + (int32_t)crossed(qu, r.y, -qv, up.y);
    const int32_t dz = a.z + (int32_t)crossed(qu, r.z, -qv, up.z);
    const int32_t ax = (int32_t)crossed(dy, a.x, dx, a.y);
    const int32_t az = (int32_t)crossed(dy, a.z, dz, a.y);
    const int64_t xu = crossed(dy, r.x, dx, r.y) - ((int64_t)qu * ax >> 16);
    const int64_t zu = crossed(dy, r.z, dz, r.y) - ((int64_t)qu * az >> 16);
    const int64_t xv = crossed(dy, up.x, dx, up.y) - ((int64_t)qv * ax >> 16);
    const int64_t zv = crossed(dy, up.z, dz, up.y) - ((int64_t)qv * az >> 16);
    const int32_t focal = shade->focal;

    return (push){
        way(2 * xu, focal), way(-2 * xv, focal), way(2 * zu, focal), way(-2 * zv, focal),
        way(-2 * (r.y - ((int64_t)qu * a.y >> 16)), focal),
        way(2 * (up.y - ((int64_t)qv * a.y >> 16)), focal),
        (int32_t)tp_limit(dy, 1 << 26),
    };
}

static push step_between(const push *a, const push *b)
{
    return (push){ b->xu - a->xu, b->xv - a->xv, b->zu - a->zu, b->zv - a->zv,
                   b->hu - a->hu, b->hv - a->hv, b->dy - a->dy };
}

TP_ALWAYS_INLINE int32_t at(int32_t from, int32_t step, int32_t k)
{
    return from + (step * k >> 4);
}

/* z / zm in Q16, held below 2. */
TP_ALWAYS_INLINE int32_t depth_ratio(uint32_t zi_mirror, uint32_t key)
{
    uint32_t zi = tp_key_zi(key);
    int      shift = tp_clz(zi);
    uint64_t ratio = (uint64_t)zi_mirror * (uint32_t)tp_recip_rough(zi << shift)
                  >> (46 - shift);
    return ratio < 131071 ? (int32_t)ratio : 131071;
}

/* Ways stay below 2048 pixels.  Those of slopes fit 32 bits: factors below 2^20.6 times
 * slopes below 2^15. */
TP_ALWAYS_INLINE int32_t moved(int32_t by_x, int32_t sx, int32_t by_z, int32_t sz,
                               int32_t share, int32_t by_h, int32_t h)
{
    int32_t slope = (int32_t)(((int64_t)by_x * sx + (int64_t)by_z * sz) >> 12);
    return (int32_t)tp_limit(((int64_t)slope * share + (int64_t)by_h * h) >> 16, 1 << 15);
}

#define BESIDE (65536 + 8192)

/* The object's colour in the mirror at column x; 0: there is none. */
TP_ALWAYS_INLINE uint32_t seen(const tp_mirror *look, int32_t y, const push *a,
                               const push *step, int32_t x, uint32_t key, int32_t sx,
                               int32_t sz)
{
    const tp_half *half = &look->half;
    int32_t k = x & 15, last = half->x1 - half->x0 - 1;
    const tp_mirrored_zi *column =
        &look->zi[tp_clamp((x >> (1 + half->coarser)) - half->x0, 0, last)];
    uint32_t zi = column->near;
    int32_t ratio = depth_ratio(zi, key);
    if (ratio > BESIDE) {
        zi = column->far;
        ratio = depth_ratio(zi, key);
        if (ratio > 65536)
            return 0;
    }
    int32_t share = tp_clamp(65536 - ratio, 0, 65536) * look->bend >> 8;
    int64_t high = ((int64_t)zi * look->height >> 27)
                 + ((int64_t)at(a->dy, step->dy, k) * ratio >> 16);
    int32_t h = (int32_t)tp_limit(high, 1 << 20);

    int32_t du = moved(at(a->xu, step->xu, k), sx, at(a->zu, step->zu, k), sz, share,
                       at(a->hu, step->hu, k), h);
    int32_t dv = moved(at(a->xv, step->xv, k), sx, at(a->zv, step->zv, k), sz, share,
                       at(a->hv, step->hv, k), h);
    return tp_half_at(half, (16 * x + 8 + du) >> half->coarser,
                      (16 * y + 8 + dv) >> half->coarser);
}

void tp_stage_mirrored(const tp_shade *shade, tp_run *run)
{
    int32_t x = run->x, end = run->x + run->count;

    const tp_mirror *look = run->mine;

    if (!look->half.colour)
        return;
    push a = push_at(shade, x & ~15, run->y);
    for (int32_t i = 0; x < end; ) {
        int32_t next = (x & ~15) + 16, stop = next < end ? next : end;
        push b = push_at(shade, next, run->y), step = step_between(&a, &b);
        for (; x < stop; x++, i++) {
            uint32_t top = seen(look, run->y, &a, &step, x, run->key[i], run->sx[i],
                                run->sz[i]);
            if (top)
                run->mirror[i] = tp_colour_over(run->mirror[i], top);
        }
        a = b;
    }
}

const tp_stage tp_mirror_stages[] = {
#define X(name) tp_stage_##name,
    TP_STAGES_OF_mirror(X)
#undef X
};
