/* SPDX-License-Identifier: MIT */
/* Cost estimate of a tank's glass: the water's side behind the walls, and the panes. */
#include "base/base.h"
#include "features/tank/tank.h"
#include "scene/fixed_cost.h"

/* True if a ray enters the tank through a wall with the eye on its outer side.  *y is the
 * ray's height at the wall. */
static bool enters(const tp_site *w, const tp_rectangle *r, tp_vec3 ray, int64_t *y)
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
            int64_t y = 0;      /* for compilers that miss the assignment in enters() */
            if (!enters(w, r, ray, &y) || y < -(int64_t)s->tank.depth || y > s->tank.rim)
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

/* Counts the faces of the water's sides.  A wall of glass has one post for each grid line
 * that ends at the wall. */
static void count_work(tp_site *w)
{
    const tp_scene *s = w->scene;
    const tp_rectangle r = tp_pool_sides(s);
    const tp_vec3 eye = w->at.eye;
    const uint32_t across = eye.x < r.x0 || eye.x > r.x1;
    const uint32_t along = eye.z < r.z0 || eye.z > r.z1;
    const int64_t cell = s->grid.cell > 0 ? s->grid.cell : 1;
    int64_t posts = 0;

    posts += across ? tp_clamp_abs(((int64_t)r.z1 - r.z0) / cell, s->grid.rows) + 1 : 0;
    posts += along ? tp_clamp_abs(((int64_t)r.x1 - r.x0) / cell, s->grid.cols) + 1 : 0;
    w->fixed_cost.of[TP_WORK_side_face] = (uint32_t)posts * 2
                                   * tp_work_bands(w->height - 1, TP_WORK_BAND);
    if (across || along)
        count_glass_rays(w, &r);
}

/* Converts the ray counts of count_work() to pixels. */
static void count_pixel_work(tp_site *w, const tp_work_pixels *px)
{
    uint32_t *work_of = w->fixed_cost.of;

    (void)px;
    work_of[TP_WORK_side] = tp_work_ray_pixels(w, work_of[TP_WORK_side]);
    work_of[TP_WORK_pane] = tp_work_ray_pixels(w, work_of[TP_WORK_pane]);
}

const tp_cost tp_glass_cost = { .work = count_work, .pixels = count_pixel_work };
