/* SPDX-License-Identifier: MIT */
/* Rows of the panel, without drawing: groups, search, words of choices, numbers as text. */
#ifndef TP_APP_PREVIEW_PANEL_ROWS_H
#define TP_APP_PREVIEW_PANEL_ROWS_H
#include "panel.h"

#ifdef __cplusplus
extern "C" {
#endif

enum { PANEL_GROUPS = 64, PANEL_NAME = 32 };

/* Consecutive rows with the same name up to the dot. */
typedef struct {
    char     name[PANEL_NAME];
    uint32_t first, count;
    bool     idle;              /* unused by the scene when opened: all values are
                                 * defaults, the first is 0 or empty */
    uint32_t changed;           /* values unlike the default, at the last count */
} panel_group;

/* Returns the number of groups, at most PANEL_GROUPS; further groups are dropped. */
uint32_t panel_groups_collect(const panel_host *host, panel_group groups[PANEL_GROUPS]);

/* Counts the changed values again.  `fresh`: the scene was just opened; sets `idle` too. */
void     panel_group_count(const panel_host *host, panel_group *group, bool fresh);

/* Writes a row's label: the name behind the dot, blanks for "_"; cut to `letters`
 * characters, then ending in "..". */
void     panel_label(const panel_row *row, uint32_t letters, char text[PANEL_NAME]);

/* Result of a search: BY_NAME if every word of `wanted` is in the name, BY_HELP if every
 * word is in the name or the help, else LOST.  Case is ignored; "_", "." and blank are
 * equal.  "" is in every name. */
typedef enum { PANEL_LOST, PANEL_BY_HELP, PANEL_BY_NAME } panel_find;
panel_find panel_found(const panel_row *row, const char *wanted);

/* Copies word i of "off|on|auto".  Returns false if there is none. */
bool     panel_word(const char *list, uint32_t i, char text[PANEL_TEXT]);

/* A slider: positions 0..steps between low and high. */
typedef struct {
    double low, high;
    double fine;                /* > 0: logarithmic for |value| > `fine` */
    int    steps;
    bool   whole;               /* integers only */
} panel_span;

/* Returns the slider of a row: the table's range; for an angle of many turns the turn
 * around `value`. */
panel_span panel_span_choose(const panel_row *row, double value);

/* Slider position of a value, clamped to the range; and the value of a position, as text
 * in scene file notation with no more digits than a step is worth. */
int      panel_place(const panel_span *span, double value);
void     panel_number(const panel_span *span, int place, char text[PANEL_TEXT]);

/* "#rrggbb" as 0xRRGGBB; black for any other text. */
uint32_t panel_colour(const char *text);

/* Writes the tooltip: name, help, range and default, one per line. */
void     panel_tip(const panel_row *row, char *text, size_t bytes);

#ifdef __cplusplus
}
#endif
#endif
