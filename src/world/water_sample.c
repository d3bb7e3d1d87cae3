/* SPDX-License-Identifier: MIT */
/*
 * The water at a position or under a pixel, for an application between ticks: sample it,
 * push it, find it.
 *
 * A sample finds the surface point and its rest position, then evaluates the same rest
 * position one tick earlier for the velocity.  tp_input.push pushes within a tick.
 */
#include "base/base.h"
#include "view/wave_models.h"
#include "world/module.h"
#include "world/pools.h"
#include "world/world.h"

/* Returns the water for an application, which may ask about positions even if the program's
 * pictures do not; *models becomes the program's models with samples. */
static tp_surface application_surface(const tp_program *program, const tp_world *world,
                                      tp_wave_models *models)
{
    tp_surface surface = tp_world_surface(program, world);

    *models = *surface.by;
    models->samples = &tp_water_samples;
    surface.by = models;
    return surface;
}

/* -- sampling ------------------------------------------------------------------------ */

/* Returns the height of all rings at `time`. */
static tp_fx sample_rings(const tp_surface *s, int64_t time, tp_fx x, tp_fx z)
{
    tp_ring_now now;
    tp_fx sum = 0;

    for (uint32_t i = 0; i < s->n_raised; i++)
        if (s->by->rings->at(&s->raised[i], time, &now))
            sum += s->by->rings->height_slope(&now, 1, x, z).height;
    return sum;
}

/* Returns the displaced surface point of a rest position. */
static tp_vec3 sample_wave_point(const tp_surface *s, const tp_fx rest[2])
{
    if (s->coastal)
        return s->by->coastal->smooth(s->coastal, s->phases, rest[0], rest[1]).position;
    if (s->by->swells)
        return tp_deep_water_displace_point(s->deep, s->phases, rest[0], rest[1]).position;
    return (tp_vec3){ rest[0], 0, rest[1] };
}

/* Returns the surface point of a rest position at `time`.  Phases and pool interpolation
 * come from `then`, set for the same time. */
static tp_vec3 sample_surface_point(const tp_surface *then, const tp_fx rest[2],
                                    int64_t time)
{
    tp_vec3 p = sample_wave_point(then, rest);
    tp_surface pools = *then;

    pools.rings = 0;
    p.y += tp_rings_pools_sample(&pools, p.x, p.z).height;
    if (then->rings)
        p.y += sample_rings(then, time, p.x, p.z);
    return p;
}

static tp_fx change_per_second(tp_fx now, tp_fx before)
{
    return tp_fx_saturate(((int64_t)now - before) * TP_TICKS_PER_SECOND);
}

tp_water tp_world_sample(const tp_program *program, const tp_world *world, tp_fx x,
                         tp_fx z)
{
    TP_ASSERT(world != NULL && world->layout.bytes > 0);
    program = tp_program_or_linked(program);
    const int64_t time = (int64_t)(world->tick * TP_FX_ONE);
    tp_wave_models models;
    tp_surface surface = application_surface(program, world, &models);
    tp_fx rest[2] = { x, z };
    const tp_surface_point at = tp_surface_sample(&surface, x, z, rest);
    const tp_vec3 now = sample_surface_point(&surface, rest, time);
    tp_turn phases[TP_WAVES];

    tp_deep_water_phases(&world->deep, world->tick, TP_FX_ONE, phases);
    surface.phases = phases;
    surface.lag = TP_FX_ONE;
    const tp_vec3 before = sample_surface_point(&surface, rest, time - TP_FX_ONE);
    return (tp_water){
        at.position.y,
        at.slope_x,
        at.slope_z,
        { change_per_second(now.x, before.x), change_per_second(now.y, before.y),
          change_per_second(now.z, before.z) },
    };
}

/* -- pushing ------------------------------------------------------------------------- */

#define RING_MOST   (4 * TP_FX_ONE)  /* largest height of a ring, m */
#define RADIUS_MOST (16 * TP_FX_ONE) /* m, a quarter of the longest ring */

/* The pool lies on the field, so a push inside both moves the pool only. */
static bool push_pools(const tp_world *world, tp_fx x, tp_fx z, tp_fx radius,
                       tp_fx height)
{
    tp_pool *const pool = tp_world_mutable_pool(world), *const field =
                                                            tp_world_mutable_field(world);

    return (pool && tp_pool_add_splash(pool, x, z, radius, height))
           || (field && tp_pool_add_splash(field, x, z, radius, height));
}

static bool is_far(tp_fx x)
{
    return x < -TP_DROP_FAR || x > TP_DROP_FAR;
}

/* Converts the push to a ring.  A splash of width sigma makes the same waves as a drop
 * impact of length 4 sigma [D5].  A ring starts with a crest, whether the push goes up or
 * down. */
static bool push_open_water(const tp_program *program, tp_world *world,
                            const tp_scene *scene, tp_fx x, tp_fx z, tp_fx radius,
                            tp_fx height)
{
    const tp_impact impact = {
        .x = x,
        .z = z,
        .time = (int64_t)(world->tick * TP_FX_ONE),
        .amplitude = (tp_fx)tp_clamp_abs(height < 0 ? -(int64_t)height : height, RING_MOST),
        .length = 4 * tp_clamp(radius, 0, RADIUS_MOST),
    };
    tp_wave_models models;
    const tp_surface surface = application_surface(program, world, &models);

    if (!program->water.rings || scene->drops.target != TP_DROPS_RINGS || is_far(x)
        || is_far(z))
        return false;
    return tp_modules_handle_impact(program, world, scene, &impact,
                                    tp_surface_sample(&surface, x, z, NULL).position.y);
}

bool tp_world_push(const tp_program *program, tp_world *world, const tp_scene *scene,
                   tp_fx x, tp_fx z, tp_fx radius, tp_fx height)
{
    TP_ASSERT(scene != NULL && world != NULL && world->layout.bytes > 0);
    if (height == 0)
        return false;
    program = tp_program_or_linked(program);
    return push_pools(world, x, z, radius, height)
           || push_open_water(program, world, scene, x, z, radius, height);
}

/* -- the water under a pixel --------------------------------------------------------- */

/* Finds the point of the water surface under a pixel.  The ray through the centre of the
 * pixel is walked until the ray changes the side of the surface; then the interval of the
 * last step is bisected down to 1 LSB.
 *
 * A step is half of the vertical distance between ray and surface: no wave is steep
 * enough to rise by that distance within the step, except where a wave is about to break.
 * Near the water a step is at least the width of two pixels there (or 1/512 of the
 * distance so far, in large pictures).  A ray may therefore skip a crest that it cuts
 * only slightly: for wave number k, amplitude A and step c, the skipped height is
 * c^2 A k^2 / 8 and never above 2 A.  At its largest the skipped height is less than kA
 * pixels.
 *
 * The ray is walked only between crest level and trough level, beyond the near plane and,
 * in a tank, between the walls.  Where the sea floor rises above the water, the ray meets
 * land. */

#define FAR   (8000 * TP_FX_ONE)
#define LEAST (TP_FX_ONE / 256)         /* smallest step, m */
#define MOST  (1 << 13)                 /* largest width or height of the picture, px */

typedef struct {
    const tp_surface *surface;
    tp_vec3   eye;
    tp_dir3   way;
    tp_fx     near;             /* distance along the ray to the near plane, m */
    int32_t   focal_q14;        /* focal length, px, Q14 */
    bool      floor;
} pick_ray;

/* -- the ray ------------------------------------------------------------------------- */

/* Builds the ray through a point of the picture.  Pixels are Q14: offsets of up to 2^16
 * px from the centre, and the focal length with the same limit, stay within the range of
 * tp_rotate_back. */
static pick_ray make_ray(const tp_surface *surface, const tp_camera *camera,
                         const tp_scene *scene, const uint32_t picture_size[2],
                         tp_fx x_px, tp_fx y_px)
{
    const tp_turn half = tp_turn_of_degrees(scene->camera.fov) / 2;
    const int64_t focal =
        (int64_t)picture_size[1] * (1 << 13) * tp_cos(half) / tp_sin(half);
    const int64_t most = (1 << 30) - 1;
    const int64_t u = ((int64_t)x_px >> 2) - (int64_t)picture_size[0] * (1 << 13);
    const int64_t v = (int64_t)picture_size[1] * (1 << 13) - ((int64_t)y_px >> 2);
    pick_ray r = {
        .surface = surface,
        .eye = camera->eye,
        .focal_q14 = (int32_t)tp_clamp_abs(focal, most),
        .floor = surface->coastal && tp_has_floor(scene),
    };
    const tp_vec3 way = tp_rotate_back(
        &camera->turn, (tp_vec3){ (tp_fx)tp_clamp_abs(u, most),
                                  (tp_fx)tp_clamp_abs(v, most), -r.focal_q14 });

    r.way = tp_normalise(way.x, way.y, way.z);
    r.near = tp_fx_saturate(((int64_t)scene->camera.near * TP_Q30_ONE)
                        / tp_clamp(-tp_dir3_dot(r.way, camera->turn.z), 1, TP_Q30_ONE));
    return r;
}

static tp_vec3 ray_point(const pick_ray *r, int64_t t)
{
    const tp_fx far = (tp_fx)t;

    return (tp_vec3){ tp_fx_add_sat(r->eye.x, tp_q30_mul(far, r->way.x)),
                      tp_fx_add_sat(r->eye.y, tp_q30_mul(far, r->way.y)),
                      tp_fx_add_sat(r->eye.z, tp_q30_mul(far, r->way.z)) };
}

/* -- the surface --------------------------------------------------------------------- */

static tp_fx sample_water(const pick_ray *r, tp_fx x, tp_fx z)
{
    return tp_surface_sample(r->surface, x, z, NULL).position.y;
}

static tp_fx sample_land(const pick_ray *r, tp_fx x, tp_fx z)
{
    const tp_surface *s = r->surface;
    return r->floor ? -s->by->coastal->floor(s->coastal, x, z).depth : TP_FX_MIN;
}

/* Returns the height of the ray above water or land, whichever is higher; negative
 * below. */
static int64_t height_above_water_or_land(const pick_ray *r, int64_t t)
{
    const tp_vec3 p = ray_point(r, t);
    const tp_fx water = sample_water(r, p.x, p.z), land = sample_land(r, p.x, p.z);

    return (int64_t)p.y - (water > land ? water : land);
}

/* -- the walk ------------------------------------------------------------------------ */

typedef struct { int64_t from, to; } stretch;       /* along the ray, Q16.16 m */

/* Clips the interval to low..high on an axis; returns false if nothing is left. */
static bool clip_interval(stretch *s, tp_fx eye, tp_q30 direction, int64_t low,
                          int64_t high)
{
    if (direction == 0)
        return eye >= low && eye <= high;
    const int64_t a = (low - eye) * TP_Q30_ONE / direction,
                  b = (high - eye) * TP_Q30_ONE / direction;
    const int64_t first = a < b ? a : b, last = a < b ? b : a;
    s->from = s->from > first ? s->from : first;
    s->to = s->to < last ? s->to : last;
    return s->from < s->to;
}

static bool clip_interval_to_tank(stretch *s, const pick_ray *r, const tp_rectangle *sides)
{
    return clip_interval(s, r->eye.x, r->way.x, sides->x0, sides->x1)
           && clip_interval(s, r->eye.z, r->way.z, sides->z0, sides->z1);
}

/* Land may be higher than any water, so a scene with a floor has no upper limit. */
static bool clip_ray_to_water(const pick_ray *r, const tp_scene *scene, stretch *s)
{
    const int64_t high = (int64_t)tp_surface_height_bound(r->surface) + LEAST;
    const tp_rectangle sides = tp_pool_sides(scene);

    *s = (stretch){ r->near, FAR };
    return clip_interval(s, r->eye.y, r->way.y, -high, r->floor ? TP_FX_MAX : high)
           && (!tp_has_tank(scene) || clip_interval_to_tank(s, r, &sides));
}

static int64_t march_step_length(const pick_ray *r, int64_t t, int64_t clearance)
{
    const int64_t half = (clearance < 0 ? -clearance : clearance) / 2;
    const int64_t pixels = t * 2 * (1 << 14) / r->focal_q14;
    const int64_t part = t / 512, least = pixels > part ? pixels : part;
    const int64_t by = half > least ? half : least;

    return by > LEAST ? by : LEAST;
}

/* Bisects between the two sides of the surface; returns the first distance on the far
 * side. */
static int64_t bisect_crossing(const pick_ray *r, int64_t from, int64_t to, bool above)
{
    while (to - from > 1) {
        const int64_t middle = (from + to) / 2;
        if ((height_above_water_or_land(r, middle) > 0) == above)
            from = middle;
        else
            to = middle;
    }
    return to;
}

static bool march_to_surface(const pick_ray *r, const stretch *s, int64_t *t)
{
    int64_t from = s->from, high = height_above_water_or_land(r, from);
    const bool above = high > 0;

    while (from < s->to) {
        const int64_t next = from + march_step_length(r, from, high);
        const int64_t to = next < s->to ? next : s->to;
        high = height_above_water_or_land(r, to);
        if ((high > 0) != above) {
            *t = bisect_crossing(r, from, to, above);
            return true;
        }
        from = to;
    }
    return false;
}

bool tp_world_pick(const tp_program *program, const tp_world *world,
                   const tp_scene *scene, uint32_t width, uint32_t height, tp_fx x_px,
                   tp_fx y_px, tp_vec3 *at)
{
    TP_ASSERT(world != NULL && world->layout.bytes > 0 && at != NULL);
    const tp_drawn drawn = tp_world_interpolate(world);
    tp_wave_models models;
    tp_surface surface =
        application_surface(tp_program_or_linked(program), world, &models);
    stretch s;
    int64_t t;

    surface.phases = drawn.phases;
    surface.lag = world->lag;
    if (scene->water.pool_normal_strength > 0) /* pools change the shading alone */
        surface.pool = surface.field = NULL;
    if (width == 0 || height == 0 || width > MOST || height > MOST)
        return false;
    const uint32_t side[2] = { width, height };
    const pick_ray r = make_ray(&surface, &drawn.camera, scene, side, x_px, y_px);
    if (!clip_ray_to_water(&r, scene, &s) || !march_to_surface(&r, &s, &t))
        return false;
    /* The ray's own point: at the side of a pool the surface steps, and the ray may meet
     * the step between its two heights. */
    *at = ray_point(&r, t);
    return sample_water(&r, at->x, at->z) >= sample_land(&r, at->x, at->z);
}
