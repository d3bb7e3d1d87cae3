/* SPDX-License-Identifier: MIT */
/*
 * The environment: the light that arrives from a direction.
 *
 * There are three kinds: a gradient by elevation; a dome, a generated sky of two
 * gradients, mixed by the angle to the light, with a glow around the light; a cube map of
 * six pictures [F7].  Directions are unit vectors in Q1.14 that point away from the eye; a
 * length error of a few hundredths does no harm.  Colours are 0xAARRGGBB; alpha is light
 * beyond white [F8].  Stages are written once and instantiated for each kind
 * (TP_ENV_KINDS): no loop tests the kind.
 *
 * A cube's pictures are seen from inside.  The four sides stand upright.  The lower edge
 * of the upper picture joins the south side; the upper edge of the lower picture does
 * too.
 */
#ifndef TP_SHADE_ENV_H
#define TP_SHADE_ENV_H
#include "shade/shade.h"
#include "tidepool/assets.h"

/* -- the gradient -------------------------------------------------------------------- */

/* Below the horizon the gradient has the horizon's colour. */

TP_ALWAYS_INLINE uint32_t tp_env_gradient(const tp_shade *shade, int32_t y)
{
    return shade->sky[tp_clamp(y >> 6, 0, TP_SKY)];
}

/* -- the dome ------------------------------------------------------------------------ */

/* Squared chord between two unit vectors, Q28: 2 - 2 cos. */
TP_ALWAYS_INLINE uint32_t tp_square_length(int32_t dx, int32_t dy, int32_t dz)
{
    return (uint32_t)(dx * dx) + (uint32_t)(dy * dy) + (uint32_t)(dz * dz);
}

TP_ALWAYS_INLINE uint32_t tp_glow_index(uint32_t square)
{
    const uint32_t n = square | 1;
    const int shift = TP_WIDE ? tp_clz_in_steps(n) : tp_clz(n);
    int32_t i = (tp_log2_q8_shifted(n, shift) >> 3) - TP_GLOW_STEP * TP_GLOW_LOG2;
    return (uint32_t)tp_clamp(i, 0, TP_GLOW);
}

/* Weight of the light's side, (1 + cos)^2 / 4, in 256ths. */
TP_ALWAYS_INLINE uint32_t tp_light_side_weight(uint32_t square)
{
    uint32_t t = square >> 22;
    t = t < 256 ? 256 - t : 0;
    return t * t >> 8;
}

TP_ALWAYS_INLINE uint32_t tp_light_chord_square(const tp_shade *shade, int32_t x, int32_t y,
                                                int32_t z)
{
    return tp_square_length(x - shade->world.lx, y - shade->world.ly, z - shade->world.lz);
}

/* Returns the glow at a squared chord of at least `least`, a minimum that leaves the disc
 * out. */
TP_ALWAYS_INLINE uint32_t tp_dome_lookup_glow(const tp_dome *dome, uint32_t least,
                                              uint32_t square)
{
    return dome->glow[tp_glow_index(square > least ? square : least)];
}

/* Returns the mixed gradients at height y plus `glow`; `light_chord_sq` is the squared
 * chord to the light.  Below the horizon the sky darkens, to a quarter within 11
 * degrees. */
TP_ALWAYS_INLINE uint32_t tp_dome_colour(const tp_dome *dome, uint32_t light_chord_sq,
                                         int32_t y, uint32_t glow)
{
    int32_t  sine = y >> 6, i = tp_clamp(sine, 0, TP_SKY);
    uint32_t base = tp_colour_mix(dome->away[i], dome->towards[i],
                                  tp_light_side_weight(light_chord_sq));

    if (sine < 0) {
        uint32_t left = (uint32_t)tp_clamp(256 + 4 * sine, 64, 256);
        return tp_colour_scale(tp_colour_add(base, glow), left);
    }
    return tp_colour_add(base, glow) | (glow & 0xff000000u);
}

TP_ALWAYS_INLINE uint32_t tp_env_dome(const tp_shade *shade, uint32_t least, int32_t x,
                                      int32_t y, int32_t z)
{
    const tp_dome *dome = shade->env.dome;
    uint32_t square = tp_light_chord_square(shade, x, y, z);

    return tp_dome_colour(dome, square, y, tp_dome_lookup_glow(dome, least, square));
}

/* -- the cube ------------------------------------------------------------------------ */

/* Returns the mask of the texels of a cube's face.  A PNG without alpha loads with alpha 255
 * in each texel.  No real face is that bright all over: such a face has no light beyond
 * white. */
static inline uint32_t tp_cube_face_mask(const tp_texture *face)
{
    TP_ASSERT(face->levels > 0 && face->levels <= TP_TEXTURE_LEVELS);
    return face->level[face->levels - 1][0] >> 24 == 255 ? 0x00ffffffu : 0xffffffffu;
}

/* A face of the cube, and the position on it: right / m and down / m, where m is the
 * largest component. */
typedef struct {
    int     face;
    int32_t right, down, m;
} tp_cube_ray;

TP_ALWAYS_INLINE tp_cube_ray tp_cube_face(int32_t x, int32_t y, int32_t z)
{
    int32_t ax = x < 0 ? -x : x, ay = y < 0 ? -y : y, az = z < 0 ? -z : z;

    if (ax >= ay && ax >= az)
        return (tp_cube_ray){ x < 0, x < 0 ? -z : z, -y, ax };
    if (ay >= az)
        return (tp_cube_ray){ 2 + (y < 0), -x, y < 0 ? -z : z, ay };
    return (tp_cube_ray){ 4 + (z < 0), z < 0 ? x : -x, -y, az };
}

/* Returns 2^29 / m for m in 8192..16383, linear between entries; the relative error of the
 * interpolation is within 2^-17. */
TP_ALWAYS_INLINE int32_t tp_cube_recip(const uint32_t *recip, int32_t m)
{
    uint32_t at = (uint32_t)(tp_clamp(m, 8192, 16383) - 8192);
    uint32_t a = recip[at >> 5], b = recip[(at >> 5) + 1];
    return (int32_t)(a - ((a - b) * (at & 31) >> 5));
}

typedef struct {
    int     face;
    int32_t s, t;               /* 0..65535, from the picture's top left corner */
    int32_t m;
} tp_cube_place;

/* Selects the face by the largest component; the other two over it give the position
 * [F7]. */
TP_ALWAYS_INLINE tp_cube_place tp_cube_project(const uint32_t *recip, int32_t x, int32_t y,
                                               int32_t z)
{
    tp_cube_ray c = tp_cube_face(x, y, z);
    int32_t r = tp_cube_recip(recip, c.m);

    return (tp_cube_place){
        c.face, tp_clamp(32768 + (c.right * r >> 14), 0, 65535),
        tp_clamp(32768 + (c.down * r >> 14), 0, 65535), c.m,
    };
}

/* One face at one mipmap level. */
typedef struct {
    const uint32_t *texel;
    int32_t log2_w, log2_h;
} tp_cube_face_level;

TP_ALWAYS_INLINE tp_cube_face_level tp_cube_face_level_select(const tp_texture *face,
                                                              int level)
{
    int l = level < face->levels ? level : face->levels - 1;
    return (tp_cube_face_level){ face->level[l], face->log2_w > l ? face->log2_w - l : 0,
                                 face->log2_h > l ? face->log2_h - l : 0 };
}

/* Four texels, clamped at the picture's edges: the index of the first one, the index steps
 * to the right and to the lower neighbour (0 at an edge), and the weights of both steps. */
typedef struct {
    int32_t  first, right, below;
    uint32_t fu, fv;
} tp_cube_four;

/* Returns the coordinate in 256ths of a texel, clamped to the texel centres; `ratio` is
 * -1/2..1/2 of a side, or slightly beyond. */
TP_ALWAYS_INLINE int32_t tp_cube_texel_coordinate(int32_t ratio, int32_t log2)
{
    int32_t u = ((32768 + ratio) * (1 << log2) >> 8) - 128;
    return tp_clamp(u, 0, (256 << log2) - 256);
}

TP_ALWAYS_INLINE tp_cube_four tp_cube_find_texels(const uint32_t *recip, int32_t m,
                                                  int32_t right, int32_t down,
                                                  int32_t log2_w, int32_t log2_h)
{
    int32_t r = tp_cube_recip(recip, m), w = 1 << log2_w, h = 1 << log2_h;
    int32_t u = tp_cube_texel_coordinate(right * r >> 14, log2_w);
    int32_t v = tp_cube_texel_coordinate(down * r >> 14, log2_h);
    int32_t u0 = u >> 8, v0 = v >> 8;

    return (tp_cube_four){ v0 * w + u0, u0 < w - 1, v0 < h - 1 ? w : 0,
                           (uint32_t)u & 255, (uint32_t)v & 255 };
}

/* Bilinear mix of the texels a b (upper) and c d (lower), all four bytes, rounded down. */
TP_ALWAYS_INLINE uint32_t tp_cube_mix(uint32_t a, uint32_t b, uint32_t c, uint32_t d,
                                      uint32_t fu, uint32_t fv)
{
    const uint32_t gu = 256 - fu, gv = 256 - fv;
    uint32_t rb = tp_odd_bytes(tp_even_bytes(a) * gu + tp_even_bytes(b) * fu);
    uint32_t ag = tp_odd_bytes(tp_odd_bytes(a) * gu + tp_odd_bytes(b) * fu);
    uint32_t low_rb = tp_odd_bytes(tp_even_bytes(c) * gu + tp_even_bytes(d) * fu);
    uint32_t low_ag = tp_odd_bytes(tp_odd_bytes(c) * gu + tp_odd_bytes(d) * fu);

    return tp_odd_bytes(rb * gv + low_rb * fv)
         | ((ag * gv + low_ag * fv) & 0xff00ff00u);
}

TP_ALWAYS_INLINE uint32_t tp_cube_sample(const tp_shade *shade, const tp_cube_ray *ray,
                                         const tp_cube_face_level *side)
{
    tp_cube_four f = tp_cube_find_texels(shade->env.recip, ray->m, ray->right, ray->down,
                                         side->log2_w, side->log2_h);
    const uint32_t *at = side->texel + f.first, *low = at + f.below;

    return tp_cube_mix(at[0], at[f.right], low[0], low[f.right], f.fu, f.fv)
         & shade->env.cube->mask[ray->face];
}

TP_ALWAYS_INLINE uint32_t tp_env_cube(const tp_shade *shade, int level, int32_t x,
                                      int32_t y, int32_t z)
{
    tp_cube_ray  ray = tp_cube_face(x, y, z);
    tp_cube_face_level side =
        tp_cube_face_level_select(shade->env.cube->face[ray.face], level);

    return tp_cube_sample(shade, &ray, &side);
}

/* -- any kind ------------------------------------------------------------------------ */

#define TP_ENV_KINDS(X) \
    X(gradient, TP_ENV_GRADIENT) \
    X(dome,     TP_ENV_DOME) \
    X(cube,     TP_ENV_CUBE)

/* `kind` is a literal or shade->env.kind; `level` is a cube's mipmap level. */
TP_ALWAYS_INLINE uint32_t tp_env_sample_kind(const tp_shade *shade, tp_env_kind kind,
                                             int level, int32_t x, int32_t y, int32_t z)
{
    return kind == TP_ENV_DOME ? tp_env_dome(shade, 0, x, y, z)
         : kind == TP_ENV_CUBE ? tp_env_cube(shade, level, x, y, z)
                               : tp_env_gradient(shade, y);
}

/* Returns a cube's mipmap level as the eye sees its pictures, plus `coarser` levels, Q8; 0
 * for other kinds. */
TP_ALWAYS_INLINE int tp_env_mip_level(const tp_shade *shade, tp_env_kind kind,
                                      int32_t coarser)
{
    if (kind != TP_ENV_CUBE)
        return 0;
    return tp_clamp((shade->env.cube->lod + coarser) >> 8, 0, TP_TEXTURE_LEVELS - 1);
}

/* Returns 0xAARRGGBB for the world direction (x, y, z). */
static inline uint32_t tp_env_sample(const tp_shade *shade, int32_t x, int32_t y,
                                     int32_t z)
{
    return tp_env_sample_kind(shade, shade->env.kind,
                              tp_env_mip_level(shade, shade->env.kind, 0), x, y, z);
}

/* True if exact stages add light beyond white, of which an alpha of 1 adds `beyond`; with
 * quality.exposure = fast none does.  The fast sky always adds it, at no cost. */
static inline bool tp_has_hdr_stages(uint32_t beyond, const tp_scene *scene)
{
    return beyond > 0 && scene->quality.exposure != TP_RUNG_FAST;
}

/* Returns 256 times the intensity of light with this alpha [F8]. */
TP_ALWAYS_INLINE uint32_t tp_hdr_gain(const tp_shade *shade, uint32_t light_argb)
{
    return 256 + ((light_argb >> 24) * shade->env.beyond >> 8);
}

/* Returns that light as a colour, each channel clamped to white. */
TP_ALWAYS_INLINE uint32_t tp_light_colour_clamped(const tp_shade *shade, uint32_t light)
{
    return tp_colour_brighten(light, tp_hdr_gain(shade, light));
}

/* -- the mirrored view vector -------------------------------------------------------- */

/*
 * The mirrored view vector [F3]: R = 2 (N.V) N - V.  Its height Ry is known already.  With
 * k = Ry + Vy = 2 (N.V) Ny and N = Ny (-sx, 1, -sz) the other components are -k sx - Vx
 * and -k sz - Vz.
 */

/* Fills rx and rz of sample i, Q1.14, and returns the mirrored vector.  A vector that
 * points down is made level. */
TP_ALWAYS_INLINE tp_ray tp_reflected_compute(tp_run *run, int32_t i)
{
    int32_t up = run->up[i], k = up + run->vy[i];
    int32_t rx = -(k * run->sx[i] >> 12) - run->vx[i];
    int32_t rz = -(k * run->sz[i] >> 12) - run->vz[i];

    rx = tp_clamp(rx, -16384, 16384);
    rz = tp_clamp(rz, -16384, 16384);
    run->rx[i] = (int16_t)rx;
    run->rz[i] = (int16_t)rz;
    return (tp_ray){ rx, up > 0 ? up : 0, rz, 0 };
}

#endif
