/* SPDX-License-Identifier: MIT */
/* Small scenes for the reference's own checks, and the colours to be seen in them. */
#ifndef TP_TESTS_LIB_REFERENCE_SCENES_H
#define TP_TESTS_LIB_REFERENCE_SCENES_H
#include "world/world.h"
#include "tests/lib/frames.h"
#include "tests/lib/measure.h"
#include "tests/lib/scenes.h"
#include "tools/reference/image.h"
#include "tidepool/modules.h"

typedef struct {
    tp_scene  scene;
    tp_assets assets;
    tp_world *world;
    ref_scene ref;
} view_of_ref;

/* Level water under a plain gradient sky: no haze, no glitter. */
static inline tp_scene scene_level(void)
{
    tp_scene s;

    tp_scene_level(&s);
    s.sky.haze = 0;
    s.water.specular = 0;
    s.water.reflection = TP_FX_ONE;
    return s;
}

/* Opens a view; the caller sets `v->scene` and `v->assets`. Waves extend to the end of the
 * water. */
static inline void view_open_at(view_of_ref *v, uint32_t width, uint32_t height,
                                uint32_t ticks)
{
    v->world = scene_world(&v->scene, &v->assets);
    if (!v->world)
        abort();
    while (v->world->tick < ticks)
        tp_world_step(&tp_program_all, v->world, &v->scene, NULL);
    ref_scene_open(&v->ref, &v->scene, &v->assets, v->world, width, height, false);
}

static inline void view_open(view_of_ref *v, uint32_t width, uint32_t height)
{
    view_open_at(v, width, height, 0);
}

static inline void view_close(view_of_ref *v)
{
    ref_scene_close(&v->ref);
    free(v->world);
}

/* -- directions ---------------------------------------------------------------------- */

/* Directions of view as angles, and closed forms for the colour seen in a direction. The
 * closed forms share nothing with the reference but the numbers of the scene. */

/* Direction in radians: azimuth clockwise from north (-z), elevation above the horizon. */
typedef struct {
    double azimuth, elevation;
} sight_angles;

/* Channel k of a colour: 0 red, 1 green, 2 blue. */
static inline double channel(int32_t colour, int k)
{
    return (uint32_t)colour >> (16 - 8 * k) & 255;
}

static inline double between(double a, double b, double share)
{
    return a * (1 - share) + b * share;
}

static inline double radians(tp_turn turn)
{
    return turn * (2 * PI / 4294967296.0);
}

/* Cosine of the angle between two directions, by the spherical law of cosines. */
static inline double sight_cos(sight_angles a, sight_angles b)
{
    return sin(a.elevation) * sin(b.elevation)
         + cos(a.elevation) * cos(b.elevation) * cos(a.azimuth - b.azimuth);
}

/* Direction of the world's light, quantised as the world stores the angles. */
static inline sight_angles sight_light(const view_of_ref *v)
{
    return (sight_angles){ radians(v->world->light_heading),
                           radians(v->world->light_elevation) };
}

static inline sight_angles sight_ahead(const view_of_ref *v)
{
    return (sight_angles){ radians(v->world->heading),
                           (int32_t)v->world->pitch * (2 * PI / 4294967296.0) };
}

/* Projects the direction `to` into a picture of width x height pixels: `place` in pixels.
 * Returns false if the direction is outside the picture. */
static inline bool sight_place(const view_of_ref *v, sight_angles to, uint32_t width,
                               uint32_t height, double place[2])
{
    const sight_angles axis = sight_ahead(v);
    const double focal = height / 2.0 / tan(v->scene.camera.fov / 65536.0 * PI / 360);
    const double level = cos(to.elevation) * cos(to.azimuth - axis.azimuth);
    const double aside = cos(to.elevation) * sin(to.azimuth - axis.azimuth);
    const double sine = sin(axis.elevation), cosine = cos(axis.elevation);
    const double deep = level * cosine + sin(to.elevation) * sine;
    const double up = sin(to.elevation) * cosine - level * sine;

    place[0] = width / 2.0 + focal * aside / deep;
    place[1] = height / 2.0 - focal * up / deep;
    return deep > 0 && place[0] > 0 && place[0] < width && place[1] > 0
        && place[1] < height;
}

/* Colour that the reference sees in a direction; for a view opened at 64x48 pixels that
 * contains the direction. */
static inline ref_seen sight_look(const view_of_ref *v, sight_angles to)
{
    double place[2];

    assert_true(sight_place(v, to, 64, 48, place));
    return ref_look(&v->ref, place[0], place[1]);
}

/* Random direction inside the picture, with an elevation from `low` to `high`. */
static inline sight_angles sight_any(const view_of_ref *v, uint64_t *state, double low,
                                     double high)
{
    const sight_angles axis = sight_ahead(v);
    double place[2];
    sight_angles s;

    do
        s = (sight_angles){ axis.azimuth + chance_double(state, -1, 1) * PI,
                            chance_double(state, low, high) };
    while (!sight_place(v, s, 64, 48, place));
    return s;
}

/* Scene of transparent water with random light and random water colours. */
static inline tp_scene scene_clear_any(uint64_t *state)
{
    tp_scene s = scene_level();

    s.light.heading = chance_fx(state, -180, 180);
    s.light.elevation = chance_fx(state, 5, 90);
    s.light.ambient = chance_fx(state, 0, 1);
    s.light.colour = chance_int(state, 0, 0xffffff);
    s.water.clarity = chance_scale(state, 1, 30);
    s.water.tint = chance_int(state, 0, 0xffffff) | 0x202020;
    s.water.deep_colour = chance_int(state, 0, 0xffffff);
    return s;
}

/* -- optics ------------------------------------------------------------------------ */

#define WATER 1.333

/* Fresnel reflectance of unpolarised light from index 1 into index `e`, by the sines and
 * tangents of the angles. The form has no value at normal incidence. */
static inline double fresnel_of(double angle, double e)
{
    const double bent = asin(sin(angle) / e);
    return (pow(sin(angle - bent) / sin(angle + bent), 2)
            + pow(tan(angle - bent) / tan(angle + bent), 2)) / 2;
}

/* Gradient sky: the zenith's colour plus (1 - sine)^2 of the difference to the
 * horizon's. */
static inline double gradient_of(const tp_scene *s, double elevation, int k)
{
    const double rest = 1 - fmax(0, sin(elevation));
    return channel(s->sky.zenith, k)
         + rest * rest * (channel(s->sky.horizon, k) - channel(s->sky.zenith, k));
}

/* Cosine of the light on a face under water. The refracted light is steeper; the factor
 * keeps the light on a level face equal to the light on a dry level face. */
static inline double wet_cos(const view_of_ref *v, sight_angles face)
{
    const sight_angles light = sight_light(v);
    const sight_angles bent = { light.azimuth, acos(cos(light.elevation) / WATER) };

    return sight_cos(face, bent) * sin(light.elevation) / sin(bent.elevation);
}

/* Beer's law: `seen` after `way` m of water; the part of the light that the water absorbs
 * is replaced by the colour `body`. */
static inline double beer_of(const tp_scene *s, double seen, double body, double way,
                             int k)
{
    const double clear = s->water.clarity > 0 ? s->water.clarity / 65536.0 : 4;
    return between(body, seen, exp(way / clear * log(channel(s->water.tint, k) / 255)));
}

/* Brightness of a surface that the light meets at an angle with this cosine: ambient plus
 * diffuse light, 0..1. */
static inline double lit_of(const tp_scene *s, double cosine)
{
    const double ambient = s->light.ambient / 65536.0;
    return ambient + (1 - ambient) * fmax(0, cosine);
}

/* Share 0..1 of channel k that the light's colour leaves of a solid's colour. */
static inline double tint_of(const tp_scene *s, int k)
{
    return channel(s->light.colour, k) / 255;
}

/* Texture of noise. */
enum { NOISE = 16 };

typedef struct {
    tp_texture texture;
    uint32_t   pixel[NOISE * NOISE], texel[2 * NOISE * NOISE];
} noise_picture;

static inline const tp_texture *noise_of(noise_picture *p, uint64_t *state)
{
    for (int i = 0; i < NOISE * NOISE; i++)
        p->pixel[i] = (uint32_t)random_next(state) | 0xff000000u;
    if (tp_texture_init(&p->texture, p->pixel, NOISE, NOISE, p->texel,
                        tp_texture_bytes(NOISE, NOISE), NULL)
        != TP_OK)
        abort();
    return &p->texture;
}

/* Channel k of the repeated noise at (x, y) by bilinear filtering: the weight of each texel
 * is 1 minus the distance to its centre, in x and in y. */
static inline double tents_of(const noise_picture *p, double x, double y, int k)
{
    double sum = 0;

    for (int i = 0; i < NOISE * NOISE; i++) {
        const double dx = x - (i % NOISE + 0.5) / NOISE;
        const double dy = y - ((double)(i / NOISE) + 0.5) / NOISE;
        const double far_x = fabs(dx - round(dx)) * NOISE;
        const double far_y = fabs(dy - round(dy)) * NOISE;
        sum += fmax(0, 1 - far_x) * fmax(0, 1 - far_y)
             * channel((int32_t)p->pixel[i], k);
    }
    return sum;
}

/* Channel k of the texel at (s, t), nearest filter. NAN within 1e-7 texel of a texel's
 * edge, where rounding decides which texel is meant. */
static inline double texel_at(const noise_picture *p, double s, double t, int k)
{
    const double x = (s - floor(s)) * NOISE, y = (t - floor(t)) * NOISE;

    if (fabs(x - round(x)) < 1e-7 || fabs(y - round(y)) < 1e-7)
        return (double)NAN;
    return channel((int32_t)p->pixel[(int)y % NOISE * NOISE + (int)x % NOISE], k);
}

/* Texture of a single colour. */
typedef struct {
    tp_texture texture;
    uint32_t   texel[4];
} plain_picture;

static inline const tp_texture *plain_of(plain_picture *p, uint32_t colour)
{
    const uint32_t pixel = colour | 0xff000000u;

    if (tp_texture_init(&p->texture, &pixel, 1, 1, p->texel, tp_texture_bytes(1, 1), NULL)
        != TP_OK)
        abort();
    return &p->texture;
}

/* -- scenes with each kind of sky ---------------------------------------------------- */

static inline tp_scene scene_sky(uint64_t *state, int32_t kind)
{
    tp_scene s = scene_level();

    s.sky.kind = kind;
    s.sky.stars = 0;
    s.camera.heading = chance_fx(state, -180, 180);
    s.camera.pitch = chance_fx(state, -40, 80);
    s.camera.fov = 90 * TP_FX_ONE;
    s.light.heading = chance_fx(state, -180, 180);
    s.light.elevation = chance_fx(state, 1, 90);
    s.light.colour = chance_int(state, 0, 0xffffff);
    s.light.ambient = TP_FX_ONE;
    s.water.colour = 0x102840;
    return s;
}

/* Moves the camera to a place without water below; water far away may stay visible. */
static inline void go_ashore(tp_scene *s)
{
    s->camera.x = 4000 * TP_FX_ONE;
    s->pool.cols = s->pool.rows = 16;
    s->tank.kind = TP_TANK_STONE;
    s->tank.sea = 0;
}
#endif
