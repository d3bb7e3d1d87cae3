/* SPDX-License-Identifier: MIT */
/*
 * Fast span stage of the view from above into clear water: floor or walls, caustics, and
 * the water's own light; all colours are lit here, and the light stage after this one adds
 * the reflection alone.
 *
 * The view is refracted at level water at both ends of a block of 16 columns of a run.
 * Between them three quantities are linear: the way from the surface to the floor, the
 * share of light that the water leaves, and the floor's light.  Slopes move a column's
 * place on the floor by the derivatives of the refracted ray [F4] at level water:
 *
 *     way = eta in + lean n,   lean = eta ci - ct,   ci = -in.n,   ct^2 = 1 - eta^2 + (eta ci)^2
 *     d lean / d ci = eta (1 - eta ci / ct) = g,   d ci = in.x dsx + in.z dsz
 *     d way.x = -lean dsx,   d way.y = g d ci
 *
 * With quality.dispersion=fast, red and blue see the floor at shifted places, by the
 * derivative of the way by eta at level water, d place.x = path in.x d eta / ct^2 and
 * d place.z likewise; other rungs leave dispersion out.
 * One plane stands for the floor of a block.  fast_floor_stage.c has
 * the colours of a block, fast_walls_stage.c caustics and the walls of a tank.
 *
 * Errors against the exact stages, as printed by
 * tests/unit/test_features_underwater_quick.c for floors of random texels: 1 to 8 levels of
 * 255 rms; shipped scenes, without foam and mirror, have 32 to 34 dB.
 */
#include "features/underwater/underwater.h"
#include "features/underwater/fast_refraction.h"
#include "shade/colour.h"
#include "shade/refracted_ray.h"
#include "shade/slope.h"

/* -- the ends of a block ------------------------------------------------------------- */

/* The part of the view that is equal along a row.  x, y, z: view direction at the middle
 * column for 1 m of depth; right: per focal length; Q16.  square: of the distance from the
 * middle row, in focal lengths, Q24. */
typedef struct {
    int32_t  x, y, z, right_x, right_y, right_z;
    uint32_t square;
} view_row;

static view_row view_row_make(const tp_shade *shade, int32_t y)
{
    const tp_view_axes *a = &shade->world;
    const int32_t from = shade->v0 - 16 * y - 8, near = tp_quick_over_focal(shade, from);
    const int64_t v = tp_over_focal(shade, from);

    return (view_row){
        (int32_t)(v * (a->up.x >> 14) >> 16) - (a->back.x >> 14),
        (int32_t)(v * (a->up.y >> 14) >> 16) - (a->back.y >> 14),
        (int32_t)(v * (a->up.z >> 14) >> 16) - (a->back.z >> 14),
        a->right.x >> 14, a->right.y >> 14, a->right.z >> 14,
        (uint32_t)near * (uint32_t)near >> 4,
    };
}

/* The view into the water at a column, through level water. */
typedef struct {
    tp_refracted_ray ray;       /* way: refracted */
    tp_ray  in;                 /* view direction above the water, Q1.14 */
    int32_t lean;               /* see above, Q1.14 */
} level_view;

/* Returns a coordinate of a point of the view, m.  Directions in Q16 are off by 1 m in
 * 30 km; beyond the range of 16.16 coordinates wrap. */
TP_ALWAYS_INLINE tp_fx along_view(tp_fx eye, int32_t way, tp_fx depth)
{
    return (tp_fx)((uint32_t)eye + (uint32_t)((int64_t)way * depth >> 16));
}

#define FAR_WATER (2048 * TP_FX_ONE)    /* m; heights of nearer water are off by 2 cm */

/* Returns the height of the water, m; far water counts as level: there the view's rounding
 * would lift the water off a shallow floor, or sink it below. */
TP_ALWAYS_INLINE tp_fx height_of_water(tp_fx eye, int32_t way, tp_fx depth)
{
    return depth < FAR_WATER ? along_view(eye, way, depth) : 0;
}

/* Returns a component of the unit vector along a view direction, Q1.14.  The root of a view
 * beyond four focal lengths is that of four. */
TP_ALWAYS_INLINE int32_t unit_component(int32_t way, int32_t unit)
{
    return tp_ssat((way >> 4) * unit, 12, 15);
}

/* Returns the view at sample i. */
TP_ALWAYS_INLINE level_view refract_at_level_water(const tp_shade *shade,
                                                   const view_row *row, const tp_run *run,
                                                   int32_t i)
{
    const tp_underwater *in = shade->underwater;
    const int32_t u = (int32_t)tp_over_focal(shade, 16 * (run->x + i) + 8 - shade->u0);
    const int32_t near = tp_clamp(u >> 2, -65535, 65535);
    const int32_t unit =
        tp_rsqrt_one_plus(row->square + ((uint32_t)near * (uint32_t)near >> 4));
    const int32_t x = row->x + (int32_t)((int64_t)u * row->right_x >> 16);
    const int32_t y = row->y + (int32_t)((int64_t)u * row->right_y >> 16);
    const int32_t z = row->z + (int32_t)((int64_t)u * row->right_z >> 16);
    const int32_t to_x = unit_component(x, unit), to_z = unit_component(z, unit);
    const int32_t to_y = unit_component(y, unit), eta = in->eta[1];
    const uint32_t s2 = (1u << 28) - (uint32_t)(to_y * to_y);
    const int32_t ct =
        tp_sqrt_one_minus((uint32_t)((uint64_t)s2 * (uint32_t)in->eta2[1] >> 14));
    const tp_fx far =
        tp_fx_saturate(tp_depth_from_zi(in->zi_near, tp_key_zi(run->key[i])));

    return (level_view){
        .ray = { { along_view(shade->eye.x, x, far), height_of_water(shade->eye.y, y, far),
                   along_view(shade->eye.z, z, far) },
                 { eta * to_x >> 14, -ct, eta * to_z >> 14, 0 }, far },
        .in = { to_x, to_y, to_z, 0 },
        .lean = -(eta * to_y >> 14) - ct,
    };
}

/* -- the floor of a block ------------------------------------------------------------ */

#define LEAST_SPEED 1024        /* Q1.14; slower rays never meet the floor */

/* Returns the speed at which a ray approaches the plane, Q1.14. */
TP_ALWAYS_INLINE int32_t approach(const tp_floor_plane *floor, tp_ray way)
{
    if (floor->rise_x == 0 && floor->rise_z == 0)
        return -way.y;
    return (int32_t)(((int64_t)floor->rise_x * way.x + (int64_t)floor->rise_z * way.z) >> 16)
         - way.y;
}

/* Returns the path from the surface to the floor, m. */
TP_ALWAYS_INLINE tp_fx path_to_floor(const tp_floor_plane *floor, const tp_refracted_ray *ray)
{
    const tp_fx gap = tp_fx_add_sat(ray->at.y, tp_floor_plane_depth(floor, ray->at));
    const int32_t down = approach(floor, ray->way);

    if (gap <= 0)
        return 0;
    return down < LEAST_SPEED ? TP_UNDERWATER_FAR : tp_underwater_closing_distance(gap, down);
}

static tp_fx mean(tp_fx a, tp_fx b)
{
    return (tp_fx)(((int64_t)a + b) >> 1);
}

/* Returns the ray in the middle of two. */
static tp_refracted_ray middle_ray(const tp_refracted_ray *a, const tp_refracted_ray *b)
{
    return (tp_refracted_ray){
        { mean(a->at.x, b->at.x), mean(a->at.y, b->at.y), mean(a->at.z, b->at.z) },
        { (a->way.x + b->way.x) >> 1, (a->way.y + b->way.y) >> 1, (a->way.z + b->way.z) >> 1,
          0 },
        mean(a->far, b->far)
    };
}

#define WIDE_BLOCK (16 * TP_FX_ONE)     /* m */

/* True if the ends lie so far apart that a plane through one place of the floor would leave
 * the floor at the other end. */
static bool is_wide(const tp_refracted_ray *a, const tp_refracted_ray *b)
{
    return tp_abs(mean(a->at.x, -b->at.x)) > WIDE_BLOCK / 2
        || tp_abs(mean(a->at.z, -b->at.z)) > WIDE_BLOCK / 2;
}

/* Finds the floor near the point that the ray between a and b hits.  Returns NULL if the
 * water there is too deep for a floor to be seen. */
static const tp_floor_plane *find_block_floor(const tp_shade *shade, tp_fx opaque,
                                              const tp_refracted_ray *a,
                                              const tp_refracted_ray *b,
                                              tp_floor_plane *floor)
{
    const tp_refracted_ray middle = middle_ray(a, b);

    *floor = tp_underwater_sample_floor(shade->underwater, middle.at);
    if ((int64_t)floor->depth + middle.at.y > opaque)
        return NULL;
    *floor = tp_underwater_find_floor_plane(shade, &middle);
    if (is_wide(a, b)) {
        floor->depth = tp_floor_plane_depth(floor, middle.at);
        floor->rise_x = floor->rise_z = 0;
    }
    return floor;
}

/* True if both ends lie on one outer side of the walls of an island. */
static bool are_outside(const tp_underwater *in, const tp_refracted_ray *a,
                        const tp_refracted_ray *b)
{
    return (a->at.x < in->x0 && b->at.x < in->x0) || (a->at.x > in->x1 && b->at.x > in->x1)
        || (a->at.z < in->z0 && b->at.z < in->z0) || (a->at.z > in->z1 && b->at.z > in->z1);
}

/* -- the numbers of a block ---------------------------------------------------------- */

/* Returns far (lean + a k), for far in Q10, a in Q12, the others in Q14; limited to 32 m. */
TP_ALWAYS_INLINE int32_t derivative(int32_t far, int32_t lean, int32_t a, int32_t k)
{
    return tp_ssat((int32_t)((int64_t)far * (lean + (a * k >> 12)) >> 14), 0, 16);
}

/* Sets the derivatives of the place by the slopes, from the view in one column and the
 * block's path: m per unit, Q10.  With a speed of 1/4 or more and floors of slopes up to 8,
 * a is below 2^13.6 and k below 2^16.7. */
TP_ALWAYS_INLINE void set_derivatives(const tp_underwater *in, const level_view *v,
                                      const tp_floor_plane *floor, tp_floor_block *to)
{
    const int32_t eta = in->eta[1], ct = -v->ray.way.y, down = approach(floor, v->ray.way);
    const int32_t speed = down > 4096 ? down : 4096, lean = -v->lean;
    const int32_t g = eta + (eta * (eta * v->in.y / ct) >> 14);
    const int32_t kx = (g * v->in.x >> 14) - (int32_t)((int64_t)floor->rise_x * lean >> 16);
    const int32_t kz = (g * v->in.z >> 14) - (int32_t)((int64_t)floor->rise_z * lean >> 16);
    const int32_t ax = v->ray.way.x * 4096 / speed, az = v->ray.way.z * 4096 / speed;
    const int32_t far = to->path < 64 * TP_FX_ONE ? to->path >> 6 : 64 << 10;       /* Q10 */

    to->by_slope_x = tp_pair16(derivative(far, lean, ax, kx), derivative(far, 0, ax, kz));
    to->by_slope_z = tp_pair16(derivative(far, 0, az, kx), derivative(far, lean, az, kz));
}

/* Returns (b - a) / (count - 1). */
TP_ALWAYS_INLINE int32_t step(int32_t a, int32_t b, int32_t count)
{
    return (int32_t)(((int64_t)b - a) * tp_fast_over[count - 1] >> 16);
}

/* Returns the way from a column's rest position to its place on the floor along an axis, m;
 * wraps as positions do. */
TP_ALWAYS_INLINE tp_fx way_to_place(tp_fx at, uint32_t rest, int32_t way, tp_fx path)
{
    return (tp_fx)((uint32_t)at - rest + (uint32_t)((int64_t)way * path >> 14));
}

static void set_places_of_ends(const tp_run *run, int32_t i, int32_t stop,
                               const tp_refracted_ray *a, const tp_refracted_ray *b,
                               const tp_fx path[2], tp_floor_block *to)
{
    const int32_t last = stop - 1;

    to->x = way_to_place(a->at.x, run->s[i], a->way.x, path[0]);
    to->z = way_to_place(a->at.z, run->t[i], a->way.z, path[0]);
    to->step_x = step(to->x, way_to_place(b->at.x, run->s[last], b->way.x, path[1]),
                      to->count);
    to->step_z = step(to->z, way_to_place(b->at.z, run->t[last], b->way.z, path[1]),
                      to->count);
}

/* Sets the weights of one channel: of the floor's texel and of the water's own colour.
 * light: of the floor, Q8. */
TP_ALWAYS_INLINE void set_channel(const tp_underwater *in, int32_t light, const tp_fx path[2],
                                  int channel, tp_floor_block *to)
{
    const uint32_t halvings = in->absorb.halvings[channel];
    const int32_t colour = (int32_t)(in->floor.colour >> (16 - 8 * channel) & 0xff);
    const int32_t bright = light * (colour + (colour >> 7)) >> 8;
    const int32_t a = tp_absorb_share_left(halvings, path[0]) >> 2;             /* Q14 */
    const int32_t b = tp_absorb_share_left(halvings, path[1]) >> 2;
    const int32_t less = (b - a) * (int32_t)tp_fast_over[to->count - 1] >> 16;

    to->weights[channel] = tp_pair16(a * bright >> 8, 16384 - a);
    to->weights_step[channel] = ((uint32_t)(less * bright >> 8) << 16) - (uint32_t)less;
}

/* Sets the light of the floor: without caustics, and the part of it that caustics
 * multiply; Q8. */
static void set_floor_light(const tp_shade *shade, int32_t nl, tp_floor_block *to)
{
    to->sun = (256 - shade->ambient) * (nl < 16384 ? nl : 16384) >> 14;
    to->light = shade->ambient + to->sun;
}

/* Returns red's shift along an axis, m: `way` is the view's direction along the axis above
 * the water, Q1.14. */
TP_ALWAYS_INLINE tp_fx shift_along_axis(int32_t spread, const level_view *view, int32_t way,
                                        tp_fx path)
{
    const int32_t square = view->ray.way.y * view->ray.way.y >> 14;
    return (tp_fx)((int64_t)path * (way * spread / square) >> 14);
}

/* Sets the shifts of red at the ends of a block. */
static void set_shifts(const tp_underwater *in, const level_view *a, const level_view *b,
                       const tp_fx path[2], tp_floor_block *to)
{
    const int32_t spread = (in->eta[0] - in->eta[2]) / 2;

    to->shift_x = shift_along_axis(spread, a, a->in.x, path[0]);
    to->shift_z = shift_along_axis(spread, a, a->in.z, path[0]);
    to->shift_step_x =
        step(to->shift_x, shift_along_axis(spread, b, b->in.x, path[1]), to->count);
    to->shift_step_z =
        step(to->shift_z, shift_along_axis(spread, b, b->in.z, path[1]), to->count);
}

/* Sets up the block of columns [i, stop) of a run.  Returns false if nothing but the
 * water's own colour is seen. */
TP_ALWAYS_INLINE bool set_up_block(const tp_shade *shade, const tp_clear_water *clear,
                                   const view_row *row, const tp_run *run, int32_t i,
                                   int32_t stop, tp_floor_block *block, int shifted)
{
    const tp_fast_refraction *fast = &clear->fast;
    const tp_underwater *in = shade->underwater;
    const level_view a = refract_at_level_water(shade, row, run, i);
    const level_view b = refract_at_level_water(shade, row, run, stop - 1);
    const tp_floor_plane *floor = &fast->floor;
    tp_floor_plane found;

    if (in->island && are_outside(in, &a.ray, &b.ray))
        return false;
    if (!fast->plane)
        floor = find_block_floor(shade, fast->opaque, &a.ray, &b.ray, &found);
    if (!floor)
        return false;
    const tp_fx path[2] = { path_to_floor(floor, &a.ray), path_to_floor(floor, &b.ray) };
    if (path[0] > fast->opaque && path[1] > fast->opaque && !in->walled && !in->island)
        return false;
    block->first = i;
    block->count = stop - i;
    block->samples = block->count / 2 + 1;
    block->path = mean(path[0], path[1]);
    block->far = tp_fx_add_sat(mean(a.ray.far, b.ray.far), block->path);
    block->at_y = mean(a.ray.at.y, b.ray.at.y);
    block->floor_y = (tp_fx)((uint32_t)block->at_y
                             + (uint32_t)((int64_t)a.ray.way.y * block->path >> 14));
    block->lit = fast->lit;
    set_floor_light(shade, floor->nl, block);
    set_places_of_ends(run, i, stop, &a.ray, &b.ray, path, block);
    set_derivatives(in, &a, floor, block);
    if (shifted)
        set_shifts(in, &a, &b, path, block);
    const int32_t light = shade->caustic ? 256 : block->light;
    set_channel(in, light, path, 0, block);
    set_channel(in, light, path, 1, block);
    set_channel(in, light, path, 2, block);
    return true;
}

/* -- the stage ----------------------------------------------------------------------- */

/* Lights the water's own colour: three parts of deep water, one of the lit colour. */
static void shade_deep_water(const tp_shade *shade, uint32_t lit, int32_t count,
                             uint32_t *colour)
{
    const uint32_t deep = shade->underwater->deep;
    uint32_t last = colour[0], body = tp_fast_own_colour(deep, last, lit);

    for (int32_t k = 0; k < count; k++) {
        if (colour[k] != last) {
            last = colour[k];
            body = tp_fast_own_colour(deep, last, lit);
        }
        colour[k] = body;
    }
}

static void mix_objects(const tp_shade *shade, const tp_clear_water *clear, tp_run *run,
                        int32_t i, int32_t stop)
{
    const tp_planar_map *map = clear->refraction_map;
    const uint32_t zi = tp_key_zi(run->key[i + (stop - i) / 2]);
    const tp_fx far = tp_fx_saturate(tp_depth_from_zi(shade->underwater->zi_near, zi));

    if (run->y / 2 + 64 < map->y0 || run->y / 2 - 64 >= map->y1
        || (run->x + stop) / 2 + 64 < map->x0 || (run->x + i) / 2 - 64 >= map->x1)
        return;
    for (; i < stop; i++)
        run->colour[i] = clear->mix(shade, map, run, i, far, -4 * tp_high16(run->slope[i]),
                                    -4 * tp_low16(run->slope[i]), run->colour[i]);
}

TP_ALWAYS_INLINE void shade_run(const tp_shade *shade, tp_run *run, int shifted)
{
    const tp_clear_water *clear = run->mine;
    const bool floored = shade->underwater->floored || shade->underwater->island;
    const view_row row = view_row_make(shade, run->y);
    tp_floor_block block;

    for (int32_t i = 0, stop; i < run->count; i = stop) {
        stop = tp_block_end(run, i);
        if (!floored || !set_up_block(shade, clear, &row, run, i, stop, &block, shifted))
            shade_deep_water(shade, clear->fast.lit, stop - i, run->colour + i);
        else if (shifted)
            tp_fast_floor_shade_shifted(shade, &block, run);
        else
            tp_fast_floor_shade(shade, &block, run);
        if (clear->refraction_map)
            mix_objects(shade, clear, run, i, stop);
    }
}

void tp_stage_quick_refract(const tp_shade *shade, tp_run *run)
{
    shade_run(shade, run, 0);
}

void tp_stage_quick_refract_shifted(const tp_shade *shade, tp_run *run)
{
    shade_run(shade, run, 1);
}
