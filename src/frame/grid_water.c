/* SPDX-License-Identifier: MIT */
/* The water's grid: its placement, and its triangles; see grid_cells.c. */
#include "frame/frame.h"
#include "frame/renderers.h"
#include "frame/tools.h"
#include "view/fan.h"
#include "view/wave_models.h"

/* -- placement ----------------------------------------------------------------------- */

/* Replaces the unbounded boxes of blocks with clipped vertices by tight boxes.  One more
 * clip of these cells pays if the picture has many tiles: each tile would clip them. */
static void tighten_clipped_boxes(tp_frame *frame, uint32_t j)
{
    const struct tp_draw_cells *by = frame->program->draw.cells;
    const tp_grid *grid = frame->buffers.grid;
    tp_grid_span span = grid->span[j];

    for (uint32_t b = span.first / TP_GRID_BLOCK; by && b * TP_GRID_BLOCK < span.end; b++) {
        tp_grid_span cells = tp_grid_block_span(span, b);
        tp_grid_box *box = &grid->box[(size_t)j * grid->blocks + b];
        if (box->x0 == INT16_MIN)
            *box = by->box(frame, j, cells.first, cells.end);
    }
}

/* Chooses the code of the vertices.  Fast normals and sines draw vertices in 32 bits, as
 * quality.waves = fast does.  Counts exact vertices that the program lacks; the corners of
 * clipped cells only if there may be such cells. */
static void choose_vertices(tp_frame *frame, tp_grid *grid)
{
    const tp_scene_quality *rungs = &frame->scene->quality;
    const tp_draws *draw = &frame->program->draw;

    grid->plain_normals = rungs->normals == TP_RUNG_FAST;
    grid->waves = rungs->waves == TP_RUNG_FAST ? draw->fast_waves : NULL;
    if (rungs->sine == TP_RUNG_FAST && draw->table_waves)
        grid->waves = &draw->table_waves->by;
    else if (grid->plain_normals && draw->packed_waves)
        grid->waves = &draw->packed_waves->by;
    if (!grid->waves && draw->level_waves && !tp_surface_has_swells(&frame->surface))
        grid->waves = &draw->level_waves->by;
    grid->exact_waves = draw->exact_waves;
    grid->exact_corners = draw->exact_corners;
    frame->stats.dropped += !grid->waves && !draw->exact_waves;
    frame->stats.dropped += !grid->waves && draw->cells && !draw->exact_corners;
}

/* Chooses the weights of the swells; the slope variance is made anew if they change.  Water
 * over a floor keeps all swells, so none of them is variance. */
static void choose_weights(const tp_frame *frame, tp_grid *grid)
{
    const int32_t rung = frame->scene->quality.geometry;
    const bool coastal = frame->surface.coastal && grid->dry;
    const struct tp_draw_large_waves *large =
        rung >= TP_RUNG_FAST && !coastal ? frame->program->draw.large_waves : NULL;
    const uint8_t half_px = rung > TP_RUNG_FAST ? 2 : 1;

    if ((large != grid->large || half_px != grid->half_px) && frame->buffers.filtered)
        tp_filtered_waves_clear(frame->buffers.filtered);
    grid->large = large;
    grid->half_px = half_px;
}

/* Without rough water no stage reads the variance. */
static void fill_variance(tp_frame *frame, const tp_grid *grid)
{
    const struct tp_draw_row_variance *variance = frame->program->draw.row_variance;
    const bool rough =
        frame->scene->water.rough && tp_surface_has_swells(&frame->surface);

    if (rough && variance)
        variance->fill(grid, frame->buffers.filtered);
    else if (frame->buffers.filtered->has_row)
        tp_filtered_waves_clear(frame->buffers.filtered);
    frame->stats.dropped += rough && !variance;
}

static void place_rows(tp_frame *frame, tp_grid *grid)
{
    const struct tp_draw_grid_rows *by = frame->program->draw.grid_rows;

    if (!grid->fan->placed) {
        tp_frame_use_baked_rows(frame);
        return;
    }
    by->place(grid, &frame->grid_view);
    if (frame->buffers.filtered)
        fill_variance(frame, grid);
}

void tp_frame_begin_grid(tp_frame *frame)
{
    const struct tp_draw_fast_triangles *fast = frame->program->draw.fast_triangles;
    const struct tp_draw_exact_triangles *exact = frame->program->draw.exact_triangles;
    tp_grid *grid = frame->buffers.grid;

    frame->draw_cell = fast && frame->scene->quality.triangles == TP_RUNG_FAST
                           ? fast->draw_cell : NULL;
    frame->draw_triangle = exact ? exact->draw : NULL;
    choose_vertices(frame, grid);
    choose_weights(frame, grid);
    tp_grid_begin(grid, &frame->grid_view);
    place_rows(frame, grid);
    frame->cull_water = frame->projection.eye.y > tp_surface_height_bound(&frame->surface);
    for (uint32_t j = 0; j + 1 < grid->rows; j++)
        frame->stats.triangles += 2u * (uint32_t)(grid->span[j].end - grid->span[j].first);
}

void tp_frame_place_grid_line(tp_frame *frame, uint32_t j)
{
    const uint32_t before = frame->buffers.grid->vertices;

    tp_grid_evaluate_row(frame->buffers.grid, j);
    frame->stats.vertices += frame->buffers.grid->vertices - before;
    if (j > 0 && (tp_frame_tiles(frame) > 1 || frame->visibility == TP_VISIBILITY_ROWS))
        tighten_clipped_boxes(frame, j - 1);
}

static void place_water(tp_frame *frame)
{
    if (!frame->program->draw.cells)
        tp_frame_count_lack(frame, TP_LACKING_CELLS);
    tp_frame_begin_grid(frame);
    for (uint32_t j = 0; j < frame->buffers.grid->rows; j++)
        tp_frame_place_grid_line(frame, j);
}

/* -- drawing ------------------------------------------------------------------------- */

tp_grid_window tp_frame_grid_window(const tp_frame *frame, const tp_gbuffer *tile,
                                    void *memory)
{
    const tp_grid *grid = frame->buffers.grid;
    tp_grid_window window =
        tp_grid_window_init(grid, (uint8_t *)memory + frame->buffers.renderer_bytes);

    window.keep = frame->program->draw.kept_lines;
    window.kept = grid->streams && window.keep
                      ? tp_frame_kept_lines(frame, tile,
                                            tp_grid_kept_row_bytes(grid->cols))
                      : NULL;
    return window;
}

/* A grid with the most rows has few columns: its rows together have no more vertices than
 * the scene's budget. */
static size_t most_kept_bytes(const tp_scene *scene, const tp_config *config)
{
    const uint32_t vertices = tp_fan_budget(scene);

    (void)config;
    return tp_kept_lines_bytes(tp_fan_most_rows(vertices), tp_grid_kept_row_bytes(0))
           + vertices * sizeof(tp_grid_vertex);
}

static void draw_water(const tp_frame *frame, tp_gbuffer *tile, void *memory)
{
    const struct tp_draw_cells *by = frame->program->draw.cells;
    tp_grid_window window = tp_frame_grid_window(frame, tile, memory);

    tile->front_only = frame->cull_water;
    for (uint32_t j = 0; by && j + 1 < frame->buffers.grid->rows; j++)
        by->draw_row(frame, tile, &window, j);
}

/* Returns the grid; `counted` stands in if the arena only counts bytes. */
static tp_grid *layout_grid(tp_frame_buffers *buffers, tp_arena *arena, tp_grid *counted)
{
    buffers->grid = tp_arena_alloc(arena, 1, sizeof *buffers->grid);
    tp_grid *grid = buffers->grid ? buffers->grid : counted;
    memset(grid, 0, sizeof *grid);
    return grid;
}

/* Returns the number of swells that the world has room for. */
static uint32_t most_swells(const tp_program *program, const tp_scene *scene)
{
    const struct tp_water_swells *swells = program->water.swells;
    uint32_t count = 0;

    for (int i = 0; i < TP_WAVES; i++)
        count += scene->wave[i].amplitude > 0;
    return !swells ? 0 : swells->few ? count : TP_WAVES;
}

static void layout_water(tp_frame_buffers *buffers, tp_arena *arena,
                         const tp_program *program, const tp_scene *scene,
                         const tp_config *config)
{
    tp_grid  counted;
    tp_grid *grid = layout_grid(buffers, arena, &counted);

    tp_grid_layout_vertices(grid, arena, tp_fan_budget(scene),
                            tp_frame_is_grid_streamed(program));
    if (!tp_frame_rows_are_baked(config->assets, tp_fan_budget(scene))) {
        tp_grid_layout_rows(grid, arena, tp_fan_budget(scene),
                            most_swells(program, scene));
        buffers->filtered = tp_arena_alloc(arena, 1, sizeof *buffers->filtered);
        if (buffers->filtered)
            tp_filtered_waves_clear(buffers->filtered);
    }
    if (buffers->coast)
        program->water.coastal->layout(grid, arena, tp_fan_budget(scene));
}

const struct tp_draw_fast_triangles tp_draw_fast_triangles = { tp_cell_water_fast };

const struct tp_water_renderer tp_method_streamed = {
    .layout = layout_water, .place = place_water, .draw = draw_water,
    .most_kept_bytes = most_kept_bytes,
};

const struct tp_water_renderer tp_method_triangles = {
    .layout = layout_water, .place = place_water, .draw = draw_water,
};
