/* SPDX-License-Identifier: MIT */
/* Work of drops, of walls in a pool and around it, and of its glass; see works.c. */
#include "base/base.h"
#include "scene/works.h"

#define BALL_FACES 440          /* of a large drop; small ones: a quarter */

/* Bands of so many rows that a thing of such a height touches. */
static uint32_t bands(int64_t rows, int32_t band)
{
    return (uint32_t)(rows / band) + 1;
}

/* -- drops --------------------------------------------------------------------------- */

/* The sphere that they fall from. */
void tp_site_add_drops(tp_site *w, const tp_outlook *o)
{
    const tp_scene *s = w->scene;
    const tp_vec3 sphere = { s->drops.x, s->drops.y, s->drops.z };
    const tp_vec3 way = tp_stand_way(w->at.eye, sphere);
    const tp_vec3 view = tp_rotate(&w->at.turn, way);
    uint32_t *work = w->works.of;

    if (s->drops.count <= 0)
        return;
    work[TP_WORK_rings] = s->drops.every > 0 ? o->vertices : 0;
    if (-view.z <= 0)
        return;
    const int64_t rows = (int64_t)o->focal * 4 * s->drops.radius / -view.z;
    const uint32_t faces = rows > 16 ? BALL_FACES : BALL_FACES / 4;
    work[TP_WORK_ball] = faces * bands(rows, TP_WORK_BAND);
    if (w->mirrors) {
        work[TP_WORK_ball] += faces * bands(rows / 2, TP_WORK_STRIP);
        w->far = -view.z > w->far ? -view.z : w->far;
    }
}

/* -- walls --------------------------------------------------------------------------- */

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

bool tp_site_wall(const tp_site *w, tp_vec3 ray, int64_t far)
{
    const tp_vec3 eye = w->at.eye;
    const int64_t high = wall_height(w->scene);

    if (!w->assets->pool_mask || w->scene->pool.cols <= 0 || eye.y <= high)
        return false;
    for (int k = 0; k <= 32; k++) {         /* from where it is as low as a wall */
        const int64_t way = far - far / 32 * k * high / eye.y;
        if (is_wall(w, eye.x + (way * ray.x >> 16), eye.z + (way * ray.z >> 16)))
            return true;
    }
    return false;
}

/* Runs of a row of cells that do not go on from the row before, as frame/tank.c joins
 * them. */
static uint32_t blocks_of(const tp_site *w)
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

/* Every face of them is cut anew in every band. */
void tp_site_add_walls(tp_site *w, const tp_outlook *o)
{
    const tp_scene *s = w->scene;
    uint32_t quads = 0, strips = bands(w->height - 1, TP_WORK_BAND);

    if (s->pool.cols <= 0)
        return;
    if (w->assets->pool_mask) {
        w->works.of[TP_WORK_walled] = o->vertices;
        quads += 5 * blocks_of(w);
    }
    if (tp_has_tank(s))
        quads += s->tank.kind == TP_TANK_STONE ? 12 : 6;
    if (w->mirrors && quads > 0) {
        strips += bands(w->height / 2 - 1, TP_WORK_STRIP);
        w->far = (int64_t)1 << 32;
    }
    w->works.of[TP_WORK_wall_face] = 2 * quads * strips;
}

/* -- glass --------------------------------------------------------------------------- */

/* Where a ray enters the tank, as a share of one ahead, through a wall that the eye stands
 * outside of; 0: through none.  `y`: there. */
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

static void add_sides(tp_site *w, const tp_rectangle *r)
{
    const tp_scene *s = w->scene;
    uint32_t panes = 0, sides = 0;

    for (int32_t j = 0; j < TP_RAYS; j++)
        for (int32_t i = 0; i < TP_RAYS; i++) {
            const tp_vec3 ray =
                tp_stand_ray(&w->at, w->at.wide * (2 * i + 1 - TP_RAYS) / TP_RAYS,
                             w->at.high * (2 * j + 1 - TP_RAYS) / TP_RAYS);
            int64_t y = 0;      /* gcc -O1 --coverage does not see that it is set */
            if (!enters(w, r, ray, &y) || y < -(int64_t)s->tank.depth || y > s->tank.rim)
                continue;
            panes++;
            sides += y < 0;
            if (y < 0)
                w->solid[j] |= 1u << i;
        }
    w->works.of[TP_WORK_pane] = panes;
    w->works.of[TP_WORK_side] = sides;
    w->walls += sides;
}

/* A wall of glass has a post for each line of the grid that ends there. */
void tp_site_add_glass(tp_site *w)
{
    const tp_scene *s = w->scene;
    const tp_rectangle r = tp_pool_sides(s);
    const tp_vec3 eye = w->at.eye;
    const uint32_t across = eye.x < r.x0 || eye.x > r.x1;
    const uint32_t along = eye.z < r.z0 || eye.z > r.z1;
    const int64_t cell = s->grid.cell > 0 ? s->grid.cell : 1;
    int64_t posts = 0;

    if (!tp_has_tank(s) || s->tank.kind != TP_TANK_GLASS)
        return;
    posts += across ? tp_limit(((int64_t)r.z1 - r.z0) / cell, s->grid.rows) + 1 : 0;
    posts += along ? tp_limit(((int64_t)r.x1 - r.x0) / cell, s->grid.cols) + 1 : 0;
    w->works.of[TP_WORK_side_face] = (uint32_t)posts * 2
                                   * bands(w->height - 1, TP_WORK_BAND);
    if (across || along)
        add_sides(w, &r);
}
