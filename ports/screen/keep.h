/* SPDX-License-Identifier: MIT */
/* A world on disk: its bytes under a head that tells whether they are whole, and of which
 * scene and program.  Replaced as a whole, so that a power cut leaves the old one or the
 * new one, never half of either. */
#ifndef SCREEN_KEEP_H
#define SCREEN_KEEP_H
#include <stdbool.h>
#include <stdint.h>
#include "tidepool/world.h"

/* How far a world had come. */
typedef struct {
    uint32_t frame;             /* number of its last picture */
    uint32_t played;            /* entries of a tape that it has taken */
} keep_at;

typedef struct {
    const char *name;           /* of the file; NULL: nothing is kept */
    uint32_t    scene, build;   /* digests */
    bool        failed;         /* the last one could not be written, and that was said */

    /* Makes the world that keep_take is given anew, at tick 0, of the scene as so many of
     * the tape's entries have changed it; false: there are not so many.  NULL: there is no
     * tape. */
    bool      (*remake)(void *user, uint32_t played);
    void       *user;
} keep;

/* Of what the world comes from, and of the program's file, as far as /proc shows it. */
keep keep_begin(const char *name, const tp_scene *scene, const tp_assets *assets);

/* The same of another scene, without reading the program again. */
void keep_scene(keep *k, const tp_scene *scene, const tp_assets *assets);

/* The world as it was kept, and how far it had come.  *world goes in at tick 0: nothing
 * of the file is trusted that does not fit it (tp_world_check).  False: the file is not
 * there, or is not whole, or of another scene or build, or holds what no scene leads to,
 * which is said; *world is as it was. */
bool keep_take(const keep *k, tp_world *world, size_t bytes, keep_at *at);

/* EXIT_INPUT: it could not be written, and that was said, once in a row. */
int  keep_put(keep *k, const tp_world *world, size_t bytes, keep_at at);
#endif
