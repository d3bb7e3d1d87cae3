/* SPDX-License-Identifier: MIT */
/* Writes scenes to INI files: the differences from the defaults, with the comments, order
 * and spelling of the scene's own file. */
#ifndef TP_APP_SCENE_SCENE_SAVE_H
#define TP_APP_SCENE_SCENE_SAVE_H
#include "scene_file.h"

/* Writes the scene as `name`, complete or not at all (output_file.h).  Lines of file->path
 * with an unchanged value stay.  A changed value replaces the text after its "=".  Lines of
 * values now equal to the default are removed.  New values come at the end of their
 * section, new sections at the end of the file.  File names are relative to the new file's
 * folder.  Returns an exit code, and prints the reason of a failure. */
int scene_save(const scene_file *file, const char *name);

/* Returns the file for Ctrl+S: the scene's own path if it is a user's writable file; for a
 * shipped scene NAME.ini in the current folder, or NAME-2.ini if the name is in use.  The
 * saved file is the file to work on from then on.  The caller frees the name; NULL: no
 * memory. */
char *scene_save_name(const scene_file *file);
#endif
