/* SPDX-License-Identifier: MIT */
/* Drawing: a world becomes a picture, tile by tile, in the caller's memory.
 *
 *     bytes = tp_frame_bytes(&config, &scene)
 *     tp_frame_init(&frame, &config, &scene, memory, bytes, &err)
 *     tp_frame_begin(frame, world)
 *     for (i = 0; tp_frame_draw_tile(frame, i, scratch, &tile); i++)
 *         show tile.pixels
 *
 * A tile depends on nothing but the frame: tiles may be drawn in any order, at once by
 * several threads (each with its own scratch), and every tiling gives the same bits. */
#ifndef TP_FRAME_H
#define TP_FRAME_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "tidepool/assets.h"
#include "tidepool/fixed.h"
#include "tidepool/scene.h"
#include "tidepool/status.h"
#include "tidepool/world.h"

TP_BEGIN_C

/* Formats of pixels: name, bits a pixel, what it is.  The last three are dithered by an
 * ordered 8x8 pattern fixed to the picture. */
#define TP_FORMAT_LIST(X) \
    X(XRGB8888, xrgb8888, 32, "0x00RRGGBB in a native uint32_t") \
    X(RGB565,   rgb565,   16, "native uint16_t, red high") \
    X(RGB565BE, rgb565be, 16, "high byte first, as SPI panels take it") \
    X(P8,       p8,        8, "index into tp_palette()") \
    X(L8,       l8,        8, "grey, 255 is white") \
    X(I1,       i1,        1, "a bit a pixel, high bit left, 1 is white")

typedef enum {
#define X(name, word, bits, text) TP_FORMAT_##name,
    TP_FORMAT_LIST(X)
#undef X
    TP_FORMAT_COUNT
} tp_format;

/* 256 colours 0x00RRGGBB: 6 reds x 7 greens x 6 blues, then four greys. */
const uint32_t *tp_palette(void);

struct tp_frame;

/* -- what an application draws into tiles ------------------------------------------- */

/* A row of a tile: its colours are final, its pixels not yet stored. */
typedef struct {
    uint32_t y, x0, x1; /* of the picture; x1 not included */
    uint32_t *colour;   /* 0x00RRGGBB of x0 and on, which may be written */
    /* -- private part -- */
    const uint32_t *key;
    tp_fx near;
} tp_overlay_row;

/* Made by tp_overlay_of; all 0 is none. */
typedef struct {
    void (*row)(void *user, const tp_overlay_row *row);
    void *user;
    /* -- private part -- */
    void (*draw)(const struct tp_frame *frame, const void *samples, int32_t y, void *row);
} tp_overlay;

/* An overlay for a config.  `row` is called with `user` for each row of each tile, when
 * haze, exposure and glass are in its colours and before the format's store converts them:
 * whatever the format, it draws in 0x00RRGGBB.  Threads that draw tiles call it at once,
 * one each, so it may change only what is a tile's own.  The row lies in the tile's
 * scratch, which needs no more bytes for it.  Who makes no overlay links none of this. */
tp_overlay tp_overlay_of(void (*row)(void *user, const tp_overlay_row *row), void *user);

/* Draws `count` pixels from column x of the picture on, where nothing else is as near as
 * `depth` m (16.16, along the camera's way ahead, as tp_frame_project has it; 0: over
 * everything).  Colours 0xAARRGGBB are laid on by their alpha; columns outside of the row
 * are left out.  Depths stay those of the picture: where spans cover each other the one
 * drawn last is seen. */
void tp_overlay_span(const tp_overlay_row *row, int32_t x, uint32_t count, tp_fx depth,
                     const uint32_t *argb);

/* ------------------------------------------------------------------------------------ */

/* A picture, and what draws it.  A field of 0 is the default. */
typedef struct {
    uint32_t  width, height;        /* pixels, 16..4096 */
    uint32_t  tile_width;           /* multiple of 16; 0: the picture's width */
    uint32_t  tile_height;          /* 0: 16 rows */
    tp_format format;               /* 0: xrgb8888 */
    const tp_program *program;      /* NULL: tp_program_linked */
    const tp_assets  *assets;       /* NULL: the scene's own pictures, or none */
    tp_overlay overlay;             /* the application's own spans: tp_overlay_of */
} tp_config;

typedef struct {
    uint32_t    x0, y0, x1, y1;     /* x1, y1 not included */
    const void *pixels;             /* row y0, from x0 */
    size_t      stride;             /* bytes from row to row */
} tp_tile;

/* What the last tp_frame_begin found; numbers of the whole picture. */
typedef struct {
    uint32_t vertices;              /* of water and boat, evaluated */
    uint32_t triangles;             /* in view, before clipping */
    uint32_t dropped;               /* things that did not fit and were left out */
} tp_draw_stats;

/* RAM by use, bytes. */
typedef struct {
    size_t frame;                   /* the block of tp_frame_bytes */
    size_t vertices, tables;        /* the two large parts of it */
    size_t mirror;                  /* of it, for what water looks into: see below */
    size_t scratch;                 /* of one tile: samples and pixels */
} tp_ram_use;

/* The frame's block holds what the scene needs at init, nothing for what it lacks:
 *  - vertices: the grid and its crossings, the boat's and the land's corners, drops, rings,
 *    specks of spray
 *  - tables: a sky's gradient; shininess, if the program has lit water; of a
 *    generated or cube sky, the exposure, the boat's materials, slopes of pools that bend
 *    the light only; glass, walls inside a pool, the map of caustics (2 bytes a cell)
 *  - mirror: with mirror.objects = stencil a picture of half the size and four rows of
 *    samples, 88320 bytes at 320x240; with mirror.size = quarter 24960.  88320 more for
 *    objects seen under water (water.clear).  With mirror.objects = cube 24576 bytes at
 *    any size.  Each has up to 128 bytes of numbers besides. */

typedef struct tp_frame tp_frame;   /* lies at the start of the block */

/* 0 if the config or the scene is out of range.  The scene's numbers may change while
 * frames are drawn, but grid.cols, grid.rows and the names; a change goes through
 * tp_world_apply, which checks it, before the next tp_frame_begin.
 *
 * Memory is fixed at init.  If the scene grows later, extra drops, rings and specks are
 * left out; a floor, wind, mirror, things under clear water, caustics, a tank, its glass
 * and walls in a pool that were absent at init are not drawn; caustic_cells stay; a new
 * kind of sky falls back to the gradient and automatic exposure to 1; pools that come to
 * bend the light only stay heights. */
size_t tp_frame_bytes(const tp_config *config, const tp_scene *scene);

/* The scratch of one tile; `into`: of a tile that is drawn into a frame buffer, see below.
 * A program that streams crossings (tp_method_streamed) needs two lines of crossings more.
 * Without rows and projected it needs 24 bytes a column less, unless pixels need them. */
size_t tp_frame_scratch_bytes(const tp_config *config, const tp_scene *scene);
size_t tp_frame_direct_scratch_bytes(const tp_config *config, const tp_scene *scene);

/* A frame in `memory`, of at least tp_frame_bytes() bytes, aligned to 8.  The config is
 * copied.  Program, scene and assets must outlive the frame, which keeps pointers to them.
 *  - TP_E_NULL, TP_E_ALIGN: err->word is the argument; TP_E_NOSPACE: `bytes` are too few
 *  - TP_E_SIZE, TP_E_TILE, TP_E_ARG: the config is out of range
 *  - as tp_world_init: the scene is, or the program lacks a module that it has on
 *  - TP_E_PROGRAM: a program has at least the stages sky and plain, and the format's store */
tp_status tp_frame_init(tp_frame **frame, const tp_config *config, const tp_scene *scene,
                        void *memory, size_t bytes, tp_error *err);

/* Takes the world's state into the frame.  The world stays as it is until the last tile
 * has been drawn. */
void tp_frame_begin(tp_frame *frame, const tp_world *world);

/* Draws tile i, row by row of tiles, into `scratch` (tp_frame_scratch_bytes(),
 * aligned to 8), where tile->pixels then points.  False: there is no such tile, or the
 * scratch is NULL or misaligned. */
bool tp_frame_draw_tile(const tp_frame *frame, uint32_t i, void *scratch, tp_tile *tile);

/* The same into a picture of the caller's, as a board has that has a frame buffer: row y
 * is at picture + y stride, aligned as tp_store wants it.  No pixels lie in the scratch
 * then: tp_frame_direct_scratch_bytes(). */
bool tp_frame_draw_tile_to(const tp_frame *frame, uint32_t i, void *scratch,
                           void *picture, size_t stride, tp_tile *tile);

tp_draw_stats tp_frame_stats(const tp_frame *frame);
tp_ram_use tp_frame_ram(const tp_frame *frame);

/* -- places of the picture ----------------------------------------------------------- */

/* Where a place of the world lies in the picture of the last tp_frame_begin: pixels from
 * the upper left corner, 16.16, saturated, also outside of the picture; and how far ahead
 * of the camera, m.  False: it lies before the near plane, or behind the camera. */
bool tp_frame_project(const tp_frame *frame, tp_vec3 place, tp_fx *x_px, tp_fx *y_px,
                      tp_fx *depth);

/* The water under a place of that picture, see tp_world_pick; the world is as it was at
 * tp_frame_begin. */
bool tp_frame_pick(const tp_frame *frame, tp_fx x_px, tp_fx y_px, tp_vec3 *at);

/* -- samples of a drawn tile ----------------------------------------------------------
 *
 * Drawing leaves them in the scratch, where they stay until the next tile is drawn there:
 * no memory is kept for these rows, and who does not ask pays nothing.  y0 <= y < y1 of
 * the tile; a row has x1 - x0 entries. */

/* How far ahead of the camera each pixel is, m, within depth^2 / (near 2^24) and half a
 * unit of 16.16; TP_FX_MAX in the sky.  What lies behind a boat's lid has the lid's. */
void tp_frame_depth_row(const tp_frame *frame, const void *scratch, const tp_tile *tile,
                        uint32_t y, tp_fx *depth);

/* tp_sample_kind of each pixel. */
void tp_frame_kind_row(const tp_frame *frame, const void *scratch, const tp_tile *tile,
                       uint32_t y, uint8_t *kind);

TP_END_C
#endif
