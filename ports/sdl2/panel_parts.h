/* SPDX-License-Identifier: MIT */
/* What the panel's parts share: its state, and the parts themselves, each drawn once a
 * picture.  Nothing of a value is kept: what is in sight is asked of the host anew. */
#ifndef SDL2_PANEL_PARTS_H
#define SDL2_PANEL_PARTS_H
#include "panel.h"
#include "panel_ink.h"
#include "panel_keys.h"
#include "panel_rows.h"

#ifdef __cplusplus
extern "C" {
#endif

enum { PANEL_CALLS = 256 };

struct panel {
    const panel_host *host;
    SDL_Window   *window;
    void         *imgui;
    ink           pen;
    ink_call      call[PANEL_CALLS];
    panel_keys    keys;
    SDL_Rect      where;
    float         scale;
    bool          hidden, measures;
    bool          to_rows;              /* the rows' tab is to come to the front */
    panel_group   group[PANEL_GROUPS];
    uint32_t      groups, counted, scene;
    uint32_t      to_open;              /* scene that was asked for, or UINT32_MAX */
    char          wanted[64];           /* what is searched for, and was when idle groups
                                           were told */
    char          counted_for[64];
    int           typing;               /* row whose number is typed, or -1 */
    bool          typing_new, typing_seen;
    uint32_t      asked;                /* pictures since the keyboard was asked for */
    int           sliding, place;       /* row that changes while it is held, or -1 */
    int           tip, tip_new;         /* row that is pointed at, or -1 */
    double        tip_since;            /* s */
};

/* The scene's list; buttons; what was said last. */
void panel_top(panel *p);

/* A button that does what the action's keys do, shown as `name`. */
void panel_button(panel *p, int what, const char *name, float wide);

/* A line cut to the width; pointed at, it shows the whole. */
void panel_line(uint32_t colour, const char *text);

/* Groups of rows, or those that were searched for. */
void panel_list(panel *p);

/* One row: its name, its value as something to hold or type in, its reset. */
void panel_row_show(panel *p, uint32_t row);
void panel_rows_begin(panel *p);        /* before and after all of a picture's rows */
void panel_rows_end(panel *p);

void panel_figures_show(panel *p);

/* Asks for the keyboard for the next thing, until it is there. */
void panel_ask(panel *p);

#ifdef __cplusplus
}
#endif
#endif
