/* SPDX-License-Identifier: MIT */
/* furniture SCENE WIDTHxHEIGHT MESH.obj...: draws each mesh as the scene's boat, scaled
 * to fill the picture.  Prints a line for each mesh refused or not visible, and the
 * number drawn.  Warnings go to stderr.  Exits with 0 if every mesh was drawn and
 * visible. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "app/scene/frame_renderer.h"
#include "app/files/log.h"
#include "app/scene/loaded_scene.h"

#define SIDE 4.0                /* m, longest side of a drawn mesh */

static double of(tp_fx x)
{
    return x / 65536.0;
}

static double most_of(double a, double b)
{
    return a > b ? a : b;
}

static void set(scene_file *file, const char *name, double value)
{
    char setting[80];
    snprintf(setting, sizeof setting, "%s=%.5f", name, value);
    if (scene_file_set(file, setting))
        exit(2);
}

/* Places the mesh in the middle, SIDE m long and above the water. */
static void place(loaded_scene *s)
{
    const tp_mesh *m = &s->assets.boat;
    const double unit = 1u << m->log2_unit;
    const double x = of(m->high.x - m->low.x), y = of(m->high.y - m->low.y);
    const double z = of(m->high.z - m->low.z), most = most_of(x, most_of(y, z)) * unit;
    double scale = SIDE / most_of(most, 0.04);
    scale = scale < 0.001 ? 0.001 : scale;
    set(&s->file, "boat.scale", scale);
    set(&s->file, "boat.x", -of(m->low.x / 2 + m->high.x / 2) * unit * scale);
    set(&s->file, "boat.z", -of(m->low.z / 2 + m->high.z / 2) * unit * scale);
    set(&s->file, "boat.lift", 0.5 - of(m->low.y) * unit * scale);
}

/* Returns the number of pixels changed by the mesh. */
static size_t count_seen(loaded_scene *s, const options *o)
{
    s->assets.names.boat = &s->assets.boat;
    if (loaded_scene_make_world(s) || loaded_scene_open_renderer(s, o))
        return 0;
    frame_renderer_draw(&s->renderer, s->world);
    const size_t bytes = s->renderer.picture.row_bytes * s->renderer.picture.height;
    uint8_t *with = malloc(bytes);
    memcpy(with, s->renderer.picture.rows, bytes);
    s->assets.names.boat = NULL;
    if (loaded_scene_make_world(s) || loaded_scene_open_renderer(s, o))
        return 0;
    frame_renderer_draw(&s->renderer, s->world);
    size_t seen = 0;
    for (size_t i = 0; i < bytes; i += 4)
        seen += memcmp(with + i, s->renderer.picture.rows + i, 4) != 0;
    free(with);
    return seen;
}

/* True if the mesh was drawn and is visible. */
static int draw(options *o, const char *mesh)
{
    static const char *settings[] = { NULL, "camera.x=2.5", "camera.y=6", "camera.z=4",
                                      "camera.heading=-32", "camera.pitch=-45",
                                      "wave0.amplitude=0" };
    static char named[8192];
    loaded_scene s;
    snprintf(named, sizeof named, "boat.mesh=%s", mesh);
    settings[0] = named;
    o->settings = settings;
    o->n_settings = sizeof settings / sizeof *settings;
    const int code = loaded_scene_load(&s, o);
    size_t seen = 0;
    if (!code) {
        options larger = *o;        /* again larger, for wires thinner than a pixel */
        larger.width *= 10;
        larger.height *= 10;
        place(&s);
        seen = count_seen(&s, o);
        if (!seen)
            seen = count_seen(&s, &larger);
    }
    if (!seen)
        printf("%s: %s\n", code ? "refused" : "not seen", mesh);
    loaded_scene_close(&s);
    return seen > 0;
}

int main(int argc, char **argv)
{
    options o = { 0 };
    unsigned w, h;
    int drawn = 0;
    if (argc < 4 || sscanf(argv[2], "%ux%u", &w, &h) != 2)
        return EXIT_USAGE;
    o.scene = argv[1];
    o.width = w;
    o.height = h;
    for (int i = 3; i < argc; i++)
        drawn += draw(&o, argv[i]);
    printf("%d of %d drawn\n", drawn, argc - 3);
    return drawn == argc - 3 ? EXIT_DONE : EXIT_CHECK;
}
