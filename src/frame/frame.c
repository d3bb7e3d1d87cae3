/* SPDX-License-Identifier: MIT */
/* A frame's memory and beginning.  One block holds the frame, its grid, the boat's
 * projected corners and the tables; nothing is taken after init. */
#include "frame/frame.h"

#define SIDE_LEAST 16
#define SIDE_MOST  4096

static tp_frame_config filled(const tp_frame_config *config)
{
    tp_frame_config c = *config;
    if (c.tile_width == 0 || c.tile_width > c.width)
        c.tile_width = c.width;
    if (c.tile_height == 0 || c.tile_height > c.height)
        c.tile_height = c.height;
    return c;
}

static tp_status check(const tp_frame_config *c, tp_error *err)
{
    if (c->width < SIDE_LEAST || c->width > SIDE_MOST
        || c->height < SIDE_LEAST || c->height > SIDE_MOST)
        return TP_FAIL(err, TP_E_SIZE, 0, c->width, c->height);
    if (c->tile_width % 16 != 0 && c->tile_width < c->width)
        return TP_FAIL(err, TP_E_TILE, 0, c->tile_width, c->tile_height);
    if ((unsigned)c->format >= TP_FORMAT_COUNT)
        return TP_FAIL(err, TP_E_ARG, 0, 0, 0);
    return TP_OK;
}

static uint32_t materials_of(const tp_assets *assets)
{
    uint32_t n = assets->boat ? assets->boat->n_materials : 0;
    return n < TP_MATERIALS ? n : TP_MATERIALS;
}

/* What a block holds behind the frame itself. */
typedef struct {
    tp_frame       *frame;
    tp_grid         grid;
    tp_boat_vertex *boat_vertex;
    tp_land_vertex *land_vertex;
    tp_land_band   *land_band;
    tp_grid_box    *drop_box;
    tp_ring_now    *ring;
    tp_frame_speck *speck;
    tp_solid       *solid;
    uint8_t        *gloss;
    tp_frame_sky    heaven;
    tp_half_store   mirrored, sunken;
    tp_around_store around;
    tp_glass       *glass;
    tp_rectangle   *block;
    uint16_t       *caustic_light;
    tp_caustic_corner *caustic_row;
    tp_pool_slope  *bump[TP_POOL_BUMPS];
    tp_frame_ram    ram;
} parts;

static bool has_land(const tp_scene *scene)
{
    return scene->floor.depth > 0 || scene->floor.map[0];
}

static bool has_blocks(const tp_scene *scene)
{
    return scene->pool.cols > 0 && scene->pool.mask[0];
}

/* What the water's inside needs. */
static void carve_depth(parts *p, tp_arena *arena, const tp_scene *scene)
{
    size_t cells = (size_t)scene->water.caustic_cells;

    if (tp_has_tank(scene) && scene->tank.kind == TP_TANK_GLASS) {
        size_t lines = (size_t)(scene->grid.cols > scene->grid.rows ? scene->grid.cols
                                                                    : scene->grid.rows);
        p->glass = tp_arena_take(arena, TP_GLASSES, sizeof *p->glass);
        for (int i = 0; i < TP_GLASSES; i++) {
            tp_side_post *post = tp_arena_take(arena, lines + 2, sizeof *post);
            if (p->glass)
                p->glass[i].post = post;
        }
    }
    if (has_blocks(scene))
        p->block = tp_arena_take(arena, TP_BLOCKS, sizeof *p->block);
    if (tp_frame_has_caustics(scene)) {
        p->caustic_light = tp_arena_take(arena, cells * cells, sizeof *p->caustic_light);
        p->caustic_row = tp_arena_take(arena, 2 * (cells + 1), sizeof *p->caustic_row);
    }
}

/* Pictures that water looks into, of scenes with something to see there. */
static void carve_looks(parts *p, tp_arena *arena, const tp_scene *scene,
                        const tp_assets *assets, const tp_frame_config *c)
{
    size_t before = arena->used;
    bool   moves = assets->boat || scene->drops.count > 0;
    bool   mirrors = scene->water.reflection > 0
                  && (moves || has_blocks(scene) || tp_has_tank(scene));

    if (mirrors && scene->mirror.objects == TP_MIRROR_STENCIL)
        tp_frame_carve_half(&p->mirrored, arena, c->width, c->height);
    if (mirrors && moves && scene->mirror.objects == TP_MIRROR_CUBE)
        tp_frame_carve_around(&p->around, arena);
    if (moves && scene->water.clear > 0)
        tp_frame_carve_half(&p->sunken, arena, c->width, c->height);
    p->ram.mirror = arena->used - before;
}

/* The block's layout: run once with a counting arena, once for real. */
static parts carve(tp_arena *arena, const tp_scene *scene, const tp_assets *assets,
                   const tp_frame_config *config)
{
    uint32_t vertices = assets->boat ? assets->boat->n_vertices : 0;
    uint32_t materials = materials_of(assets);
    parts p = { .frame = tp_arena_take(arena, 1, sizeof *p.frame) };
    size_t fixed = arena->used;

    tp_grid_carve(&p.grid, arena, (uint32_t)scene->grid.cols, (uint32_t)scene->grid.rows);
    if (has_land(scene) || scene->wind.strength > 0)
        tp_grid_carve_ocean(&p.grid, arena);
    p.boat_vertex = tp_arena_take(arena, vertices, sizeof *p.boat_vertex);
    if (has_land(scene)) {
        p.land_vertex = tp_arena_take(arena, (size_t)p.grid.cols * p.grid.rows,
                                      sizeof *p.land_vertex);
        p.land_band = tp_arena_take(arena, p.grid.rows, sizeof *p.land_band);
    }
    if (scene->drops.count > 0) {
        p.drop_box = tp_arena_take(arena, (size_t)scene->drops.count + 1,
                                   sizeof *p.drop_box);
        p.ring = tp_arena_take(arena, (size_t)scene->drops.rings, sizeof *p.ring);
    }
    if (scene->spray.count > 0)
        p.speck = tp_arena_take(arena, (size_t)scene->spray.count, sizeof *p.speck);
    carve_depth(&p, arena, scene);
    p.ram.vertices = arena->used - fixed;
    p.solid = tp_arena_take(arena, materials, sizeof *p.solid);
    p.gloss = tp_arena_take(arena, materials, TP_GLOSS);
    p.heaven = tp_frame_carve_sky(arena, scene, assets);
    for (int k = 0; k < TP_POOL_BUMPS; k++)
        p.bump[k] = tp_arena_take(arena, tp_frame_bump_cells(scene, k),
                                  sizeof *p.bump[k]);
    p.ram.tables = arena->used - fixed - p.ram.vertices + sizeof p.frame->shade;
    carve_looks(&p, arena, scene, assets, config);
    p.ram.frame = arena->used;
    return p;
}

size_t tp_frame_bytes(const tp_scene *scene, const tp_assets *assets,
                      const tp_frame_config *config)
{
    tp_frame_config c = filled(config);
    tp_arena arena = tp_arena_over(NULL, 0);

    if (check(&c, NULL) != TP_OK)
        return 0;
    return carve(&arena, scene, assets, &c).ram.frame;
}

static size_t tile_samples(const tp_frame_config *c)
{
    return (size_t)c->tile_width * c->tile_height;
}

/* Four planes of samples, then the pixels. */
size_t tp_frame_scratch_bytes(const tp_frame_config *config)
{
    tp_frame_config c = filled(config);

    if (check(&c, NULL) != TP_OK)
        return 0;
    return 4 * tile_samples(&c) * sizeof(uint32_t)
         + tp_format_row_bytes(c.format, (int)c.tile_width) * c.tile_height;
}

void tp_frame_make_gloss(tp_frame *frame)
{
    frame->model = frame->scene->light.model;
    for (uint32_t i = 0; i < materials_of(&frame->assets); i++) {
        uint8_t *gloss = frame->gloss + (size_t)i * TP_GLOSS;
        tp_fx shininess = frame->assets.boat->materials[i].shininess;
        if (frame->model == TP_LIGHT_BLINN)
            tp_shade_gloss_blinn(gloss, shininess);
        else
            tp_shade_gloss(gloss, shininess);
    }
}

tp_status tp_frame_init(tp_frame **out, const tp_scene *scene, const tp_assets *assets,
                        const tp_frame_config *config, void *block, tp_error *err)
{
    tp_frame_config c = filled(config);
    tp_status status = check(&c, err);

    if (status != TP_OK)
        return status;
    tp_arena arena = tp_arena_over(block, tp_frame_bytes(scene, assets, config));
    parts p = carve(&arena, scene, assets, &c);
    tp_frame *frame = p.frame;
    memset(frame, 0, sizeof *frame);
    frame->scene = scene;
    frame->assets = *assets;
    frame->config = c;
    frame->across = (c.width + c.tile_width - 1) / c.tile_width;
    frame->down = (c.height + c.tile_height - 1) / c.tile_height;
    frame->grid = p.grid;
    frame->boat_vertex = p.boat_vertex;
    frame->land_vertex = p.land_vertex;
    frame->land_band = p.land_band;
    frame->drop_box = p.drop_box;
    frame->ring = p.ring;
    frame->drop_capacity = p.drop_box ? (uint32_t)scene->drops.count : 0;
    frame->ring_capacity = p.ring ? (uint32_t)scene->drops.rings : 0;
    frame->speck = p.speck;
    frame->speck_capacity = p.speck ? (uint32_t)scene->spray.count : 0;
    frame->solid = p.solid;
    frame->gloss = p.gloss;
    frame->heaven = p.heaven;
    frame->mirrored = p.mirrored;
    frame->sunken = p.sunken;
    frame->around = p.around;
    frame->glass = p.glass;
    frame->block = p.block;
    frame->caustic_light = p.caustic_light;
    frame->caustic_row = p.caustic_row;
    frame->caustic_cells = (uint32_t)scene->water.caustic_cells;
    for (int k = 0; k < TP_POOL_BUMPS; k++) {
        frame->bump[k] = p.bump[k];
        frame->bump_cells[k] = tp_frame_bump_cells(scene, k);
    }
    frame->ram = p.ram;
    frame->ram.scratch = tp_frame_scratch_bytes(&c);
    frame->shade.boat = assets->boat;
    frame->shade.solid = frame->solid;
    tp_shade_tables(&frame->shade);
    tp_frame_init_sky(frame);
    tp_frame_make_gloss(frame);
    if (assets->foam)
        tp_shade_foam_rank(&frame->shade.foam, assets->foam);
    if (frame->drop_capacity > 0) {
        tp_frame_make_ball(frame);
        tp_shade_gloss(frame->drop_gloss, 40 * TP_FX_ONE);
    }
    *out = frame;
    return TP_OK;
}

/* Rings between ticks are rings of another age. */
static void place_surface(tp_frame *frame)
{
    const tp_world *world = frame->world;
    const tp_drops *drops = tp_world_drops(world);
    tp_surface *surface = &frame->surface;

    *surface = (tp_surface){
        .sea = &world->sea, .phases = frame->drawn.phases, .ring = frame->ring,
        .ocean = tp_world_ocean(world), .back = world->back,
    };
    if (!tp_frame_bumps(frame)) {
        surface->pool = tp_world_pool(world);
        surface->field = tp_world_field(world);
    }
    for (uint32_t i = 0; drops && i < drops->rings; i++) {
        if (surface->rings < frame->ring_capacity)
            surface->rings += tp_ring_at(&tp_drops_rings(drops)[i], frame->drawn.time,
                                         &frame->ring[surface->rings]);
    }
}

/* What water looks into, then the picture itself: they share memory, and the numbers of
 * the last frame are the picture's. */
static void place_solids(tp_frame *frame)
{
    const tp_frame_stats stats = frame->stats;

    if (frame->mirrored.colour)
        tp_frame_draw_mirrored(frame);
    if (frame->around.colour)
        tp_frame_draw_around(frame);
    if (frame->sunken.colour)
        tp_frame_draw_sunken(frame);
    frame->stats = stats;
    frame->sight = (tp_sight){ .lens = &frame->lens };
    tp_sight_begin(frame, &frame->sight);
    tp_sight_place(frame, &frame->sight);
}

void tp_frame_begin(tp_frame *frame, const tp_world *world)
{
    const tp_scene *scene = frame->scene;

    frame->stats = (tp_frame_stats){ 0 };
    if (frame->assets.boat && frame->assets.boat->n_materials > TP_MATERIALS)
        frame->stats.dropped += frame->assets.boat->n_materials - TP_MATERIALS;
    frame->world = world;
    frame->drawn = tp_world_drawn(world);
    place_surface(frame);
    tp_lens_turned(&frame->lens, frame->drawn.camera.eye, frame->drawn.camera.turn,
                   scene->camera.fov, scene->camera.near,
                   frame->config.width, frame->config.height);
    tp_frame_plan(frame);
    tp_frame_place_water(frame);
    if (frame->block)
        tp_frame_place_blocks(frame);
    if (frame->glass)
        tp_frame_place_glass(frame);
    place_solids(frame);
    if (frame->land_vertex && frame->surface.ocean)
        tp_frame_place_land(frame);
    if (frame->speck_capacity > 0)
        tp_frame_place_spray(frame);
}

uint32_t tp_frame_tiles(const tp_frame *frame)
{
    return frame->across * frame->down;
}

tp_frame_stats tp_frame_last_stats(const tp_frame *frame)
{
    return frame->stats;
}

tp_frame_ram tp_frame_memory(const tp_frame *frame)
{
    return frame->ram;
}
