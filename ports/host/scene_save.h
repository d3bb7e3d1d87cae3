/* SPDX-License-Identifier: MIT */
/* Scenes back to INI files: what differs from the defaults, with the comments, order and
 * spelling of the file that the scene came from. */
#ifndef HOST_SCENE_SAVE_H
#define HOST_SCENE_SAVE_H
#include "scene_file.h"

/* Writes the scene as `name`, whole or not at all (output.h).  Lines of file->path whose
 * value has not changed stay as they are, changed values are put in place behind their
 * "=", lines of values that are now the default's go, and new values come at the end of
 * their section, new sections at the end.  Names of files are told relative to the new
 * file's folder.  An exit code, having said why. */
int scene_save(const scene_file *file, const char *name);

/* Where Ctrl+S writes: the scene's own path if that is a person's file that can be
 * written; of a shipped scene NAME.ini in the current folder, NAME-2.ini where that is
 * somebody's: what is saved is from then on the file to work on.  To free; NULL: no
 * memory. */
char *scene_save_name(const scene_file *file);
#endif
