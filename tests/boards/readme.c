/* SPDX-License-Identifier: MIT */
/* Runs the program of ports/README.md with test callbacks on a model of the panel:
 *
 *     readme          the panel shows the whole picture after the program's frames
 *     readme stuck    the program reports that the screen is missing */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "cortex-m/baked.h"
#include "lcd/lcd.h"
#include "pixel/pixel.h"
#include "tests/lib/lcd_panel.h"
#include "tests/boards/sdk/sdk.h"
#include "tidepool/tidepool.h"

int example(void);                      /* the README's main */

enum { WIDTH = 320, HEIGHT = 240, FRAMES = 3 };

uint32_t sdk_ms;

static panel_model    shown;
static bool     dc, stuck;
static uint32_t to_end, to_leave;       /* queries until DMA end, until all is sent */

/* -- the wires ---------------------------------------------------------------------- */

static void fault(const char *why)
{
    shown.faults++;
    shown.fault = shown.fault ? shown.fault : why;
}

void sdk_dc(bool data)
{
    if (shown.waiting || to_leave)
        fault("D/C moves while bytes are on their way");
    dc = data;
}

void sdk_send(const uint8_t *bytes, size_t count)
{
    if (shown.waiting || to_leave)
        fault("bytes among those of a DMA");
    while (count--)
        panel_byte(&shown, dc, *bytes++);
}

void sdk_dma(const uint8_t *bytes, size_t count)
{
    if (!dc || shown.waiting || to_leave)
        fault("a DMA too early, or without D/C");
    panel_send(&shown, bytes, count);
    to_end = 2;
    to_leave = 1;
}

bool sdk_dma_busy(void)
{
    sdk_ms++;
    if (stuck)
        return true;
    if (to_end && --to_end)
        return true;
    panel_settle(&shown);
    return false;
}

bool sdk_wire_busy(void)
{
    sdk_ms++;
    if (shown.waiting)
        return true;
    if (!to_leave)
        return false;
    to_leave--;
    return true;
}

bool sdk_idle(void)
{
    return !sdk_dma_busy() && !sdk_wire_busy();
}

void sdk_pause(uint32_t ms)
{
    sdk_ms += ms;
    panel_pause(&shown, ms);
}

/* -- displayed picture -------------------------------------------------------------- */

/* Number of pixels of the glass, turned by a quarter, that differ from the frame; ends the
 * program if the comparison is impossible. */
static uint32_t wrong(void)
{
    const tp_scene *s = &baked_scene;
    const tp_assets *a = &baked_assets;
    const tp_config c = { .width = WIDTH,
                          .height = HEIGHT,
                          .tile_height = HEIGHT,
                          .format = TP_FORMAT_RGB565BE,
                          .assets = a };
    void *block = malloc(tp_frame_bytes(&c, s)),
         *scratch = malloc(tp_frame_scratch_bytes(&c, s));
    tp_world *world = malloc(tp_world_bytes(&tp_program_all, s, a));
    tp_frame *frame;
    tp_tile tile;
    uint32_t n = 0;
    if (tp_frame_init(&frame, &c, s, block, tp_frame_bytes(&c, s), NULL)
        || tp_world_init(&tp_program_all, world, tp_world_bytes(&tp_program_all, s, a), s,
                         a, NULL))
        exit(1);
    for (int i = 1; i < FRAMES; i++)
        tp_world_step(&tp_program_all, world, s, NULL);
    tp_frame_begin(frame, world);
    tp_frame_draw_tile(frame, 0, scratch, &tile);
    for (uint32_t y = 0; y < HEIGHT; y++)
        for (uint32_t x = 0; x < WIDTH; x++)
            n += panel_seen(&shown, HEIGHT - 1 - y, x)
                 != tp_pixel_read(c.format, (const uint8_t *)tile.pixels + y * tile.stride,
                                  (int)x);
    free(block);
    free(scratch);
    free(world);
    return n;
}

static void say_ram(void)
{
    const tp_program *p = &baked_program;
    const tp_config *c = &baked_config;
    const size_t frame = tp_frame_bytes(c, &baked_scene);
    const size_t world = tp_world_bytes(p, &baked_scene, &baked_assets);
    const size_t scratch = tp_frame_scratch_bytes(c, &baked_scene),
                 buffers = 4 * c->tile_width * c->tile_height;
    printf("frame %zu world %zu scratch %zu buffers %zu lcd %zu: %zu bytes\n", frame, world,
           scratch, buffers, sizeof(lcd), frame + world + scratch + buffers + sizeof(lcd));
}

int main(int argc, char **argv)
{
    stuck = argc > 1 && !strcmp(argv[1], "stuck");
    panel_power(&shown, PANEL_ILI9341);
    shown.late = 1;
    const int code = example();
    if (stuck)
        return code != 4;
    const uint32_t pixels = wrong();
    say_ram();
    printf("exit %d, %u pixels wrong, %u faults, %s\n", code, (unsigned)pixels,
           (unsigned)shown.faults, shown.fault ? shown.fault : "none");
    return code || pixels || shown.faults || shown.overwritten;
}
