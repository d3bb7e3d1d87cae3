/* SPDX-License-Identifier: MIT */
/* Caustics: sunlight focused on the floor by the surface's curvature.
 *
 * The surface is divided into as many cells as the map.  The light of a cell is refracted
 * at its four vertices [F4] and falls to the floor.  Four points between the vertices
 * distribute the light to the map's cells around each point.  The sums are of integers,
 * so their order does not matter and no light is lost.  Light beyond an edge is mirrored
 * at the edge, as by a wall.  A place on the map is the surface point lighting the floor
 * there through still water, so still water gives exactly 256 everywhere. */
#include "base/base.h"
#include "base/dsp.h"
#include "features/underwater/underwater.h"
#include "frame/frame.h"
#include "quality/prices.h"
#include "shade/caustic_light.h"
#include "shade/refracted_ray.h"
#include "shade/slope.h"

/* -- place of the map ---------------------------------------------------------------- */

/* Returns the low corner of the map's square along one axis.  The square lies ahead of
 * the eye and moves by whole cells, so the pattern does not crawl. */
static tp_fx snapped_map_corner(tp_fx eye, int32_t back_q30, tp_fx size, int32_t cells)
{
    tp_fx   cell = size / cells > 0 ? size / cells : 1;
    int64_t corner = (int64_t)eye - size / 2 - ((int64_t)back_q30 * (size / 5 * 2) >> 30);
    return tp_fx_saturate(corner / cell * cell);
}

static tp_rectangle caustic_rectangle(const tp_frame *frame, int32_t cells)
{
    const tp_scene *scene = frame->scene;
    tp_fx size = scene->water.caustic_size;

    if (scene->pool.cols > 0)
        return tp_pool_sides(scene);
    tp_fx x = snapped_map_corner(frame->projection.eye.x, frame->projection.turn.z.x,
                                 size, cells);
    tp_fx z = snapped_map_corner(frame->projection.eye.z, frame->projection.turn.z.z,
                                 size, cells);
    return (tp_rectangle){ x, tp_fx_saturate((int64_t)x + size), z,
                           tp_fx_saturate((int64_t)z + size) };
}

static tp_fx sample_depth(const tp_frame *frame, tp_fx x, tp_fx z)
{
    const tp_underwater *in = frame->shade.underwater;
    tp_fx depth =
        in->coastal ? in->sample_floor(in->coastal, x, z).depth : in->floor_plane.depth;
    return tp_clamp(depth, 0, 100 * TP_FX_ONE);
}

/* -- refraction of the light --------------------------------------------------------- */

/* Returns the refracted fall at a surface with these slopes, by Snell's law.  The
 * downward component of the ray is at least 1/10. */
static tp_fall refract_light(const tp_shade *shade, tp_fx slope_x, tp_fx slope_z)
{
    tp_ray in = { -shade->world.lx, -shade->world.ly, -shade->world.lz, 0 };
    tp_ray n = tp_slope_normal(tp_clamp(slope_x >> 4, -16000, 16000),
                               tp_clamp(slope_z >> 4, -16000, 16000));
    tp_ray t = tp_underwater_refract(shade->underwater, 1, in, n);
    int32_t down = t.y < -1638 ? -t.y : 1638;

    return (tp_fall){ t.x * 65536 / down, t.z * 65536 / down };
}

/* Returns the fall of the sun's rays above the water; slopes are at most 10, as those of
 * refracted rays. */
static tp_fall trace_sun_fall(const tp_shade *shade)
{
    const int32_t down = shade->world.ly > 1638 ? shade->world.ly : 1638;

    return (tp_fall){ -shade->world.lx * 65536 / down, -shade->world.lz * 65536 / down };
}

/* Returns the surface point with the rest position (x, z), or of coastal water near it. */
static tp_surface_point displaced_surface_point(const tp_surface *s, tp_fx x, tp_fx z,
                                                tp_fx off[2])
{
    tp_surface_point p = s->coastal ? s->by->coastal->near(s, x, z, off)
                                    : tp_surface_displaced(s, x, z);

    if (tp_surface_has_rings_or_pools(s)) {
        tp_height_slope relief = tp_rings_pools_sample(s, p.position.x, p.position.z);
        p.position.y += relief.height;
        p.slope_x += relief.slope_x;
        p.slope_z += relief.slope_z;
    }
    return p;
}

/* Converts metres to cells Q8, clamped to 2^20 cells.  With 16 fraction bits, 256 cells
 * over a pool of 0.16 m are 2^27 per metre. */
static int32_t metres_to_cells_q8(int64_t metres, uint32_t per_metre)
{
    const int32_t near = (int32_t)tp_clamp_abs(metres, (int64_t)1 << 30);
    const int64_t cells = (int64_t)near * per_metre >> 24;
    return (int32_t)tp_clamp_abs(cells, (int64_t)1 << 28);
}

/* Returns from + (to - from) i / cells, the division rounded down; from <= to, i <= cells
 * <= 256.  The quotient and the rest of (to - from) / cells keep the division in 32 bits. */
static tp_fx vertex_coordinate(tp_fx from, tp_fx to, uint32_t i, uint32_t cells)
{
    const uint32_t wide = (uint32_t)to - (uint32_t)from;
    const uint32_t cell = wide / cells, rest = wide % cells;

    return (tp_fx)((uint32_t)from + cell * i + rest * i / cells);
}

/* Traces vertex (i, j): its place along the sun's rays on the level, and the place of its
 * light. */
static void trace_light_vertex(const tp_frame *frame, const tp_caustics *map,
                               const tp_surface *surface, uint32_t i, uint32_t j,
                               tp_fx off[2], tp_caustic_vertex *to)
{
    const tp_caustic *c = &map->look;
    const tp_rectangle r = map->place;
    tp_fx x = vertex_coordinate(r.x0, r.x1, i, c->cells);
    tp_fx z = vertex_coordinate(r.z0, r.z1, j, c->cells);
    tp_surface_point p = displaced_surface_point(surface, x, z, off);
    tp_fall fall = refract_light(&frame->shade, p.slope_x, p.slope_z);
    tp_fall still = map->level_fall;
    tp_fx high = tp_fx_add_sat(sample_depth(frame, p.position.x, p.position.z), p.position.y);
    int64_t away_x = (int64_t)p.position.x - x, away_z = (int64_t)p.position.z - z;

    high = high > 0 ? high : 0;
    to->x = (int32_t)(i * 256)
          + metres_to_cells_q8(away_x + ((int64_t)map->sun_fall.x * p.position.y >> 16),
                               c->per_metre_x);
    to->z = (int32_t)(j * 256)
          + metres_to_cells_q8(away_z + ((int64_t)map->sun_fall.z * p.position.y >> 16),
                               c->per_metre_z);
    away_x += ((int64_t)(fall.x - still.x) * high + (int64_t)still.x * p.position.y) >> 16;
    away_z += ((int64_t)(fall.z - still.z) * high + (int64_t)still.z * p.position.y) >> 16;
    to->lit_x = (int32_t)(i * 256) + metres_to_cells_q8(away_x, c->per_metre_x);
    to->lit_z = (int32_t)(j * 256) + metres_to_cells_q8(away_z, c->per_metre_z);
}

/* -- distribution of the light ------------------------------------------------------- */

/* Returns the index of a cell; a cell outside of the map is mirrored at the map's edge. */
static uint32_t mirrored_index(int32_t i, uint32_t cells)
{
    int32_t n = (int32_t)cells, at = i < 0 ? -1 - i : i < n ? i : 2 * n - 1 - i;
    return (uint32_t)tp_clamp(at, 0, n - 1);
}

/* Adds light to cell (i, j), at most to 65535; cells outside of the map are mirrored. */
static void add_mirrored_cell_light(uint16_t *light, uint32_t cells, int32_t i, int32_t j,
                                    int32_t share)
{
    uint16_t *to = light + mirrored_index(j, cells) * cells + mirrored_index(i, cells);
    *to = (uint16_t)(*to + share < 65535 ? *to + share : 65535);
}

/* Adds light to a cell, at most to 65535. */
TP_ALWAYS_INLINE void add_cell_light(uint16_t *to, int32_t share)
{
    *to = (uint16_t)tp_usat(*to + share, 0, 16);
}

/* Adds `share` at a place in cells, Q8, to the four cells around it, weighted in
 * sixteenths. */
TP_ALWAYS_INLINE void splat_light(uint16_t *light, uint32_t cells, int32_t x, int32_t z,
                                  int32_t share)
{
    int32_t i = (x - 128) >> 8, j = (z - 128) >> 8;
    int32_t f = (x - 128) >> 4 & 15, g = (z - 128) >> 4 & 15;
    int32_t b = share * f * (16 - g) >> 8, c = share * (16 - f) * g >> 8;
    int32_t d = share * f * g >> 8;

    if ((uint32_t)i < cells - 1 && (uint32_t)j < cells - 1) {
        uint16_t *to = light + (uint32_t)j * cells + (uint32_t)i;
        add_cell_light(to, share - b - c - d);
        add_cell_light(to + 1, b);
        add_cell_light(to + cells, c);
        add_cell_light(to + cells + 1, d);
        return;
    }
    add_mirrored_cell_light(light, cells, i, j, share - b - c - d);
    add_mirrored_cell_light(light, cells, i + 1, j, b);
    add_mirrored_cell_light(light, cells, i, j + 1, c);
    add_mirrored_cell_light(light, cells, i + 1, j + 1, d);
}

/* Sets the bilinear means at a quarter and three quarters of a cell's sides.  The sum of
 * the weights is 16: values below 2^26, as all near the map, take 32 bits. */
TP_ALWAYS_INLINE void interpolate_quarters(int32_t a, int32_t b, int32_t c, int32_t d,
                                           int32_t to[4])
{
    const int32_t most = 1 << 26;

    if (tp_abs(a) < most && tp_abs(b) < most && tp_abs(c) < most && tp_abs(d) < most) {
        const int32_t over[2] = { 3 * a + b, a + 3 * b }, under[2] = { 3 * c + d, c + 3 * d };
        for (int k = 0; k < 2; k++) {
            to[k] = (3 * over[k] + under[k]) >> 4;
            to[k + 2] = (over[k] + 3 * under[k]) >> 4;
        }
        return;
    }
    for (int k = 0; k < 4; k++) {
        const int32_t s = k & 1 ? 3 : 1, t = k & 2 ? 3 : 1;
        to[k] = (int32_t)(((int64_t)a * (4 - s) * (4 - t) + (int64_t)b * s * (4 - t)
                           + (int64_t)c * (4 - s) * t + (int64_t)d * s * t) >> 4);
    }
}

/* Distributes the light of the cell between two rows of vertices.  Its light is the area
 * that it covers on the level along the sun's rays, half of the cross product of its
 * diagonals: 256 at rest. */
static void splat_cell_light(uint16_t *light, uint32_t cells, const tp_caustic_vertex *a,
                             const tp_caustic_vertex *c)
{
    const tp_caustic_vertex *b = a + 1, *d = c + 1;
    int64_t area = (int64_t)(d->x - a->x) * (c->z - b->z)
                 - (int64_t)(d->z - a->z) * (c->x - b->x);
    int32_t share = (int32_t)tp_clamp_abs(area > 0 ? area >> 9 : 0, 2048);
    int32_t x[4], z[4];

    interpolate_quarters(a->lit_x, b->lit_x, c->lit_x, d->lit_x, x);
    interpolate_quarters(a->lit_z, b->lit_z, c->lit_z, d->lit_z, z);
    for (int k = 0; k < 4; k++)
        splat_light(light, cells, x[k], z[k], k < 3 ? share / 4 : share - share / 4 * 3);
}

/* Traces light through each vertex of the map to the floor, and distributes the light of
 * each cell. */
static void make_light_map(const tp_frame *frame, tp_caustics *map)
{
    const tp_surface surface = tp_frame_surface_with_all_pools(frame);
    uint32_t n = map->look.cells;

    memset(map->light, 0, (size_t)n * n * sizeof *map->light);
    for (uint32_t j = 0; j <= n; j++) {
        tp_caustic_vertex *here = map->row + (j & 1) * (n + 1);
        const tp_caustic_vertex *last = map->row + (~j & 1) * (n + 1);
        tp_fx off[2] = { 0, 0 };
        for (uint32_t i = 0; i <= n; i++)
            trace_light_vertex(frame, map, &surface, i, j, off, &here[i]);
        for (uint32_t i = 0; j > 0 && i < n; i++)
            splat_cell_light(map->light, n, &last[i], &here[i]);
    }
}

/* Returns the cells along a side of the map at the scene's rung, at least 8. */
static uint32_t rung_cells(const tp_scene *scene, uint32_t cells)
{
    const int32_t rung = scene->quality.caustics;
    const uint32_t halved = cells >> (rung > TP_RUNG_EXACT ? rung - TP_RUNG_EXACT : 0);

    return halved > 8 ? halved : 8;
}

/* Makes the map of caustics for this picture: where its cells lie, and their light. */
static void begin_caustic_map(tp_frame *frame, void *mine)
{
    const tp_scene *scene = frame->scene;
    tp_caustics *map = mine;
    const uint32_t wanted = rung_cells(scene, map->cells);
    const uint32_t cells = wanted < map->room ? wanted : map->room;
    tp_rectangle r = caustic_rectangle(frame, (int32_t)cells);
    tp_fx wide = tp_fx_saturate((int64_t)r.x1 - r.x0),
          deep = tp_fx_saturate((int64_t)r.z1 - r.z0);
    tp_fx   depth = sample_depth(frame, r.x0 / 2 + r.x1 / 2, r.z0 / 2 + r.z1 / 2);
    bool    coastal = frame->shade.underwater->coastal != NULL;
    tp_fall still = refract_light(&frame->shade, 0, 0);

    frame->stats.dropped += !coastal && tp_surface_has_swells(&frame->surface)
                            && !frame->surface.by->samples;
    map->look = (tp_caustic){
        .sample = caustic_sample, .light = map->light, .x = r.x0, .z = r.z0, .cells = cells,
        .per_metre_x = (uint32_t)(((uint64_t)cells << 32) / (uint32_t)(wide + !wide)),
        .per_metre_z = (uint32_t)(((uint64_t)cells << 32) / (uint32_t)(deep + !deep)),
        .per_depth = coastal ? UINT32_MAX
                             : (uint32_t)(((uint64_t)256 << 32)
                                          / (uint32_t)(depth > 32768 ? depth : 32768)),
        .lean_x = -still.x / 4, .lean_z = -still.z / 4,
        .strength = scene->water.caustics >> 8,
        .fades = scene->pool.cols == 0,
    };
    map->place = r;
    map->level_fall = still;
    map->sun_fall = trace_sun_fall(&frame->shade);
    frame->shade.caustic = &map->look;
    make_light_map(frame, map);
}

/* -- the module ---------------------------------------------------------------------- */

bool tp_caustics_enabled(const tp_module_conditions *conditions)
{
    const tp_scene *scene = conditions->scene;
    const bool tank = tp_has_tank(scene) && conditions->above & TP_MODULE_WALLS;

    return scene->water.clarity > 0 && scene->water.caustics > 0
           && conditions->above & TP_MODULE_UNDERWATER && (tank || tp_has_floor(scene));
}

static void *layout(tp_arena *arena, const tp_module_conditions *conditions)
{
    const uint32_t all = (uint32_t)conditions->scene->water.caustic_cells;
    const size_t cells = rung_cells(conditions->scene, all);
    tp_caustics *map = tp_arena_alloc(arena, 1, sizeof *map);
    uint16_t *light = tp_arena_alloc(arena, cells * cells, sizeof *light);
    tp_caustic_vertex *row = tp_arena_alloc(arena, 2 * (cells + 1), sizeof *row);

    TP_ASSERT(cells > 0);
    if (map)
        *map = (tp_caustics){ .light = light, .row = row, .cells = all,
                              .room = (uint32_t)cells };
    return map;
}

const tp_module tp_caustics_module = {
    .name = "caustics", .id = TP_CAUSTICS_ID, .trait = TP_TRAIT_caustic,
    .enabled = tp_caustics_enabled,
};

const tp_drawing tp_caustics_drawing = { .layout = layout, .begin = begin_caustic_map };
const tp_stage tp_caustics_stages[] = { NULL };

/* -- cost ---------------------------------------------------------------------------- */

/* Counts the cells of the map, over a tank's floor or the sea floor. */
static void count_work(tp_site *w)
{
    const uint32_t cells = rung_cells(w->scene, (uint32_t)w->scene->water.caustic_cells);
    const int way = tp_has_tank(w->scene) ? TP_WORK_caustic_pool : TP_WORK_caustic_sea;

    w->fixed_cost.of[way] = cells * cells;
}

const tp_cost tp_caustics_cost = { .work = count_work };
