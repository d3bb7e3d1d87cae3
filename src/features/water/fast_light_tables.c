/* SPDX-License-Identifier: MIT */
/*
 * Tables of light for fast shading, made from the tables of the exact stages, and the
 * choice of a table for a span.  See fast_shading.h.
 */
#include "features/water/fast_shading.h"
#include "features/water/water.h"
#include "shade/colour.h"
#include "shade/env.h"
#include "shade/rough_lobe.h"

/* -- levels of roughness ------------------------------------------------------------- */

#define RIPPLED_VIEW 1638               /* same value as in lighting_stage.c */
#define FAR_AWAY (24 * 256)             /* log2 of a depth that shows the last level */

/* Slope variances of the levels, Q24: none, then three times the one before.  A level's
 * root reaches half way to the roots of its neighbours. */
static const uint32_t variance_of_level[TP_QUICK_LEVELS] = { 0, 32768, 98304, 294912 };
static const uint32_t variance_from[TP_QUICK_LEVELS] = { 0, 8192, 61158, 183475 };

/* Heights of the vector to the eye, Q14, that the levels' skies are made for: water of
 * much variance is far away. */
static const int32_t view_height[TP_QUICK_LEVELS] = { 0, 2048, 1311, 819 };

/* A level while its tables are made.  least: lower bound of N.V, Q14. */
typedef struct {
    uint32_t number, share_at_sun;
    int32_t  least, vy;
    tp_rough_view view;
} rough_level;

uint32_t tp_quick_ripple_variance(const tp_shade *shade)
{
    return shade->ripple ? tp_rough_ripple_variance(shade->ripple, FAR_AWAY) : 0;
}

/* Ripples are lost near the eye, waves far away: a level has ripples first. */
static rough_level rough_level_make(const tp_shade *shade, uint32_t number, int32_t least)
{
    const uint32_t variance = variance_of_level[number];
    const uint32_t all = tp_quick_ripple_variance(shade);
    const uint32_t ripples = all < variance ? all : variance;

    return (rough_level){ number, tp_quick_share_at_sun(shade), least,
                          view_height[number],
                          tp_rough_view_make(ripples, variance - ripples) };
}

/* Returns N.V as water of a level shows it, Q14. */
static int32_t rough_cosine(const rough_level *level, int32_t n)
{
    const int32_t bent = level->number ? tp_rough_view_cosine(n, &level->view) : n;
    return tp_clamp(bent, level->least, 16384);
}

/* Returns the mirrored height at n = N.V, seen from the height vy; both Q14. */
static int32_t mirrored_height(const rough_level *level, int32_t n, int32_t vy)
{
    const int32_t up = 2 * rough_cosine(level, n) - vy;
    return level->number ? up * level->view.height >> 14 : up;
}

/* -- Fresnel's share ----------------------------------------------------------------- */

/* Fills the table of shares.  In the middle of entry i, n is the lower bound plus
 * (i + 1/2) / 256. */
static void fill_fresnel_by_view_cosine(tp_quick_rough *rough, const tp_shade *shade,
                                        const rough_level *level)
{
    for (int32_t i = 0; i < TP_QUICK_SHARES; i++) {
        const int32_t n = rough_cosine(level, (rough->least >> 12) + 64 * i + 64);
        const uint32_t mirrors = shade->fresnel[n >> 6] * (uint32_t)shade->mirror >> 8;
        rough->share[i] = (256 - mirrors) << 16 | (mirrors + 1);
    }
}

/* Returns the root of a Q28 number, Q14. */
static int32_t root_q14(int32_t q28)
{
    return (int32_t)tp_isqrt64((uint64_t)(q28 > 0 ? q28 : 0));
}

/* Returns Fresnel's share at the sun's image, for a view with the camera's pitch.
 * N.L = N.V is the cosine of half the angle between sun and view, on opposite sides. */
uint32_t tp_quick_share_at_sun(const tp_shade *shade)
{
    int32_t l = shade->world.ly, v = tp_clamp(shade->world.back.y >> 16, 0, 16384);
    int32_t far = (root_q14((1 << 28) - l * l) * root_q14((1 << 28) - v * v)) >> 14;
    int32_t cos_lv = tp_clamp((l * v >> 14) - far, -16384, 16384);

    return shade->fresnel[root_q14((16384 + cos_lv) << 13) >> 6]
         * (uint32_t)shade->mirror >> 8;
}

/* -- the lobe ------------------------------------------------------------------------ */

/* A lobe widened by a factor: 1 over the factor, and its peak; Q14. */
typedef struct {
    int32_t narrow, peak;
} wide_lobe;

static wide_lobe wide_lobe_make(const tp_shade *shade, const rough_level *level)
{
    if (level->number == 0)
        return (wide_lobe){ 16384, 16384 };
    const int32_t narrow = tp_rough_narrowing(shade->lobe.exponent,
                                              variance_of_level[level->number]);
    return (wide_lobe){ narrow, tp_rough_peak(&shade->lobe, narrow) };
}

/* Returns the specular lobe at a cosine, 0..256. */
static uint32_t wide_lobe_shine(const tp_shade *shade, wide_lobe lobe, int32_t c)
{
    const int32_t  wide = 16384 - ((16384 - c) * lobe.narrow >> 14);
    const uint32_t up = (uint32_t)tp_clamp(wide, 0, 16384);
    const uint32_t here = shade->shine[up >> 4], next = shade->shine[(up + 15) >> 4];
    const uint32_t shine = here + (((next - here) * (up & 15)) >> 4);
    const uint32_t share = shine * (uint32_t)lobe.peak >> 14;

    return share < 256 ? share : 256;
}

/* The glow of a dome at one entry: its squared chord to the light, Q28, and the share of it
 * that is mirrored, 0..256. */
typedef struct {
    uint32_t square, share;
} mirrored_glow;

/* Returns the glow that a level mirrors where smooth water mirrors the direction at a chord
 * to the light: the mirrored ray is raised and lowered as that of the sky is.  Rays are
 * taken below the light, by at most what level water has, and the rest aside.  A level is
 * seen from more heights than one, so its share is the mean of that and of level 0. */
static mirrored_glow raise_glow(const tp_shade *shade, const rough_level *level,
                                uint32_t square)
{
    const int32_t chord = (int32_t)tp_isqrt64(square), ly = shade->world.ly;
    const int32_t most = ly > level->vy ? ly - level->vy : 0;
    const int32_t below = chord < most ? chord : most;
    const int32_t n = (ly - below + level->vy) / 2;
    const int32_t left = ly - mirrored_height(level, n, level->vy);

    return (mirrored_glow){
        square - (uint32_t)(below * below) + (uint32_t)(left * left),
        (level->share_at_sun + (shade->fresnel[rough_cosine(level, n) >> 6]
                                * (uint32_t)shade->mirror >> 8)) / 2,
    };
}

/* Returns the colour of the specular lobe, if `specular`, plus the glow of a dome.  c:
 * cosine of the angle from the lobe's axis, R.V or 2 (N.H)^2 - 1, Q14. */
static uint32_t lobe_colour(const tp_shade *shade, int32_t c, bool specular,
                            const rough_level *level, wide_lobe wide)
{
    const uint32_t light = specular ? tp_colour_scale(shade->light_colour,
                                                      wide_lobe_shine(shade, wide, c))
                                    : 0;
    mirrored_glow at = { (uint32_t)(16384 - c) << 15, level->share_at_sun };

    if (shade->env.kind != TP_ENV_DOME)
        return light;
    if (level->number)
        at = raise_glow(shade, level, at.square);
    const uint32_t glow = tp_dome_lookup_glow(shade->env.dome, shade->env.least, at.square);
    return tp_colour_add(light, tp_colour_scale(glow & 0xffffff, at.share));
}

/* Fills the lobe's table.  In the middle of entry i, w is (i + 1/2) / 2048.  For Phong
 * R.V is 1 - w.  For Blinn w is the square of the tangent, and c = (1 - w) / (1 + w). */
static void fill_lobe(tp_quick_rough *rough, const tp_shade *shade, tp_lobe lobe,
                      bool specular, const rough_level *level)
{
    const wide_lobe wide = wide_lobe_make(shade, level);

    for (int32_t i = 0; i < TP_QUICK_LOBE; i++) {
        int32_t w = 8 * i + 4;
        int32_t c = lobe == TP_LOBE_BLINN ? (16384 - w) * 16384 / (16384 + w)
                                          : 16384 - w;
        rough->lobe[i] = lobe_colour(shade, c, specular, level, wide);
    }
}

/* -- columns of heights -------------------------------------------------------------- */

/* Returns the sky as mirrored at a height.  A reflected view downwards meets other water,
 * with a share of the horizon's brightness by the rule of lighting_stage.c. */
static uint32_t darken_sky_below_horizon(uint32_t sky, int32_t up)
{
    return tp_colour_scale(sky, (uint32_t)tp_clamp(256 + 4 * up, 128, 256));
}

/* Returns the mirrored sky at a height in 256ths, of a dome by its sunny side's share. */
static uint32_t mirrored_sky_colour(const tp_shade *shade, int32_t up, uint32_t share)
{
    const tp_dome *dome = shade->env.kind == TP_ENV_DOME ? shade->env.dome : NULL;
    const int32_t at = tp_clamp(up, 0, TP_SKY);
    const uint32_t sky = dome ? tp_colour_mix(dome->away[at], dome->towards[at], share)
                              : shade->sky[at];

    return darken_sky_below_horizon(sky, up);
}

/* Fills the columns of heights of smooth water.  Entry i is in the middle of a 32nd; `up`
 * is in 256ths.  A gradient has one column; a dome has 16, mixed from its two sides. */
static void fill_smooth_sky(const tp_quick_tables *quick, const tp_shade *shade)
{
    const int32_t least = quick->rough[0].least >> 18;

    for (uint32_t k = 0; k < (shade->env.kind == TP_ENV_DOME ? 16 : 1); k++)
        for (int32_t i = 0; i < TP_QUICK_HEIGHTS; i++) {
            const int32_t up = 8 * (i - TP_QUICK_HEIGHTS / 2) + 4 + least;
            quick->sky[k * TP_QUICK_HEIGHTS + (uint32_t)i] =
                mirrored_sky_colour(shade, up, 16 * k + 8);
        }
}

/* -- the sky of rough water ---------------------------------------------------------- */

/* A pixel looks the sky up by up = 2 n - vy, as on smooth water, n = N.V and vy the height
 * of the vector to the eye.  Rough water mirrors the height (2 f(n) - vy) h [V3, V5], f and
 * h by the variance.  At one vy, view_height, that is a function of up alone, and so a
 * column.  For another vy the span moves the column by some entries, so many that level
 * water, n = vy, mirrors its height; f is nearly linear, so steeper water nearly does. */

enum { MARGIN = (TP_QUICK_ROUGH_HEIGHTS - TP_QUICK_HEIGHTS) / 2 };

/* Returns the first entry of a column of a level above 0. */
static uint32_t rough_sky_place(uint32_t level, bool dome, uint32_t column)
{
    const uint32_t smooth = dome ? 16 : 1, rough = dome ? TP_QUICK_ROUGH_COLUMNS : 1;

    return TP_QUICK_HEIGHTS * smooth
         + TP_QUICK_ROUGH_HEIGHTS * ((level - 1) * rough + column);
}

/* Returns the height that the column has at `up` for level water seen from the height vy,
 * before the lower sky; Q14. */
static int32_t column_height(const rough_level *level, int32_t up)
{
    return 2 * rough_cosine(level, (up + level->vy) / 2) - level->vy;
}

/* Fills the entries by which a span moves the column.  Heights rise with up. */
static void fill_shifts(tp_quick_rough *rough, const rough_level *level)
{
    for (int32_t i = 0; i < TP_QUICK_VIEWS; i++) {
        const int32_t vy = (16384 * i + 8192) / TP_QUICK_VIEWS;
        const int32_t height = 2 * rough_cosine(level, vy) - vy;
        int32_t shift = -MARGIN;
        while (shift < MARGIN && column_height(level, vy + 512 * shift + 256) < height)
            shift++;
        rough->shift[i / 4] = rough->shift[i / 4] >> 8 | (uint32_t)shift << 24;
    }
}

static void fill_rough_sky(const tp_quick_tables *quick, const tp_shade *shade,
                           const rough_level *level)
{
    const bool dome = shade->env.kind == TP_ENV_DOME;
    const int32_t least = quick->rough[level->number].least >> 12;

    fill_shifts(&quick->rough[level->number], level);
    for (int32_t i = 0; i < TP_QUICK_ROUGH_HEIGHTS; i++) {
        const int32_t up = 512 * (i - MARGIN - TP_QUICK_HEIGHTS / 2) + 256 + least;
        const int32_t at = mirrored_height(level, (up + level->vy) / 2, level->vy) / 64;
        for (uint32_t k = 0; k < (dome ? TP_QUICK_ROUGH_COLUMNS : 1); k++)
            quick->sky[rough_sky_place(level->number, dome, k) + (uint32_t)i] =
                mirrored_sky_colour(shade, at, 256 / TP_QUICK_ROUGH_COLUMNS * k
                                                   + 128 / TP_QUICK_ROUGH_COLUMNS);
    }
}

/* -- all tables ---------------------------------------------------------------------- */

void tp_quick_light_init(const tp_quick_tables *quick, const tp_shade *shade,
                         tp_lobe lobe, bool specular, bool rippled)
{
    TP_ASSERT((unsigned)lobe <= TP_LOBE_BLINN && shade->fresnel != NULL);
    const bool cube = shade->env.kind == TP_ENV_CUBE;
    const int32_t least = rippled ? RIPPLED_VIEW : 0;

    for (uint32_t k = 0; k < quick->levels; k++) {
        const rough_level level = rough_level_make(shade, k, least);
        tp_quick_rough *rough = &quick->rough[k];
        rough->least = k == 0 || cube ? least << 12 : 0;
        rough->beyond = shade->env.beyond;
        fill_fresnel_by_view_cosine(rough, shade, &level);
        fill_lobe(rough, shade, lobe, specular, &level);
        if (k > 0 && !cube)
            fill_rough_sky(quick, shade, &level);
    }
    if (!cube)
        fill_smooth_sky(quick, shade);
}

/* -- the water of a span ------------------------------------------------------------- */

/* Returns log2 of the depth, m, Q8, at which level water is seen at a height vy of the
 * vector to the eye, Q26. */
static int32_t log_depth_of_level_water(const tp_shade *shade, int32_t vy)
{
    const int64_t above = shade->eye.y > 1 << 12 ? shade->eye.y : 1 << 12;

    return tp_log2_q8((uint32_t)above) - tp_log2_q8((uint32_t)(vy > 1 ? vy : 1)) + 10 * 256;
}

/* Returns the level of a variance of up to 2. */
static uint32_t choose_roughness(const tp_shade *shade, uint32_t variance)
{
    uint32_t level = 0;
    while (level + 1 < shade->quick->levels && variance >= variance_from[level + 1])
        level++;
    return level;
}

/* Returns the index of height 0 in the sky of a level; vy: Q14. */
static uint32_t sky_place(const tp_shade *shade, const tp_quick_view *v, int env,
                          uint32_t level, int32_t vy)
{
    const uint32_t column = env == TP_ENV_DOME ? tp_quick_column(shade, v) : 0;

    if (env == TP_ENV_CUBE)
        return 0;
    if (level == 0)
        return column * TP_QUICK_HEIGHTS + TP_QUICK_HEIGHTS / 2;
    const int32_t at = tp_clamp(vy * TP_QUICK_VIEWS >> 14, 0, TP_QUICK_VIEWS - 1);

    return rough_sky_place(level, env == TP_ENV_DOME, column * TP_QUICK_ROUGH_COLUMNS / 16)
         + (uint32_t)(MARGIN + TP_QUICK_HEIGHTS / 2
                      + (int8_t)(shade->quick->rough[level].shift[at / 4] >> 8 * (at & 3)));
}

/* Returns tp_quick_water's `seen`, so that level water has tp_rough_lobe's: with the view's
 * horizontal part as 1, within 8 % for vy up to 0.4. */
static int32_t seen_light(const tp_shade *shade, const tp_quick_view *v, uint32_t waves,
                          int32_t vy)
{
    const int32_t towards = -tp_high16(v->back) * shade->world.lx
                          - tp_low16(v->back) * shade->world.lz;
    const int32_t direct = tp_quick_sun_make(shade).direct, ly = shade->world.ly;

    if (waves == 0)
        return 0;
    const int32_t rise =
        tp_rough_seen_rise(tp_clamp(vy, 0, 16384), waves) * (towards >> 14) >> 14;
    const int32_t room = rise < 0 ? ly : 16384 - ly;
    return room > 0 ? tp_clamp(direct * rise / room, -direct, direct) : 0;
}

tp_quick_water tp_quick_rough_water(const tp_shade *shade, const tp_quick_view *v, int env)
{
    const int32_t log_depth = log_depth_of_level_water(shade, v->y), vy = v->y >> 12;
    const tp_slope_variance waves = tp_filtered_waves_lookup(shade->filtered, log_depth);
    const uint32_t lost =
        shade->ripple ? tp_rough_ripple_variance(shade->ripple, log_depth) : 0;
    const uint32_t level = choose_roughness(shade, (waves.along + waves.across) / 2 + lost);

    return (tp_quick_water){ level, seen_light(shade, v, waves.along, vy),
                             sky_place(shade, v, env, level, vy) };
}
