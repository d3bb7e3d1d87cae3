/* SPDX-License-Identifier: MIT */
/* The preview's state, and what its files do for each other:
 *
 *     view.c          the command, and the loop
 *     view_time.c     ticks, pause, rewinding, tapes
 *     view_scenes.c   scenes listed and opened
 *     view_change.c   values changed, undone, saved, kept and resumed
 *     view_act.c      what an action does
 *     view_picture.c  the picture, drawn, compared, filmed and shown with what lies on it
 *     view_panel.c    what the panel asks for */
#ifndef SDL2_VIEW_H
#define SDL2_VIEW_H
#include "../host/actions.h"
#include "../host/compare.h"
#include "../host/deck.h"
#include "../host/figures_texts.h"
#include "../host/governing.h"
#include "../host/past.h"
#include "../host/recorder.h"
#include "../host/replay.h"
#include "../host/session.h"
#include "../host/stage.h"
#include "../host/undo.h"
#include "../live/look.h"
#include "../live/poke.h"
#include "control.h"
#include "keymap.h"
#include "letters.h"
#include "pad.h"
#include "panel.h"
#include "window.h"

#define VIEW_SAID 256           /* bytes of a message over the picture */

/* What can be opened: shipped scenes, then the current folder's. */
typedef struct {
    char   **name;              /* as stage_open takes it */
    char   **shows;
    char   **path;              /* of the file */
    uint32_t count, at;         /* at: the one that is shown, or count */
} view_scenes;

typedef struct view {
    options    *options;
    stage      *stage;          /* never moved: what it names points into it */
    tp_scene    filed;          /* as the scene's file has it */
    view_scenes scenes;
    char      **pictures;       /* PNGs that a row can take */
    size_t      picture_count;

    /* time */
    uint64_t    clock, owed;    /* us; ticks not yet made, in 1/1000000 */
    uint32_t    picture;        /* since the scene was opened or restarted */
    uint64_t    base;           /* ticks of worlds that have been made anew since then */
    tp_input    wish;           /* for the next tick ... */
    poke_queue  pokes;          /* ... and for it and those after it */
    bool        paused;
    bool        changed;        /* since the last picture: scene or camera, untapedly */
    past       *past;           /* NULL: no memory for it */
    look        look;
    deck        tape;           /* that is recorded; and one that plays */
    replay      replay;
    bool        taping, playing;
    char        tape_name[TP_NAME_BYTES + 32];
    edits       edits;
    char       *saved_as;       /* what saving writes */

    /* the picture */
    bool        stale;          /* it is older than the world */
    governing   governing;
    compare    *compare;
    bool        chosen;         /* with what: by a person */
    figures    *figures;
    figures_plan plan;
    panel_figures  shown;
    panel_compare  compared;
    recorder   *film;
    uint32_t    drawn;          /* pictures */
    uint64_t    title_at, kept_at, shown_at;    /* us */

    /* the window */
    window      window;
    control     control;
    keymap      keys;
    pad         pad;
    letters    *letters;
    panel      *panel;
    panel_host  host;
    int         scale;          /* of a pixel */
    int         ui;             /* size of letters, percent */
    bool        quit, help, sheet, full;    /* sheet: figures on the picture */
    bool        measures, timed;    /* stages: wished by the panel, and now */
    int         hidden_panel;   /* the panel's width before it was hidden, px */
    int         lively;         /* pictures to be shown though nothing has changed */
    char        said[VIEW_SAID];    /* of the last action or value, "" nothing */
    unsigned    said_count;     /* of say_last, when that was taken */
    uint64_t    said_at;        /* us */
    session    *session;
    uint64_t    filled_at;      /* us, of the panel's texts */
} view;

/* -- view_time.c ------------------------------------------------------------------- */

void view_advance(view *v, uint64_t now);       /* as many ticks as are due */
void view_poke(view *v, const tp_push *push);   /* with the next tick that has room */
void view_step(view *v);                        /* one picture further */
void view_back(view *v);                        /* one picture back, if it is kept */
void view_restart(view *v);                     /* from tick 0, with the changes */
int  view_play(view *v, const char *name);      /* a tape, from here on */
int  view_tape(view *v, const char *name);      /* records one, from here on; it stays */
void view_tape_changes(view *v);                /* what is not as the scene's file says */
int  view_untape(view *v);

/* -- view_scenes.c ----------------------------------------------------------------- */

/* Opens it in place of what is shown; if that fails nothing changes, and it was said. */
bool view_open(view *v, const char *scene);
void view_turn_to(view *v, int by);             /* the next scene of the list, or -1 */
void view_list(view *v);                        /* fills v->scenes and v->pictures */
void view_unlist(view *v);

/* The scene is another one than was drawn; `opened`: and so is the canvas. */
void view_refit(view *v, bool opened);

/* -- view_change.c ----------------------------------------------------------------- */

/* A value, as text; `going` as in panel.h.  False: refused, and said why. */
bool view_set(view *v, uint32_t row, const char *text, bool going);
void view_undo(view *v, bool again);
void view_look(view *v, look_mode mode);
void view_begin_here(view *v);                  /* camera.* is where the camera is */
void view_save(view *v);

/* Before the first picture; opens `otherwise` if nothing was kept. */
int  view_resume(view *v, const char *otherwise);
void view_keep(view *v, uint64_t now);

/* -- view_act.c -------------------------------------------------------------------- */

void view_act(view *v, action what);
bool view_is_on(const view *v, action what);    /* what is switched on */
void view_say(view *v, const char *format, ...) HOST_PRINTF(2, 3);  /* on the picture
                                                            for a while, and in the panel */
void view_hush(view *v);                        /* what was said is of no use any more */

/* -- view_picture.c ---------------------------------------------------------------- */

int  view_size(view *v);                        /* a canvas for the window as it is */
int  view_draw(view *v);
void view_show(view *v, uint64_t now);
void view_save_shot(view *v);
void view_film(view *v, bool on);

/* -- view_panel.c ------------------------------------------------------------------ */

void view_panel_open(view *v);
void view_panel_fill(view *v, uint64_t now);    /* what it shows of this moment */
void view_panel_close(view *v);
int  view_panel_width(const view *v);           /* as designed, px */
#endif
