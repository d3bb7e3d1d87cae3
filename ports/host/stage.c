/* SPDX-License-Identifier: MIT */
/* From the command line to a world and a canvas. */
#include "stage.h"
#include "pool/pool.h"
#include "scene/value.h"
#include "scene/world.h"
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "say.h"

int stage_read(scene_file *file, const options *o)
{
    int code = scene_file_open(file, o->scene);
    for (uint32_t i = 0; i < o->n_settings && !code; i++)
        code = scene_file_set(file, o->settings[i]);
    if (!code && o->visibility) {
        uint32_t count;
        const tp_param *row = tp_param_find("quality.visibility", 18);
        file->scene.quality.visibility = o->visibility;
        file->set_at[row - tp_params(&count)] = SET_BY_COMMAND;
    }
    return code;
}

/* Reports clamped steepness with three decimals: in 16.16 a sum of decimal values as 0.4 is
 * not a round number. */
static void report_clamps(const scene_file *file, const tp_sea *sea)
{
    char sum[16];
    if (!sea->clamped)
        return;
    const int64_t thousandths = ((int64_t)sea->steepness * 1000 + 0x8000) >> 16;
    tp_fx_write((tp_fx)((thousandths * 65536 + 500) / 1000), sum);
    say("%s: steepness sum %s is clamped to 0.95", file->name, sum);
}

/* True if the noise exceeds an eighth of the range: 8-bit cells then show little but their
 * own rounding errors. */
static bool is_noisy(tp_fx courant, int32_t damping)
{
    return tp_pool_noise(courant, (uint32_t)damping) > 16 * TP_FX_ONE;
}

static void report_noise(const scene_file *file, const tp_scene_pool *pool,
                         const char *courant)
{
    const int64_t noise = tp_pool_noise(pool->courant, (uint32_t)pool->damping);
    int  thousandths = 50;
    char who[300];

    if (pool->cols == 0 || pool->cells != TP_CELLS_8
        || !is_noisy(pool->courant, pool->damping))
        return;
    while (is_noisy(thousandths * TP_FX_ONE / 1000, pool->damping))
        thousandths++;
    scene_file_who(file, tp_param_find(courant, strlen(courant)), who, sizeof who);
    say("%s: 8-bit cells have noise of %d %% of their range; 0.%03d or more, or cells = 16,"
        " gives less than 13 %%", who, (int)((noise * 100 / 127 + 0xffff) >> 16),
        thousandths);
}

void stage_report(const scene_file *file, const tp_sea *sea)
{
    report_clamps(file, sea);
    report_noise(file, &file->scene.pool, "pool.courant");
    report_noise(file, &file->scene.field, "field.courant");
}

int stage_load_assets(asset_set *a, const scene_file *file, const options *o)
{
    return assets_load(a, file, &(assets_options){
        .texels = o->texels, .strict = o->strict, .quiet = o->quiet });
}

int stage_load(stage *s, const options *o)
{
    memset(s, 0, sizeof *s);
    int code = stage_read(&s->file, o);
    if (!code)
        code = stage_load_assets(&s->assets, &s->file, o);
    if (!code)
        code = stage_world(s);
    if (!code && !o->quiet)
        stage_report(&s->file, &s->world->sea);
    return code;
}

int stage_open(stage *s, const options *o)
{
    const int code = stage_load(s, o);
    return code ? code : stage_canvas(s, o);
}

tp_world *stage_new_world(const tp_scene *scene, const tp_assets *names, size_t *bytes,
                          tp_error *err)
{
    *bytes = tp_world_bytes(&tp_program_all, scene, names);
    tp_world *world = malloc(*bytes > sizeof *world ? *bytes : sizeof *world);
    if (world
        && tp_world_init(&tp_program_all, world, *bytes, scene, names, err) == TP_OK)
        return world;
    free(world);
    return NULL;
}

void stage_take_world(stage *s, tp_world *world, size_t bytes)
{
    free(s->world);
    s->world = world;
    s->world_bytes = bytes;
}

int stage_world(stage *s)
{
    tp_error err = { 0 };
    size_t bytes;
    tp_world *world = stage_new_world(&s->file.scene, &s->assets.names, &bytes, &err);
    if (!world)
        return err.code ? scene_file_refuse(&s->file, &err) : fail_memory(bytes);
    stage_take_world(s, world, bytes);
    return EXIT_DONE;
}

/* Returns the memory that a board needs beside the picture, bytes. */
static size_t board_memory_bytes(const canvas *c, size_t world_bytes)
{
    return c->frame_bytes + world_bytes + c->scratch_bytes;
}

/* Chooses streaming of grid vertices if memory does not suffice for storing them. */
static void choose_store(canvas *c, const tp_scene *scene, const tp_assets *names,
                         size_t world_bytes, const options *o)
{
    c->stream = o->stream;
    canvas_count(c, scene, names);
    if (o->memory && board_memory_bytes(c, world_bytes) > o->memory) {
        c->stream = true;
        canvas_count(c, scene, names);
    }
}

/* Checks --memory.  Meshes and textures are not counted: on a board they may be in ROM. */
static int check_memory(const stage *s, const canvas *c, const asset_set *a,
                        size_t world_bytes, uint64_t allowed)
{
    const size_t named = a->mesh_bytes + a->texture_bytes;
    const size_t bytes = board_memory_bytes(c, world_bytes);
    char rom[80] = "";
    if (!allowed || bytes <= allowed)
        return EXIT_DONE;
    if (named)
        snprintf(rom, sizeof rom, "; %zu bytes of pictures and mesh are not counted",
                 named);
    return fail(EXIT_INPUT, "%s needs %zu bytes (frame %zu, world %zu, scratch %zu),"
                " --memory allows %" PRIu64 "%s", s->file.name, bytes, c->frame_bytes,
                world_bytes, c->scratch_bytes, allowed, rom);
}

int stage_plan(const stage *s, const options *o, const asset_set *a, size_t world_bytes,
               canvas *c)
{
    const tp_config config = {
        .width = o->width,
        .height = o->height,
        .tile_width = o->strip,
        .tile_height = o->band,
        .format = o->format,
    };
    canvas_plan(c, &config, o->threads);
    if (o->machine)
        c->machine = o->machine;
    choose_store(c, &s->file.scene, &a->names, world_bytes, o);
    return check_memory(s, c, a, world_bytes, o->memory);
}

tp_ladder stage_ladder(const stage *s)
{
    return tp_ladder_make(&s->file.scene, &s->assets.names, s->canvas.config.width,
                          s->canvas.config.height);
}

int stage_canvas(stage *s, const options *o)
{
    canvas_close(&s->canvas);
    const int code = stage_plan(s, o, &s->assets, s->world_bytes, &s->canvas);
    s->ladder = stage_ladder(s);
    return code ? code : canvas_open(&s->canvas, &s->file.scene, &s->assets.names);
}

void stage_close(stage *s)
{
    canvas_close(&s->canvas);
    free(s->world);
    assets_close(&s->assets);
    scene_file_close(&s->file);
}
