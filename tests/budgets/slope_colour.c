/* SPDX-License-Identifier: MIT */
/* Measures what slopes of water do to colours, for the culling of waves: shipped scenes at
 * 160x120 and 320x240, with and without a small wave.
 *
 *     slope_colour SCENE.ini...
 *
 * Prints lines: slope COLOUR SCENE, the rms of the picture that the wave causes, of 255, for
 * slopes of rms 1. */
#include <stdio.h>
#include "tests/lib/drawings.h"
#include "world/pools.h"

#define SMALL_SLOPE  0.02       /* k A, the slope */
#define SMALL_LENGTH 4          /* wavelength, m */

/* Adds a small wave to a scene with plain waves; the wave's phase does not matter. */
static void lay_a_wave(loaded_scene *s)
{
    static drawing without, more;
    tp_wave  *last = &s->file.scene.wave[TP_WAVES - 1];

    if (last->amplitude > 0 || tp_world_coastal(s->world))
        return;
    tp_scene scene = exact_scene(s);
    draw(&without, s, &scene, s->world);
    *last = (tp_wave){ .length = SMALL_LENGTH * TP_FX_ONE, .heading = 70 * TP_FX_ONE,
                       .exponent = 1 };
    last->amplitude = (tp_fx)lround(SMALL_SLOPE * SMALL_LENGTH / 6.2831853 * 65536);
    if (loaded_scene_make_world(s))
        exit(1);
    scene = exact_scene(s);
    draw(&more, s, &scene, s->world);
    printf("slope %.4f %s\n",
           colour_rms(&without, &more) / (SMALL_SLOPE * sqrt(0.5)),
           s->file.name);
}

static int measure(const char *path)
{
    options o = { .command = "slope_colour", .scene = path, .width = width,
                  .height = height };
    loaded_scene s;
    int code = loaded_scene_open(&s, &o);

    if (!code)
        lay_a_wave(&s);
    loaded_scene_close(&s);
    return code;
}

int main(int argc, char **argv)
{
    int code = 0;

    for (uint32_t size = 1; size <= 2 && !code; size++) {
        width = 160 * size;
        height = 120 * size;
        for (int i = 1; i < argc && !code; i++)
            code = measure(argv[i]);
    }
    return code;
}
