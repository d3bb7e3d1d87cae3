/* SPDX-License-Identifier: MIT */
/* Lines of walked water, for its two renderers: walk_water.c stores the points of a frame,
 * streamed_walk.c evaluates them again in each tile. */
#ifndef TP_FRAME_WALK_WATER_H
#define TP_FRAME_WALK_WATER_H
#include "frame/frame.h"
#include "waves/deep_water.h"

enum { TP_WALK_CELL = 16 };        /* px from point to point of a line */

/* Returns the points of a line across so many pixels. */
static inline uint32_t tp_walk_count_points(uint32_t width)
{
    return (width + TP_WALK_CELL - 1) / TP_WALK_CELL + 1;
}

/* A line of points at columns 0, 16, ... of pixels. */
typedef struct {
    tp_line_scale scale;        /* half_s, half_t: half a pixel along the line */
    uint32_t s, t;              /* rest position at column 0, 16.16 m */
    int32_t  step_s, step_t;    /* per pixel, 16.16 m */
    int32_t  top;               /* least v of its points, 16.16 px */
} tp_walk_line;

struct tp_walk {
    tp_level level;
    uint32_t most_lines, lines, cols;
    int32_t  first;             /* the first line, px below the horizon */
    tp_walk_line *line;            /* from near to far; streamed: NULL */
    tp_even_point *point;       /* `cols` a line; streamed: NULL */
    uint8_t *row;               /* streamed: rows of the points, rounded down, `cols` a line */
    int      row_bits;          /* log2 of the pixels of a unit of `row` */
    int32_t  top;               /* the least of `row` */
};

/* A line being placed: rest positions at column 0, on it and on the next line, and their
 * steps per pixel, by axis; m, 16.16. */
typedef struct {
    int64_t row;                /* px, Q.30 */
    int64_t at[2], step[2], beyond[2], beyond_step[2];
} tp_walk_placed_line;

/* Allocates the renderer's data, with `bytes` for each point. */
struct tp_walk *tp_walk_allocate(tp_arena *arena, const tp_config *config, size_t bytes,
                                 void **points);

/* Returns the most lines of a picture of so many rows. */
uint32_t tp_walk_most_lines(uint32_t height);

/* True if the view is one that can be walked. */
bool tp_walk_can_draw(tp_frame *frame);

/* Places the lines of a frame, and stores their points or the points' rows. */
void tp_walk_place(tp_frame *frame);

/* Returns the next line, px below the horizon. */
int32_t tp_walk_next_line(int32_t below);

/* Sets up a line, px below the horizon; 0: the last line, an eighth of a pixel below it. */
void tp_walk_begin_line(const tp_level *level, int32_t below, tp_walk_placed_line *at,
                        tp_walk_line *line);

/* Returns the point of a line at column x of pixels. */
tp_even_point tp_walk_make_point(const tp_frame *frame, const tp_walk_placed_line *line,
                                 int32_t x);

/* Ends a tile without solids: sets its keys.  Returns false if a column has holes. */
bool tp_walk_end_alone(const tp_frame *frame, const tp_fast_rows *rows, tp_water_rows *found);

#endif
