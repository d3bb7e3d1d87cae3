/* SPDX-License-Identifier: MIT */
/*
 * Skies other than the plain gradient, and the air below them.  A scene has at most one
 * sky.  The `begin` of a sky sets shade->env for its stages, for reflections and for
 * haze. The tables are made in shade/.  Haze is air between the eye and everything except
 * the sky.
 *
 *     sky_drawing.c      the modules: dome (day, dusk, night), stars, cube map; the cost of
 *                        their pixels
 *     haze_drawing.c     the module haze, and the cost of its pixels
 *     sky_stage.c        the visible cube map of six textures, the visible dome, exact; their
 *                        reflections
 *     fast_dome_stage.c  the visible dome, by fast stages
 *     fast_cube_stage.c  the visible cube, by a fast stage
 *     stars_stage.c      stars, exact and fast
 *     haze_stage.c       the rule of haze; its exact stages, one for each kind of sky, and
 *                        its fast stage
 */
#ifndef TP_FEATURES_SKY_SKY_H
#define TP_FEATURES_SKY_SKY_H
#include "base/dsp.h"
#include "shade/env.h"
#include "shade/shade.h"
#include "tidepool/modules.h"
#include "world/light.h"
#include "world/module.h"

#define TP_SKY_DOME_ID TP_MODULE_ID('s', 'k', 'y', 'd')
#define TP_SKY_CUBE_ID TP_MODULE_ID('s', 'k', 'y', 'c')
#define TP_STARS_ID    TP_MODULE_ID('s', 't', 'a', 'r')

/* Returns the whites, Q8, that an alpha of 1 in the sky's colours adds [F8]: by hdr.share; 0
 * if the sky has no light beyond white, that is a gradient, a dome without a sun, or a cube
 * of pictures without alpha. */
uint32_t tp_beyond_white(const tp_scene *scene, const tp_assets *assets);

static inline bool tp_dome_config_equal(const tp_dome_config *a, const tp_dome_config *b)
{
    return a->kind == b->kind && a->horizon == b->horizon && a->zenith == b->zenith
        && a->light == b->light && a->sun == b->sun;
}

/* -- helpers of the stages ----------------------------------------------------------- */

/* Returns the colour of a sky look-up.  `hdr` is a literal: 1 adds the light above white,
 * 0 leaves it out.  Most look-ups have no light above white. */
TP_ALWAYS_INLINE uint32_t tp_sky_colour(const tp_shade *shade, uint32_t light, int hdr)
{
    if (hdr && (TP_WIDE || light >> 24))
        return tp_light_colour_clamped(shade, light);
    return light & 0x00ffffffu;
}

/* -- fast shading of the visible dome ------------------------------------------------ */

/* The colour is looked up at every 16th or 32nd column and linear in between.  Close to the
 * sun the colour, or its glow, is looked up at every column.
 *
 * Channels are 8.8 in the halves of a word, so one addition serves two channels. */

/* Red and blue packed, and green; each with its step per column. */
typedef struct {
    uint32_t rb, g, rb_step, g_step;
} tp_quick_shade;

/* `log2_columns`, 4 or 5, is a literal: the colours a and b are 16 or 32 columns apart. */
static inline tp_quick_shade tp_quick_shade_make_long(uint32_t a, uint32_t b, int log2_columns)
{
    const uint32_t from = tp_even_bytes(a), to = tp_even_bytes(b);
    const int32_t  factor = 256 >> log2_columns;

    return (tp_quick_shade){
        .rb = (from << 8) + 0x00800080, .g = (a & 0xff00) + 0x80,
        .rb_step = tp_pair16((tp_high16(to) - tp_high16(from)) * factor,
                             (tp_low16(to) - tp_low16(from)) * factor),
        .g_step = ((b & 0xff00) - (a & 0xff00)) >> log2_columns,
    };
}

static inline tp_quick_shade tp_quick_shade_make(uint32_t a, uint32_t b)
{
    return tp_quick_shade_make_long(a, b, 4);
}

/* Fills columns [k, end) of a block. */
static inline void tp_gradient_fill_scalar(uint32_t *colour, tp_quick_shade s, int32_t k,
                                           int32_t end)
{
    const int32_t r = tp_high16(s.rb_step), b = tp_low16(s.rb_step);
    const int32_t g = (int16_t)s.g_step;

    for (; k < end; k++) {
        uint32_t red = (s.rb >> 16) + (uint32_t)(r * k);
        uint32_t blue = (s.rb & 0xffff) + (uint32_t)(b * k);
        uint32_t green = s.g + (uint32_t)(g * k);
        *colour++ = (red & 0xff00) << 8 | (green & 0xff00) | (blue >> 8 & 0xff);
    }
}

static inline void tp_gradient_fill_packed(uint32_t *colour, tp_quick_shade s, int32_t k,
                                           int32_t end)
{
    s.g_step = (uint32_t)(int32_t)(int16_t)s.g_step;
    for (int32_t i = 0; i < k; i++) {
        s.rb = tp_sadd16(s.rb, s.rb_step);
        s.g += s.g_step;
    }
    for (; k < end; k++) {
        *colour++ = tp_halves_add_odd_bytes(s.g & 0xff00, s.rb);
        s.rb = tp_sadd16(s.rb, s.rb_step);
        s.g += s.g_step;
    }
}

/* -- haze ---------------------------------------------------------------------------- */

#define TP_HAZE_ID TP_MODULE_ID('h', 'a', 'z', 'e')

/* Inputs of the horizon's colours; any change makes them anew. */
typedef struct {
    tp_dome_config dome;
    int32_t  kind, level, lx, ly, lz;
    uint32_t beyond;
} tp_horizon_source;

/* Data of the haze stages, in tp_run.mine. */
typedef struct {
    uint32_t scale;             /* factor from zi to table entries, Q0.32 */
    uint16_t laid;              /* 1: the first member of a tp_horizon */
    uint16_t around;            /* 1: fast stages read tp_horizon.colour, 0: shade->sky[0] */
} tp_haze;

/* The horizon's colours around the compass, 0x00RRGGBB, for the fast stage.  Entry i of the
 * four sides towards +x, +z, -x and -z lies in the direction with a tangent of
 * 2 i / TP_HORIZON_SIDE - 1 to the side's right. */
#define TP_HORIZON_SIDE 64
#define TP_HORIZON (4 * TP_HORIZON_SIDE)

typedef struct {
    tp_haze  haze;
    uint32_t colour[TP_HORIZON + 1];
    tp_horizon_source made_of;
} tp_horizon;

/* Fills the colours from the sky of shade->env. */
void tp_horizon_make(uint32_t colour[TP_HORIZON + 1], const tp_shade *shade);

/* Makes the colours of a horizon if the sky or the light has changed. */
struct tp_draw_horizon {
    void (*refresh)(tp_horizon *horizon, const tp_shade *shade);
};

#define TP_HAZE 512
extern const tp_entry8 tp_haze_table[TP_HAZE + 1];      /* horizon's share of 255 */

/* -- parameters ---------------------------------------------------------------------- */

#define TP_ROW_FACE(name, part, help) TP_ROW_NAME("sky." name, sky.part, TEXTURE, help)

#define TP_SKY_COLOUR_ROWS \
    TP_ROW_CHOICE("sky.kind", sky.kind, "gradient|day|dusk|night|cube", TP_SKY_CUBE, \
        TP_SKY_GRADIENT, "two colours, a generated sky, or a cube map of six PNGs"), \
    TP_ROW_COLOUR("sky.horizon", sky.horizon, 0xc8d8e4, \
        "colour at the horizon, for gradient and day"), \
    TP_ROW_COLOUR("sky.zenith", sky.zenith, 0x3a6ea5, \
        "colour overhead, for gradient and day")

#define TP_SKY_LIGHT_ROWS \
    TP_ROW_NUMBER("sky.sun", sky.sun, "", 0, 16, 1, \
        "brightness of a generated sun; above 1 needs hdr.share"), \
    TP_ROW_NUMBER("sky.stars", sky.stars, "", 0, 1, 0.5, \
        "density of stars in a night sky"), \
    TP_ROW_FACE("east", east, \
        "PNG of the cube's face towards +x; alpha: light above white"), \
    TP_ROW_FACE("west", west, "PNG of the face towards -x"), \
    TP_ROW_FACE("up", up, "PNG overhead; its lower edge joins the south face"), \
    TP_ROW_FACE("down", down, "PNG underfoot; its upper edge joins the south face"), \
    TP_ROW_FACE("south", south, "PNG of the face towards +z"), \
    TP_ROW_FACE("north", north, "PNG of the face towards -z")

#define TP_HAZE_ROWS \
    TP_ROW_NUMBER("sky.haze", sky.haze, "m", 0, 32000, 2000, \
        "distance at which a colour is half the horizon's; 0: no haze")

#endif
