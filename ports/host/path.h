/* SPDX-License-Identifier: MIT */
/* File names: joining them, and where the shipped scenes lie.  What returns a char *
 * returns memory that the caller frees, or NULL when there is none. */
#ifndef HOST_PATH_H
#define HOST_PATH_H
#include <stdbool.h>
#include <stddef.h>

/* `name` as the file `from` means it: relative to the folder that `from` lies in. */
char *path_beside(const char *from, const char *name);

/* The other way round: what `file` has to call `target` by.  Where one of the folders
 * does not exist, `target` as it is. */
char *path_from(const char *file, const char *target);

/* The file's name without folders and ".ini". */
char *path_stem(const char *path);

/* Whether two names are of one file that is there, or of files in one folder. */
bool  path_same_file(const char *a, const char *b);
bool  path_same_folder(const char *a, const char *b);

/* folder/name, or folder/name.ini with suffix ".ini". */
char *path_join(const char *folder, const char *name, const char *suffix);

char *path_copy(const char *text, size_t bytes);
/* "stem-0001.png" of the current folder, with the first number that is free. */
void  path_numbered(char *name, size_t bytes, const char *stem, const char *suffix);

bool  path_is_file(const char *path);       /* and no folder */
bool  path_ends(const char *path, const char *suffix);

/* The folder of shipped scenes: beside the executable or in the install prefix;
 * NULL if there is none. */
char *path_of_scenes(void);

/* Names of a folder's files that end so, sorted, without that; *count of them.  Free with
 * path_free_names. */
char **path_names(const char *folder, const char *suffix, size_t *count);
char **path_scene_names(const char *folder, size_t *count);     /* of ".ini" */
void   path_free_names(char **names, size_t count);
#endif
