/* SPDX-License-Identifier: MIT */
/* Walked water for little memory.  The frame keeps a byte a point, its row; by the rows a
 * tile finds the lines that it needs, and evaluates their points again.  The picture is
 * that of stored points, to the bit. */
#include "frame/walk_water.h"
#include "frame/renderers.h"

static void layout_streamed(tp_frame_buffers *buffers, tp_arena *arena,
                            const tp_program *program, const tp_scene *scene,
                            const tp_config *config)
{
    void *rows;
    struct tp_walk *to = tp_walk_allocate(arena, config, sizeof *to->row, &rows);

    (void)program;
    (void)scene;
    if (to) {
        to->row = rows;
        while (config->height >> to->row_bits > 256)
            to->row_bits++;
    }
    buffers->walk = to;
}

/* Lays a line, px below the horizon.  `before`: the line laid before it, or NULL; a line
 * that was not laid was not visible. */
static void lay_streamed_line(const tp_frame *frame, tp_fast_rows *rows, int32_t below,
                              const tp_line_scale *before, tp_walk_line *line)
{
    tp_walk_placed_line at;
    tp_even_point pair[2];

    tp_walk_begin_line(&frame->buffers.walk->level, below, &at, line);
    const tp_line_scale scale[2] = { line->scale, before ? *before : line->scale };
    const tp_even_line even = { NULL, line->s, line->t, line->step_s, line->step_t,
                                line->scale.zi };
    int32_t x = rows->tile->x0 / TP_WALK_CELL * TP_WALK_CELL;

    tp_fast_rows_begin_line(rows, scale);
    pair[1] = tp_walk_make_point(frame, &at, x);
    for (; x < rows->tile->x1; x += TP_WALK_CELL) {
        pair[0] = pair[1];
        pair[1] = tp_walk_make_point(frame, &at, x + TP_WALK_CELL);
        tp_fast_rows_lay_even_segment(rows, &even, x / TP_WALK_CELL, pair);
    }
}

/* True if line k, if there is one, rises into the tile. */
static bool rises(const struct tp_walk *walk, uint32_t k, const tp_gbuffer *tile)
{
    const uint8_t *row = walk->row + (size_t)k * walk->cols;
    const int32_t  end = (tile->x1 + TP_WALK_CELL - 1) / TP_WALK_CELL;

    for (int32_t i = tile->x0 / TP_WALK_CELL; k < walk->lines && i <= end; i++)
        if (row[i] << walk->row_bits < tile->y1)
            return true;
    return false;
}

/* Draws the lines that matter for the tile: those that rise into it, and before each the
 * line in front. */
static void draw_streamed_lines(const tp_frame *frame, tp_fast_rows *rows)
{
    const struct tp_walk *walk = frame->buffers.walk;
    const uint32_t lines = walk->top << walk->row_bits < rows->tile->y1 ? walk->lines : 0;
    int32_t below = walk->first;
    tp_walk_line  line;
    tp_line_scale before;
    bool laid = false, next_rises = lines > 0 && rises(walk, 0, rows->tile);

    for (uint32_t k = 0; k < lines && rows->open > 0; k++, below = tp_walk_next_line(below)) {
        const bool this_rises = next_rises;
        next_rises = rises(walk, k + 1, rows->tile);
        if (!this_rises && !next_rises)
            continue;
        lay_streamed_line(frame, rows, below, laid ? &before : NULL, &line);
        tp_fast_rows_end_line(rows, k > 0 ? TP_LINE_ON : TP_LINE_BEHIND_GAP);
        before = line.scale;
        laid = true;
    }
}

static void draw_streamed(const tp_frame *frame, tp_gbuffer *tile, void *memory)
{
    tp_fast_rows rows;

    tp_fast_rows_begin(&rows, tile, memory, frame->column_bits, true);
    rows.solid = tp_frame_has_solids(frame);
    draw_streamed_lines(frame, &rows);
}

static bool draw_streamed_alone(const tp_frame *frame, const tp_gbuffer *tile, void *memory,
                                tp_water_rows *found)
{
    tp_fast_rows rows;

    tp_fast_rows_begin(&rows, tile, memory, frame->column_bits, false);
    draw_streamed_lines(frame, &rows);
    return tp_walk_end_alone(frame, &rows, found);
}

const struct tp_water_renderer tp_method_streamed_walk = {
    .layout = layout_streamed, .holds = tp_walk_can_draw, .place = tp_walk_place,
    .draw = draw_streamed, .draw_alone = draw_streamed_alone,
    .level_keys = tp_frame_shade_level_run,
};
