/* SPDX-License-Identifier: MIT */
/* Rows of the water's grid as a table.  Entries: rows, columns, the rows' direction; each
 * row's numbers; each row's visible cells, first and end; the slope variance by depth. */
#include "frame/frame.h"
#include "waves/deep_water.h"

enum { ROW = sizeof(tp_fan_row) / sizeof(int32_t), HEAD = 5, BUDGET = 16 /* a number */ };

_Static_assert(sizeof(tp_fan_row) == 24 && sizeof(tp_slope_variance) == 12,
               "rows and variances are words without gaps");

/* Returns a sum of the numbers of all swells that rows depend on. */
static int32_t sum_swells(const tp_deep_water *deep)
{
    uint32_t sum = deep->count;

    for (uint32_t i = 0; i < deep->count; i++) {
        const tp_swell *w = &deep->swell[i];
        const uint32_t of[] = { (uint32_t)w->turns_x, (uint32_t)w->turns_z,
                                (uint32_t)w->amplitude, (uint32_t)w->orbit_x,
                                (uint32_t)w->orbit_z, (uint32_t)w->slope_x,
                                (uint32_t)w->slope_z };
        for (uint32_t k = 0; k < sizeof of / sizeof *of; k++)
            sum = (sum ^ of[k]) * 16777619u;
    }
    return (int32_t)sum;
}

/* Collects all numbers that rows and variance depend on, for water without rings, pools and
 * a floor. */
static void collect_numbers(const tp_frame *frame, int32_t to[TP_ROWS_NUMBERS])
{
    const tp_projection *p = &frame->projection;
    const tp_rotation *turn = &p->turn;
    const int32_t numbers[TP_ROWS_NUMBERS] = {
        p->eye.x, p->eye.y, p->eye.z, p->near, p->focal,
        turn->x.x, turn->x.y, turn->x.z, turn->y.x, turn->y.y, turn->y.z,
        turn->z.x, turn->z.y, turn->z.z,
        (int32_t)frame->config.width, (int32_t)frame->config.height,
        (int32_t)frame->grid_view.vertices, frame->scene->quality.geometry,
        sum_swells(frame->surface.deep), frame->scene->water.rough != 0,
        frame->grid_view.detail.length || frame->surface.coastal,
    };

    memcpy(to, numbers, sizeof numbers);
}

bool tp_frame_rows_are_baked(const tp_assets *assets, uint32_t vertices)
{
    const tp_table *baked = tp_assets_table(assets, TP_TABLE_rows);
    return baked && baked->made_of[BUDGET] == (int32_t)vertices;
}

void tp_frame_use_baked_rows(tp_frame *frame)
{
    tp_grid *grid = frame->buffers.grid;
    int32_t numbers[TP_ROWS_NUMBERS];

    collect_numbers(frame, numbers);
    const uint32_t dropped = frame->stats.dropped;
    const int32_t *at = tp_frame_table(frame, TP_TABLE_rows, NULL, numbers, NULL, NULL);
    TP_ASSERT(at[0] > 1 && at[1] > 1 && (uint32_t)at[1] <= grid->most_cols);
    if (frame->stats.dropped > dropped && !frame->lacking)
        frame->lacking = TP_LACKING_ROWS;
    grid->rows = (uint32_t)at[0];
    grid->cols = (uint32_t)at[1];
    grid->blocks = (grid->cols - 2) / TP_GRID_BLOCK + 1;
    grid->fan->law.right = (tp_dir3){ at[2], at[3], at[4] };
    grid->fan->end_column = UINT32_MAX;
    grid->fan->row = (const tp_fan_row *)(const void *)(at + HEAD);
    at += HEAD + ROW * grid->rows;
    grid->span = (const tp_grid_span *)(const void *)at;
}

const tp_filtered_waves *tp_frame_filtered_waves(const tp_frame *frame)
{
    const tp_table *baked = tp_assets_table(&frame->assets, TP_TABLE_rows);

    if (frame->buffers.filtered || !baked)
        return frame->buffers.filtered;
    const int32_t *at = baked->entries;
    return (const tp_filtered_waves *)(const void *)(at + HEAD + (ROW + 1) * at[0]);
}

void tp_frame_pack_rows(const tp_frame *frame, int32_t numbers[TP_ROWS_NUMBERS],
                        int32_t *entries, uint32_t *count)
{
    const tp_grid *grid = frame->buffers.grid;

    collect_numbers(frame, numbers);
    *count = 0;
    if (frame->visibility > TP_VISIBILITY_ROWS || !grid || numbers[TP_ROWS_NUMBERS - 1])
        return;
    const tp_dir3 right = grid->fan->law.right;
    const int32_t head[HEAD] = { (int32_t)grid->rows, (int32_t)grid->cols, right.x, right.y,
                                 right.z };
    memcpy(entries, head, sizeof head);
    entries += HEAD;
    memcpy(entries, grid->fan->row, grid->rows * sizeof *grid->fan->row);
    entries += ROW * grid->rows;
    const uint32_t cells = grid->rows - 1;      /* rows of cells: the last span is not set */
    memcpy(entries, grid->span, cells * sizeof *grid->span);
    entries[cells] = 0;
    entries += grid->rows;
    memset(entries, 0, sizeof frame->buffers.filtered->at);     /* water that is not rough */
    if (frame->buffers.filtered->has_row)
        memcpy(entries, frame->buffers.filtered->at, sizeof frame->buffers.filtered->at);
    *count = TP_FRAME_ROWS_WORDS(grid->rows);
}
