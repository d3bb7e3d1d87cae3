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
    tp_solid       *solid;
    uint8_t        *gloss;
    tp_frame_ram    ram;
} parts;

/* The block's layout: run once with a counting arena, once for real. */
static parts carve(tp_arena *arena, const tp_scene *scene, const tp_assets *assets)
{
    uint32_t vertices = assets->boat ? assets->boat->n_vertices : 0;
    uint32_t materials = materials_of(assets);
    parts p = { .frame = tp_arena_take(arena, 1, sizeof *p.frame) };
    size_t fixed = arena->used;

    tp_grid_carve(&p.grid, arena, (uint32_t)scene->grid.cols, (uint32_t)scene->grid.rows);
    p.boat_vertex = tp_arena_take(arena, vertices, sizeof *p.boat_vertex);
    p.ram.vertices = arena->used - fixed;
    p.solid = tp_arena_take(arena, materials, sizeof *p.solid);
    p.gloss = tp_arena_take(arena, materials, TP_GLOSS);
    p.ram.frame = arena->used;
    p.ram.tables = arena->used - fixed - p.ram.vertices + sizeof p.frame->shade;
    return p;
}

size_t tp_frame_bytes(const tp_scene *scene, const tp_assets *assets,
                      const tp_frame_config *config)
{
    tp_frame_config c = filled(config);
    tp_arena arena = tp_arena_over(NULL, 0);

    if (check(&c, NULL) != TP_OK)
        return 0;
    return carve(&arena, scene, assets).ram.frame;
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

tp_status tp_frame_init(tp_frame **out, const tp_scene *scene, const tp_assets *assets,
                        const tp_frame_config *config, void *block, tp_error *err)
{
    tp_frame_config c = filled(config);
    tp_status status = check(&c, err);

    if (status != TP_OK)
        return status;
    tp_arena arena = tp_arena_over(block, tp_frame_bytes(scene, assets, config));
    parts p = carve(&arena, scene, assets);
    tp_frame *frame = p.frame;
    memset(frame, 0, sizeof *frame);
    frame->scene = scene;
    frame->assets = *assets;
    frame->config = c;
    frame->across = (c.width + c.tile_width - 1) / c.tile_width;
    frame->down = (c.height + c.tile_height - 1) / c.tile_height;
    frame->grid = p.grid;
    frame->boat_vertex = p.boat_vertex;
    frame->solid = p.solid;
    frame->gloss = p.gloss;
    frame->ram = p.ram;
    frame->ram.scratch = tp_frame_scratch_bytes(&c);
    frame->shade.boat = assets->boat;
    frame->shade.solid = frame->solid;
    tp_shade_tables(&frame->shade);
    for (uint32_t i = 0; i < materials_of(assets); i++)
        tp_shade_gloss(frame->gloss + (size_t)i * TP_GLOSS,
                       assets->boat->materials[i].shininess);
    *out = frame;
    return TP_OK;
}

void tp_frame_begin(tp_frame *frame, const tp_world *world)
{
    const tp_scene *scene = frame->scene;

    frame->stats = (tp_frame_stats){ 0 };
    if (frame->assets.boat && frame->assets.boat->n_materials > TP_MATERIALS)
        frame->stats.dropped += frame->assets.boat->n_materials - TP_MATERIALS;
    frame->sea = world->sea;
    memcpy(frame->phases, world->phases, sizeof frame->phases);
    tp_lens_init(&frame->lens, world->eye, world->heading, world->pitch,
                 scene->camera.fov, scene->camera.near,
                 frame->config.width, frame->config.height);
    tp_frame_plan(frame, world);
    tp_frame_place_water(frame);
    tp_frame_place_boat(frame, world);
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
