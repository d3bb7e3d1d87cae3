/* SPDX-License-Identifier: MIT */
/* The panel beside the picture: its data and its callbacks.
 *
 * The panel uses no type of the core.  Values are exchanged as text, in the notation of
 * scene files, so the panel sets exactly the values a file can set.  Without Dear ImGui
 * panel_none.c replaces the panel: panel_open then returns NULL. */
#ifndef TP_APP_PREVIEW_PANEL_H
#define TP_APP_PREVIEW_PANEL_H
#include <SDL.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "app/session/performance.h"

#ifdef __cplusplus
extern "C" {
#endif

#define PANEL_TEXT 192          /* bytes of a value with the terminating 0 */

typedef enum {
    PANEL_NUMBER, PANEL_COUNT, PANEL_SWITCH, PANEL_COLOUR, PANEL_CHOICE,
    PANEL_PICTURE,              /* name of a PNG, from panel_host.pictures or any other */
    PANEL_MESH, PANEL_WORDS
} panel_kind;

typedef struct {
    const char *name;           /* "wave0.steepness": group, dot, rest */
    const char *unit;           /* "m"; words of a choice: "off|on" */
    const char *help;
    panel_kind  kind;
    double      low, high;      /* range of numbers and counts */
    const char *normal;         /* default value as text; NULL: not in the tooltip */
} panel_row;

typedef struct {
    void            *user;      /* first argument of every function below */
    const panel_row *row;
    uint32_t         rows;

    /* The value as text; true if equal to the default, to the scene file's value. */
    void (*get)(void *user, uint32_t row, char text[PANEL_TEXT]);
    bool (*is_normal)(void *user, uint32_t row);        /* equal to the table's default */
    bool (*is_filed)(void *user, uint32_t row);         /* equal to the scene file's */

    /* Sets a value.  Returns false if refused; panel_host.message has the reason.
     * `going`: part of a drag still held; a whole drag is one step of undo. */
    bool (*set)(void *user, uint32_t row, const char *text, bool going);
    void (*reset)(void *user, uint32_t row);            /* first to the file's value,
                                                         * then to the default */

    const char *const *scenes;  /* names or paths; shows: descriptions */
    const char *const *shows;
    uint32_t           scene_count, scene;              /* scene: the open one */
    const char        *name, *about;                    /* of the open scene */
    void (*open)(void *user, uint32_t scene);

    const char *const *pictures;                        /* PNG names offered to a row */
    uint32_t           picture_count;

    /* Runs an action, as a key does.  `action`: a number of ../session/actions.h. */
    void (*act)(void *user, int action);
    const char *(*keys)(void *user, int action);        /* "Ctrl+S" */
    bool (*is_on)(void *user, int action);              /* state of a switch: pause,
                                                         * film, panel ... */

    const panel_performance *performance;
    const panel_compare *compare;
    bool       (*measures)(void *user, bool on);        /* measures stage times */
    const char  *message;       /* last message, "" if none */
    const char  *saved_as;      /* path written by Ctrl+S */
} panel_host;

typedef struct panel panel;

bool   panel_is_built(void);

/* Opens the panel.  It reads the host and the data behind its pointers at every frame:
 * both must stay valid until panel_close.  Returns NULL if this build has no panel or on
 * failure. */
panel *panel_open(SDL_Window *window, SDL_Renderer *renderer, const panel_host *host);

/* Offers an event to the panel first.  True: the panel has consumed the event. */
bool   panel_event(panel *p, const SDL_Event *event);

/* Draws into the rectangle of the window; call between clearing and presenting.  NULL:
 * the panel is hidden; call once, to release the keyboard and to stop measuring. */
void   panel_draw(panel *p, const SDL_Rect *where);

void   panel_scale(panel *p, float scale);      /* letter size; 1 = as designed */
void   panel_search(panel *p);                  /* sets the focus to the search */

/* True if the panel has the keyboard: held keys are then not the picture's. panel_event
 * still returns false for a key used neither by a field nor for moving in the panel. */
bool   panel_types(const panel *p);
void   panel_close(panel *p);

#ifdef __cplusplus
}
#endif
#endif
