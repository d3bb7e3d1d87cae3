/* SPDX-License-Identifier: MIT */
/* The lines of an INI file, for editing single lines without changing the others. */
#ifndef TP_APP_SCENE_SCENE_LINES_H
#define TP_APP_SCENE_SCENE_LINES_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#define LINE_NONE  (-1)         /* sets nothing: a comment, a section's head ... */
#define LINE_OTHER (-2)         /* sets a name that is not in the table */
#define LINE_OLDER_GRID (-3)    /* sets a row of the older grid */

typedef struct {
    char  *text;                /* text without line end */
    char  *more;                /* new lines after this line, each with its end */
    const char *end;            /* "\n", "\r\n" or, of the last line, "" */
    size_t value_bytes;
    long   row;                 /* row of the table that the line sets, or LINE_... */
    bool   head;                /* head of a section */
    bool   gone;
} scene_line;

typedef struct {
    scene_line *of;
    size_t      count;
    char       *tail;           /* new sections; NULL: none */
} scene_lines;

/* Returns EXIT_INPUT after printing the reason.  The caller calls scene_lines_free in every
 * case. */
int  scene_lines_read(scene_lines *l, const char *path);
void scene_lines_free(scene_lines *l);
void scene_lines_write(const scene_lines *l, FILE *to);

/* Notes that line `line`, from 1, sets a row; value_bytes: length of the value. */
void scene_lines_value(scene_lines *l, uint32_t line, long row, size_t value_bytes);

/* Removes the lines of a row, and a section that becomes empty.  A comment after a value
 * stays, on a line of its own. */
void scene_lines_remove(scene_lines *l, long row);

/* Replaces the value in line `line`, from 1.  A comment that would make the line longer
 * than `most` bytes moves to a line of its own before the line.  Returns false if memory is
 * lacking, with nothing changed. */
bool scene_lines_replace(scene_lines *l, uint32_t line, const char *value, size_t most);

/* Replaces the name before the "=" of line `line`, from 1, by `now`; blanks and the rest of
 * the line stay.  Returns false if the line does not set `old`, or memory is lacking, with
 * nothing changed.  Names are without their section. */
bool scene_lines_rename(scene_lines *l, uint32_t line, const char *old, const char *now);

/* Adds "section.name" at the end of its section, or in a new section at the end of the
 * file.  Returns false if memory is lacking, with nothing changed. */
bool scene_lines_append(scene_lines *l, const char *name, const char *value);
#endif
