/* SPDX-License-Identifier: MIT */
/* The session's file: an INI with the scene's path, the changed values, and the name of the
 * file beside it that holds the world.
 *
 *     [session]
 *     world = world-5e2a91c7          CRC-32 of all text after this line
 *     scene = /home/a/pond.ini
 *     [wave0]
 *     amplitude = 0.8
 *
 * Blanks and characters that an INI file cannot hold are written as %20.  A value longer
 * than a line continues in another line with the same name. */
#ifndef TP_APP_SESSION_SESSION_FILE_H
#define TP_APP_SESSION_SESSION_FILE_H
#include "app/scene/scene_file.h"
#include "session.h"

#define SESSION_INI   "session.ini"
#define SESSION_WORLD "world-"          /* followed by eight digits */

typedef struct { char name[16]; } session_world_name;

/* Returns the folder, which the caller frees; make: creates the folder.  NULL: *why is an
 * errno, or 0 if neither XDG_STATE_HOME nor HOME is set. */
char *session_folder(bool make, int *why);

/* Returns the text of the file, which the caller frees; *world: the world's name in it.
 * NULL: no memory. */
char *session_text(const scene_file *file, session_world_name *world);

/* Returns the text of folder/session.ini, which the caller frees; *world: the world's name
 * in the text.  Returns NULL after a message: no file or an incomplete one (*code =
 * EXIT_DONE), or a read error (EXIT_INPUT). */
char *session_load(const char *folder, session_world_name *world, int *code);

/* Copies a scene without file names: files are identified by their contents. */
void  session_nameless(tp_scene *to, const tp_scene *scene);
#endif
