/* SPDX-License-Identifier: MIT */
/* A scene as a person gives it: an INI file and settings of the command line. */
#ifndef HOST_SCENE_FILE_H
#define HOST_SCENE_FILE_H
#include <stdint.h>
#include "tidepool/scene.h"

#define SET_BY_COMMAND UINT32_MAX

typedef struct {
    char    *name;          /* "three-swells" */
    char    *path;          /* of the INI */
    uint32_t *set_at;       /* of each row of the table: the INI's line that set it, 0 for
                               its default, SET_BY_COMMAND */
    const char *by;         /* what messages call SET_BY_COMMAND; NULL: "--set" */
    tp_scene scene;
} scene_file;

/* `given`: a shipped scene's name or a path.  Each returns an exit code and has said
 * why; close in any case. */
int  scene_file_open(scene_file *file, const char *given);
int  scene_file_set(scene_file *file, const char *setting);     /* "name=value" */
void scene_file_close(scene_file *file);

/* "name=value" without setting it: its row, *value behind the "=".  NULL: it cannot be
 * set, and said why; the message begins with `place`. */
const tp_param *scene_file_check(const char *place, const char *setting,
                                 const char **value);

/* What a scene takes for a value: of a file's name that is too long for it a short one,
 * that stands for it (long_name.h); else the value.  NULL: no memory, and it said so. */
const char *scene_file_value(const tp_param *param, const char *value);

/* The file that a row of kind mesh or texture names, to free; NULL: no memory.
 * Names in the INI are relative to it; those of the command line to the folder that the
 * program was started in or, if there is no such file, to the INI too. */
char *scene_file_path_of(const scene_file *file, const tp_param *param);

/* The row's value as it has to be set by hand to mean what it means now: a name that the
 * INI gave is relative to the INI, those given by hand to the current folder. */
void scene_file_text(const scene_file *file, const tp_param *param, char *text,
                     size_t bytes);

/* "harbour.ini:14: boat.mesh", what messages about its file begin with. */
void scene_file_who(const scene_file *file, const tp_param *param, char *text,
                    size_t bytes);

/* What the core found wrong with the scene: at the place where err->word was set, if that
 * is a parameter. */
int  scene_file_refuse(const scene_file *file, const tp_error *err);

/* -- between scene_file.c and scene_ini.c ---------------------------------------- */

/* One value; a message begins with `place`.  False: refused, and said why. */
bool scene_file_apply(scene_file *file, const char *place, uint32_t set_at,
                      const char *name, const char *value);
int  scene_ini_read(scene_file *file);
#endif
