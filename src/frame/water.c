/* SPDX-License-Identifier: MIT */
/* The water's cells as triangles. */
#include "frame/frame.h"
#include "geom/waters.h"

static tp_corner corner_of(const tp_grid *grid, uint32_t i, uint32_t j)
{
    const tp_grid_vertex *vertex = &grid->vertex[(size_t)j * grid->cols + i];
    return (tp_corner){
        .u = vertex->u, .v = vertex->v, .zi = vertex->zi,
        .s = grid->column[i].place, .t = grid->row[j].place,
        .n = { vertex->slope_x, vertex->slope_z, 0 },
    };
}

/* Corners in the order (i, j), (i+1, j), (i+1, j+1), (i, j+1); seen from above these two
 * are front faces. */
static const uint8_t halves[2][3] = { { 0, 3, 2 }, { 0, 2, 1 } };

static bool is_cut(const tp_corner *const p[4])
{
    return p[0]->u == TP_GRID_CUT || p[1]->u == TP_GRID_CUT
        || p[2]->u == TP_GRID_CUT || p[3]->u == TP_GRID_CUT;
}

static void view_cell(const tp_frame *frame, uint32_t i, uint32_t j, tp_view_corner c[4])
{
    for (uint32_t k = 0; k < 4; k++)
        c[k] = tp_grid_corner(&frame->parts.grid, &frame->grid_view,
                              i + (k == 1 || k == 2), j + k / 2);
}

/* What the lens leaves of a half of a cell: returns how many corners. */
static int cut_half(const tp_frame *frame, const tp_view_corner c[4], int half,
                    tp_corner to[TP_CLIP_CORNERS])
{
    const uint8_t *k = halves[half];
    const tp_view_corner in[3] = { c[k[0]], c[k[1]], c[k[2]] };

    return tp_clipped_corners(&frame->lens, NULL, in, to);
}

static void draw_cell(const tp_frame *frame, const tp_samples *tile,
                      const tp_corner *const p[4], uint32_t i, uint32_t j)
{
    if (!is_cut(p)) {
        tp_tri_water(tile, p[0], p[3], p[2]);
        tp_tri_water(tile, p[0], p[2], p[1]);
        return;
    }
    tp_view_corner c[4];
    tp_corner corner[TP_CLIP_CORNERS];
    view_cell(frame, i, j, c);
    for (int half = 0; half < 2; half++) {
        int count = cut_half(frame, c, half, corner);
        for (int k = 2; k < count; k++)
            tp_tri_water(tile, &corner[0], &corner[k - 1], &corner[k]);
    }
}

/* Each cell's right side is the next one's left. */
void tp_frame_draw_cells(const tp_frame *frame, const tp_samples *tile, uint32_t j,
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

/* -- placing ------------------------------------------------------------------------- */

static void widen_by_cut(const tp_frame *frame, tp_grid_box *box, uint32_t i, uint32_t j)
{
    tp_view_corner c[4];
    tp_corner corner[TP_CLIP_CORNERS];

    view_cell(frame, i, j, c);
    for (int half = 0; half < 2; half++)
        for (int k = cut_half(frame, c, half, corner) - 1; k >= 0; k--)
            tp_box_widen(box, corner[k].u, corner[k].v);
}

tp_grid_box tp_frame_cells_box(const tp_frame *frame, uint32_t j, uint32_t first,
                               uint32_t end)
{
    tp_grid_box box = TP_BOX_NONE;

    for (uint32_t i = first; i < end; i++) {
        const tp_corner c[4] = { corner_of(&frame->parts.grid, i, j),
                                 corner_of(&frame->parts.grid, i + 1, j),
                                 corner_of(&frame->parts.grid, i + 1, j + 1),
                                 corner_of(&frame->parts.grid, i, j + 1) };
        const tp_corner *const p[4] = { &c[0], &c[1], &c[2], &c[3] };
        if (is_cut(p))
            widen_by_cut(frame, &box, i, j);
        else
            for (int k = 0; k < 4; k++)
                tp_box_widen(&box, c[k].u, c[k].v);
    }
    return box;
}

/* Blocks with cut crossings may lie anywhere, says the grid.  Where there are many tiles
 * it pays to clip their cells once more than each tile does, and know. */
static void place_cut_boxes(tp_frame *frame)
{
    const tp_grid *grid = &frame->parts.grid;

    for (uint32_t j = 0; j + 1 < grid->rows; j++) {
        tp_grid_span span = grid->span[j];
        for (uint32_t b = span.first / TP_GRID_BLOCK; b * TP_GRID_BLOCK < span.end; b++) {
            uint32_t first = b * TP_GRID_BLOCK, end = first + TP_GRID_BLOCK;
            first = first > span.first ? first : span.first;
            end = end < span.end ? end : span.end;
            tp_grid_box *box = &grid->box[(size_t)j * grid->blocks + b];
            if (box->x0 == INT16_MIN)
                *box = tp_frame_cells_box(frame, j, first, end);
        }
    }
}

void tp_frame_place_water(tp_frame *frame)
{
    tp_grid_place(&frame->parts.grid, &frame->grid_view);
    frame->cull_water = frame->lens.eye.y > tp_surface_height(&frame->surface);
    frame->stats.vertices += frame->parts.grid.vertices;
    for (uint32_t j = 0; j + 1 < frame->parts.grid.rows; j++)
        frame->stats.triangles += 2u * (uint32_t)(frame->parts.grid.span[j].end
                                                  - frame->parts.grid.span[j].first);
    if (tp_frame_tiles(frame) > 1 || frame->visibility == TP_VISIBILITY_ROWS)
        place_cut_boxes(frame);
}

/* -- drawing ------------------------------------------------------------------------- */

static void draw_water(const tp_frame *frame, tp_samples *tile, void *memory)
{
    const tp_grid *grid = &frame->parts.grid;

    (void)memory;
    tile->front_only = frame->cull_water;
    for (uint32_t j = 0; j + 1 < grid->rows; j++) {
        tp_grid_span span = grid->span[j];
        const tp_grid_box *box = grid->box + (size_t)j * grid->blocks;
        for (uint32_t b = span.first / TP_GRID_BLOCK; b * TP_GRID_BLOCK < span.end; b++) {
            uint32_t first = b * TP_GRID_BLOCK, end = first + TP_GRID_BLOCK;
            first = first > span.first ? first : span.first;
            end = end < span.end ? end : span.end;
            if (first < end && tp_sight_touches(&box[b], tile))
                tp_frame_draw_cells(frame, tile, j, first, end);
        }
    }
}

static void carve_water(tp_frame_parts *parts, tp_arena *arena, const tp_kit *kit,
                        const tp_scene *scene, const tp_frame_config *config)
{
    const struct tp_water_ocean *ocean = kit->water.ocean;

    (void)config;
    tp_grid_carve(&parts->grid, arena, (uint32_t)scene->grid.cols,
                  (uint32_t)scene->grid.rows);
    if (tp_frame_wants(parts, tp_has_ocean(scene), ocean))
        ocean->carve(&parts->grid, arena);
}

const struct tp_method tp_method_triangles = {
    .carve = carve_water, .place = tp_frame_place_water, .draw = draw_water,
};
