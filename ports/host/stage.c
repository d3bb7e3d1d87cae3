/* SPDX-License-Identifier: MIT */
/* From the command line to a world and a canvas. */
#include "stage.h"
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
    if (!code && o->visibility)
        file->scene.quality.visibility = o->visibility;
    return code;
}

/* To three decimals: 16.16 of a sum of people's 0.4 is no round number. */
void stage_report_clamps(const scene_file *file, const tp_sea *sea)
{
    char sum[16];
    if (!sea->clamped)
        return;
    const int64_t thousandths = ((int64_t)sea->steepness * 1000 + 0x8000) >> 16;
    tp_fx_write((tp_fx)((thousandths * 65536 + 500) / 1000), sum);
    say("%s: steepness sum %s is clamped to 0.95", file->name, sum);
}

int stage_load(stage *s, const options *o)
{
    memset(s, 0, sizeof *s);
    int code = stage_read(&s->file, o);
    if (!code)
        code = assets_open_within(&s->assets, &s->file, o->texels);
    if (!code)
        code = stage_world(s);
    if (!code)
        stage_report_clamps(&s->file, &s->world->sea);
    return code;
}

int stage_open(stage *s, const options *o)
{
    const int code = stage_load(s, o);
    return code ? code : stage_canvas(s, o);
}

int stage_world(stage *s)
{
    const tp_scene *scene = &s->file.scene;
    const size_t bytes = tp_world_bytes(scene, &s->assets.names);
    tp_error err = { 0 };
    tp_world *world = malloc(bytes > sizeof *world ? bytes : sizeof *world);
    if (!world)
        return fail_memory(bytes);
    if (tp_world_init(world, bytes, scene, &s->assets.names, &err)) {
        free(world);
        return scene_file_refuse(&s->file, &err);
    }
    free(s->world);
    s->world = world;
    s->world_bytes = bytes;
    return EXIT_DONE;
}

/* What a board would need beside the picture. */
static size_t bytes_of(const stage *s)
{
    return s->canvas.frame_bytes + s->world_bytes + s->canvas.scratch_bytes;
}

/* Crossings are not stored if there is no room for them. */
static void choose_store(stage *s, const options *o)
{
    const tp_scene *scene = &s->file.scene;
    const tp_assets *names = &s->assets.names;

    s->canvas.stream = o->stream;
    canvas_count(&s->canvas, scene, names);
    if (o->memory && bytes_of(s) > o->memory) {
        s->canvas.stream = true;
        canvas_count(&s->canvas, scene, names);
    }
}

/* What the scene names may lie in ROM there. */
static int check_memory(const stage *s, uint64_t allowed)
{
    const canvas *c = &s->canvas;
    const size_t named = s->assets.mesh_bytes + s->assets.texture_bytes;
    const size_t bytes = bytes_of(s);
    char rom[80] = "";
    if (!allowed || bytes <= allowed)
        return EXIT_DONE;
    if (named)
        snprintf(rom, sizeof rom, "; what it names, %zu bytes, is not counted", named);
    return fail(EXIT_INPUT, "%s needs %zu bytes (frame %zu, world %zu, scratch %zu),"
                " --memory allows %" PRIu64 "%s", s->file.name, bytes, c->frame_bytes,
                s->world_bytes, c->scratch_bytes, allowed, rom);
}

int stage_canvas(stage *s, const options *o)
{
    const tp_frame_config config = {
        .width = o->width, .height = o->height,
        .tile_width = o->strip, .tile_height = o->band,
        .format = o->format,
    };
    canvas_close(&s->canvas);
    canvas_plan(&s->canvas, &s->file.scene, &s->assets.names, &config, o->threads);
    if (o->machine)
        s->canvas.machine = o->machine;
    choose_store(s, o);
    const int code = check_memory(s, o->memory);
    return code ? code : canvas_open(&s->canvas, &s->file.scene, &s->assets.names);
}

void stage_close(stage *s)
{
    canvas_close(&s->canvas);
    free(s->world);
    assets_close(&s->assets);
    scene_file_close(&s->file);
}
