/* SPDX-License-Identifier: MIT */
/* State shared by the panel's parts, and the parts, each drawn once per frame.  The
 * panel caches no values: it asks the host for the visible values at each frame. */
#ifndef TP_APP_PREVIEW_PANEL_PARTS_H
#define TP_APP_PREVIEW_PANEL_PARTS_H
#include "panel.h"
#include "panel_keys.h"
#include "panel_raster.h"
#include "panel_rows.h"

#ifdef __cplusplus
extern "C" {
#endif

enum { PANEL_CALLS = 256 };

struct panel {
    const panel_host *host;
    SDL_Window   *window;
    void         *imgui;
    panel_raster  pen;
    panel_draw_call call[PANEL_CALLS];
    panel_keys    keys;
    SDL_Rect      where;
    float         scale;
    bool          hidden, measures;
    bool          to_rows;              /* select the tab of rows */
    panel_group   group[PANEL_GROUPS];
    uint32_t      groups, counted, scene;
    uint32_t      to_open;              /* index of a scene to open, or UINT32_MAX */
    char          wanted[64];           /* search text; counted_for: as of the last
                                         * update of the groups' `idle` */
    char          counted_for[64];
    int           typing;               /* row with a number being typed, or -1 */
    bool          typing_new, typing_seen;
    uint32_t      asked;                /* frames since the request for the focus */
    int           sliding, place;       /* row with a held slider, or -1; its position */
    int           tip, tip_new;         /* row under the mouse or the focus, or -1 */
    double        tip_since;            /* s */
};

/* The list of scenes, the buttons, the last message. */
void panel_top(panel *p);

/* A button for an action, labelled `name`. */
void panel_button(panel *p, int what, const char *name, float wide);

/* A line of text, cut to the width; the mouse over the line shows all of the text. */
void panel_line(uint32_t colour, const char *text);

/* The groups of rows, or the result of the search. */
void panel_list(panel *p);

/* One row: name, value widget, reset button. */
void panel_row_show(panel *p, uint32_t row);
void panel_rows_begin(panel *p);        /* call before and after the rows of a frame */
void panel_rows_end(panel *p);

void panel_performance_show(panel *p);

/* Requests the keyboard focus for the next widget.  Call in each frame until the widget has
 * the focus. */
void panel_request_focus(panel *p);

#ifdef __cplusplus
}
#endif
#endif
