/* SPDX-License-Identifier: MIT */
/* What the preview was doing, on disk, so that `tidepool view --resume` goes on after a
 * crash, a lost display or a power cut: the scene's path, the changes made to it, the
 * world, in $XDG_STATE_HOME/tidepool (~/.local/state/tidepool). */
#ifndef HOST_SESSION_H
#define HOST_SESSION_H
#include "scene_file.h"
#include "tidepool/world.h"

typedef struct session session;

/* NULL: nothing can be kept there, which is said once; every function takes NULL. */
session *session_begin(void);

/* Each second or so: writes in a thread of its own, and returns at once.  False: the last
 * one is still being written. */
bool session_offer(session *s, const scene_file *file, const tp_assets *assets,
                   const tp_world *world, size_t bytes, uint32_t picture);

/* The same now, on this thread; when it returns it is on the disk.  Safe in an atexit
 * handler. */
int  session_put(session *s, const scene_file *file, const tp_assets *assets,
                 const tp_world *world, size_t bytes, uint32_t picture);

void session_end(session *s);

/* What was kept last.  `scene` (to free) is what stage_open is to be given, settings
 * ("name=value", to free with session_free) what is to be set after it.  Where nothing
 * whole is kept `scene` is NULL, and that was said.  EXIT_INPUT: it cannot be read. */
typedef struct {
    char    *scene;
    char   **settings;
    uint32_t count;
} session_state;

int  session_read(session_state *state);
void session_free(session_state *state);

/* The world of the scene as read and set, which goes in at tick 0; false: another build's
 * or not whole, said, and *world is as it was. */
bool session_world(const tp_scene *scene, const tp_assets *assets, tp_world *world,
                   size_t bytes, uint32_t *picture);
#endif
