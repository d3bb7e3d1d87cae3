/* SPDX-License-Identifier: MIT */
/* Tables of a frame; see tables.h. */
#include "frame/tables.h"
#include "frame/frame.h"

static const uint8_t numbers_of[TP_TABLE_COUNT] = {
#define X(name, numbers, type) numbers,
    TP_TABLE_LIST(X)
#undef X
};

tp_own_table *tp_table_layout_own(tp_arena *arena, tp_table_id id, size_t bytes)
{
    TP_ASSERT(id < TP_TABLE_COUNT && bytes > 0);
    const size_t all = (1u + numbers_of[id]) * sizeof(int32_t) + bytes;
    tp_own_table *own = tp_arena_alloc(arena, (all + 3) / 4, sizeof *own);

    if (!own)
        return NULL;
    memset(own, 0, all);
    own[0] = (int32_t)bytes;
    own[1] = INT32_MIN;         /* no table is made of this number first */
    return own;
}

tp_own_table *tp_table_layout(tp_arena *arena, const tp_assets *assets, tp_table_id id,
                              size_t bytes)
{
    return tp_assets_table(assets, id) ? NULL : tp_table_layout_own(arena, id, bytes);
}

/* Makes an own table if it is not made of these numbers. */
static void refresh(tp_frame *frame, tp_table_id id, tp_own_table *own,
                    const int32_t *numbers, const tp_table_maker *maker, const void *from)
{
    const size_t bytes = numbers_of[id] * sizeof *numbers;

    if (memcmp(own + 1, numbers, bytes) == 0)
        return;
    if (!maker) {
        frame->stats.dropped++;
        return;
    }
    memcpy(own + 1, numbers, bytes);
    maker->make(frame, from, own + 1 + numbers_of[id]);
}

const void *tp_frame_table(tp_frame *frame, tp_table_id id, tp_own_table *own,
                           const int32_t *numbers, const tp_table_maker *maker,
                           const void *from)
{
    TP_ASSERT(numbers != NULL && (own || frame->assets.tables));
    frame->own_table[id] = own;
    if (own) {
        refresh(frame, id, own, numbers, maker, from);
        return own + 1 + numbers_of[id];
    }
    const tp_table *baked = &frame->assets.tables->table[id];
    frame->stats.dropped +=
        memcmp(baked->made_of, numbers, numbers_of[id] * sizeof *numbers) != 0;
    return baked->entries;
}

tp_table tp_frame_own_table(const tp_frame *frame, tp_table_id id, size_t *bytes)
{
    TP_ASSERT(frame != NULL && bytes != NULL && id < TP_TABLE_COUNT);
    const tp_own_table *own = frame->own_table[id];

    *bytes = own ? (size_t)own[0] : 0;
    return own ? (tp_table){ own + 1 + numbers_of[id], own + 1 } : (tp_table){ 0 };
}
