/* SPDX-License-Identifier: MIT */
/*
 * Span stages of reflected objects, over the reflected sky: from the planar map, or from
 * the object cube map.
 */
#include "features/reflection/reflection.h"
#include "shade/shade.h"

/* -- the planar map ------------------------------------------------------------------ */

/* A look-up in the planar map, displaced by the slope.
 *
 * The map shows the image of each object in level water, below the level.  Let d be the
 * view ray with 1 along the camera's axis, so water at depth z lies at eye + z d.  A
 * normal (-sx, 1, -sz) turns the reflected ray.  At the distance t the image moves to
 * first order by 2 t (dy sx, -(sx dx + sz dz), dy sz): twice the slope.  At the image's
 * depth zm the displacement on the screen is focal x share, share = t / zm = 1 - z / zm.
 * At the foot of an object the image therefore stays in place, and high masts move most.
 * zm is stored for each column of the map, because an object's image lies below the
 * object, at the same depth.
 *
 * Water h above the level has its image 2 h higher.  The look-up moves down by 2 h / zm,
 * and h / zm = eye / zm + dy z / zm.
 *
 * In a column with several objects, tp_mirror_find_object picks one.
 *
 * Displacements are linear in the slopes; their factors are computed at every 16th
 * column. */

typedef struct {
    int32_t x, y, z;            /* direction, Q16 */
} axis;

static axis make_axis(tp_dir3 d, int sign)
{
    return (axis){ sign * (d.x >> 14), sign * (d.y >> 14), sign * (d.z >> 14) };
}

/* Returns a displacement, clamped to 2^20: 65536 px. */
static int32_t clamped_displacement(int64_t q16, int32_t focal)
{
    return (int32_t)tp_clamp_abs(q16 * focal >> 16, 1 << 20);
}

/* Returns the tangent of a screen offset from the centre, in 1/16 px, over the focal
 * length; Q16, clamped. */
static int32_t ray_coordinate(const tp_shade *shade, int32_t sixteenths)
{
    TP_ASSERT(shade->per_focal > 0);
    return (int32_t)tp_clamp_abs(tp_over_focal(shade, sixteenths), 1 << 27);
}

/* Returns a b - c d in the format of one factor. */
TP_ALWAYS_INLINE int64_t difference_of_products(int32_t a, int32_t b, int32_t c, int32_t d)
{
    return ((int64_t)a * b - (int64_t)c * d) >> 16;
}

/* Computes the factors at column x.  Wide views have rays up to 300, 2^25 in Q16.  Rays
 * are clamped to 2048, so cross products with an axis stay below 2^30 and products of two
 * such numbers below 2^58. */
tp_mirror_push tp_mirror_push_make(const tp_shade *shade, int32_t x, int32_t y)
{
    const tp_view_axes *axes = &shade->world;
    const axis r = make_axis(axes->right, 1), up = make_axis(axes->up, 1),
               a = make_axis(axes->back, -1);
    const int32_t qu = ray_coordinate(shade, 16 * x + 8 - shade->u0);
    const int32_t qv = ray_coordinate(shade, shade->v0 - 16 * y - 8);
    const int32_t dx = a.x + (int32_t)difference_of_products(qu, r.x, -qv, up.x);
    const int32_t dy = a.y + (int32_t)difference_of_products(qu, r.y, -qv, up.y);
    const int32_t dz = a.z + (int32_t)difference_of_products(qu, r.z, -qv, up.z);
    const int32_t ax = (int32_t)difference_of_products(dy, a.x, dx, a.y);
    const int32_t az = (int32_t)difference_of_products(dy, a.z, dz, a.y);
    const int64_t xu =
        difference_of_products(dy, r.x, dx, r.y) - ((int64_t)qu * ax >> 16);
    const int64_t zu =
        difference_of_products(dy, r.z, dz, r.y) - ((int64_t)qu * az >> 16);
    const int64_t xv =
        difference_of_products(dy, up.x, dx, up.y) - ((int64_t)qv * ax >> 16);
    const int64_t zv =
        difference_of_products(dy, up.z, dz, up.y) - ((int64_t)qv * az >> 16);
    const int32_t focal = shade->focal;

    return (tp_mirror_push){
        clamped_displacement(2 * xu, focal),
        clamped_displacement(-2 * xv, focal),
        clamped_displacement(2 * zu, focal),
        clamped_displacement(-2 * zv, focal),
        clamped_displacement(-2 * (r.y - ((int64_t)qu * a.y >> 16)), focal),
        clamped_displacement(2 * (up.y - ((int64_t)qv * a.y >> 16)), focal),
        (int32_t)tp_clamp_abs(dy, 1 << 26),
    };
}

static tp_mirror_push push_change_per_block(const tp_mirror_push *from,
                                            const tp_mirror_push *to)
{
    return (tp_mirror_push){
        to->xu - from->xu, to->xv - from->xv, to->zu - from->zu, to->zv - from->zv,
        to->hu - from->hu, to->hv - from->hv, to->dy - from->dy,
    };
}

/* Returns a factor at column k of a block of 16 columns.  `from` is the factor at column 0,
 * `step` the difference to column 0 of the next block. */
TP_ALWAYS_INLINE int32_t interpolate_in_block(int32_t from, int32_t step, int32_t k)
{
    return from + (step * k >> 4);
}

/* Returns a displacement below 2048 px.  Displacements by slopes fit 32 bits: factors
 * below 2^20.6 times slopes below 2^15. */
TP_ALWAYS_INLINE int32_t pixel_displacement(int32_t by_x, int32_t sx, int32_t by_z,
                                            int32_t sz, int32_t share, int32_t by_h,
                                            int32_t h)
{
    int32_t slope = (int32_t)(((int64_t)by_x * sx + (int64_t)by_z * sz) >> 12);
    return (int32_t)tp_clamp_abs(((int64_t)slope * share + (int64_t)by_h * h) >> 16,
                                 1 << 15);
}

/* Returns the colour of the reflected object at column x; 0: no object. */
TP_ALWAYS_INLINE uint32_t sample_reflected_object(const tp_mirror *look, int32_t y,
                                                  const tp_mirror_push *a,
                                                  const tp_mirror_push *step,
                                                  int32_t x, uint32_t key, int32_t sx,
                                                  int32_t sz, int packed)
{
    const tp_planar_map *map = &look->map;
    int32_t k = x & 15, ratio;
    uint32_t zi;

    if (!tp_mirror_find_object(look, x, key, &zi, &ratio))
        return 0;
    int32_t share = tp_clamp(65536 - ratio, 0, 65536) * look->bend >> 8;
    int64_t high = ((int64_t)zi * look->height >> 27)
                   + ((int64_t)interpolate_in_block(a->dy, step->dy, k) * ratio >> 16);
    int32_t h = (int32_t)tp_clamp_abs(high, 1 << 20);

    int32_t du = pixel_displacement(interpolate_in_block(a->xu, step->xu, k), sx,
                                    interpolate_in_block(a->zu, step->zu, k), sz, share,
                                    interpolate_in_block(a->hu, step->hu, k), h);
    int32_t u = tp_planar_map_position(map, 16 * x + 8 + du);
    if (tp_planar_map_misses_column(map, u))
        return 0;
    int32_t dv = pixel_displacement(interpolate_in_block(a->xv, step->xv, k), sx,
                                    interpolate_in_block(a->zv, step->zv, k), sz, share,
                                    interpolate_in_block(a->hv, step->hv, k), h);
    return tp_mirror_sample(map, u, tp_planar_map_position(map, 16 * y + 8 + dv), packed);
}

#include "features/reflection/reflection_wide.h"

TP_ALWAYS_INLINE void mirror_run(const tp_shade *shade, tp_run *run, int packed)
{
    int32_t x = run->x, end = run->x + run->count;

    const tp_mirror *look = run->mine;

    if (!look->map.colour)
        return;
    tp_mirror_push a = tp_mirror_push_make(shade, x & ~15, run->y);
    for (int32_t i = 0; x < end; ) {
        int32_t next = (x & ~15) + 16, stop = next < end ? next : end;
        tp_mirror_push b = tp_mirror_push_make(shade, next, run->y),
             step = push_change_per_block(&a, &b);
        if (TP_WIDE && !packed && look->height >= 0 && look->height <= UINT32_MAX) {
            mirror_columns_wide(look, run, &a, &step, i, stop - x);
            i += stop - x;
            x = stop;
        }
        for (; x < stop; x++, i++) {
            uint32_t top = sample_reflected_object(look, run->y, &a, &step, x,
                                                   run->key[i], run->sx[i], run->sz[i],
                                                   packed);
            if (top)
                run->mirror[i] = tp_colour_composite(run->mirror[i], top);
        }
        a = b;
    }
}

void tp_stage_mirrored(const tp_shade *shade, tp_run *run)
{
    mirror_run(shade, run, 0);
}

void tp_stage_mirrored_packed(const tp_shade *shade, tp_run *run)
{
    mirror_run(shade, run, 1);
}

const tp_stage tp_mirror_stages[] = {
#define X(name) tp_stage_##name,
    TP_STAGES_OF_mirror(X)
#undef X
};

/* -- the object cube map ------------------------------------------------------------- */

/* A cube is exact for the single point of its drawing.  With a look-up by direction alone
 * the boat's reflection would move with the camera all over the water.  The stage
 * therefore intersects the reflected ray with a vertical plane through the objects'
 * middle, facing the point, and looks up the direction from the point to the
 * intersection.  The result is exact for objects in the plane.  With n the plane's
 * normal, a = (middle - p).n, b = r.n, the direction is (p - point) + r a / b.  A cube
 * accepts vectors of any length, so the stage uses b times the vector and needs no
 * division. */

typedef struct {
    int64_t x, y, z;
} cube_way;

static int64_t magnitude(int64_t x)
{
    return x < 0 ? -x : x;
}

static uint32_t texel(const uint32_t *face, int32_t i, int32_t j)
{
    return face[tp_clamp(j, 0, TP_OBJECT_CUBE_SIDE - 1) * TP_OBJECT_CUBE_SIDE
                + tp_clamp(i, 0, TP_OBJECT_CUBE_SIDE - 1)];
}

/* Returns the number of the face hit by *w.  Sets the coordinates right and up on the
 * face, and `ahead`, the largest of the three. */
static int find_cube_face(const cube_way *w, int64_t *right, int64_t *up, int64_t *ahead)
{
    int64_t ax = magnitude(w->x), az = magnitude(w->z);
    int     face = ax >= az ? w->x < 0 : 2 + (w->z < 0);

    *up = w->y;
    *ahead = ax >= az ? ax : az;
    *right = face == 0 ? w->z : face == 1 ? -w->z : face == 2 ? -w->x : w->x;
    if (w->y > *ahead) {
        *right = w->x;
        *up = w->z;
        *ahead = w->y;
        return 4;
    }
    return face;
}

/* Returns the colour, bilinear within one face.  The divisor `ahead` is shifted below
 * 2^31. */
static uint32_t sample_cube(const tp_object_cube *cube, const cube_way *w)
{
    int64_t right, up, ahead;
    int     face = find_cube_face(w, &right, &up, &ahead), down = 0;

    if (ahead <= 0 || up < -ahead)
        return 0;
    while (ahead >> down >= (int64_t)1 << 31)
        down++;
    uint32_t n = (uint32_t)(ahead >> down);
    int      shift = tp_clz(n);
    int64_t  r = tp_recip_rough(n << shift);    /* 2^(62 - shift) / n */
    int64_t  scale = TP_OBJECT_CUBE_SIDE / 2 * 32;     /* 1/32 texel */
    int32_t  u = (int32_t)(((right >> down) * r >> (46 - shift)) * scale >> 16);
    int32_t  v = (int32_t)(((up >> down) * r >> (46 - shift)) * scale >> 16);
    const uint32_t *from = cube->colour + face * TP_OBJECT_CUBE_SIDE * TP_OBJECT_CUBE_SIDE;
    int32_t  i = (int32_t)scale + u - 16, j = (int32_t)scale - v - 16;
    uint32_t fi = (uint32_t)i & 31, fj = (uint32_t)j & 31;

    i >>= 5;
    j >>= 5;
    return tp_argb_mix_32nds(
        tp_argb_mix_32nds(texel(from, i, j), texel(from, i + 1, j), fi),
        tp_argb_mix_32nds(texel(from, i, j + 1), texel(from, i + 1, j + 1), fi), fj);
}

/* Returns the view ray at column x with 1 along the camera's axis, Q16. */
static cube_way compute_view_ray(const tp_shade *shade, int32_t x, int32_t y)
{
    const tp_view_axes *a = &shade->world;
    const int64_t u = tp_over_focal(shade, 16 * x + 8 - shade->u0);
    const int64_t v = tp_over_focal(shade, shade->v0 - 16 * y - 8);

    return (cube_way){
        (((u * a->right.x + v * a->up.x) >> 16) - a->back.x) >> 14,
        (((u * a->right.y + v * a->up.y) >> 16) - a->back.y) >> 14,
        (((u * a->right.z + v * a->up.z) >> 16) - a->back.z) >> 14,
    };
}

/* Returns the vector from the point to the water at a pixel, m, 16.16. */
static cube_way viewpoint_to_water(const tp_object_cube *cube, const cube_way *ray,
                                   uint32_t key)
{
    int64_t z = tp_depth_from_zi(cube->zi_near, tp_key_zi(key));

    return (cube_way){ cube->from.x + (ray->x * z >> 16), cube->from.y + (ray->y * z >> 16),
                  cube->from.z + (ray->z * z >> 16) };
}

/* Draws the objects' cube map over the sky's reflection, where the mirrored ray meets the
 * vertical plane through the middle of the objects.  Lengths have 8 fraction bits of a
 * metre, are below 2^25, and are multiplied by 14 bits. */
void tp_stage_mirrored_object_cube(const tp_shade *shade, tp_run *run)
{
    const tp_object_cube *cube = run->mine;

    if (!cube->colour)
        return;
    for (int32_t i = 0; i < run->count; i++) {
        int64_t rx = run->rx[i], ry = run->up[i], rz = run->rz[i];
        cube_way ray = compute_view_ray(shade, run->x + i, run->y);
        cube_way p = viewpoint_to_water(cube, &ray, run->key[i]);
        int64_t a = ((cube->to.x - p.x) * cube->nx + (cube->to.z - p.z) * cube->nz) >> 22;
        int64_t b = (rx * cube->nx + rz * cube->nz) >> 14;
        if (a <= 0 || b <= 0)       /* behind the plane, or the ray leads away from it */
            continue;
        cube_way w = { rx * a + (p.x >> 8) * b, ry * a + (p.y >> 8) * b,
                       rz * a + (p.z >> 8) * b };
        uint32_t top = sample_cube(cube, &w);
        if (top)
            run->mirror[i] = tp_colour_composite(run->mirror[i], top);
    }
}

const tp_stage tp_object_cube_stages[] = {
#define X(name) tp_stage_##name,
    TP_STAGES_OF_object_cube(X)
#undef X
};
