/* SPDX-License-Identifier: MIT */
/*
 * Automatic exposure of the camera [F8]: a light meter of 32 x 24 rays, once per tick,
 * and the adaptation to its mean.  Adaptation runs in fixed ticks, not in wall time, so a
 * recorded input gives the same pictures again.
 *
 * Rays upwards meet the sky.  Rays downwards meet level water: the mirrored sky, weighted
 * by Fresnel, and the water's own lit colour.  The rules are the same as in the span
 * stages, in grey and without waves.  The mean therefore depends on the world alone, not
 * on the picture's size, its tiles or the frames drawn.  The lattice is 4:3, with
 * camera.fov from bottom to top.
 *
 * The module's state is tables of greys, because a world has no textures while it moves.
 */
#include "base/base.h"
#include "features/exposure/exposure.h"
#include "shade/env.h"
#include "shade/optics.h"
#include "world/light.h"
#include "world/world.h"

/* -- adaptation ---------------------------------------------------------------------- */

#define LEAST      (TP_FX_ONE / 8)
#define MOST       (8 * TP_FX_ONE)
#define MEAN_LEAST (TP_FX_ONE / 16)

/* A share of a difference of a few LSB may round to zero.  The exposure then moves by one
 * LSB, so the target is reached exactly.  The difference is below 2^19, the product below
 * 2^36. */
tp_fx tp_exposure_step(tp_fx exposure, tp_fx mean, tp_fx rate)
{
    const tp_fx floored = mean < MEAN_LEAST ? MEAN_LEAST : mean;
    const tp_fx target = tp_clamp(tp_fx_div(TP_FX_ONE / 2, floored), LEAST, MOST);
    const tp_fx from = tp_clamp(exposure, LEAST, MOST), way = target - from;
    const tp_fx share = tp_clamp(rate, 0, TP_FX_ONE), step = tp_fx_mul(way, share);

    if (step == 0 && share > 0)
        return from + (way > 0) - (way < 0);
    return from + step;
}

/* -- the meter ----------------------------------------------------------------------- */

#define ACROSS 32
#define DOWN   24
#define BANDS  64               /* intervals of the gradients and of Fresnel */
#define SIDE   8                /* texels of a cube face, each way */
#define GLOWS  (TP_GLOW / 8)
#define BRIGHTEST 1020          /* four times white: upper limit, also for a sun */

/* Inputs of the tables, from the scene. */
typedef struct {
    int32_t kind, horizon, zenith, light;
    tp_fx   sun, share;
    int32_t colour, fresnel;
    tp_fx   reflection;
} source;

/* Tables of greys; white is 255. */
typedef struct {
    source   made_of;
    uint32_t cube;              /* 1: cube faces; 0: gradients and glow */
    uint16_t low[2][BANDS + 1]; /* gradients, away from the light; towards it */
    uint16_t glow[GLOWS + 1];
    uint16_t face[TP_FACES][SIDE * SIDE];
    uint16_t fresnel[BANDS + 1];        /* 1/256, times the water's reflection */
    uint16_t water;             /* water colour in full light */
} probe;

/* -- the tables ---------------------------------------------------------------------- */

static uint16_t hdr_brightness(uint32_t hdr_argb, uint32_t whites_q8)
{
    TP_ASSERT(whites_q8 <= 256 * TP_WHITES);
    uint32_t grey = (77 * (hdr_argb >> 16 & 0xff) + 150 * (hdr_argb >> 8 & 0xff)
                     + 29 * (hdr_argb & 0xff)) >> 8;
    uint32_t gain = 256 + ((hdr_argb >> 24) * whites_q8 >> 8);
    uint32_t bright = grey * gain >> 8;

    return (uint16_t)(bright < BRIGHTEST ? bright : BRIGHTEST);
}

/* Fills the gradients and the glow.  A plain gradient sky is filled like a daytime dome
 * without a sun. */
static void fill_dome(probe *p, const tp_scene *scene, uint32_t beyond)
{
    const bool dome = tp_has_dome(scene);
    const tp_dome_config config = tp_dome_config_make(scene);

    for (int32_t i = 0; i <= BANDS; i++) {
        int32_t sine = i * TP_SKY / BANDS;
        p->low[0][i] = hdr_brightness(tp_dome_gradient(&config, false, sine), 0);
        p->low[1][i] = hdr_brightness(tp_dome_gradient(&config, dome, sine), 0);
    }
    for (uint32_t i = 0; i <= GLOWS; i++)
        p->glow[i] =
            dome ? hdr_brightness(tp_dome_glow(&config, tp_glow_entry_squared_chord(8 * i)),
                            beyond)
                 : 0;
}

/* Fills a face from the mipmap level with 8 texels per side, or from level 0 of a smaller
 * texture. */
static void fill_face(uint16_t to[SIDE * SIDE], const tp_cube *cube, int i, uint32_t beyond)
{
    const tp_texture *face = cube->face[i];
    int larger = face->log2_w > face->log2_h ? face->log2_w : face->log2_h;
    int level = larger > 3 ? larger - 3 : 0;
    int w = face->log2_w > level ? face->log2_w - level : 0;
    int h = face->log2_h > level ? face->log2_h - level : 0;

    for (int at = 0; at < SIDE * SIDE; at++) {
        int u = at % SIDE << w >> 3, v = at / SIDE << h >> 3;
        to[at] = hdr_brightness(face->level[level][(v << w) + u] & cube->mask[i], beyond);
    }
}

static void fill_water(probe *p, const tp_scene *scene, const tp_assets *assets)
{
    const tp_texture *layer = assets ? assets->layer[0] : NULL;
    uint32_t colour = (uint32_t)scene->water.colour;
    uint32_t share = (uint32_t)scene->water.reflection >> 8;

    if (layer)
        colour = tp_colour_times(layer->level[layer->levels - 1][0], colour);
    p->water = hdr_brightness(colour & 0xffffff, 0);
    for (int32_t i = 0; i <= BANDS; i++) {
        tp_q30 c = i * (TP_Q30_ONE / BANDS);
        tp_q30 r = scene->water.fresnel == TP_FRESNEL_SCHLICK ? tp_fresnel_schlick(c)
                                                              : tp_fresnel(c);
        p->fresnel[i] = (uint16_t)((uint32_t)(r >> 22) * share >> 8);
    }
}

static source collect_table_inputs(const tp_scene *scene)
{
    return (source){
        .kind = scene->sky.kind, .horizon = scene->sky.horizon,
        .zenith = scene->sky.zenith, .light = scene->light.colour,
        .sun = scene->sky.sun, .share = scene->hdr.share,
        .colour = scene->water.colour, .fresnel = scene->water.fresnel,
        .reflection = scene->water.reflection,
    };
}

static void make_tables(probe *p, const tp_scene *scene, const tp_assets *assets)
{
    uint32_t beyond = (uint32_t)scene->hdr.share * TP_WHITES >> 8;
    tp_cube  cube;

    memset(p, 0, sizeof *p);            /* clears tables of another kind of sky */
    p->made_of = collect_table_inputs(scene);
    p->cube = tp_has_cube(scene, assets) && tp_cube_init(&cube, assets->sky);
    if (!p->cube)
        fill_dome(p, scene, beyond);
    for (int i = 0; p->cube && i < TP_FACES; i++)
        fill_face(p->face[i], &cube, i, beyond);
    fill_water(p, scene, assets);
}

/* -- a tick -------------------------------------------------------------------------- */

typedef struct {
    int32_t x, y, z;            /* direction, Q1.14 */
} meter_way;

static meter_way direction_q14(tp_dir3 d)
{
    return (meter_way){ d.x >> 16, d.y >> 16, d.z >> 16 };
}

/* Returns the grey of the sky in direction d, with d.y >= 0. */
static uint32_t sample_sky(const probe *p, meter_way light, meter_way d)
{
    if (p->cube) {
        tp_cube_ray at = tp_cube_face(d.x, d.y, d.z);
        int32_t u = tp_clamp((at.m + at.right) * SIDE / (2 * at.m), 0, SIDE - 1);
        int32_t v = tp_clamp((at.m + at.down) * SIDE / (2 * at.m), 0, SIDE - 1);
        return p->face[at.face][v * SIDE + u];
    }
    uint32_t square = tp_square_length(d.x - light.x, d.y - light.y, d.z - light.z);
    uint32_t share = tp_light_side_weight(square);
    int32_t  band = tp_clamp(d.y >> 8, 0, BANDS);
    uint32_t low = (p->low[0][band] * (256 - share) + p->low[1][band] * share) >> 8;
    uint32_t sum = low + p->glow[tp_glow_index(square) / 8];

    return sum < BRIGHTEST ? sum : BRIGHTEST;
}

static uint32_t trace_ray(const probe *p, const tp_scene *scene, meter_way light,
                          meter_way d)
{
    if (d.y >= 0)
        return sample_sky(p, light, d);
    uint32_t lit = (uint32_t)tp_lit_share(scene->light.ambient >> 8, light.y);
    uint32_t share = p->fresnel[tp_clamp(-d.y >> 8, 0, BANDS)];
    uint32_t mirror = sample_sky(p, light, (meter_way){ d.x, -d.y, d.z });

    return ((p->water * lit >> 8) * (256 - share) + mirror * share) >> 8;
}

/* Returns the mean brightness, 1 for white, over a lattice of 32 x 24 view rays, for a
 * picture of 4:3.  A ray's direction in view space is (u, v, depth): u and v are the sine
 * of half the vertical view angle times -31/24..31/24 and -23/24..23/24; the depth is the
 * cosine of the same angle. */
tp_fx tp_meter_mean(const tp_world *world, const tp_scene *scene)
{
    const probe *p = tp_world_module_state(world, TP_METER_ID);
    tp_turn half = tp_turn_of_degrees(scene->camera.fov) / 2;
    int32_t s = tp_sin(half) >> 16, c = tp_cos(half) >> 16;
    tp_rotation turn = tp_camera_interpolate(world, 0).turn;
    meter_way right = direction_q14(turn.x), up = direction_q14(turn.y),
              back = direction_q14(turn.z);
    meter_way light =
        direction_q14(tp_light_direction(world->light_heading, world->light_elevation));
    uint32_t sum = 0;

    for (int32_t k = 0; p && k < ACROSS * DOWN; k++) {
        int32_t u = s * (2 * (k % ACROSS) - 31) / 24, v = s * (23 - 2 * (k / ACROSS)) / 24;
        sum += trace_ray(p, scene, light, direction_q14(tp_normalise(
            right.x * u + up.x * v - back.x * c, right.y * u + up.y * v - back.y * c,
            right.z * u + up.z * v - back.z * c)));
    }
    return (tp_fx)((uint64_t)sum * TP_FX_ONE / (ACROSS * DOWN * 255));
}

/* -- the module ---------------------------------------------------------------------- */

bool tp_meter_enabled(const tp_module_conditions *conditions)
{
    return conditions->scene->hdr.exposure == TP_EXPOSURE_AUTO;
}

static size_t bytes(const tp_module_conditions *conditions)
{
    (void)conditions;
    return sizeof(probe);
}

static tp_status init(void *mine, tp_world *world, const tp_module_conditions *conditions,
                      tp_error *err)
{
    (void)world, (void)err;
    make_tables(mine, conditions->scene, conditions->assets);
    return TP_OK;
}

/* Makes the tables again if the numbers of the scene behind them have changed.  Returns
 * true: the state fits every scene. */
static bool refresh(void *mine, tp_world *world, const tp_module_conditions *conditions)
{
    const probe *p = mine;
    const source of = collect_table_inputs(conditions->scene);

    (void)world;
    if (memcmp(&of, &p->made_of, sizeof of) != 0)
        make_tables(mine, conditions->scene, conditions->assets);
    return true;
}

/* Advances the exposure.  Camera and light are already those of this tick. */
static void step(void *mine, const tp_program *program, tp_world *world,
                 const tp_scene *scene, const tp_input *input)
{
    TP_ASSERT(scene->hdr.rate >= 0);
    (void)mine, (void)program, (void)input;
    world->exposure = tp_exposure_step(world->exposure, tp_meter_mean(world, scene),
                                       scene->hdr.rate);
}

/* True if the tables equal those of `fresh`: ticks do not change the tables. */
static bool is_valid(const void *mine, const void *fresh, const tp_world *world)
{
    (void)world;
    return memcmp(mine, fresh, sizeof(probe)) == 0;
}

bool tp_world_is_metered(const tp_world *world)
{
    return tp_world_module_state(world, TP_METER_ID) != NULL;
}

const tp_module tp_meter_module = {
    .name = "meter", .id = TP_METER_ID,
    .enabled = tp_meter_enabled, .bytes = bytes, .init = init,
    .refresh = refresh, .step = step, .is_valid = is_valid,
};
