/* SPDX-License-Identifier: MIT */
/* Walked water for little memory.  The frame keeps a byte a point, its row; by the rows a
 * tile finds the lines that it needs, and evaluates their points again, unless its strip
 * keeps them.  The picture is that of stored points, to the bit. */
#include "frame/walk_water.h"
#include "frame/renderers.h"

/* A line of walked water that a strip keeps. */
typedef struct {
    tp_walk_line  line;
    tp_even_point point[];      /* of the strip's columns */
} kept_line;

static uint32_t kept_line_bytes(int32_t width)
{
    return (uint32_t)(sizeof(kept_line)
                      + tp_walk_count_points((uint32_t)width) * sizeof(tp_even_point));
}

static size_t most_kept_bytes(const tp_scene *scene, const tp_config *config)
{
    (void)scene;
    return tp_kept_lines_bytes(tp_walk_most_lines(config->height),
                               kept_line_bytes((int32_t)config->tile_width));
}

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

/* A tile that is walked. */
typedef struct {
    const tp_frame *frame;
    tp_fast_rows    rows;
    tp_kept_lines  *kept;       /* of the strip; NULL: none */
    int32_t first;              /* the tile's first cell */
    int32_t end;                /* the cell after its last */
} tile_walk;

static void begin_tile(tile_walk *w, const tp_frame *frame, const tp_gbuffer *tile,
                       void *memory, bool keyed)
{
    w->frame = frame;
    w->first = tile->x0 / TP_WALK_CELL;
    w->end = (tile->x1 + TP_WALK_CELL - 1) / TP_WALK_CELL;
    TP_ASSERT(w->first * TP_WALK_CELL == tile->x0);
    w->kept = tp_frame_kept_lines(frame, tile, kept_line_bytes(tile->x1 - tile->x0));
    tp_fast_rows_begin(&w->rows, tile, memory, frame->column_bits, keyed);
}

/* Begins to lay a line.  `before`: the line laid before it, or NULL; a line that was not laid
 * was not visible. */
static tp_even_line begin_line(tile_walk *w, const tp_walk_line *line,
                               const tp_line_scale *before)
{
    const tp_line_scale scale[2] = { line->scale, before ? *before : line->scale };

    tp_fast_rows_begin_line(&w->rows, scale);
    return (tp_even_line){ NULL, line->s, line->t, line->step_s, line->step_t,
                           line->scale.zi };
}

/* Returns a line that the strip keeps, evaluated if the tiles above did not need it; NULL:
 * the strip has no room for it. */
static const kept_line *find_kept_line(tile_walk *w, uint32_t number, int32_t below)
{
    tp_walk_placed_line at;
    bool known = false;
    kept_line *to =
        w->kept ? w->frame->program->draw.kept_lines->find(w->kept, number, &known) : NULL;

    if (!to || known)
        return to;
    tp_walk_begin_line(&w->frame->buffers.walk->level, below, &at, &to->line);
    for (int32_t i = w->first; i <= w->end; i++)
        to->point[i - w->first] = tp_walk_make_point(w->frame, &at, i * TP_WALK_CELL);
    return to;
}

static void lay_kept_line(tile_walk *w, const kept_line *kept, const tp_line_scale *before)
{
    const tp_even_line even = begin_line(w, &kept->line, before);

    for (int32_t i = w->first; i < w->end; i++)
        tp_fast_rows_lay_even_segment(&w->rows, &even, i, &kept->point[i - w->first]);
}

/* Evaluates a line, px below the horizon, and lays it. */
static void lay_streamed_line(tile_walk *w, int32_t below, const tp_line_scale *before,
                              tp_line_scale *scale)
{
    tp_walk_placed_line at;
    tp_walk_line  line;
    tp_even_point pair[2];

    tp_walk_begin_line(&w->frame->buffers.walk->level, below, &at, &line);
    const tp_even_line even = begin_line(w, &line, before);
    pair[1] = tp_walk_make_point(w->frame, &at, w->first * TP_WALK_CELL);
    for (int32_t i = w->first; i < w->end; i++) {
        pair[0] = pair[1];
        pair[1] = tp_walk_make_point(w->frame, &at, (i + 1) * TP_WALK_CELL);
        tp_fast_rows_lay_even_segment(&w->rows, &even, i, pair);
    }
    *scale = line.scale;
}

/* Lays line k; *before is the scale of the line laid before it, then that of line k. */
static void lay_line(tile_walk *w, uint32_t k, int32_t below, bool laid,
                     tp_line_scale *before)
{
    const tp_line_scale *was = laid ? before : NULL;
    const kept_line *kept = find_kept_line(w, w->frame->buffers.walk->lines - k, below);

    if (kept) {
        lay_kept_line(w, kept, was);
        *before = kept->line.scale;
    } else {
        lay_streamed_line(w, below, was, before);
    }
    tp_fast_rows_end_line(&w->rows, k > 0 ? TP_LINE_ON : TP_LINE_BEHIND_GAP);
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
static void draw_streamed_lines(tile_walk *w)
{
    const struct tp_walk *walk = w->frame->buffers.walk;
    const tp_gbuffer *tile = w->rows.tile;
    const uint32_t lines = walk->top << walk->row_bits < tile->y1 ? walk->lines : 0;
    int32_t below = walk->first;
    tp_line_scale before;
    bool laid = false, next_rises = lines > 0 && rises(walk, 0, tile);

    for (uint32_t k = 0; k < lines && w->rows.open > 0;
         k++, below = tp_walk_next_line(below)) {
        const bool this_rises = next_rises;
        next_rises = rises(walk, k + 1, tile);
        if (!this_rises && !next_rises)
            continue;
        lay_line(w, k, below, laid, &before);
        laid = true;
    }
}

static void draw_streamed(const tp_frame *frame, tp_gbuffer *tile, void *memory)
{
    tile_walk w;

    begin_tile(&w, frame, tile, memory, true);
    w.rows.solid = tp_frame_has_solids(frame);
    draw_streamed_lines(&w);
}

static bool draw_streamed_alone(const tp_frame *frame, const tp_gbuffer *tile, void *memory,
                                tp_water_rows *found)
{
    tile_walk w;

    begin_tile(&w, frame, tile, memory, false);
    draw_streamed_lines(&w);
    return tp_walk_end_alone(frame, &w.rows, found);
}

const struct tp_water_renderer tp_method_streamed_walk = {
    .layout = layout_streamed, .holds = tp_walk_can_draw, .place = tp_walk_place,
    .draw = draw_streamed, .draw_alone = draw_streamed_alone,
    .level_keys = tp_frame_shade_level_run, .most_kept_bytes = most_kept_bytes,
};
