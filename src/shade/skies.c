/* SPDX-License-Identifier: MIT */
/*
 * Water and sky without a module, as stages: water of one colour, and a gradient from
 * horizon to zenith by the sine of the elevation.  Then the data of the other skies: the
 * tables of a generated sky, and the cube map of the surroundings, six pictures [F7].
 *
 * The generated sky, for day, dusk and night, needs no pictures.  Palettes are colour
 * stops by the sine of the elevation, chosen by eye after photographs.  Each palette has a
 * gradient on the light's side and one on the opposite side; both are equal at the zenith,
 * where the sides meet.  Day uses the scene's own two colours.  The disc of sun or moon is
 * 1.1 degrees in radius, four times the real size: the disc stays round at 320 x 240.  The
 * disc's alpha is its light beyond white.
 */
#include "base/base.h"
#include "shade/env.h"
#include "shade/shade.h"
#include "tidepool/modules.h"

/* -- water of one colour ------------------------------------------------------------- */

void tp_stage_plain(const tp_shade *shade, tp_run *run)
{
    for (int32_t i = 0; i < run->count; i++)
        run->colour[i] = shade->water_colour;
}

/* -- the gradient -------------------------------------------------------------------- */

/* Entry i is the colour at sine i / 256.  The zenith's share grows as 1 - (1 - sine)^2:
 * fast near the horizon, where the air is thick. */
void tp_shade_sky(uint32_t sky[TP_SKY + 1], uint32_t horizon, uint32_t zenith)
{
    for (uint32_t i = 0; i <= TP_SKY; i++) {
        uint32_t left = TP_SKY - i;
        sky[i] = tp_colour_mix(horizon, zenith, 256 - left * left / TP_SKY);
    }
}

#define STEP 32

/* The height of the view vector is exact at every 32nd column and linear between: the
 * error is below two of the 256 entries at 128 pixels a row, below one at 320.  The view
 * vector points down to the eye: its negative is the height in the sky.  Columns of one entry
 * are filled. */
void tp_stage_sky(const tp_shade *shade, tp_run *run)
{
    const uint32_t *sky = shade->sky;
    int32_t x = run->x, end = run->x + run->count;
    int32_t a = tp_vector_to_eye(shade, &shade->world, x & -STEP, run->y).y;

    for (int32_t i = 0; x < end; ) {
        int32_t from = x & -STEP, next = from + STEP;
        int32_t b = tp_vector_to_eye(shade, &shade->world, next, run->y).y;
        int32_t stop = next < end ? next : end;
        int32_t step = a - b, sine = -STEP * a + step * (x - from);     /* Q14 x 32 */
        const int32_t last = sine + step * (stop - x - 1);
        if (sine >> 11 == last >> 11) {
            const uint32_t colour = sky[sine < 0 ? 0 : sine >> 11];
            for (; x < stop; x++)
                run->colour[i++] = colour;
        }
        for (; x < stop; x++, i++, sine += step)
            run->colour[i] = sky[sine < 0 ? 0 : sine >> 11];
        a = b;
    }
}

/* -- the generated sky --------------------------------------------------------------- */

typedef struct {
    int32_t  sine;              /* sine of the elevation, 256ths */
    uint32_t colour;
} colour_stop;

#define STOPS 7

static const colour_stop dusk_towards[STOPS] = {
    { 0, 0xffae58 }, { 12, 0xf79860 }, { 34, 0xd77a74 }, { 66, 0x9d6488 },
    { 110, 0x645688 }, { 170, 0x343c74 }, { 256, 0x161f50 },
};
static const colour_stop dusk_away[STOPS] = {
    { 0, 0x74668c }, { 16, 0x8e7298 }, { 36, 0x86709c }, { 66, 0x625f96 },
    { 110, 0x414a86 }, { 170, 0x26316a }, { 256, 0x161f50 },
};
static const colour_stop night_towards[STOPS] = {
    { 0, 0x2c3c58 }, { 12, 0x243450 }, { 34, 0x1a2844 }, { 66, 0x121d36 },
    { 110, 0x0c152a }, { 170, 0x070e1e }, { 256, 0x040915 },
};
static const colour_stop night_away[STOPS] = {
    { 0, 0x172236 }, { 12, 0x141e32 }, { 34, 0x10192c }, { 66, 0x0b1324 },
    { 110, 0x080e1e }, { 170, 0x060b19 }, { 256, 0x040915 },
};

static uint32_t interpolate_colour_stops(const colour_stop *s, int32_t sine)
{
    int i = 0;

    while (i < STOPS - 2 && s[i + 1].sine < sine)
        i++;
    int32_t part = (sine - s[i].sine) * 256 / (s[i + 1].sine - s[i].sine);
    return tp_colour_mix(s[i].colour, s[i + 1].colour, (uint32_t)tp_clamp(part, 0, 256));
}

/* Mixes horizon and zenith by 1 - (1 - sine)^2, as the plain gradient does.  Towards the
 * sun the low air takes up to 5/8 of the sun's colour. */
static uint32_t day_gradient(const tp_dome_config *config, bool towards_light, int32_t sine)
{
    uint32_t left = (uint32_t)(TP_SKY - sine), low = left * left / TP_SKY;
    uint32_t colour = tp_colour_mix(config->horizon, config->zenith, 256 - low);
    uint32_t haze = low * low / TP_SKY;

    return towards_light ? tp_colour_mix(colour, config->light, haze * 5 / 8) : colour;
}

uint32_t tp_dome_gradient(const tp_dome_config *config, bool towards_light, int32_t sine)
{
    TP_ASSERT(sine >= 0 && sine <= TP_SKY);
    if (config->kind == TP_DOME_DUSK)
        return interpolate_colour_stops(towards_light ? dusk_towards : dusk_away, sine);
    if (config->kind == TP_DOME_NIGHT)
        return interpolate_colour_stops(towards_light ? night_towards : night_away, sine);
    return day_gradient(config, towards_light, sine);
}

/* -- the glow around the light ------------------------------------------------------- */

/* The glow is the sum of two lobes.  Peaks are of 255; widths are squared chord distances
 * to the light in Q28: 2^20 is 3.6 degrees, 2^25 is 20 degrees. */
typedef struct {
    uint32_t peak, width;
    uint32_t last;              /* 256ths of a level opposite the light */
} lobe;

#define DISC      98000u        /* squared chord of 1.1 degrees */
#define DISC_EDGE (TP_DISC_END - DISC)
#define FAR       (1u << 30)    /* squared chord to the point opposite the light */

#define LOBE(peak, width) \
    { peak, width, (uint32_t)((uint64_t)(peak) * 256 * (width) / ((uint64_t)(width) + FAR)) }

static const lobe halos[][2] = {
    [TP_DOME_DAY]   = { LOBE(96, 1u << 20), LOBE(72, 1u << 24) },
    [TP_DOME_DUSK]  = { LOBE(88, 1u << 20), LOBE(96, 1u << 25) },
    [TP_DOME_NIGHT] = { LOBE(80, 1u << 18), LOBE(52, 1u << 23) },
};

/* Returns peak / (1 + square / width), shifted to reach 0 opposite the light; in 256ths of
 * a level. */
static uint32_t glow_lobe(const lobe *l, uint32_t squared_chord)
{
    const uint64_t product = ((uint64_t)l->peak << 8) * l->width;
    const uint64_t here = product / ((uint64_t)l->width + squared_chord);

    return here > l->last ? (uint32_t)here - l->last : 0;
}

/* Returns the glow with the disc.  The disc takes its intensity from config->sun: the
 * moon's disc is paler than moonlight, grey. */
uint32_t tp_dome_glow(const tp_dome_config *config, uint32_t squared_chord)
{
    TP_ASSERT((unsigned)config->kind <= TP_DOME_NIGHT);
    const lobe *l = halos[config->kind];
    uint32_t share = (glow_lobe(&l[0], squared_chord) + glow_lobe(&l[1], squared_chord)) >> 8;
    uint32_t glow = tp_colour_scale(config->light, share);
    uint32_t over = squared_chord > DISC ? squared_chord - DISC : 0;
    uint32_t cover = over < DISC_EDGE ? 256 - over * 256 / DISC_EDGE : 0;
    uint32_t sun = (uint32_t)tp_clamp(config->sun, 0, 16 * TP_FX_ONE);
    uint32_t white = sun < TP_FX_ONE ? sun >> 8 : 256;
    uint32_t alpha = (sun >> 8) * 255 / (256 * TP_WHITES) * cover >> 8;

    glow = tp_colour_add(glow, tp_colour_scale(config->light, white * cover >> 8));
    return glow | alpha << 24;
}

uint32_t tp_glow_entry_squared_chord(uint32_t i)
{
    TP_ASSERT(i <= TP_GLOW);
    uint32_t mantissa = TP_GLOW_STEP + i % TP_GLOW_STEP;
    return mantissa << (TP_GLOW_LOG2 - 5 + i / TP_GLOW_STEP);
}

void tp_dome_init(tp_dome *dome, const tp_dome_config *config)
{
    dome->made_of = *config;
    for (int32_t i = 0; i <= TP_SKY; i++) {
        dome->away[i] = tp_dome_gradient(config, false, i);
        dome->towards[i] = tp_dome_gradient(config, true, i);
    }
    for (uint32_t i = 0; i <= TP_GLOW; i++)
        dome->glow[i] = tp_dome_glow(config, tp_glow_entry_squared_chord(i));
}

/* -- the cube map -------------------------------------------------------------------- */

bool tp_cube_init(tp_cube *cube, const tp_texture *const face[TP_CUBE_FACES])
{
    for (int i = 0; i < TP_CUBE_FACES; i++) {
        if (!face[i])
            return false;
        cube->face[i] = face[i];
        cube->mask[i] = tp_cube_face_mask(face[i]);
    }
    cube->lod = 0;
    return true;
}

/* Entry i is 2^29 / m for m = 8192 + 32 i.  One extra entry serves linear interpolation. */
void tp_recip_init(uint32_t recip[TP_RECIP + 2])
{
    for (uint32_t i = 0; i < TP_RECIP + 2; i++)
        recip[i] = (1u << 29) / (8192 + 32 * i);
}
