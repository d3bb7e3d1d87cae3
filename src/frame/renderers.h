/* SPDX-License-Identifier: MIT */
/*
 * Water renderers, and the other parts of drawing that a program's list names: the structs
 * behind TP_METHOD_LIST and TP_DRAW_LIST.  A program's pointer to a part is NULL if the program
 * lacks it.
 */
#ifndef TP_FRAME_RENDERERS_H
#define TP_FRAME_RENDERERS_H
#include "frame/frame.h"

/* A water renderer, see visibility.c.  `memory` is scratch, free until pixels are
 * stored: tp_renderer_tile_bytes(), then a window if grid vertices are streamed. */
struct tp_water_renderer {
    void (*layout)(tp_frame_buffers *parts, tp_arena *arena, const tp_program *program,
                   const tp_scene *scene, const tp_config *config);
    bool (*holds)(tp_frame *frame);     /* true if it can draw this frame; NULL: always */
    void (*place)(tp_frame *frame);
    void (*draw)(const tp_frame *frame, tp_gbuffer *tile, void *memory);
    /* For streamed lines: the bytes that keep all of a strip.  NULL: lines are stored, or
     * there are none. */
    size_t (*most_kept_bytes)(const tp_scene *scene, const tp_config *config);
    /* Draws into a tile without solids, which need not be cleared, and sets all keys.
     * Returns false if it cannot.  NULL: it never can. */
    bool (*draw_alone)(const tp_frame *frame, const tp_gbuffer *tile, void *memory,
                       tp_water_rows *found);
    /* tp_frame_shade_level_run, for renderers whose stages may read the depth of level
     * water. */
    void (*level_keys)(const tp_frame *frame, const tp_shaders *list, tp_run *run);
};

/* True if the scene asks for fast rows and the program has them. */
static inline bool tp_frame_asks_fast_rows(const tp_program *program, const tp_scene *scene)
{
    return scene->quality.rows >= TP_RUNG_FAST && program->method.rows
           && program->method.lines;
}

/* True if the scene asks for walked water and the program has it. */
static inline bool tp_frame_asks_walk(const tp_program *program, const tp_scene *scene)
{
    return program->method.walk && scene->quality.visibility == TP_VISIBILITY_WALK;
}

/* Returns the width of the columns of walked water, and of pairs of columns, log2 of 28.4
 * px.  Pairs need a picture of even width. */
static inline uint8_t tp_frame_pair_bits(const tp_config *config)
{
    return config->width % 2 == 0 ? 5 : 4;
}

/* Scratch bytes of a tile's columns; 0 if no renderer of the program works by columns. */
static inline size_t tp_renderer_tile_bytes(const tp_program *program, const tp_scene *scene,
                                            const tp_config *config)
{
    if (tp_frame_asks_fast_rows(program, scene))
        return tp_fast_rows_bytes(config->tile_width, 4);
    if (tp_frame_asks_walk(program, scene))
        return tp_fast_rows_bytes(config->tile_width, tp_frame_pair_bits(config));
    return program->method.rows || program->method.projected
               ? sizeof(tp_row_column) * config->tile_width : 0;
}

/* Edges of rows, scanline_water.c: segments of line k whose row of cells ends in the
 * picture, and a middle line of row k, for wide cells.  A frame that needs a missing one
 * counts as dropped. */
struct tp_row_walk;
struct tp_draw_row_sides {
    void (*lay)(struct tp_row_walk *walk, uint32_t k, tp_grid_span segments);
};
struct tp_draw_row_middles {
    void (*lay)(struct tp_row_walk *walk, uint32_t k);
};

/* Land in rows over a floor: is_land is true if segment m of line k has land on both sides;
 * mark_gap leaves the columns between two places out. */
struct tp_draw_row_land {
    bool (*is_land)(const tp_frame *frame, uint32_t k, uint32_t m);
    void (*mark_gap)(tp_rows *rows, int32_t left, int32_t right);
};

/* The grid's cells as triangles; grid_cells.c: draws row j, or returns the box of its cells
 * [first, end) after the frustum clip, which needs the line placed last and the line before
 * it, or stored lines.  Without this part no triangles are drawn: a frame that
 * needs some counts as dropped. */
struct tp_draw_cells {
    void (*draw_row)(const tp_frame *frame, const tp_gbuffer *tile, tp_grid_window *window,
                     uint32_t j);
    tp_grid_box (*box)(tp_frame *frame, uint32_t j, uint32_t first, uint32_t end);
};

/* Parts of flat water, flat.c: its waves, and rows of pictures that roll. */
struct tp_flat_piece;
struct tp_draw_flat_waves {
    void (*layout)(tp_frame_buffers *buffers, tp_arena *arena, const tp_scene *scene,
                   const tp_config *config);
    void (*place)(tp_frame *frame);
    void (*fill)(const tp_frame *frame, const struct tp_flat_piece *piece, bool tested);
};
struct tp_draw_flat_roll {
    void (*draw_row)(const tp_frame *frame, const struct tp_flat_piece *row);
};

/* Tone mapping and store in one, of a format; without it the stage `expose` maps. */
struct tp_draw_tone_rgb565 {
    tp_tone_mapped_store *store;
};
struct tp_draw_tone_rgb565be {
    tp_tone_mapped_store *store;
};

/* The water's triangles by exact arithmetic, which large and clipped cells need at any rung.
 * A tile counts each cell half that lacks it. */
struct tp_draw_exact_triangles {
    tp_triangle_drawer *draw;
};

/* Solid triangles whose s and t need perspective.  Without it they are affine, and counted. */
struct tp_draw_wide_solids {
    tp_solid_drawer *draw;
};

/* Lets solids of the tile have perspective, and counts triangles that the program cannot
 * draw. */
static inline void tp_frame_allow_wide_solids(const tp_frame *frame, tp_gbuffer *tile,
                                              uint32_t *dropped)
{
    const struct tp_draw_wide_solids *wide = frame->program->draw.wide_solids;

    tile->draw_wide = wide ? wide->draw : NULL;
    tile->dropped = dropped;
}

/* The water's triangles by cheaper arithmetic, for quality.triangles = fast. */
struct tp_draw_fast_triangles {
    tp_cell_drawer *draw_cell;
};

/* Rows of a tile's samples, y1 not included. */
typedef struct {
    int32_t y0, y1;
} tp_line_bounds;

/* Water at half the rows, for quality.lines = half; half_lines.c.  A tile may need rows
 * beside its own: `bounds` returns the rows of one, `extra_rows` the most of all. */
struct tp_draw_half_lines {
    uint32_t (*extra_rows)(uint32_t tile_height, uint32_t height);
    tp_line_bounds (*bounds)(int32_t y0, int32_t y1, int32_t height);
    void (*draw)(const tp_frame *frame, const tp_gbuffer *samples,
                 const tp_water_rows *found, const tp_tile *tile, uint8_t *row);
};

/* True if the water of this frame is shaded at half the rows. */
static inline bool tp_frame_has_half_lines(const tp_frame *frame)
{
    return frame->half_lines && frame->scene->quality.lines == TP_RUNG_FAST;
}

/* Returns the rows of a tile's samples. */
static inline tp_line_bounds tp_frame_line_bounds(const tp_frame *frame,
                                                  const tp_tile *tile)
{
    const int32_t y0 = (int32_t)tile->y0, y1 = (int32_t)tile->y1;
    return tp_frame_has_half_lines(frame)
               ? frame->half_lines->bounds(y0, y1, (int32_t)frame->config.height)
               : (tp_line_bounds){ y0, y1 };
}

/* Means of rgb565 pixels, for quality.blending = rgb565; packed_rows.c. */
struct tp_draw_packed_rows {
    void (*draw)(const tp_frame *frame, const tp_gbuffer *samples,
                 const tp_water_rows *found, const tp_tile *tile, uint8_t *row);
};

/* True if this frame's rows are packed; neither overlays nor outlines are drawn over packed
 * pixels. */
static inline bool tp_frame_has_packed_rows(const tp_frame *frame)
{
    return frame->packed_rows && frame->scene->quality.blending == TP_RUNG_FAST
           && !frame->config.overlay.draw && !frame->outlined;
}

/* Waves too faint to be seen are not drawn; culled_water.c. */
struct tp_draw_culling {
    void (*layout)(tp_frame_buffers *parts, tp_arena *arena, const tp_plan_input *in);
    void (*cull_waves)(tp_frame *frame);
};

#endif
