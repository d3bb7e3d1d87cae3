/* SPDX-License-Identifier: MIT */
/* A world on disk: its bytes under a head that tells whether they are whole, and of which
 * scene and program.  Written beside the file and renamed, so that a power cut leaves the
 * old one or the new one, never half of either. */
#ifndef SCREEN_KEEP_H
#define SCREEN_KEEP_H
#include <stdbool.h>
#include <stdint.h>
#include "tidepool/scene.h"

typedef struct {
    const char *name;           /* of the file; NULL: nothing is kept */
    uint32_t    scene, build;   /* digests */
    bool        failed;         /* the last one could not be written, and that was said */
} keep;

/* Of what the world comes from, and of the program's file, as far as /proc shows it. */
keep keep_begin(const char *name, const tp_scene *scene, const tp_assets *assets);

/* The same of another scene, without reading the program again. */
void keep_scene(keep *k, const tp_scene *scene, const tp_assets *assets);

/* The world as it was kept, and its frame's number.  False: the file is not there, not
 * whole, or of another scene or build, and that was said; *world is as it was. */
bool keep_take(const keep *k, tp_world *world, size_t bytes, uint32_t *frame);

/* EXIT_INPUT: it could not be written, and that was said, once in a row. */
int  keep_put(keep *k, const tp_world *world, size_t bytes, uint32_t frame);

/* Any file of two parts, the old one or the new one whatever happens, and on the disk
 * when it returns.  False: errno tells why. */
bool keep_file(const char *name, const void *head_part, size_t head_bytes,
               const void *body, size_t body_bytes);
#endif
