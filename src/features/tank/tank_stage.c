/* SPDX-License-Identifier: MIT */
/*
 * Span stages of a tank: the stone of the tank and of a pool's inner walls; behind walls
 * of glass the water's side, and the panes.
 *
 * The glass is thin: a ray is refracted as from air directly to water [F4].
 */
#include "features/tank/tank.h"
#include "raster/raster.h"
#include "shade/env.h"
#include "shade/material.h"
#include "shade/refracted_ray.h"
#include "shade/slope.h"

/* -- stone --------------------------------------------------------------------------- */

/* Shades stone.  The texture is projected along the largest component of the normal:
 * on x y, z y or x z. */
static uint32_t stone_colour(const tp_shade *shade, tp_packed_dir n,
                             const tp_refracted_ray *ray)
{
    int32_t x = tp_abs(tp_dir_x(n)), y = tp_abs(tp_dir_y(n)), z = tp_abs(tp_dir_z(n));
    tp_fx s = x > y && x > z ? ray->at.z : ray->at.x;
    tp_fx t = y >= x && y >= z ? ray->at.z : -ray->at.y;
    uint32_t colour =
        tp_wall_material_sample(&shade->underwater->wall, s, t, ray->far, false);

    return tp_light_matt_colour(shade, colour, n);
}

void tp_stage_wall(const tp_shade *shade, tp_run *run)
{
    tp_refracted_ray ray[TP_UNDERWATER_ROW];

    for (int32_t i = 0, stop; i < run->count; i = stop) {
        stop = tp_block_end(run, i);
        tp_underwater_set_start_points(shade, run, i, stop, ray);
        for (int32_t k = i; k < stop; k++)
            run->colour[k] = stone_colour(shade, run->n[k], &ray[k - i]);
    }
}

const tp_stage tp_tank_stages[] = {
#define X(name) tp_stage_##name,
    TP_STAGES_OF_tank(X)
#undef X
};

/* -- glass --------------------------------------------------------------------------- */

/* Returns the outward normal of wall `face`: +x, -x, +z, -z. */
static tp_ray wall_normal(uint32_t face)
{
    int32_t one = face & 1 ? -16384 : 16384;
    return face & 2 ? (tp_ray){ 0, 0, one, 0 } : (tp_ray){ one, 0, 0, 0 };
}

/* Returns the colour of the water's side at sample i; the view vectors of the run and the
 * ray's start are set. */
static uint32_t side_colour(const tp_shade *shade, const tp_run *run, int32_t i,
                            tp_refracted_ray ray)
{
    const tp_underwater *in = shade->underwater;
    const tp_ray view = { -run->vx[i], -run->vy[i], -run->vz[i], 0 };

    ray.way = tp_underwater_refract(in, 1, view, wall_normal(run->t[i]));
    return tp_underwater_trace(shade, &in->floor_plane, &ray, in->deep);
}

void tp_stage_tank_side(const tp_shade *shade, tp_run *run)
{
    tp_refracted_ray ray[TP_UNDERWATER_ROW];

    tp_run_fill_vectors_to_eye(shade, &shade->world, run);
    for (int32_t i = 0, stop; i < run->count; i = stop) {
        stop = tp_block_end(run, i);
        tp_underwater_set_start_points(shade, run, i, stop, ray);
        for (int32_t k = i; k < stop; k++)
            run->colour[k] = side_colour(shade, run, k, ray[k - i]);
    }
}

/* -- the water's side, fast ------------------------------------------------------------ */

/* Rays into the water at both ends of a block's columns. */
typedef struct {
    tp_refracted_ray first, last;
    int32_t columns;            /* from the first to the last */
} side_block;

static tp_refracted_ray side_ray(const tp_shade *shade, const tp_quick_ray_row *row,
                                 const tp_run *run, int32_t i)
{
    const tp_ray eye = tp_quick_ray(shade, row, 16 * (run->x + i) + 8);
    const tp_ray view = { -eye.x, -eye.y, -eye.z, 0 };
    tp_refracted_ray ray;

    tp_underwater_set_start_points(shade, run, i, i + 1, &ray);
    ray.way = tp_underwater_refract(shade->underwater, 1, view, wall_normal(run->t[i]));
    return ray;
}

/* Returns the end of the block's columns of one wall. */
static int32_t wall_end(const tp_run *run, int32_t i, int32_t stop)
{
    const uint32_t face = run->t[i];

    while (i < stop && run->t[i] == face)
        i++;
    return i;
}

/* Interpolates by `share`, 0..65536.  Both ends of a block see the same wall less than
 * 2^15 m away. */
static int32_t between(int32_t a, int32_t b, int32_t share)
{
    return (int32_t)(a + (((int64_t)b - a) * share >> 16));
}

/* Returns the colour at a column of the block. */
static uint32_t side_block_colour(const tp_shade *shade, const side_block *s, int32_t column)
{
    const tp_refracted_ray *a = &s->first, *b = &s->last;
    const int32_t share = s->columns > 0 ? column * 65536 / s->columns : 0;
    const tp_refracted_ray ray = {
        { between(a->at.x, b->at.x, share), between(a->at.y, b->at.y, share),
          between(a->at.z, b->at.z, share) },
        { between(a->way.x, b->way.x, share), between(a->way.y, b->way.y, share),
          between(a->way.z, b->way.z, share), 0 },
        between(a->far, b->far, share)
    };

    return tp_underwater_trace(shade, &shade->underwater->floor_plane, &ray,
                               shade->underwater->deep);
}

/* Sets the columns before `end`, `count` of them, between two colours. */
static void mix_columns(uint32_t *end, int32_t count, uint32_t here, uint32_t next)
{
    const uint32_t middle = tp_uhadd8(here, next);

    if (count > 1) {
        end[-count] = tp_uhadd8(here, middle);
        end[-1] = tp_uhadd8(middle, next);
    }
    if (count & 1)
        end[-(count + 1) / 2] = middle;
}

/* Shades columns i to stop - 1, of one wall and one block: rays are refracted at both ends,
 * every fourth column and the last one follow a ray between them, and the rest are mixed. */
static void shade_side_block(const tp_shade *shade, const tp_quick_ray_row *row, tp_run *run,
                             int32_t i, int32_t stop)
{
    const int32_t last = stop - 1 - i;
    side_block s = { .first = side_ray(shade, row, run, i), .columns = last };
    uint32_t *to = run->colour + i;

    s.last = last > 0 ? side_ray(shade, row, run, i + last) : s.first;
    to[0] = side_block_colour(shade, &s, 0);
    for (int32_t k = 0; k < last; ) {
        const int32_t next = k + 4 < last ? k + 4 : last;
        to[next] = side_block_colour(shade, &s, next);
        mix_columns(&to[next], next - k - 1, to[k], to[next]);
        k = next;
    }
}

void tp_stage_quick_tank_side(const tp_shade *shade, tp_run *run)
{
    const tp_quick_ray_row row = tp_quick_ray_row_make(shade, run->y);

    for (int32_t i = 0, stop; i < run->count; i = stop) {
        stop = wall_end(run, i, tp_block_end(run, i));
        shade_side_block(shade, &row, run, i, stop);
    }
}

/* -- panes --------------------------------------------------------------------------- */

/* Samples first to end - 1 of a run. */
typedef struct {
    int32_t first, end;
} pane_part;

/* Returns the part of a run covered by a convex polygon, with the fill rule of
 * triangles. */
static pane_part covered_part(const tp_pane *pane, const tp_run *run)
{
    int32_t y = run->y, x0 = INT32_MAX, x1 = INT32_MIN;

    for (int k = 0; k < pane->count; k++) {
        int n = k + 1 < pane->count ? k + 1 : 0;
        int a = pane->v[k] < pane->v[n] ? k : n, b = a == k ? n : k;
        if (tp_first_centre(pane->v[a]) > y || tp_first_centre(pane->v[b]) <= y)
            continue;
        tp_edge edge = tp_edge_begin(pane->u[a], pane->v[a], pane->u[b], pane->v[b]);
        tp_edge_advance(&edge, y);
        x0 = edge.pixel < x0 ? edge.pixel : x0;
        x1 = edge.pixel > x1 ? edge.pixel : x1;
    }
    if (x0 >= x1)
        return (pane_part){ 0, 0 };
    return (pane_part){ x0 > run->x ? x0 - run->x : 0,
                        x1 < run->x + run->count ? x1 - run->x : run->count };
}

/* True if a sample lies behind the glass: depth > gap / (n . D), or zi < zi_near (n .
 * D) / gap.  The test is multiplied by `gap`; the formats are Q42, and 16.16 times Q31. */
static bool is_behind_glass(const tp_shade *shade, const tp_glass_wall *wall, uint32_t key,
                            int64_t view)
{
    int64_t near = (int64_t)shade->underwater->zi_near * (view >> 22);      /* Q36 */
    int64_t here = (int64_t)(TP_ZI(key) >> 4) * (wall->gap >> 2);       /* Q27 times Q14 */
    int64_t rise = near * (wall->gap > 0 ? 1 : -1);
    int64_t far = (here >> 5) * (wall->gap > 0 ? 1 : -1);
    return far <= rise + (rise >> 10);
}

/* Tints samples: the sky's reflection in the pane over the glass's own colour.  The view
 * vectors of the run are set. */
static void tint(const tp_shade *shade, const tp_glass *glass, tp_run *run, pane_part p,
                 uint32_t face)
{
    tp_ray n = wall_normal(face);

    for (int32_t i = p.first; i < p.end; i++) {
        int32_t  vx = run->vx[i], vy = run->vy[i], vz = run->vz[i];
        int32_t  nv = (vx * n.x + vz * n.z) >> 14;
        uint32_t share = shade->fresnel[tp_clamp(nv, 0, 16384) >> 6];
        uint32_t sky = tp_env_sample(shade, (2 * nv * n.x >> 14) - vx, -vy,
                                     (2 * nv * n.z >> 14) - vz);
        uint32_t c = tp_colour_mix(run->colour[i], glass->colour, glass->share);
        run->colour[i] = tp_colour_mix(c, sky, share);
    }
}

/* The same for samples of a block of 16 columns, with the share and the sky of their
 * middle. */
static void tint_block(const tp_shade *shade, const tp_glass *glass, tp_run *run,
                           pane_part p, uint32_t face)
{
    const tp_ray n = wall_normal(face);
    const tp_quick_ray_row row = tp_quick_ray_row_make(shade, run->y);
    const tp_ray v = tp_quick_ray(shade, &row, 16 * run->x + 8 * (p.first + p.end));
    const int32_t nv = (v.x * n.x + v.z * n.z) >> 14;
    const uint32_t share = shade->fresnel[tp_clamp(nv, 0, 16384) >> 6];
    const uint32_t sky = tp_env_sample(shade, (2 * nv * n.x >> 14) - v.x, -v.y,
                                       (2 * nv * n.z >> 14) - v.z);
    const uint32_t kept = (256 - glass->share) * (256 - share) >> 8;
    const uint32_t added =
        tp_colour_mix(tp_colour_scale(glass->colour, glass->share), sky, share);

    for (int32_t i = p.first; i < p.end; i++)
        run->colour[i] = tp_colour_add(tp_colour_scale(run->colour[i], kept), added);
}

static void tint_behind_glass(const tp_shade *shade, const tp_glass *glass,
                              const tp_glass_wall *wall, tp_run *run, pane_part p)
{
    int64_t v = shade->v0 - 16 * run->y - 8;

    for (int32_t i = p.first; i < p.end; ) {
        int32_t from = i;
        int64_t u = 16 * (run->x + i) + 8 - shade->u0;
        int64_t view = wall->right * u + wall->up * v + wall->ahead;
        bool seen = is_behind_glass(shade, wall, run->key[i], view);
        for (; i < p.end && seen == is_behind_glass(shade, wall, run->key[i], view); i++)
            view += wall->right * 16;
        if (seen)
            tint(shade, glass, run, (pane_part){ from, i }, wall->face);
    }
}

/* Returns the end of the samples from i on that lie on one side of the glass, within a
 * block up to `stop`.  A block whose ends lie there is taken as a whole. */
static int32_t side_end(const tp_shade *shade, const tp_glass_wall *wall, const tp_run *run,
                        int32_t i, int32_t stop, int64_t view, bool seen)
{
    int32_t k = stop - 1;

    if (seen == is_behind_glass(shade, wall, run->key[k], view + wall->right * 16 * k))
        return stop;
    for (k = i + 1; k < stop; k++)
        if (seen != is_behind_glass(shade, wall, run->key[k], view + wall->right * 16 * k))
            break;
    return k;
}

static void tint_blocks_behind_glass(const tp_shade *shade, const tp_glass *glass,
                                     const tp_glass_wall *wall, tp_run *run, pane_part p)
{
    const int64_t view = wall->right * (int64_t)(16 * run->x + 8 - shade->u0)
                       + wall->up * (int64_t)(shade->v0 - 16 * run->y - 8) + wall->ahead;

    for (int32_t i = p.first, stop; i < p.end; i = stop) {
        stop = tp_block_end(run, i) < p.end ? tp_block_end(run, i) : p.end;
        const bool seen =
            is_behind_glass(shade, wall, run->key[i], view + wall->right * 16 * i);
        stop = side_end(shade, wall, run, i, stop, view, seen);
        if (seen)
            tint_block(shade, glass, run, (pane_part){ i, stop }, wall->face);
    }
}

static bool is_run_in_wall_box(const tp_glass_wall *wall, const tp_run *run)
{
    return run->y >= wall->y0 && run->y < wall->y1
        && run->x < wall->x1 && run->x + run->count > wall->x0;
}

void tp_stage_pane(const tp_shade *shade, tp_run *run)
{
    const tp_glass *glass = run->mine;
    bool viewed = false;

    for (uint32_t k = 0; k < 2 * glass->walls; k++) {
        const tp_glass_wall *wall = &glass->wall[k / 2];
        if (!is_run_in_wall_box(wall, run))
            continue;
        const pane_part p = covered_part(&wall->pane[k % 2], run);
        if (p.first >= p.end)
            continue;
        if (!viewed)
            tp_run_fill_vectors_to_eye(shade, &shade->world, run);
        viewed = true;
        tint_behind_glass(shade, glass, wall, run, p);
    }
}

/* Joins the halves of a wall, which no edge of the view cuts, along their diagonal. */
static void join_halves(const tp_pane half[2], tp_pane *to)
{
    to->count = 4;
    for (int k = 0; k < 4; k++) {
        to->u[k] = half[k / 3].u[k < 3 ? k : 2];
        to->v[k] = half[k / 3].v[k < 3 ? k : 2];
    }
}

static void tint_wall_by_blocks(const tp_shade *shade, const tp_glass *glass,
                                const tp_glass_wall *wall, const tp_pane *pane, tp_run *run)
{
    const pane_part p = covered_part(pane, run);

    if (p.first < p.end)
        tint_blocks_behind_glass(shade, glass, wall, run, p);
}

void tp_stage_quick_pane(const tp_shade *shade, tp_run *run)
{
    const tp_glass *glass = run->mine;

    for (uint32_t k = 0; k < glass->walls; k++) {
        const tp_glass_wall *wall = &glass->wall[k];
        if (!is_run_in_wall_box(wall, run))
            continue;
        if (wall->pane[0].count == 3 && wall->pane[1].count == 3) {
            tp_pane whole;
            join_halves(wall->pane, &whole);
            tint_wall_by_blocks(shade, glass, wall, &whole, run);
            continue;
        }
        tint_wall_by_blocks(shade, glass, wall, &wall->pane[0], run);
        tint_wall_by_blocks(shade, glass, wall, &wall->pane[1], run);
    }
}

const tp_stage tp_glass_stages[] = {
#define X(name) tp_stage_##name,
    TP_STAGES_OF_glass(X)
#undef X
};
