/* SPDX-License-Identifier: MIT */
/* The rows of the older grid in a scene's file, which grid.vertices replaced: grid.cols,
 * grid.rows, grid.cell, grid.reach and grid.follow.  Files may say them until OLD_NAMES_END;
 * they are read as a number of vertices. */
#ifndef TP_APP_SCENE_OLDER_GRID_H
#define TP_APP_SCENE_OLDER_GRID_H
#include <stdbool.h>
#include <stdint.h>
#include "tidepool/scene.h"

typedef struct {
    uint32_t line;              /* first line of the file that says such a row, 0: none */
    int32_t  cols, rows;        /* 0: the file does not say it */
    bool     ends;              /* grid.reach = 0: no water beyond the grid */
} older_grid;

bool older_grid_has_row(const char *name);

/* Reads a row.  Returns false, after a message that begins with `place`, if the value is
 * no number in range; without a place no message. */
bool older_grid_read(older_grid *grid, const char *place, uint32_t line, const char *name,
                     const char *value);

/* Return the values of grid.vertices and tank.sea in a file that does not say them. */
int32_t older_grid_vertices(const older_grid *grid, const tp_scene *scene);
int32_t older_grid_sea(const older_grid *grid);
#endif
