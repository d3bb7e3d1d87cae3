/* SPDX-License-Identifier: MIT */
/* From the command line to a world and a canvas. */
#include "stage.h"
#include <stdlib.h>
#include <string.h>
#include "say.h"

int stage_read(scene_file *file, const options *o)
{
    int code = scene_file_open(file, o->scene);
    for (uint32_t i = 0; i < o->n_settings && !code; i++)
        code = scene_file_set(file, o->settings[i]);
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

int stage_open(stage *s, const options *o)
{
    memset(s, 0, sizeof *s);
    int code = stage_read(&s->file, o);
    if (!code)
        code = assets_open(&s->assets, &s->file);
    if (code)
        return code;
    code = stage_world(s);
    if (code)
        return code;
    stage_report_clamps(&s->file, &s->world->sea);
    return stage_canvas(s, o);
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

int stage_canvas(stage *s, const options *o)
{
    const tp_frame_config config = {
        .width = o->width, .height = o->height,
        .tile_width = o->strip, .tile_height = o->band,
        .format = o->format,
    };
    canvas_close(&s->canvas);
    return canvas_open(&s->canvas, &s->file.scene, &s->assets.names, &config, o->threads);
}

void stage_close(stage *s)
{
    canvas_close(&s->canvas);
    free(s->world);
    assets_close(&s->assets);
    scene_file_close(&s->file);
}
