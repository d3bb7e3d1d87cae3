/* SPDX-License-Identifier: MIT */
/* State of the preview (`tidepool view`), and the functions shared by its files:
 *
 *     view.c          the command and the main loop
 *     view_time.c     ticks, pause, rewinding, tapes
 *     view_scenes.c   the list of scenes, opening a scene
 *     view_changes.c  changing values, undo, saving, the session for --resume
 *     view_actions.c  what each action does
 *     view_picture.c  drawing the frame, comparing, filming, overlays
 *     view_panel.c    callbacks of the panel */
#ifndef TP_APP_PREVIEW_VIEW_H
#define TP_APP_PREVIEW_VIEW_H
#include "app/files/log.h"
#include "app/scene/frame_governor.h"
#include "app/scene/loaded_scene.h"
#include "app/scene/replay.h"
#include "app/scene/tape_file.h"
#include "app/session/actions.h"
#include "app/session/compare.h"
#include "app/session/performance_texts.h"
#include "app/session/recorder.h"
#include "app/session/rewind.h"
#include "app/session/session.h"
#include "app/session/undo.h"
#include "font.h"
#include "gamepad.h"
#include "interact/camera_mode.h"
#include "interact/poke.h"
#include "keymap.h"
#include "panel.h"
#include "user_input.h"
#include "window.h"

#define VIEW_SAID 256           /* bytes of a message over the picture */

/* Scenes offered for opening: the shipped scenes, then those of the current folder. */
typedef struct {
    char   **name;              /* name to pass to loaded_scene_open */
    char   **shows;
    char   **path;              /* path of the scene file */
    uint32_t count, at;         /* at: index of the open scene; count: not listed */
} view_scenes;

typedef struct view {
    options    *options;
    loaded_scene *loaded;       /* never moved: it has pointers into itself */
    tp_scene    filed;          /* the scene as its file has it */
    view_scenes scenes;
    char      **pictures;       /* PNG files offered as values of a row */
    size_t      picture_count;

    /* time */
    uint64_t    clock, owed;    /* clock: us; owed: ticks due, in 1/1000000 */
    uint32_t    picture;        /* frames since the scene was opened or restarted */
    uint64_t    base;           /* ticks made in replaced worlds of this scene */
    tp_input    next_input;     /* input of the next tick */
    poke_queue  pokes;          /* pokes for the next tick and later ticks */
    bool        paused;
    bool        changed;        /* scene or camera changed, other than by a tick */
    rewind_history *history;    /* NULL: out of memory */
    camera_mode camera_mode;
    tape_file   tape;           /* the tape being recorded; replay: the tape being played */
    replay      replay;
    bool        taping, playing;
    char        tape_name[TP_NAME_BYTES + 32];
    undo_edits  edits;
    char       *saved_as;       /* path used by "save" */

    /* the picture */
    bool        stale;          /* the picture is older than the world */
    frame_governor governor;
    comparison *compare;
    bool        chosen;         /* comparison renderer chosen by the person */
    performance *performance;
    performance_plan plan;
    panel_performance shown;
    panel_compare compared;
    recorder   *film;
    uint32_t    drawn;          /* frames drawn so far */
    uint64_t    title_at, kept_at, shown_at;    /* us */

    /* the window */
    window      window;
    user_input  control;
    keymap      keys;
    pad         pad;
    font       *font;
    panel      *panel;
    panel_host  host;
    int         scale;          /* window pixels per picture pixel */
    int         ui;             /* letter size, percent */
    bool        quit, help, sheet, full;    /* sheet: the figures over the picture are on */
    bool        measures, timed;    /* stage times: wanted by the panel; measured now */
    int         hidden_panel;   /* the panel's width before hiding, px */
    int         lively;         /* frames still to show although nothing has changed */
    char        said[VIEW_SAID];    /* message of the last change; "" if none */
    unsigned    said_count;     /* count of log_last at the time of `said` */
    uint64_t    said_at;        /* us */
    session    *session;
    uint64_t    filled_at;      /* us: last update of the panel's texts */
} view;

/* -- view_time.c --------------------------------------------------------------------- */

void view_advance(view *v, uint64_t now);       /* makes all ticks due */
void view_poke(view *v, const tp_push *push);   /* for the next tick with a free place */
void view_step(view *v);                        /* one frame forward */
void view_back(view *v);                        /* one frame back, if kept */
void view_restart(view *v);                     /* from tick 0; keeps the changes */
int  view_play(view *v, const char *name);      /* plays a tape from now on */
int  view_tape(view *v, const char *name);      /* records from now on; keeps `name` */
int  view_untape(view *v);

/* -- view_scenes.c ------------------------------------------------------------------- */

/* Opens a scene in place of the current one.  On failure nothing changes, and a message
 * gives the reason. */
bool view_open(view *v, const char *scene);
void view_step_scene(view *v, int by);          /* by: 1 next, -1 previous scene */
void view_list(view *v);                        /* fills v->scenes and v->pictures */
void view_unlist(view *v);

/* The scene differs from the drawn scene.  `opened`: the frame renderer was opened again
 * too. */
void view_refit(view *v, bool opened);

/* -- view_changes.c ------------------------------------------------------------------ */

/* Sets the value of a row from text.  `going` as in panel.h.  Returns false if refused;
 * a message has given the reason. */
bool view_set(view *v, uint32_t row, const char *text, bool going);
void view_undo(view *v, bool again);
void view_look(view *v, camera_mode_kind mode);
void view_begin_here(view *v);                  /* stores the camera's pose as camera.* */
void view_save(view *v);
void view_tape_changes(view *v);                /* records values unlike the file's */

/* Called before the first frame.  Opens `otherwise` if no session was kept. */
int  view_resume(view *v, const char *otherwise);
void view_keep(view *v, uint64_t now);

/* -- view_actions.c ------------------------------------------------------------------ */

void view_act(view *v, action what);
bool view_is_active(const view *v, action what);    /* true if switched on */
void view_say(view *v, const char *format, ...) LOG_PRINTF(2, 3);  /* on the picture */
void view_hush(view *v);                        /* removes the message */

/* -- view_picture.c ------------------------------------------------------------------ */

int  view_size(view *v);                        /* opens a renderer for the window's size */
int  view_draw(view *v);
void view_show(view *v, uint64_t now);
void view_save_shot(view *v);
void view_film(view *v, bool on);

/* -- view_panel.c -------------------------------------------------------------------- */

void view_panel_open(view *v);
void view_panel_fill(view *v, uint64_t now);    /* current values for the panel */
void view_panel_close(view *v);
int  view_panel_width(const view *v);           /* at the current letter size, px */
#endif
