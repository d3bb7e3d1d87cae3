/* SPDX-License-Identifier: MIT */
/* The lines of an INI file, to be edited without touching the others. */
#ifndef HOST_SCENE_LINES_H
#define HOST_SCENE_LINES_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#define LINE_NONE  (-1)         /* sets nothing: a comment, a section's head ... */
#define LINE_OTHER (-2)         /* sets what is not in the table */

typedef struct {
    char  *text;                /* without the line's end */
    char  *more;                /* lines that follow it now, each with its end; NULL */
    const char *end;            /* "\n", "\r\n" or, of the last one, "" */
    size_t value_bytes;
    long   row;                 /* of the table that it sets, or LINE_... */
    bool   head;                /* of a section */
    bool   gone;
} scene_line;

typedef struct {
    scene_line *of;
    size_t      count;
    char       *tail;           /* new sections; NULL: none */
} scene_lines;

/* EXIT_INPUT: and said why.  Free in any case. */
int  scene_lines_read(scene_lines *l, const char *path);
void scene_lines_free(scene_lines *l);
void scene_lines_write(const scene_lines *l, FILE *to);

/* Line `line`, from 1, sets a row, to a value of so many bytes. */
void scene_lines_value(scene_lines *l, uint32_t line, long row, size_t value_bytes);

/* Takes the lines of a row away, and a section that has nothing else.  A comment behind
 * a value stays as one of its own. */
void scene_lines_remove(scene_lines *l, long row);

/* Each false: no memory, and nothing has changed.  A comment that makes the line longer
 * than `most` bytes gets one of its own, before it. */
bool scene_lines_replace(scene_lines *l, uint32_t line, const char *value, size_t most);

/* "section.name" at its section's end, or at the file's. */
bool scene_lines_append(scene_lines *l, const char *name, const char *value);
#endif
