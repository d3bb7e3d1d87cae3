/* SPDX-License-Identifier: MIT */
/* Lines of streamed water that stay from tile to tile of a strip; see the header. */
#include "view/kept_lines.h"
#include "tidepool/modules.h"

static tp_kept_lines *open_lines(void *memory, size_t bytes, const tp_kept_lines *wanted,
                                 bool first_tile)
{
    tp_kept_lines *kept = memory;

    TP_ASSERT(wanted->frame != 0 && wanted->line_bytes % sizeof(uint32_t) == 0);
    if (bytes < tp_kept_lines_bytes(2, wanted->line_bytes))
        return NULL;
    if (!first_tile && kept->frame == wanted->frame && kept->picture == wanted->picture
        && kept->strip == wanted->strip) {
        TP_ASSERT(kept->line_bytes == wanted->line_bytes);
        TP_ASSERT(sizeof *kept + kept->count * (sizeof *kept->number + kept->line_bytes)
                  <= bytes);
        return kept;
    }
    *kept = *wanted;
    kept->count = (uint32_t)(bytes - sizeof *kept)
                / (uint32_t)(sizeof *kept->number + wanted->line_bytes);
    TP_ASSERT(kept->count >= 2);
    memset(kept->number, 0, kept->count * sizeof *kept->number);
    return kept;
}

static void *find_line(tp_kept_lines *kept, uint32_t number, bool *known)
{
    const uint32_t slot = number % kept->count, mark = number + 1;
    uint8_t *line = (uint8_t *)&kept->number[kept->count];

    TP_ASSERT(mark > 0);
    if (kept->number[slot] > mark)
        return NULL;
    *known = kept->number[slot] == mark;
    kept->number[slot] = mark;
    return line + (size_t)slot * kept->line_bytes;
}

const struct tp_draw_kept_lines tp_draw_kept_lines = { open_lines, find_line };
