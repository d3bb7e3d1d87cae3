/* SPDX-License-Identifier: MIT */
#include "ram_rungs.h"
#include <math.h>
#include <stdlib.h>
#include "app/files/log.h"
#include "pixel/pixel.h"

enum { TICK = 60 };

/* -- the values ---------------------------------------------------------------------- */

/* A change of a scene; returns false if there is nothing to change. */
typedef struct {
    const char *text;
    bool (*change)(tp_scene *scene);
} value;

static bool narrow_cells(tp_scene_pool *p)
{
    const bool has = p->cols > 0 && p->cell_bits != TP_CELLS_8;

    p->cell_bits = TP_CELLS_8;
    return has;
}

static bool narrow_pool(tp_scene *s)  { return narrow_cells(&s->pool); }
static bool narrow_field(tp_scene *s) { return narrow_cells(&s->field); }

static bool pack_mirror(tp_scene *s)
{
    const bool has = s->mirror.colours != TP_MIRROR_RGB565;

    s->mirror.colours = TP_MIRROR_RGB565;
    return has;
}

static bool shrink_mirror(tp_scene *s)
{
    const bool has = s->mirror.size != TP_MIRROR_QUARTER;

    s->mirror.size = TP_MIRROR_QUARTER;
    return has;
}

static const value values[RAM_RUNGS] = {
    { "pool.cell_bits=8", narrow_pool },
    { "field.cell_bits=8", narrow_field },
    { "mirror.colours=rgb565", pack_mirror },
    { "mirror.size=quarter", shrink_mirror },
};

/* -- measured ------------------------------------------------------------------------ */

/* A scene's bytes, and its exact picture at TICK. */
typedef struct {
    size_t    bytes;
    uint32_t *pixel;
} measured;

static tp_config picture_config(const loaded_scene *s)
{
    const tp_config *c = &s->renderer.config;

    return (tp_config){ .width = c->width, .height = c->height, .tile_width = c->tile_width,
                        .tile_height = c->tile_height, .program = &tp_program_all,
                        .assets = &s->assets.names };
}

static void draw_tiles(const tp_config *c, tp_frame *frame, void *scratch, uint32_t *to)
{
    tp_tile tile;

    for (uint32_t i = 0; tp_frame_draw_tile(frame, i, scratch, &tile); i++)
        for (uint32_t y = tile.y0; y < tile.y1; y++)
            for (uint32_t x = tile.x0; x < tile.x1; x++)
                to[(size_t)y * c->width + x] = tp_pixel_read(
                    TP_FORMAT_XRGB8888,
                    (const uint8_t *)tile.pixels + (size_t)(y - tile.y0) * tile.stride,
                    (int)(x - tile.x0));
}

/* Draws the picture at TICK by a new world and frame; false: no memory, or the scene is
 * refused. */
static bool draw(const loaded_scene *s, const tp_scene *scene, measured *to)
{
    const tp_config c = picture_config(s);
    const size_t frame_bytes = tp_frame_bytes(&c, scene),
                 scratch_bytes = tp_frame_scratch_bytes(&c, scene);
    size_t world_bytes;
    tp_world *world =
        loaded_scene_new_world(scene, &s->assets.names, &world_bytes, &(tp_error){ 0 });
    void *block = frame_bytes ? malloc(frame_bytes) : NULL;
    void *scratch = scratch_bytes ? malloc(scratch_bytes) : NULL;
    tp_frame *frame;
    const bool drawn = world && block && scratch
        && tp_frame_init(&frame, &c, scene, block, frame_bytes, NULL) == TP_OK;

    if (drawn) {
        while (world->tick < TICK)
            tp_world_step(&tp_program_all, world, scene, NULL);
        tp_frame_begin(frame, world);
        draw_tiles(&c, frame, scratch, to->pixel);
        to->bytes = frame_bytes + scratch_bytes + world_bytes;
    }
    free(world);
    free(block);
    free(scratch);
    return drawn;
}

static double root_mean_square(const uint32_t *a, const uint32_t *b, size_t pixels)
{
    double sum = 0;

    for (size_t i = 0; i < pixels; i++)
        for (int k = 0; k < 24; k += 8) {
            const double d = (double)(a[i] >> k & 255) - (double)(b[i] >> k & 255);
            sum += d * d;
        }
    return sqrt(sum / 3 / (double)pixels);
}

/* True if the changed scene takes less memory, without drawing it. */
static bool is_smaller(const loaded_scene *s, const tp_scene *changed)
{
    const tp_config c = picture_config(s);
    const tp_scene *scene = &s->file.scene;
    const tp_assets *names = &s->assets.names;
    const size_t frame = tp_frame_bytes(&c, changed),
                 world = tp_world_bytes(&tp_program_all, changed, names);

    return frame && world
        && frame + world < tp_frame_bytes(&c, scene)
                               + tp_world_bytes(&tp_program_all, scene, names);
}

static void find(ram_rungs *to, const loaded_scene *s, size_t pixels, measured *plain,
                 measured *with)
{
    bool drawn = false;

    for (int i = 0; i < RAM_RUNGS; i++) {
        tp_scene changed = s->file.scene;
        if (!values[i].change(&changed) || !is_smaller(s, &changed))
            continue;
        drawn = drawn || draw(s, &s->file.scene, plain);
        if (!drawn || !draw(s, &changed, with))
            continue;
        to->rung[to->count++] = (ram_rung){
            values[i].text, plain->bytes - with->bytes,
            root_mean_square(plain->pixel, with->pixel, pixels),
        };
    }
}

int ram_rungs_find(ram_rungs *to, const loaded_scene *s)
{
    const size_t pixels =
        (size_t)s->renderer.config.width * s->renderer.config.height;
    measured plain = { .pixel = malloc(pixels * sizeof(uint32_t)) };
    measured with = { .pixel = malloc(pixels * sizeof(uint32_t)) };
    const bool taken = plain.pixel && with.pixel;

    to->count = 0;
    if (taken)
        find(to, s, pixels, &plain, &with);
    free(plain.pixel);
    free(with.pixel);
    return taken ? EXIT_DONE : log_fail_memory(2 * pixels * sizeof(uint32_t));
}
