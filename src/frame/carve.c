/* SPDX-License-Identifier: MIT */
/* A frame's memory: one block, laid out as the scene asks at init.  Nothing is taken
 * after that. */
#include "frame/frame.h"

uint32_t tp_frame_materials(const tp_assets *assets)
{
    uint32_t n = assets->boat ? assets->boat->n_materials : 0;
    return n < TP_MATERIALS ? n : TP_MATERIALS;
}

static bool has_blocks(const tp_scene *scene)
{
    return scene->pool.cols > 0 && scene->pool.mask[0];
}

/* The water's surface, and what is drawn before it as triangles. */
static void carve_places(tp_frame_parts *p, tp_arena *arena, const tp_scene *scene,
                         const tp_assets *assets)
{
    const uint32_t cols = (uint32_t)scene->grid.cols, rows = (uint32_t)scene->grid.rows;

    tp_grid_carve(&p->grid, arena, cols, rows);
    if (tp_has_ocean(scene))
        tp_grid_carve_ocean(&p->grid, arena);
    if (assets->boat)
        p->boat_vertex = tp_arena_take(arena, assets->boat->n_vertices,
                                       sizeof *p->boat_vertex);
    if (tp_has_floor(scene)) {
        p->land_vertex = tp_arena_take(arena, (size_t)cols * rows,
                                       sizeof *p->land_vertex);
        p->land_band = tp_arena_take(arena, rows, sizeof *p->land_band);
    }
}

static void carve_drops(tp_frame_parts *p, tp_arena *arena, const tp_scene *scene)
{
    if (scene->drops.count > 0) {
        p->drop_capacity = (uint32_t)scene->drops.count;
        p->ring_capacity = (uint32_t)scene->drops.rings;
        p->drop_box = tp_arena_take(arena, p->drop_capacity + 1, sizeof *p->drop_box);
        p->ring = tp_arena_take(arena, p->ring_capacity, sizeof *p->ring);
    }
    if (scene->spray.count > 0) {
        p->speck_capacity = (uint32_t)scene->spray.count;
        p->speck = tp_arena_take(arena, p->speck_capacity, sizeof *p->speck);
    }
}

static void carve_glass(tp_frame_parts *p, tp_arena *arena, const tp_scene *scene)
{
    const int32_t cols = scene->grid.cols, rows = scene->grid.rows;
    const size_t lines = (size_t)(cols > rows ? cols : rows);

    p->glass = tp_arena_take(arena, TP_GLASSES, sizeof *p->glass);
    for (int i = 0; i < TP_GLASSES; i++) {
        tp_side_post *post = tp_arena_take(arena, lines + 2, sizeof *post);
        if (p->glass)
            p->glass[i].post = post;
    }
}

/* What the water's inside needs. */
static void carve_depth(tp_frame_parts *p, tp_arena *arena, const tp_scene *scene)
{
    if (tp_has_tank(scene) && scene->tank.kind == TP_TANK_GLASS)
        carve_glass(p, arena, scene);
    if (has_blocks(scene))
        p->block = tp_arena_take(arena, TP_BLOCKS, sizeof *p->block);
    if (tp_frame_has_caustics(scene)) {
        size_t cells = (size_t)scene->water.caustic_cells;
        p->caustic_cells = (uint32_t)cells;
        p->caustic_light = tp_arena_take(arena, cells * cells, sizeof *p->caustic_light);
        p->caustic_row = tp_arena_take(arena, 2 * (cells + 1), sizeof *p->caustic_row);
    }
}

static void carve_tables(tp_frame_parts *p, tp_arena *arena, const tp_scene *scene,
                         const tp_assets *assets)
{
    const uint32_t materials = tp_frame_materials(assets);

    p->solid = tp_arena_take(arena, materials, sizeof *p->solid);
    p->gloss = tp_arena_take(arena, materials, TP_GLOSS);
    p->heaven = tp_frame_carve_sky(arena, scene, assets);
    for (int k = 0; k < TP_POOL_BUMPS; k++) {
        p->bump_cells[k] = tp_frame_bump_cells(scene, k);
        p->bump[k] = tp_arena_take(arena, p->bump_cells[k], sizeof *p->bump[k]);
    }
}

/* Pictures that water looks into, of scenes with something to see there. */
static void carve_looks(tp_frame_parts *p, tp_arena *arena, const tp_scene *scene,
                        const tp_assets *assets, const tp_frame_config *c)
{
    bool moves = assets->boat || scene->drops.count > 0;
    bool mirrors = scene->water.reflection > 0
                && (moves || has_blocks(scene) || tp_has_tank(scene));

    if (mirrors && scene->mirror.objects == TP_MIRROR_STENCIL)
        tp_frame_carve_half(&p->mirrored, arena, c->width, c->height);
    if (mirrors && moves && scene->mirror.objects == TP_MIRROR_CUBE)
        tp_frame_carve_around(&p->around, arena);
    if (moves && scene->water.clear > 0)
        tp_frame_carve_half(&p->sunken, arena, c->width, c->height);
}

tp_frame *tp_frame_carve(const tp_kit *kit, tp_frame_parts *parts, tp_frame_ram *ram,
                         tp_arena *arena, const tp_scene *scene, const tp_assets *assets,
                         const tp_frame_config *config)
{
    tp_frame *frame = tp_arena_take(arena, 1, sizeof *frame);
    const size_t fixed = arena->used;
    (void)kit;

    *parts = (tp_frame_parts){ .glass = NULL };
    carve_places(parts, arena, scene, assets);
    carve_drops(parts, arena, scene);
    carve_depth(parts, arena, scene);
    const size_t placed = arena->used;
    carve_tables(parts, arena, scene, assets);
    const size_t tabled = arena->used;
    carve_looks(parts, arena, scene, assets, config);
    *ram = (tp_frame_ram){
        .frame = arena->used, .vertices = placed - fixed,
        .tables = tabled - placed + sizeof frame->shade, .mirror = arena->used - tabled,
    };
    return frame;
}
