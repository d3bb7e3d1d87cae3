/* SPDX-License-Identifier: MIT */
/* The water's cells as triangles. */
#include "frame/frame.h"

/* A grid of more than 16 km across is drawn with smaller cells: places stay in range. */
static tp_fx cell_of(const tp_scene *scene)
{
    int32_t lines = scene->grid.cols > scene->grid.rows ? scene->grid.cols
                                                        : scene->grid.rows;
    tp_fx most = 16000 * TP_FX_ONE / (lines - 1);
    return scene->grid.cell < most ? scene->grid.cell : most;
}

void tp_frame_place_water(tp_frame *frame)
{
    frame->grid_view = (tp_grid_view){
        .lens = &frame->lens,
        .surface = &frame->surface,
        .width = frame->config.width,
        .height = frame->config.height,
        .cell = cell_of(frame->scene),
        .reach = frame->scene->grid.reach,
        .follow = frame->scene->grid.follow != 0,
    };
    tp_grid_place(&frame->parts.grid, &frame->grid_view);
    frame->cull_water = frame->lens.eye.y > tp_surface_height(&frame->surface);
    frame->stats.vertices += frame->parts.grid.vertices;
    for (uint32_t j = 0; j + 1 < frame->parts.grid.rows; j++)
        frame->stats.triangles += 2u * (uint32_t)(frame->parts.grid.span[j].end
                                                  - frame->parts.grid.span[j].first);
}

static tp_corner corner_of(const tp_grid *grid, uint32_t i, uint32_t j)
{
    const tp_grid_vertex *vertex = &grid->vertex[(size_t)j * grid->cols + i];
    return (tp_corner){
        .u = vertex->u, .v = vertex->v, .zi = vertex->zi,
        .s = grid->column[i].place, .t = grid->row[j].place,
        .n = { vertex->slope_x, vertex->slope_z, 0 },
    };
}

static void draw_clipped(const tp_frame *frame, const tp_samples *tile,
                         const uint32_t place[3][2])
{
    tp_view_corner in[3];
    tp_corner corner[TP_CLIP_CORNERS];

    for (int k = 0; k < 3; k++)
        in[k] = tp_grid_corner(&frame->parts.grid, &frame->grid_view, place[k][0],
                               place[k][1]);
    int count = tp_clipped_corners(&frame->lens, NULL, in, corner);
    for (int k = 2; k < count; k++)
        tp_tri_water(tile, &corner[0], &corner[k - 1], &corner[k]);
}

/* Corners p: near left, near right ... in the order (i, j), (i+1, j), (i+1, j+1),
 * (i, j+1); seen from above the triangles (0, 3, 2) and (0, 2, 1) are front faces. */
static void draw_cell(const tp_frame *frame, const tp_samples *tile,
                      const tp_corner *const p[4], uint32_t i, uint32_t j)
{
    if (p[0]->u == TP_GRID_CUT || p[1]->u == TP_GRID_CUT
        || p[2]->u == TP_GRID_CUT || p[3]->u == TP_GRID_CUT) {
        const uint32_t first[3][2] = { { i, j }, { i, j + 1 }, { i + 1, j + 1 } };
        const uint32_t second[3][2] = { { i, j }, { i + 1, j + 1 }, { i + 1, j } };
        draw_clipped(frame, tile, first);
        draw_clipped(frame, tile, second);
        return;
    }
    tp_tri_water(tile, p[0], p[3], p[2]);
    tp_tri_water(tile, p[0], p[2], p[1]);
}

/* Cells [first, end) of row j.  Each cell's right side is the next one's left. */
static void draw_cells(const tp_frame *frame, const tp_samples *tile, uint32_t j,
                       uint32_t first, uint32_t end)
{
    tp_corner side[2][2] = { { corner_of(&frame->parts.grid, first, j),
                               corner_of(&frame->parts.grid, first, j + 1) } };
    int left = 0;

    for (uint32_t i = first; i < end; i++) {
        bool dry = tp_grid_cell_is_dry(&frame->parts.grid, i, j);
        int right = 1 - left;
        side[right][0] = corner_of(&frame->parts.grid, i + 1, j);
        side[right][1] = corner_of(&frame->parts.grid, i + 1, j + 1);
        const tp_corner *const p[4] = { &side[left][0], &side[right][0],
                                        &side[right][1], &side[left][1] };
        if (!dry)
            draw_cell(frame, tile, p, i, j);
        left = right;
    }
}

void tp_frame_draw_water(const tp_frame *frame, tp_samples *tile)
{
    const tp_grid *grid = &frame->parts.grid;

    tile->front_only = frame->cull_water;
    for (uint32_t j = 0; j + 1 < grid->rows; j++) {
        tp_grid_span span = grid->span[j];
        const tp_grid_box *box = grid->box + (size_t)j * grid->blocks;
        for (uint32_t b = span.first / TP_GRID_BLOCK; b * TP_GRID_BLOCK < span.end; b++) {
            uint32_t first = b * TP_GRID_BLOCK, end = first + TP_GRID_BLOCK;
            first = first > span.first ? first : span.first;
            end = end < span.end ? end : span.end;
            if (first < end && tp_sight_touches(&box[b], tile))
                draw_cells(frame, tile, j, first, end);
        }
    }
}
