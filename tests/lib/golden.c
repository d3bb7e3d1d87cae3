/* SPDX-License-Identifier: MIT */
/* Draws golden frames and compares them with their references. */
#include "tests/lib/golden.h"
#include "pixel/pixel.h"
#include "world/world.h"
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "app/scene/frame_renderer.h"

#define PATH_BYTES 512

const uint32_t golden_frames[GOLDEN_FRAMES] = GOLDEN_TICKS;

/* -- drawing ------------------------------------------------------------------- */

bool golden_open(golden_scene *g, const char *name)
{
    memset(g, 0, sizeof *g);
    if (scene_file_open(&g->file, name) || assets_open(&g->assets, &g->file))
        return false;
    const size_t bytes =
        tp_world_bytes(&tp_program_all, &g->file.scene, &g->assets.names);
    tp_world *world = malloc(bytes);
    if (!world
        || tp_world_init(&tp_program_all, world, bytes, &g->file.scene, &g->assets.names,
                         NULL))
        exit(1);
    for (uint32_t i = 0; i < GOLDEN_FRAMES; i++) {
        while (world->tick < golden_frames[i])
            tp_world_step(&tp_program_all, world, &g->file.scene, NULL);
        g->world[i] = malloc(bytes);
        if (!g->world[i])
            exit(1);
        memcpy(g->world[i], world, bytes);
    }
    free(world);
    return true;
}

void golden_close(golden_scene *g)
{
    for (uint32_t i = 0; i < GOLDEN_FRAMES; i++)
        free(g->world[i]);
    assets_close(&g->assets);
    scene_file_close(&g->file);
}

picture golden_draw(const golden_scene *g, uint32_t frame_index, tp_format format,
                    uint32_t strip, uint32_t band)
{
    const tp_config config = {
        .width = GOLDEN_WIDTH,
        .height = GOLDEN_HEIGHT,
        .tile_width = strip,
        .tile_height = band,
        .format = format,
    };
    frame_renderer c;
    memset(&c, 0, sizeof c);
    frame_renderer_plan(&c, &config, 1);
    if (frame_renderer_open(&c, &g->file.scene, &g->assets.names))
        exit(1);
    frame_renderer_draw(&c, g->world[frame_index]);

    picture p = c.picture;
    p.rows = malloc(p.row_bytes * p.height);
    if (!p.rows)
        exit(1);
    memcpy(p.rows, c.picture.rows, p.row_bytes * p.height);
    frame_renderer_close(&c);
    return p;
}

void golden_free(picture *p)
{
    free(p->rows);
    p->rows = NULL;
}

/* -- references ---------------------------------------------------------------- */

static bool exists(const char *path)
{
    FILE *f = fopen(path, "rb");
    if (f)
        fclose(f);
    return f != NULL;
}

static void list_path(char path[PATH_BYTES], const char *folder, tp_format format)
{
    snprintf(path, PATH_BYTES, "%s/%s.crc", folder, tp_format_name(format));
}

static void png_path(char path[PATH_BYTES], const char *folder, tp_format format,
                     uint32_t frame)
{
    snprintf(path, PATH_BYTES, "%s/%s-%04" PRIu32 ".png", folder, tp_format_name(format),
             frame);
}

/* Reads a frame's CRC from the list.  Returns false if the list has no such frame. */
static bool listed_crc(const char *folder, tp_format format, uint32_t frame,
                       uint32_t *crc)
{
    char path[PATH_BYTES], line[80];
    list_path(path, folder, format);
    FILE *f = fopen(path, "r");
    bool found = false;
    while (f && fgets(line, sizeof line, f)) {
        uint32_t n, c;
        if (sscanf(line, "frame %" SCNu32 " crc32 %" SCNx32, &n, &c) == 2 && n == frame) {
            *crc = c;
            found = true;
        }
    }
    if (f)
        fclose(f);
    return found;
}

/* Returns the reference picture as 0x00RRGGBB, for any format; rows is NULL if there is
 * none. */
static picture reference(const char *folder, tp_format format, uint32_t frame)
{
    char path[PATH_BYTES];
    picture p = { .format = TP_FORMAT_XRGB8888 };
    png_path(path, folder, format, frame);
    if (!exists(path))
        return p;
    uint32_t *pixels = picture_read_png(path, "golden", &p.width, &p.height);
    for (size_t i = 0; pixels && i < (size_t)p.width * p.height; i++)
        pixels[i] &= 0xffffff;
    p.row_bytes = p.width * sizeof *pixels;
    p.rows = (uint8_t *)pixels;
    return p;
}

static picture expanded(const picture *from)
{
    picture p = { .format = TP_FORMAT_XRGB8888, .width = from->width,
                  .height = from->height, .row_bytes = from->width * 4 };
    p.rows = malloc(p.row_bytes * p.height);
    if (!p.rows)
        exit(1);
    for (uint32_t y = 0; y < p.height; y++)
        picture_expand_row(from, y, (uint32_t *)(void *)(p.rows + y * p.row_bytes));
    return p;
}

/* -- comparing ----------------------------------------------------------------- */

static void leave(const char *wreck, const char *name, const char *what, const picture *p)
{
    char path[PATH_BYTES];
    snprintf(path, sizeof path, "%s/%s-%s.png", wreck, name, what);
    if (!picture_write_png(p, path))
        printf("    see %s\n", path);
}

/* Returns the difference per channel: black where equal, raised elsewhere to be visible. */
static picture difference(const picture *a, const picture *b)
{
    picture d = expanded(a);
    for (size_t i = 0; i < d.row_bytes * d.height; i++) {
        int apart = abs(a->rows[i] - b->rows[i]);
        d.rows[i] = (uint8_t)(apart ? 64 + apart * 3 / 4 : 0);
    }
    return d;
}

static void leave_wreck(const char *wreck, const char *name, const picture *expected,
                        const picture *actual)
{
    picture shown = expanded(actual);
    leave(wreck, name, "actual", &shown);
    if (expected->rows)
        leave(wreck, name, "expected", expected);
    if (expected->rows && expected->width == shown.width
        && expected->height == shown.height) {
        picture d = difference(&shown, expected);
        leave(wreck, name, "difference", &d);
        golden_free(&d);
    }
    golden_free(&shown);
}

bool golden_compare(const char *folder, const char *wreck, const picture *actual,
                    uint32_t frame, const char *name)
{
    uint32_t crc = picture_crc(actual), listed = 0;
    picture  expected = reference(folder, actual->format, frame);
    const char *wrong = NULL;

    if (!listed_crc(folder, actual->format, frame, &listed))
        wrong = "is not listed";
    else if (!expected.rows)
        wrong = "has no reference picture";
    else if (picture_crc(&expected) != listed)
        wrong = "has a reference picture that is not the listed one";
    else if (crc != listed)
        wrong = "differs from its reference";
    if (wrong) {
        printf("frame %04" PRIu32 " of %s %s: %08" PRIx32 ", listed %08" PRIx32 "\n",
               frame, name, wrong, crc, listed);
        leave_wreck(wreck, name, &expected, actual);
    }
    golden_free(&expected);
    return !wrong;
}

/* -- writing ------------------------------------------------------------------- */

/* Returns the peak signal to noise ratio over all channels, dB; infinite for equal
 * pictures. */
static double psnr(const picture *a, const picture *b)
{
    double squares = 0, n = 0;
    for (size_t i = 0; i < a->row_bytes * a->height; i++) {
        double apart = a->rows[i] - b->rows[i];
        squares += apart * apart;
        n += 1;
    }
    return 10 * log10(255.0 * 255.0 * 3 / 4 * n / squares);     /* 3/4: X byte is 0 */
}

void golden_write(const char *folder, const picture *actual, uint32_t frame, bool first)
{
    char path[PATH_BYTES];
    const char *format = tp_format_name(actual->format);
    picture old = reference(folder, actual->format, frame), shown = expanded(actual);

    printf("%s frame %04" PRIu32 ": ", format, frame);
    if (!old.rows || old.width != shown.width || old.height != shown.height)
        printf("new\n");
    else if (picture_crc(&old) == picture_crc(&shown))
        printf("unchanged\n");
    else
        printf("PSNR %.1f dB to the old one\n", psnr(&old, &shown));
    golden_free(&old);
    golden_free(&shown);

    png_path(path, folder, actual->format, frame);
    if (picture_write_png(actual, path))
        exit(1);
    list_path(path, folder, actual->format);
    FILE *list = fopen(path, first ? "w" : "a");
    if (!list)
        exit(1);
    fprintf(list, "frame %04" PRIu32 " crc32 %08" PRIx32 "\n", frame,
            picture_crc(actual));
    fclose(list);
}
