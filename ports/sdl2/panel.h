/* SPDX-License-Identifier: MIT */
/* The panel beside the picture: what it shows, and what it may ask for.
 *
 * No type of the core's is named here: values go as text, by the words that scene files
 * use, so that what the panel sets is what a file would.  Built without Dear ImGui,
 * panel_none.c stands for it: panel_open then returns NULL. */
#ifndef SDL2_PANEL_H
#define SDL2_PANEL_H
#include <SDL.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "../host/figures.h"

#ifdef __cplusplus
extern "C" {
#endif

#define PANEL_TEXT 192          /* bytes of a value, its end included */

typedef enum {
    PANEL_NUMBER, PANEL_COUNT, PANEL_SWITCH, PANEL_COLOUR, PANEL_CHOICE,
    PANEL_PICTURE,              /* name of a PNG, of panel_host.pictures or any other */
    PANEL_MESH, PANEL_WORDS
} panel_kind;

typedef struct {
    const char *name;           /* "wave0.steepness": group and the rest */
    const char *unit;           /* "m"; of a choice its words: "off|on" */
    const char *help;
    panel_kind  kind;
    double      low, high;      /* of numbers and counts */
    const char *normal;         /* the default as text; NULL: the tooltip has none */
} panel_row;

typedef struct {
    void            *user;      /* of every function below */
    const panel_row *row;
    uint32_t         rows;

    /* Value as text, and whether it is the scene file's and the default one. */
    void (*get)(void *user, uint32_t row, char text[PANEL_TEXT]);
    bool (*is_normal)(void *user, uint32_t row);        /* the table's default */
    bool (*is_filed)(void *user, uint32_t row);         /* as the scene's file has it */

    /* False: refused; panel_host.message tells why.  `going`: a drag that goes on; all of
     * it is one step of undo. */
    bool (*set)(void *user, uint32_t row, const char *text, bool going);
    void (*reset)(void *user, uint32_t row);            /* to the file's value; if it is
                                                           that, to the table's default */

    const char *const *scenes;  /* names or paths, and what each shows */
    const char *const *shows;
    uint32_t           scene_count, scene;              /* scene: the one shown ... */
    const char        *name, *about;                    /* ... of these; and its name and
                                                           what it shows, listed or not */
    void (*open)(void *user, uint32_t scene);

    const char *const *pictures;                        /* that a row can take */
    uint32_t           picture_count;

    /* What a key does, does a button too: an action's number of ../host/actions.h. */
    void (*act)(void *user, int action);
    const char *(*keys)(void *user, int action);        /* "Ctrl+S" */
    bool (*is_on)(void *user, int action);              /* of what is switched: pause,
                                                           film, tape, figures, panel */

    const panel_figures *figures;
    const panel_compare *compare;
    bool       (*measures)(void *user, bool on);        /* times of stages, while seen */
    const char  *message;       /* the last thing said, "" none */
    const char  *saved_as;      /* what Ctrl+S writes */
} panel_host;

typedef struct panel panel;

bool   panel_is_built(void);

/* The host and what it points at are read at every picture, and stay until panel_close.
 * NULL: there is no panel in this build, or it could not be made. */
panel *panel_open(SDL_Window *window, SDL_Renderer *renderer, const panel_host *host);

/* Every event goes here first.  True: it was the panel's, and nobody else's. */
bool   panel_event(panel *p, const SDL_Event *event);

/* Between clearing and presenting: into this rectangle of the window.  NULL: it is
 * hidden; to be said once, so that it gives the keyboard back and measures nothing. */
void   panel_draw(panel *p, const SDL_Rect *where);

void   panel_scale(panel *p, float scale);      /* of letters, 1 = as designed */
void   panel_search(panel *p);                  /* the keyboard goes to its search */

/* The keyboard is the panel's: keys that are held down are not the picture's.  A key that
 * neither a field nor moving about in the panel wants is still told by panel_event. */
bool   panel_types(const panel *p);
void   panel_close(panel *p);

#ifdef __cplusplus
}
#endif
#endif
