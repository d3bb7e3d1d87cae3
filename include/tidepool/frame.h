/* SPDX-License-Identifier: MIT */
/* A frame: draws pictures of a world, tile by tile, in the caller's memory.
 *
 *     bytes = tp_frame_bytes(&config, &scene)
 *     tp_frame_init(&frame, &config, &scene, memory, bytes, &err)
 *     tp_frame_begin(frame, world)
 *     for (i = 0; tp_frame_draw_tile(frame, i, scratch, &tile); i++)
 *         show tile.pixels
 *
 * A tile depends only on the frame.  Tiles may be drawn in any order, and by several
 * threads at once, each with a scratch of its own; every tiling gives the same bits.
 * A second picture at the same time needs a second frame. */
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

/* Pixel formats: name, bits per pixel, description.  The last three are dithered by an
 * ordered 8x8 pattern fixed to the picture. */
#define TP_FORMAT_LIST(X) \
    X(XRGB8888, xrgb8888, 32, "0x00RRGGBB in a native uint32_t") \
    X(RGB565,   rgb565,   16, "native uint16_t, red high") \
    X(RGB565BE, rgb565be, 16, "high byte first, as SPI panels take it") \
    X(P8,       p8,        8, "index into tp_palette") \
    X(L8,       l8,        8, "grey, 255 is white") \
    X(I1,       i1,        1, "a bit a pixel, high bit left, 1 is white")

typedef enum {
#define X(name, word, bits, text) TP_FORMAT_##name,
    TP_FORMAT_LIST(X)
#undef X
    TP_FORMAT_COUNT
} tp_format;

/* The palette of p8, 0x00RRGGBB: 6 reds x 7 greens x 6 blues, then four greys. */
extern const uint32_t tp_palette[256];

/* Returns the bytes of a row of `width` pixels, rounded up to whole bytes. */
size_t tp_format_row_bytes(tp_format format, int width);

/* Continues a CRC-32 (IEEE; 0 to begin) over `count` pixels from the start of a row.  Each
 * pixel counts as the four bytes of 0x00RRGGBB, low byte first.  The rows of a picture,
 * from top to bottom, give the checksum of `tidepool render --hash`, equal on machines of
 * any byte order. */
uint32_t tp_crc32_pixels(uint32_t crc, tp_format format, const void *row, int count);

struct tp_frame;

/* -- spans of the application, drawn into tiles -------------------------------------- */

/* A row of a tile with its final colours, before they become pixels of the format. */
typedef struct {
    uint32_t y, x0, x1; /* row and columns of the picture; x1 excluded */
    uint32_t *colour;   /* 0x00RRGGBB, x1 - x0 colours; the callback may write them */
    /* -- private part -- */
    const uint32_t *key;
    tp_fx near;
} tp_overlay_row;

/* Made by tp_overlay_make; all zero: no overlay. */
typedef struct {
    void (*row)(void *user, const tp_overlay_row *row);
    void *user;
    /* -- private part -- */
    void (*draw)(const struct tp_frame *frame, const void *samples, int32_t y, void *row);
} tp_overlay;

/* Returns an overlay for tp_config.  The frame calls `row` with `user` for each row of
 * each tile: after haze, exposure and glass, before the colours are converted to the
 * format.  Threads that draw tiles call `row` at the same time: `row` must not change data
 * that two tiles share.  An overlay costs no memory; a program without an overlay links
 * none of its code. */
tp_overlay tp_overlay_make(void (*row)(void *user, const tp_overlay_row *row),
                           void *user);

/* Draws `count` pixels 0xAARRGGBB, blended by their alpha, from column x of the picture
 * on.  Pixels nearer than `depth` m hide the span (16.16, as from tp_frame_project; 0 draws
 * over everything).  Columns outside of the row are left out.  A span does not change the
 * picture's depths: of two spans in one place the later one is visible. */
void tp_overlay_span(const tp_overlay_row *row, int32_t x, uint32_t count, tp_fx depth,
                     const uint32_t *argb);

/* -- the frame ----------------------------------------------------------------------- */

/* The format of a picture and the parts that draw it.  A field of 0 is the default. */
typedef struct {
    uint32_t  width, height;        /* pixels, 16..4096 */
    uint32_t  tile_width;           /* multiple of 16; 0: the picture's width */
    uint32_t  tile_height;          /* 0: 16 rows */
    tp_format format;               /* 0: xrgb8888 */
    const tp_program *program;      /* NULL: the linked program */
    const tp_assets  *assets;       /* NULL: the scene's built-in pictures, or none */
    tp_overlay overlay;             /* from tp_overlay_make; all zero: none.  With an overlay
                                     * quality.blending is exact */
    uint32_t  kept_bytes;           /* of a scratch, for lines of streamed water that stay
                                     * from tile to tile, see below; 0: none */
    bool      depth;                /* true: tp_frame_sample_row gives the depth of the
                                     * drawn water at every rung; an overlay implies it.
                                     * The picture does not depend on it */
} tp_config;

/* Kept lines.  A program that streams the water computes its lines again in each tile that
 * they touch: rows of grid vertices (tp_method_streamed) or lines of walked water.  With
 * kept_bytes tiles are counted strip by strip, each from top to bottom, and a scratch keeps
 * lines of its strip for the tiles below; with enough bytes each line is computed once a
 * strip.  Any number draws the same bits, and so does any order of tiles; the order of their
 * count is the cheapest.  Between two tiles an application may change a tile's pixels, and
 * nothing else of the scratch.  A scratch that does not begin with tile 0, as that of a
 * second thread, must be zero when the frame is made.  The program needs the part kept_lines
 * (TP_DRAW_LIST); a program that stores its lines, or lacks the part, keeps none and takes
 * none of the bytes. */

/* Checks a config as tp_frame_init does; the scene is not checked.  *filled, if not NULL,
 * receives the config with the tile size in use.
 *  - TP_E_SIZE (also of NULL), TP_E_TILE, TP_E_ARG: size, tile or format is out of range */
tp_status tp_config_check(const tp_config *config, tp_config *filled, tp_error *err);

typedef struct {
    uint32_t    x0, y0, x1, y1;     /* x1, y1 excluded */
    const void *pixels;             /* row y0, from column x0 */
    size_t      stride;             /* bytes from row to row */
    uint32_t    dropped;            /* number of triangles left out: the program lacks the
                                     * part that draws them */
} tp_tile;

/* Counts of the picture begun last. */
typedef struct {
    uint32_t vertices;              /* number of evaluated vertices of water and boat */
    uint32_t triangles;             /* number of triangles in view, before clipping */
    uint32_t dropped;               /* number of stages, drops, walls and materials left
                                     * out: no module for them, or no room */
} tp_draw_stats;

typedef struct tp_frame tp_frame;   /* lies at the start of the block */

/* Returns the bytes of a frame's block.  0: the config or the scene is out of range.
 *
 * The numbers of the scene may change between pictures, except grid.vertices and the
 * names of files: tp_world_apply checks a change and applies it.
 *
 * Memory is fixed at init.  If the scene grows later, extra drops, rings and specks are
 * left out.  Features that were absent at init are not drawn: a floor, wind, mirror,
 * objects under clear water, caustics, a tank, its glass, walls in a pool.  caustic_cells
 * keeps its value; a new kind of sky falls back to the gradient, automatic exposure to 1;
 * pools that change to bending normals only stay heights. */
size_t tp_frame_bytes(const tp_config *config, const tp_scene *scene);

/* Return the bytes of one tile's scratch, for tp_frame_draw_tile and for
 * tp_frame_draw_tile_direct.  A program with tp_method_streamed needs two rows of grid
 * vertices more, and one with kept_bytes these bytes; a program without the renderers rows
 * and projected needs up to 24 bytes a column less. */
size_t tp_frame_scratch_bytes(const tp_config *config, const tp_scene *scene);
size_t tp_frame_direct_scratch_bytes(const tp_config *config, const tp_scene *scene);

/* Makes a frame in `memory`, at least tp_frame_bytes() bytes, aligned to 8.  The frame
 * copies the config and keeps pointers to its program and assets and to the scene, which
 * must outlive it; nothing has to be closed.
 *  - TP_E_NULL, TP_E_ALIGN: err->word is the argument; TP_E_NOSPACE: `bytes` are too few
 *  - TP_E_SIZE, TP_E_TILE, TP_E_ARG: the config is out of range
 *  - as tp_world_init: the scene cannot be used, or the program lacks one of its modules
 *  - TP_E_PROGRAM: the program lacks the stage sky or plain, or the format's store */
tp_status tp_frame_init(tp_frame **frame, const tp_config *config, const tp_scene *scene,
                        void *memory, size_t bytes, tp_error *err);

/* All that tp_frame_init finds out about a config and a scene, as a constant.  `tidepool
 * bake` writes it, and a function NAME_frame_init that makes the frame of it, without the
 * code that checks and finds out.  The numbers are the same on every machine. */
typedef struct {
    const tp_config *config;        /* tile size filled in, program named */
    const tp_scene  *scene;         /* never changes while the frame lives */
    const tp_assets *assets;        /* not NULL */
    const uint8_t   *stencil;       /* first stencil value of each module, or 0 */
    uint64_t enabled;               /* bit i: module i of the program is on, ... */
    uint64_t laid;                  /* ... and draws */
    uint32_t scratch_bytes;         /* tp_frame_scratch_bytes */
    uint32_t renderer_bytes;        /* of it, for the columns of a water renderer */
    uint32_t kept_bytes;            /* of it, for lines of streamed water */
    uint16_t across, down;          /* number of tiles */
    uint16_t extra_rows;            /* rows of samples that a tile needs beyond its own */
    uint16_t stencil_values;        /* in use */
    uint8_t  lists;                 /* number of shader lists */
    uint8_t  modules;               /* number of modules of the program */
    uint8_t  unmarked;              /* number of modules without enough stencil values */
    uint8_t  outlined;              /* 1 + the module that draws outlines; 0: none */
    uint8_t  visibility, shading, rate;     /* rungs */
    bool     half_lines;            /* quality.lines = half */
    bool     packed_rows;           /* quality.blending = rgb565 */
    bool     coast;                 /* the water's grid is displaced over a floor */
    bool     needs_samples;         /* things in the water, but no model `samples` */
} tp_baked_frame;

/* Functions that a baked file calls: tp_frame_bytes and tp_frame_init of a baked frame.
 *  - TP_E_NULL, TP_E_ALIGN: err->word is the argument; TP_E_NOSPACE: `bytes` are too few */
struct tp_frame_maker {
    size_t (*bytes)(const tp_baked_frame *baked);
    tp_status (*init)(tp_frame **frame, const tp_baked_frame *baked, void *memory,
                      size_t bytes, tp_error *err);
};
extern const struct tp_frame_maker tp_frame_maker;

/* Begins a picture of the world.  The world must not change before the last tile is
 * drawn. */
void tp_frame_begin(tp_frame *frame, const tp_world *world);

/* Draws tile i, counted from left to right and from top to bottom, or strip by strip with
 * kept_bytes.  tile->pixels points into `scratch`: tp_frame_scratch_bytes(), aligned to 8.
 * Returns false if no tile i exists, or if the scratch is NULL or not aligned. */
bool tp_frame_draw_tile(const tp_frame *frame, uint32_t i, void *scratch, tp_tile *tile);

/* Draws tile i directly into a whole picture, such as a frame buffer: row y begins at
 * picture + y stride, aligned to 4 bytes for xrgb8888, to 2 for rgb565.  The scratch then
 * needs no room for pixels: tp_frame_direct_scratch_bytes().  With quality.blending = rgb565
 * pixels of the tile are also read from the picture. */
bool tp_frame_draw_tile_direct(const tp_frame *frame, uint32_t i, void *scratch,
                               void *picture, size_t stride, tp_tile *tile);

tp_draw_stats tp_frame_stats(const tp_frame *frame);

/* -- conversion between world and picture -------------------------------------------- */

/* Projects a world position to the picture begun last: px from the upper left corner,
 * 16.16, saturated, also outside of the picture; and the depth, m along the camera's
 * direction.  Returns false if the position lies behind the camera or before the near
 * plane. */
bool tp_frame_project(const tp_frame *frame, tp_vec3 place, tp_fx *x_px, tp_fx *y_px,
                      tp_fx *depth);

/* Finds the water at a pixel of the picture begun last: the first intersection, from above
 * or from below, of the water and the ray through (x_px, y_px), px from the upper left
 * corner in 16.16.  The middle of pixel n is n + 1/2.  The result is within 1 px of the
 * drawn water, except where crests overhang and where waves fade at the far end of a mesh.
 * Returns false if the ray meets land, the end of a tank, or no water within 8000 m. */
bool tp_frame_pick(const tp_frame *frame, tp_fx x_px, tp_fx y_px, tp_vec3 *at);

/* -- samples of a drawn tile --------------------------------------------------------- */

/* Drawing leaves depth and kind of each pixel in the scratch until the next tile is drawn
 * there, so these rows need no memory of their own.  tile->y0 <= y < tile->y1; a row has
 * x1 - x0 entries. */

/* The kind of object at a pixel.  Spray and bubbles are translucent: what lies behind them
 * counts. */
typedef enum {
    TP_SAMPLE_SKY,    /* no object; in the water: open depth */
    TP_SAMPLE_WATER,  /* the surface, from either side */
    TP_SAMPLE_OBJECT, /* a mesh */
    TP_SAMPLE_LAND,   /* the sea floor, dry or not */
    TP_SAMPLE_DROP,   /* a falling drop, or the sphere that drops fall from */
    TP_SAMPLE_WALL,   /* a wall of a tank or in a pool */
    TP_SAMPLE_GLASS,  /* a tank's glass wall, and the water behind it */
    TP_SAMPLE_OTHER   /* object of a module that a program brings itself */
} tp_sample_kind;

/* Writes the depth of each pixel, m along the camera's direction, and its tp_sample_kind;
 * `depth` or `kind` may be NULL.  The depth's error is at most depth^2 / (near 2^24) plus
 * half a unit of 16.16.  In the sky the depth is TP_FX_MAX.  Pixels behind the lid of a
 * boat have the depth of the lid.  Fast rows (quality.rows = fast or pairs) and walked water
 * keep the depth of level water instead of the drawn water's, unless tp_config.depth asks
 * for it. */
void tp_frame_sample_row(const tp_frame *frame, const void *scratch, const tp_tile *tile,
                         uint32_t y, tp_fx *depth, uint8_t *kind);

TP_END_C
#endif
