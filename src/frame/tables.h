/* SPDX-License-Identifier: MIT */
/*
 * Tables of a frame, TP_TABLE_LIST: baked with the assets, or made in the frame's block.
 * A module lays its table out, and asks for the entries by the numbers that the table is
 * made of.
 */
#ifndef TP_FRAME_TABLES_H
#define TP_FRAME_TABLES_H
#include "base/base.h"
#include "tidepool/assets.h"

struct tp_frame;

#define TP_TABLE_NUMBERS 32     /* numbers of a table, at most */
#define X(name, numbers, type) \
    _Static_assert(numbers <= TP_TABLE_NUMBERS, "numbers of a table");
TP_TABLE_LIST(X)
#undef X

/* Parts of a program that make a table's entries; a program whose tables are baked needs
 * none.  `from`: the module's own data, or NULL. */
typedef struct {
    void (*make)(const struct tp_frame *frame, const void *from, void *entries);
} tp_table_maker;

struct tp_draw_shine { tp_table_maker maker; };
struct tp_draw_tones { tp_table_maker maker; };
struct tp_draw_dome { tp_table_maker maker; };
struct tp_draw_light { tp_table_maker maker; };
struct tp_draw_ripple_sums { tp_table_maker maker; };

/* The maker of a part, or NULL. */
#define TP_TABLE_MAKER(part) ((part) ? &(part)->maker : NULL)

/* Memory of a table that is not baked: how many bytes of entries, the numbers, and the
 * entries. */
typedef int32_t tp_own_table;

/* Returns a table of the assets; NULL: not baked. */
static inline const tp_table *tp_assets_table(const tp_assets *assets, tp_table_id id)
{
    return assets && assets->tables && assets->tables->table[id].entries
               ? &assets->tables->table[id] : NULL;
}

/* Allocates a table of `bytes`, empty; NULL: the assets have it, or the arena only counts.
 * tp_table_layout_own: whatever the assets have. */
tp_own_table *tp_table_layout(tp_arena *arena, const tp_assets *assets, tp_table_id id,
                              size_t bytes);
tp_own_table *tp_table_layout_own(tp_arena *arena, tp_table_id id, size_t bytes);

/* Returns the entries.  An own table is made again if its numbers have changed.  Without
 * its maker, or baked of other numbers, it counts as dropped. */
const void *tp_frame_table(struct tp_frame *frame, tp_table_id id, tp_own_table *own,
                           const int32_t *numbers, const tp_table_maker *maker,
                           const void *from);

/* Returns the table that the frame has in its block, with the bytes of its entries; not
 * baked ones. */
tp_table tp_frame_own_table(const struct tp_frame *frame, tp_table_id id, size_t *bytes);

#endif
