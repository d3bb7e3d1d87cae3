/* SPDX-License-Identifier: MIT */
/* The preview's state on disk, for `tidepool view --resume` after a crash, a lost display
 * or a power cut: the scene's path, the changes to the scene, and the world.  The folder is
 * $XDG_STATE_HOME/tidepool (~/.local/state/tidepool). */
#ifndef TP_APP_SESSION_SESSION_H
#define TP_APP_SESSION_SESSION_H
#include "app/scene/scene_file.h"
#include "tidepool/world.h"

typedef struct session session;

/* Returns NULL if nothing can be kept there, after one message; every function accepts
 * NULL. */
session *session_begin(void);

/* To call about once per second.  Copies the state and returns at once; a thread writes the
 * copy.  False: the thread still writes the last state. */
bool session_offer(session *s, const scene_file *file, const tp_assets *assets,
                   const tp_world *world, size_t bytes, uint32_t picture);

/* Writes the state now, on the calling thread; the state is on disk when the function
 * returns.  Safe in an atexit handler. */
int  session_put(session *s, const scene_file *file, const tp_assets *assets,
                 const tp_world *world, size_t bytes, uint32_t picture);

void session_end(session *s);

/* The last kept state.  scene (the caller frees): argument for loaded_scene_open.  settings
 * ("name=value", freed by session_free): to be set after it.  If no complete state is kept,
 * scene is NULL, after a message.  Returns EXIT_INPUT if the file cannot be read. */
typedef struct {
    char    *scene;
    char   **settings;
    uint32_t count;
} session_state;

int  session_read(session_state *state);
void session_free(session_state *state);

/* Reads the kept world into `world`, a world at tick 0 of the scene as read and set.
 * False, after a message, with *world unchanged: the kept world is of another build or
 * incomplete. */
bool session_world(const tp_scene *scene, const tp_assets *assets, tp_world *world,
                   size_t bytes, uint32_t *picture);
#endif
