/* SPDX-License-Identifier: MIT */
#include "older_grid.h"
#include <stdlib.h>
#include <string.h>
#include "app/files/log.h"
#include "world/pools.h"

#define COLS 100                /* of a file that says rows alone, and the reverse */

static const struct {
    const char *name;
    double      low, high;
} rows[] = {
    { "grid.cols", 2, 1024 },
    { "grid.rows", 2, 1024 },
    { "grid.cell", 0.01, 50 },
    { "grid.reach", 0, 16000 },
    { "grid.follow", 0, 1 },
};

enum { COLS_ROW, ROWS_ROW, CELL_ROW, REACH_ROW, FOLLOW_ROW, ROWS };

static int find_row(const char *name)
{
    int i = 0;

    while (i < ROWS && strcmp(name, rows[i].name) != 0)
        i++;
    return i;
}

static bool is_switch(const char *value)
{
    return strcmp(value, "on") == 0 || strcmp(value, "off") == 0;
}

bool older_grid_has_row(const char *name)
{
    return find_row(name) < ROWS;
}

bool older_grid_read(older_grid *grid, const char *place, uint32_t line, const char *name,
                     const char *value)
{
    const int row = find_row(name);
    char *end;
    const double number = strtod(value, &end);
    const bool is_number = end != value && end[strspn(end, " \t")] == '\0';

    if (!(row == FOLLOW_ROW && is_switch(value))
        && !(is_number && number >= rows[row].low && number <= rows[row].high)) {
        if (place)
            log_line("%s: %s = %s is outside %g..%g", place, name, value, rows[row].low,
                     rows[row].high);
        return false;
    }
    grid->line = grid->line && grid->line < line ? grid->line : line;
    if (row == COLS_ROW)
        grid->cols = (int32_t)number;
    else if (row == ROWS_ROW)
        grid->rows = (int32_t)number;
    else if (row == REACH_ROW)
        grid->ends = number == 0;
    return true;
}

/* A tank needs all points.  Cells as fine as before up to the end of rings and pools need
 * 3 in 5, as measured for raindrops; open water needs the third that a view shows. */
int32_t older_grid_vertices(const older_grid *grid, const tp_scene *s)
{
    const int64_t all = (int64_t)(grid->cols ? grid->cols : COLS)
                        * (grid->rows ? grid->rows : COLS);
    const int64_t kept = tp_is_walled(s) ? all
                       : tp_has_pools_or_drops(s) ? all * 3 / 5 : all / 3;

    if (grid->cols == 0 && grid->rows == 0)
        return 0;
    return (int32_t)(kept < 64 ? 64 : kept > 65536 ? 65536 : kept);
}

int32_t older_grid_sea(const older_grid *grid)
{
    return !grid->ends;
}
