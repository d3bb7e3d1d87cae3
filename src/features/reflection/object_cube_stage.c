/* SPDX-License-Identifier: MIT */
/* The object cube map on the water: reflected objects from a small cube of pictures.
 *
 * A cube is exact for the single point of its drawing.  With a look-up by direction alone
 * the boat's reflection would move with the camera all over the water.  The stage
 * therefore intersects the reflected ray with a vertical plane through the objects'
 * middle, facing the point, and looks up the direction from the point to the
 * intersection.  The result is exact for objects in the plane.  With n the plane's
 * normal, a = (middle - p).n, b = r.n, the direction is (p - point) + r a / b.  A cube
 * accepts vectors of any length, so the stage uses b times the vector and needs no
 * division. */
#include "features/reflection/object_cube.h"
#include "shade/depth.h"
#include "shade/half.h"

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
    return tp_argb_mix_32(
        tp_argb_mix_32(texel(from, i, j), texel(from, i + 1, j), fi),
        tp_argb_mix_32(texel(from, i, j + 1), texel(from, i + 1, j + 1), fi), fj);
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
static cube_way water_offset(const tp_object_cube *cube, const cube_way *ray, uint32_t key)
{
    int64_t z = tp_depth_from_zi(cube->zi_near, tp_key_zi(key));

    return (cube_way){ cube->from.x + (ray->x * z >> 16), cube->from.y + (ray->y * z >> 16),
                  cube->from.z + (ray->z * z >> 16) };
}

/* Lengths have 8 fraction bits of a metre, are below 2^25, and are multiplied by 14
 * bits. */
void tp_stage_mirrored_cube(const tp_shade *shade, tp_run *run)
{
    const tp_object_cube *cube = run->mine;

    if (!cube->colour)
        return;
    for (int32_t i = 0; i < run->count; i++) {
        int64_t rx = run->rx[i], ry = run->up[i], rz = run->rz[i];
        cube_way ray = compute_view_ray(shade, run->x + i, run->y);
        cube_way p = water_offset(cube, &ray, run->key[i]);
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
