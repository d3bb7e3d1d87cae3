/* SPDX-License-Identifier: MIT */
/* Cost estimate of a tank's stone walls and of a pool's inner walls. */
#include "base/base.h"
#include "features/tank/tank.h"
#include "scene/fixed_cost.h"

static bool is_wall(const tp_site *w, int64_t x, int64_t z)
{
    const tp_grey *mask = w->assets->pool_mask;
    const tp_rectangle r = tp_pool_sides(w->scene);

    if (!mask || x < r.x0 || x >= r.x1 || z < r.z0 || z >= r.z1)
        return false;
    const uint32_t col = (uint32_t)((x - r.x0) * mask->cols / ((int64_t)r.x1 - r.x0));
    const uint32_t row = (uint32_t)((z - r.z0) * mask->rows / ((int64_t)r.z1 - r.z0));
    return mask->sample[row * mask->cols + col] < 0x8000;
}

static tp_fx wall_height(const tp_scene *s)
{
    return tp_has_tank(s) ? s->tank.rim : 3 * s->pool.cell;
}

/* True if an inner wall of the pool stops a ray that would meet the water `far` m ahead,
 * Q16. */
static bool is_ray_stopped(const tp_site *w, tp_vec3 ray, int64_t far)
{
    const tp_vec3 eye = w->at.eye;
    const int64_t high = wall_height(w->scene);

    if (!w->assets->pool_mask || eye.y <= high)
        return false;
    /* points of the ray, from the water back to where the ray is as high as a wall's top */
    for (int k = 0; k <= 32; k++) {
        const int64_t way = far - far / 32 * k * high / eye.y;
        if (is_wall(w, eye.x + (way * ray.x >> 16), eye.z + (way * ray.z >> 16)))
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
            const bool here = col < pool->cols && is_wall(w, x, z);
            const bool above = row > 0 && col < pool->cols
                            && is_wall(w, x, z - pool->cell);
            if (here && !wall)
                same = above && !(col > 0 && is_wall(w, x - pool->cell, z - pool->cell));
            if (!here && wall)
                blocks += !(same && !above);
            wall = here;
            same = same && above == here;
        }
    }
    return blocks;
}

/* Counts the faces; every face is clipped again in every band. */
static void count_work(tp_site *w)
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

static void count_pixel_work(tp_site *w, const tp_work_pixels *px)
{
    w->fixed_cost.of[TP_WORK_wall] = tp_work_ray_pixels(w, px->stopped);
}

const tp_cost tp_tank_cost = { .work = count_work,
                               .stops = is_ray_stopped,
                               .pixels = count_pixel_work };
