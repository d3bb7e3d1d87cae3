/* SPDX-License-Identifier: MIT */
/* File names: joining, comparing, and the folder of the shipped scenes.  Every returned
 * char * is freed by the caller; NULL means no memory. */
#ifndef TP_APP_FILES_PATH_H
#define TP_APP_FILES_PATH_H
#include <stdbool.h>
#include <stddef.h>

/* Returns `name` as named in the file `from`: relative to the folder of `from`. */
char *path_beside(const char *from, const char *name);

/* Returns the inverse: the name of `target` relative to the folder of `file`.  If one of
 * the folders does not exist, returns a copy of `target`. */
char *path_make_relative(const char *file, const char *target);

/* Returns the name of a file without folders and ".ini". */
char *path_stem(const char *path);

/* True if two names refer to the same existing file; to files in the same folder. */
bool  path_same_file(const char *a, const char *b);
bool  path_same_folder(const char *a, const char *b);

/* Returns folder/name, or folder/name.ini with suffix ".ini". */
char *path_join(const char *folder, const char *name, const char *suffix);

char *path_copy(const char *text, size_t bytes);
/* Writes "stem-0001.png" with the first number unused in the current folder. */
void  path_numbered(char *name, size_t bytes, const char *stem, const char *suffix);

bool  path_is_file(const char *path);       /* true if it exists and is no folder */
bool  path_ends(const char *path, const char *suffix);

/* Returns the folder of shipped scenes, beside the executable or in the install prefix;
 * NULL if there is none. */
char *path_of_scenes(void);

/* Returns the names of a folder's files with the suffix, sorted, without the suffix;
 * *count: their number.  path_free_names frees them. */
char **path_names(const char *folder, const char *suffix, size_t *count);
char **path_scene_names(const char *folder, size_t *count);     /* suffix ".ini" */
void   path_free_names(char **names, size_t count);
#endif
