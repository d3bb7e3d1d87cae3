/* SPDX-License-Identifier: MIT */
/* Tables of a frame as constants: those that stay the same while the scene runs. */
#ifndef TP_TOOLS_BAKE_BAKE_TABLES_H
#define TP_TOOLS_BAKE_BAKE_TABLES_H
#include <stdio.h>
#include "tidepool/frame.h"

typedef struct {
    tp_tables tables;                   /* entries NULL: not baked */
    size_t    bytes[TP_TABLE_COUNT];    /* of the entries on this machine */
} bake_tables;

/* Makes the tables of a scene by a frame of it, at moments of a run without input.  acts: a
 * user will act: tables that depend on light and camera are left out.  Returns an exit
 * code; the caller calls bake_tables_free in every case. */
int bake_tables_make(bake_tables *to, const tp_scene *scene, const tp_assets *assets,
                     const tp_config *config, bool acts);
void bake_tables_free(bake_tables *t);

/* Writes NAME_tables, and the tables before it. */
void bake_tables_write(FILE *out, const char *name, const bake_tables *t);

/* Returns the bytes of the entries and numbers on a machine of 32 bits. */
size_t bake_tables_bytes(const bake_tables *t);
#endif
