/* SPDX-License-Identifier: MIT */
/* Air between the eye and surfaces: colours fade to the horizon's colour.
 *
 * The share is z^2 / (z^2 + h^2): 1/2 at the distance h and 0 near the eye.  The rule is
 * the project's own.  It is smooth in 1/z, the depth of the G-buffer, so a short table is
 * enough.
 *
 * The horizon of a dome or a cube varies with direction.  The stage looks the horizon up
 * at every 16th column and interpolates linearly. */
#include "features/sky/sky.h"
#include "shade/env.h"
#include "shade/slope.h"

const tp_entry8 tp_haze_table[TP_HAZE + 1] = {
#include "features/sky/haze_table.inc"
};

TP_ALWAYS_INLINE uint32_t haze_share(uint32_t scale, uint32_t key)
{
    uint32_t entry = (uint32_t)((uint64_t)(key >> 1) * scale >> 32);
    return tp_haze_table[entry < TP_HAZE ? entry : TP_HAZE];
}

void tp_stage_haze(const tp_shade *restrict shade, tp_run *restrict run)
{
    const tp_haze *mine = run->mine;
    const uint32_t horizon = shade->sky[0], scale = mine->scale;
    const int32_t  count = run->count;

    for (int32_t i = 0; i < count; i++) {
        uint32_t share = haze_share(scale, run->key[i]);
        if (TP_WIDE || share > 0)
            run->colour[i] = tp_colour_mix(run->colour[i], horizon, share);
    }
}

/* Returns the horizon's colour in column x.  A cube is read at the mipmap level of the
 * sky view. */
TP_ALWAYS_INLINE uint32_t sample_horizon(const tp_shade *shade, tp_env_kind kind, int32_t x,
                                         int32_t y)
{
    tp_ray  ray = tp_vector_to_eye(shade, &shade->world, x, y);
    tp_dir3 d = tp_normalise(-ray.x, 0, -ray.z);
    int     level = tp_env_mip_level(shade, kind, 0);
    uint32_t light =
        tp_env_sample_kind(shade, kind, level, d.x >> 16, d.y >> 16, d.z >> 16);

    return tp_light_colour_clamped(shade, light);
}

/* Fades columns [k, k + count) of the 16 columns between the horizon's colours a and b. */
TP_ALWAYS_INLINE void haze_columns(uint32_t a, uint32_t b, uint32_t scale, int32_t k,
                                   int32_t count, const uint32_t *restrict key,
                                   uint32_t *restrict colour)
{
    for (int32_t i = 0; i < count; i++) {
        uint32_t horizon = tp_colour_mix(a, b, (uint32_t)(k + i) * 16);
        colour[i] = tp_colour_mix(colour[i], horizon, haze_share(scale, key[i]));
    }
}

/* Returns the first sample of [i, stop) that has haze, or `stop`. */
TP_ALWAYS_INLINE int32_t find_hazy(const tp_run *run, uint32_t scale, int32_t i,
                                   int32_t stop)
{
    while (i < stop && haze_share(scale, run->key[i]) == 0)
        i++;
    return i;
}

/* Samples without haze keep their colours: blocks without haze need no horizon. */
TP_ALWAYS_INLINE void haze_run(const tp_shade *restrict shade, tp_run *restrict run,
                               tp_env_kind kind)
{
    const tp_haze *mine = run->mine;
    const uint32_t scale = mine->scale;
    int32_t  known = -1;        /* column of the horizon's colour b */
    uint32_t b = 0;

    for (int32_t i = 0; i < run->count; ) {
        int32_t stop = tp_block_end(run, i), first = find_hazy(run, scale, i, stop);
        if (first < stop) {
            int32_t  x = (run->x + first) & ~15;
            uint32_t a = x == known ? b : sample_horizon(shade, kind, x, run->y);
            known = x + 16;
            b = sample_horizon(shade, kind, known, run->y);
            haze_columns(a, b, scale, run->x + first - x, stop - first,
                         run->key + first, run->colour + first);
        }
        i = stop;
    }
}

void tp_stage_haze_dome(const tp_shade *restrict shade, tp_run *restrict run)
{
    haze_run(shade, run, TP_ENV_DOME);
}

void tp_stage_haze_cube(const tp_shade *restrict shade, tp_run *restrict run)
{
    haze_run(shade, run, TP_ENV_CUBE);
}

/* -- the fast rung ------------------------------------------------------------------- */

/* The horizon's colours lie in a table around the compass, for any view.  A block of 16
 * samples reads its shares at three samples, and at two more if it has haze.  Both terms of
 * the sum colour (256 - share) + horizon share are linear between the block's ends.  Near
 * and far water in one block, and blocks cut by other samples, are mixed sample by sample.
 * A share of 1 / 255 counts as none. */

#define NO_HAZE 1u              /* largest share that is left out */
#define BENT    3               /* 255ths: most by which a share may differ from the line */
#define STEEP   64              /* 255ths: most by which the ends' shares may differ */

/* Returns the world direction of entry i of the table, level, Q1.14. */
static tp_dir3 horizon_direction(uint32_t i)
{
    const int32_t way = ((int32_t)(i % TP_HORIZON_SIDE) - TP_HORIZON_SIDE / 2)
                      * (2 * 16384 / TP_HORIZON_SIDE);
    const uint32_t side = i / TP_HORIZON_SIDE & 3;
    const int32_t x = side == 0 ? 16384 : side == 2 ? -16384 : side == 1 ? -way : way;
    const int32_t z = side == 1 ? 16384 : side == 3 ? -16384 : side == 0 ? way : -way;
    const tp_dir3 d = tp_normalise(x, 0, z);

    return (tp_dir3){ d.x >> 16, 0, d.z >> 16 };
}

void tp_horizon_make(uint32_t horizon[TP_HORIZON + 1], const tp_shade *shade)
{
    const tp_env_kind kind = shade->env.kind;
    const int level = tp_env_mip_level(shade, kind, 0);

    for (uint32_t i = 0; i <= TP_HORIZON; i++) {
        const tp_dir3 d = horizon_direction(i);
        horizon[i] = tp_light_colour_clamped(
            shade, tp_env_sample_kind(shade, kind, level, d.x, 0, d.z));
    }
}

/* Returns the horizon's colour in the direction (x, z), Q14, of length 1/2..4; a direction
 * straight up or down gets any colour. */
static uint32_t look_up_horizon(const uint32_t *horizon, int32_t x, int32_t z)
{
    const int32_t ax = x < 0 ? -x : x, az = z < 0 ? -z : z;
    const bool east = ax >= az;
    const int32_t most = east ? ax : az, way = east ? (x < 0 ? -z : z) : (z < 0 ? x : -x);
    const uint32_t side = east ? (x < 0 ? 2 : 0) : (z < 0 ? 3 : 1);
    const int shift = tp_clz((uint32_t)most | 1);
    const int32_t recip = tp_recip_rough(((uint32_t)most | 1) << shift);
    /* way / most in -1..1, Q12 */
    const int32_t ratio = (int32_t)((int64_t)way * recip >> (50 - shift));
    const int32_t at = tp_clamp(ratio + 4096, 0, 8191) * TP_HORIZON_SIDE / 32;
    const uint32_t *entry = horizon + side * TP_HORIZON_SIDE + (at >> 8);

    return tp_colour_mix(entry[0], entry[1], (uint32_t)at & 255);
}

/* Returns the horizon's colour in column x of a row. */
static uint32_t find_horizon(const tp_haze *mine, const tp_shade *shade,
                             const tp_quick_ray_row *row, int32_t x)
{
    if (!mine->around)
        return shade->sky[0];
    const tp_view_axes *a = &shade->world;
    const int32_t u = tp_quick_over_focal(shade, 16 * x + 8 - shade->u0);
    const tp_horizon *horizon = (const void *)mine;
    const int32_t x_q14 = (u * (a->right.x >> 16) >> 14) - row->x;
    const int32_t z_q14 = (u * (a->right.z >> 16) >> 14) - row->z;
    return look_up_horizon(horizon->colour, x_q14, z_q14);
}

/* Mixes a whole block: shares p and q at the first and the last sample.  t = 17 k / 256 is
 * 0..1 over the block.  A step is rounded down and the share is rounded up, so the term of
 * the horizon stays below 255 share, and each sum below 2^16. */
TP_ALWAYS_INLINE void mix_linear(uint32_t *colour, uint32_t a, uint32_t b, int32_t p,
                                 int32_t q)
{
    const int32_t red = (int32_t)(a >> 16 & 255) * p, blue = (int32_t)(a & 255) * p;
    const int32_t green = (int32_t)(a >> 8 & 255) * p;
    const int32_t red_step = ((int32_t)(b >> 16 & 255) * q - red) * 17 >> 8;
    const int32_t blue_step = ((int32_t)(b & 255) * q - blue) * 17 >> 8;
    const uint32_t g_step = (uint32_t)(((int32_t)(b >> 8 & 255) * q - green) * 17 >> 8);
    const uint32_t rb_step = (uint32_t)(red_step * 65536) + (uint32_t)blue_step;
    uint32_t rb = ((uint32_t)red << 16 | (uint32_t)blue) + TP_HALF_RB;
    uint32_t g = (uint32_t)green + 128;
    int32_t  share = p * 256 + 255;

    for (const uint32_t *end = colour + 16; colour < end; colour++) {
        const uint32_t left = 256 - ((uint32_t)share >> 8), c = *colour;
        *colour = tp_odd_bytes(tp_even_bytes(c) * left + rb)
                | (((c >> 8 & 255) * left + g) & 0xff00);
        share += (q - p) * 17;
        rb += rb_step;
        g += g_step;
    }
}

/* True if the shares of samples i..i + 15 lie on a line from p to q, at three samples: no
 * wave's crest hides farther water there. */
static bool is_linear(const tp_run *run, uint32_t scale, int32_t i, int32_t p, int32_t q)
{
    bool linear = tp_abs(p - q) <= STEEP;

    for (int32_t k = 4; k < 16; k += 4) {
        const int32_t share = (int32_t)haze_share(scale, run->key[i + k]);
        linear &= tp_abs(15 * (share - p) - k * (q - p)) <= 15 * BENT;
    }
    return linear;
}

/* Mixes samples [i, stop) of a block, some of which have haze: shares p and q at its
 * ends. */
TP_NEVER_INLINE void haze_block(const tp_shade *shade, tp_run *run, int32_t i, int32_t stop,
                                int32_t p, int32_t q)
{
    const tp_haze *mine = run->mine;
    const tp_quick_ray_row row = tp_quick_ray_row_make(shade, run->y);
    const int32_t  x = (run->x + i) & ~15;
    const uint32_t a = find_horizon(mine, shade, &row, x);
    const uint32_t b = find_horizon(mine, shade, &row, x + 16);

    if (stop - i == 16 && is_linear(run, mine->scale, i, p, q))
        mix_linear(run->colour + i, a, b, p, q);
    else
        haze_columns(a, b, mine->scale, run->x + i - x, stop - i, run->key + i,
                     run->colour + i);
}

void tp_stage_haze_fast(const tp_shade *shade, tp_run *run)
{
    const tp_haze *mine = run->mine;
    const uint32_t scale = mine->scale;

    for (int32_t i = 0, stop; i < run->count; i = stop) {
        stop = tp_block_end(run, i);
        const uint32_t first = haze_share(scale, run->key[i]);
        const uint32_t last = haze_share(scale, run->key[stop - 1]);
        const uint32_t middle = haze_share(scale, run->key[(i + stop) >> 1]);
        if (first > NO_HAZE || last > NO_HAZE || middle > NO_HAZE)
            haze_block(shade, run, i, stop, (int32_t)first, (int32_t)last);
    }
}

const tp_stage tp_haze_stages[] = {
#define X(name) tp_stage_##name,
    TP_STAGES_OF_haze(X)
#undef X
};
