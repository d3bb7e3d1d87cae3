/* SPDX-License-Identifier: MIT */
/* Rows of the panel without anything drawn: groups, search, words, numbers as text. */
#ifndef SDL2_PANEL_ROWS_H
#define SDL2_PANEL_ROWS_H
#include "panel.h"

#ifdef __cplusplus
extern "C" {
#endif

enum { PANEL_GROUPS = 64, PANEL_NAME = 32 };

/* Rows one after the other whose names begin alike, to the dot. */
typedef struct {
    char     name[PANEL_NAME];
    uint32_t first, count;
    bool     idle;              /* not in the scene when it was opened: every value was
                                   the default, and the first one none */
    uint32_t changed;           /* values that are not the default's, when last counted */
} panel_group;

/* The number of groups, PANEL_GROUPS at the most; what is beyond is left out. */
uint32_t panel_groups_of(const panel_host *host, panel_group groups[PANEL_GROUPS]);

/* Counts again; `fresh`: of a scene that was just opened, which tells what is idle. */
void     panel_group_count(const panel_host *host, panel_group *group, bool fresh);

/* What stands beside a value: the name behind the dot, "_" as blanks; no more than
 * `letters` of it, the last two then dots. */
void     panel_label(const panel_row *row, uint32_t letters, char text[PANEL_NAME]);

/* Whether every word of `wanted` is in the name, or else in name or help; capital or not,
 * and "_", "." and blank are the same.  "" is in every name. */
typedef enum { PANEL_LOST, PANEL_BY_HELP, PANEL_BY_NAME } panel_find;
panel_find panel_found(const panel_row *row, const char *wanted);

/* Word i of "off|on|auto"; false: there is none. */
bool     panel_word(const char *list, uint32_t i, char text[PANEL_TEXT]);

/* A slider: places 0..steps from low to high. */
typedef struct {
    double low, high;
    double fine;                /* > 0: of sizes above this, equal ways multiply */
    int    steps;
    bool   whole;               /* of whole numbers */
} panel_span;

/* The table's range; of angles of many turns the turn that `value` lies in. */
panel_span panel_span_of(const panel_row *row, double value);

/* The place of a value, which may lie outside; and a place's value, as text that a scene
 * file has, told as finely as the slider is worth. */
int      panel_place(const panel_span *span, double value);
void     panel_number(const panel_span *span, int place, char text[PANEL_TEXT]);

/* "#rrggbb" as 0xRRGGBB; anything else is black. */
uint32_t panel_colour(const char *text);

/* Name, help, range and default, one a line. */
void     panel_tip(const panel_row *row, char *text, size_t bytes);

#ifdef __cplusplus
}
#endif
#endif
