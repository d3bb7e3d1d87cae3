/* SPDX-License-Identifier: MIT */
/* A scene as given by a user: an INI file and settings of the command line. */
#ifndef TP_APP_SCENE_SCENE_FILE_H
#define TP_APP_SCENE_SCENE_FILE_H
#include <stdbool.h>
#include <stdint.h>
#include "old_name_note.h"
#include "older_grid.h"
#include "tidepool/scene.h"

#define SET_BY_COMMAND UINT32_MAX

typedef struct {
    char    *name;          /* "three-swells" */
    char    *path;          /* path of the INI */
    uint32_t *set_at;       /* for each row of the table: line of the INI that set the
                             * value, 0: default, or SET_BY_COMMAND */
    const char *by;         /* origin of SET_BY_COMMAND in messages; NULL: "--set" */
    older_grid older;       /* rows of the older grid in the file */
    old_name_note old_in_file, old_by_command;      /* old names of rows that were read */
    tp_scene scene;
} scene_file;

/* Opens a scene; given: name of a shipped scene, or a path.  Each function returns an exit
 * code, and prints the reason of a failure; the caller calls scene_file_close in every
 * case. */
int  scene_file_open(scene_file *file, const char *given);
int  scene_file_set(scene_file *file, const char *setting);     /* "name=value" */
void scene_file_close(scene_file *file);

/* Sets what the file says by rows of the older grid; after the last line was applied. */
void scene_file_read_older_grid(scene_file *file);

/* Opens a scene without reading its file. */
int  scene_file_find(scene_file *file, const char *given);

/* Prints a warning for the old names of rows in the file, and one for those of --set. */
void scene_file_report_old_names(const scene_file *file);

/* Sets the rungs of all kinds and effects: "exact", "planned" (every rung left to the plan),
 * "named" (those of the scene, and exact ones in open rows) or "fast" (fast shading, the
 * middle mesh, and the cheapest rung of each other effect). */
bool scene_file_knows_rung(const char *name);
void scene_file_set_rung(scene_file *file, const char *name);

/* Checks "name=value" without setting it.  Returns the row, by its present name or an
 * earlier one; *value points after the "=".
 * Returns NULL after a message that begins with `place`. */
const tp_param *scene_file_check(const char *place, const char *setting,
                                 const char **value);

/* Returns the value for a scene.  A file name longer than a scene can hold is replaced by a
 * short text that stands for it (long_name.h).  NULL: no memory, after a message. */
const char *scene_file_value(const tp_param *param, const char *value);

/* Returns the path of the file that a row of kind mesh or texture names; the caller frees
 * the path.  NULL: no memory.  Names in the INI are relative to the INI.  Names of the
 * command line are relative to the current folder or, if no such file exists, to the
 * INI. */
char *scene_file_resolve_path(const scene_file *file, const tp_param *param);

/* Writes the row's value as a user would have to set it by hand for the same meaning: names
 * in the INI are relative to the INI, names given by hand to the current folder. */
void scene_file_text(const scene_file *file, const tp_param *param, char *text,
                     size_t bytes);

/* Writes the place of a setting, as "harbour.ini:14: boat.mesh", the start of messages
 * about its file. */
void scene_file_who(const scene_file *file, const tp_param *param, char *text,
                    size_t bytes);

/* Prints an error that the core found in the scene.  If err->word is a parameter, the
 * message names the place where the parameter was set. */
int  scene_file_refuse(const scene_file *file, const tp_error *err);

/* Sets one value.  False: refused, after a message that begins with `place`. */
bool scene_file_apply(scene_file *file, const char *place, uint32_t set_at,
                      const char *name, const char *value);
#endif
