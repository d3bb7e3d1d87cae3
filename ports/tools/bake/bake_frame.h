/* SPDX-License-Identifier: MIT */
/* The frame of a program's scene and config as a constant. */
#ifndef TP_TOOLS_BAKE_BAKE_FRAME_H
#define TP_TOOLS_BAKE_BAKE_FRAME_H
#include <stdio.h>
#include "bake_program.h"

/* Writes NAME_frame_bytes, NAME_frame_init and the bytes of a tile's scratch, after the
 * program.  Returns an exit code. */
int bake_put_frame(const bake_program *p, const tp_assets *assets, FILE *out,
                   const char *name);
#endif
