/* SPDX-License-Identifier: MIT */
/* Snapshots of a world on disk: the world's bytes under a head with a CRC and digests of
 * scene and program.  A file is replaced atomically: after a power cut it is the old
 * file or the new file, never a mixture. */
#ifndef TP_APP_FILES_SNAPSHOT_H
#define TP_APP_FILES_SNAPSHOT_H
#include <stdbool.h>
#include <stdint.h>
#include "tidepool/world.h"

/* Progress of a world. */
typedef struct {
    uint32_t frame;             /* number of its last frame */
    uint32_t played;            /* tape entries applied so far */
} snapshot_progress;

typedef struct {
    const char *name;           /* file name; NULL: keep nothing */
    uint32_t    scene, build;   /* digests */
    bool        failed;         /* the last write of a world failed; error printed */

    /* Makes a fresh world at tick 0 in the memory passed to snapshot_read, for the scene as
     * changed by the first `played` entries of the tape.  Returns false if the tape has
     * fewer entries.  NULL: no tape. */
    bool      (*remake)(void *user, uint32_t played);
    void       *user;
} snapshot_store;

/* Computes the digests: of the scene and its maps, and of the program's file, as far as
 * /proc gives access. */
snapshot_store snapshot_begin(const char *name, const tp_scene *scene,
                              const tp_assets *assets);

/* Computes the scene's digest again, for another scene. */
void snapshot_set_scene(snapshot_store *k, const tp_scene *scene, const tp_assets *assets);

/* Reads the kept world and its progress.  On entry *world is a world at tick 0, used to
 * check the file's content (tp_world_check).  Returns false if the file is missing,
 * incomplete, of another scene or build, or holds a state no scene can reach; the reason
 * has been said and *world is unchanged. */
bool snapshot_read(const snapshot_store *k, tp_world *world, size_t bytes,
                   snapshot_progress *at);

/* Writes the world.  Returns EXIT_INPUT on failure; only the first failure in a row is
 * printed. */
int snapshot_write(snapshot_store *k, const tp_world *world, size_t bytes,
                   snapshot_progress at);
#endif
