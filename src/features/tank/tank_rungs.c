/* SPDX-License-Identifier: MIT */
/*
 * Cost estimate of a tank: stone walls and a pool's inner walls; glass, the water's side
 * behind the walls and the panes.
 */
#include "base/base.h"
#include "features/tank/tank.h"
#include "quality/prices.h"

/* -- stone --------------------------------------------------------------------------- */

static bool is_mask_wall(const tp_site *w, int64_t x, int64_t z)
{
    const tp_grey *mask = w->assets->pool_mask;
    const tp_rectangle r = tp_pool_sides(w->scene);

    if (!mask || x < r.x0 || x >= r.x1 || z < r.z0 || z >= r.z1)
        return false;
    const uint32_t col = (uint32_t)((x - r.x0) * mask->cols / ((int64_t)r.x1 - r.x0));
    const uint32_t row = (uint32_t)((z - r.z0) * mask->rows / ((int64_t)r.z1 - r.z0));
    return mask->sample[row * mask->cols + col] < 0x8000;
}

static bool is_within(const tp_rectangle *r, int64_t x, int64_t z)
{
    return x >= r->x0 && x < r->x1 && z >= r->z0 && z < r->z1;
}

/* True for a point in the tank's stone around the water. */
static bool is_in_stone(const tp_site *w, int64_t x, int64_t z)
{
    const tp_rectangle in = tp_pool_sides(w->scene);
    const tp_rectangle out = tp_tank_outer_sides(w->scene, &in);

    return w->scene->tank.kind == TP_TANK_STONE && tp_has_tank(w->scene)
           && is_within(&out, x, z) && !is_within(&in, x, z);
}

static tp_fx wall_height(const tp_scene *s)
{
    return tp_has_tank(s) ? s->tank.rim : 3 * s->pool.cell;
}

/* True if stone stops a ray that would meet the water `water_distance` m ahead, Q16. */
static bool is_ray_stopped_by_stone(const tp_site *w, tp_vec3 ray,
                                         int64_t water_distance)
{
    const tp_vec3 eye = w->at.eye;
    const int64_t high = wall_height(w->scene);

    if (eye.y <= high)
        return false;
    /* points of the ray, from the water back to where the ray is as high as a wall's top */
    for (int k = 0; k <= 32; k++) {
        const int64_t way = water_distance - water_distance / 32 * k * high / eye.y;
        const int64_t x = eye.x + (way * ray.x >> 16), z = eye.z + (way * ray.z >> 16);
        if (is_mask_wall(w, x, z) || is_in_stone(w, x, z))
            return true;
    }
    return false;
}

/* Returns the number of blocks: runs of wall cells in a row without an equal run in the
 * row before, joined as in tank_drawing.c. */
static uint32_t count_blocks(const tp_site *w)
{
    const tp_scene_pool *pool = &w->scene->pool;
    const tp_rectangle r = tp_pool_sides(w->scene);
    uint32_t blocks = 0;

    for (int32_t row = 0; row < pool->rows; row++) {
        const int64_t z = r.z0 + (int64_t)pool->cell * row + pool->cell / 2;
        bool wall = false, same = false;
        for (int32_t col = 0; col <= pool->cols; col++) {
            const int64_t x = r.x0 + (int64_t)pool->cell * col + pool->cell / 2;
            const bool here = col < pool->cols && is_mask_wall(w, x, z);
            const bool above = row > 0 && col < pool->cols
                            && is_mask_wall(w, x, z - pool->cell);
            if (here && !wall)
                same = above
                       && !(col > 0 && is_mask_wall(w, x - pool->cell, z - pool->cell));
            if (!here && wall)
                blocks += !(same && !above);
            wall = here;
            same = same && above == here;
        }
    }
    return blocks;
}

/* Counts the faces; every face is clipped again in every band. */
static void count_wall_work(tp_site *w)
{
    const tp_scene *s = w->scene;
    uint32_t quads = 0, strips = tp_work_bands(w->height - 1, TP_WORK_BAND);

    if (w->assets->pool_mask) {
        w->fixed_cost.of[TP_WORK_walled] = w->estimate->vertices;
        quads += 5 * count_blocks(w);
    }
    if (tp_has_tank(s))
        quads += s->tank.kind == TP_TANK_STONE ? 12 : 6;
    if (w->mirrors && quads > 0) {
        strips += tp_work_bands(w->height / 2 - 1, TP_WORK_STRIP);
        w->far = (int64_t)1 << 32;
    }
    w->fixed_cost.of[TP_WORK_wall_face] = 2 * quads * strips;
}

static void count_wall_pixel_work(tp_site *w, const tp_work_pixels *px)
{
    w->fixed_cost.of[TP_WORK_wall] = tp_work_ray_pixels(w, px->stopped);
}

const tp_cost tp_tank_cost = { .work = count_wall_work,
                               .stops = is_ray_stopped_by_stone,
                               .pixels = count_wall_pixel_work };

/* -- glass --------------------------------------------------------------------------- */

/* True if a ray enters the tank through a wall with the eye on its outer side.  *y is the
 * ray's height at the wall. */
static bool ray_enters_tank(const tp_site *w, const tp_rectangle *r, tp_vec3 ray,
                            int64_t *y)
{
    const tp_vec3 eye = w->at.eye;
    bool found = false;

    for (int axis = 0; axis < 2 && !found; axis++) {
        const int64_t from = axis ? eye.z : eye.x, way = axis ? ray.z : ray.x;
        const int64_t low = axis ? r->z0 : r->x0, high = axis ? r->z1 : r->x1;
        const int64_t wall = from > high ? high : low;
        if ((from <= high && from >= low) || way == 0 || (wall < from) != (way < 0))
            continue;
        const int64_t t = (wall - from) * TP_FX_ONE / way;
        const int64_t aside = axis ? eye.x + (t * ray.x >> 16) : eye.z + (t * ray.z >> 16);
        *y = eye.y + (t * ray.y >> 16);
        found = aside >= (axis ? r->x0 : r->z0) && aside <= (axis ? r->x1 : r->z1);
    }
    return found;
}

static void count_glass_rays(tp_site *w, const tp_rectangle *r)
{
    const tp_scene *s = w->scene;
    uint32_t panes = 0, sides = 0;

    for (int32_t j = 0; j < TP_RAYS; j++)
        for (int32_t i = 0; i < TP_RAYS; i++) {
            const tp_vec3 ray = tp_work_ray(w, i, j);
            int64_t y = 0;      /* for compilers that miss the assignment by the call */
            if (!ray_enters_tank(w, r, ray, &y) || y < -(int64_t)s->tank.depth
                || y > s->tank.rim)
                continue;
            panes++;
            sides += y < 0;
            if (y < 0)
                w->solid[j] |= 1u << i;
        }
    w->fixed_cost.of[TP_WORK_pane] = panes;
    w->fixed_cost.of[TP_WORK_side] = sides;
    w->apart += sides;
}

/* Counts the faces of the water's sides.  A wall of glass has one post for each line of the
 * grid that ends at the wall (view/fan_tank.c); without these, one face. */
static void count_glass_work(tp_site *w)
{
    const tp_scene *s = w->scene;
    const tp_rectangle r = tp_pool_sides(s);
    const tp_vec3 eye = w->at.eye;
    const uint32_t across = eye.x < r.x0 || eye.x > r.x1;
    const uint32_t along = eye.z < r.z0 || eye.z > r.z1;
    const uint32_t line = tp_is_walled(s) ? tp_isqrt64(tp_fan_budget(s)) : 1;
    const uint32_t posts = (across + along) * line;

    w->fixed_cost.of[TP_WORK_side_face] = posts * 2
                                   * tp_work_bands(w->height - 1, TP_WORK_BAND);
    if (across || along)
        count_glass_rays(w, &r);
}

/* Converts the ray counts of count_glass_work() to pixels. */
static void count_glass_pixel_work(tp_site *w, const tp_work_pixels *px)
{
    uint32_t *work_of = w->fixed_cost.of;

    (void)px;
    work_of[TP_WORK_side] = tp_work_ray_pixels(w, work_of[TP_WORK_side]);
    work_of[TP_WORK_pane] = tp_work_ray_pixels(w, work_of[TP_WORK_pane]);
}

const tp_cost tp_glass_cost = { .work = count_glass_work,
                                .pixels = count_glass_pixel_work };
