/* SPDX-License-Identifier: MIT */
/* The session's file: an INI of the scene's path and what was changed, and the name of
 * the file beside it that holds the world.
 *
 *     [session]
 *     world = world-5e2a91c7          the CRC-32 of all that follows this line
 *     scene = /home/a/pond.ini
 *     [wave0]
 *     amplitude = 0.8
 *
 * Blanks and what an INI file cannot hold are written %20; what is longer than a line
 * goes on in another of the same name. */
#ifndef HOST_SESSION_FILE_H
#define HOST_SESSION_FILE_H
#include "scene_file.h"
#include "session.h"

#define SESSION_INI   "session.ini"
#define SESSION_WORLD "world-"          /* and eight digits */

typedef struct { char name[16]; } session_world_name;

/* The folder, made if it is not there, or NULL; *why is then errno's, 0: neither
 * XDG_STATE_HOME nor HOME tell it.  To free. */
char *session_folder(bool make, int *why);

/* The file's text, to free, and the world's name in it.  NULL: no memory. */
char *session_text(const scene_file *file, session_world_name *world);

/* The whole file folder/session.ini as text, to free.  NULL: none, or not whole
 * (*code EXIT_DONE), or it cannot be read (EXIT_INPUT), which is said. */
char *session_load(const char *folder, session_world_name *world, int *code);

/* A scene whose names are left out: files are told by what is in them. */
void  session_nameless(tp_scene *to, const tp_scene *scene);
#endif
