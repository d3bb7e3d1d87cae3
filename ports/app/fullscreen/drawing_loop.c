/* SPDX-License-Identifier: MIT */
/* The drawing loop.  Ticks of 1/60 s follow the clock, independent of the screen's rate.
 * A frame is drawn if a tick has changed the world and the screen is ready.  With
 * --frames each frame is shown, at 60 per second or slower.  Signals are unblocked only
 * while the loop waits.
 *
 * Time spent stopped or behind another terminal is not made up: if more than
 * TICKS_AT_ONCE ticks are due, the water slows down. */
#define _GNU_SOURCE             /* for ppoll */
#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include "app/files/hashes.h"
#include "app/files/log.h"
#include "app/files/timing.h"
#include "fullscreen.h"
#include "interact/input_merge.h"
#include "snapshot_thread.h"
#include "tidepool/modules.h"
#include "world/world.h"

#define TICKS_AT_ONCE 8
#define SECOND_US     1000000u
#define KEEP_US       1000000u
#define ESC_US        50000u    /* an Esc with no byte behind for this long is a key */
#define SIDE_HIGH     4096u
#define LOOK_FRAMES   64        /* skipped frames between looks at signals */

typedef struct {
    const show *what;
    screen     *on;
    console    *tty;
    terminal_keys keys;
    snapshot_thread *keeper;        /* NULL: only the final world is kept, or nothing */
    tp_input    next_input;         /* input of the next tick */
    uint64_t    clock, owed;        /* clock: us; owed: ticks due, in 1/1000000 */
    uint64_t    kept_at, key_at;    /* us */
    uint32_t    width, height;      /* of pictures, px */
    uint32_t    frame, kept;        /* frame number of the world; of the world on disk */
    bool        stale;              /* the screen is older than the world */
    bool        away;               /* another terminal is active */
    bool        over;
    int         code;               /* exit code of the tape; not EXIT_DONE: the tape
                                     * failed, and the loop ends */
} loop;

/* -- signals ------------------------------------------------------------------------- */

static volatile sig_atomic_t ended_by, asked_away, asked_back;

static void on_signal(int signal)
{
    if (signal == CONSOLE_AWAY)
        asked_away = 1;
    else if (signal == CONSOLE_BACK)
        asked_back = 1;
    else
        ended_by = signal;
}

static const int heard[] = { SIGINT, SIGTERM, SIGHUP, SIGQUIT, CONSOLE_AWAY, CONSOLE_BACK };

void loop_signals(sigset_t *set)
{
    sigemptyset(set);
    for (size_t i = 0; i < sizeof heard / sizeof *heard; i++)
        sigaddset(set, heard[i]);
}

static void listen_to_signals(void)
{
    struct sigaction act = { .sa_handler = on_signal };
    for (size_t i = 0; i < sizeof heard / sizeof *heard; i++)
        sigaction(heard[i], &act, NULL);
}

/* -- time ---------------------------------------------------------------------------- */

static bool act(loop *l)
{
    if (l->what->acts)
        l->code = l->what->acts(l->what->user);
    l->over = l->over || l->code;
    return !l->code;
}

/* One frame; its first tick takes the input. */
static void step(loop *l)
{
    static const tp_input nothing;
    const show *what = l->what;
    for (uint32_t n = act(l) ? tp_world_advance_clock(what->world) : 0; n > 0 && act(l);
         n--) {
        tp_world_step(&tp_program_all, what->world, what->scene,
                      what->taped ? what->taped(what->user) : &l->next_input);
        l->next_input = nothing;
    }
    l->frame++;
    l->stale = true;
}

static void tick(loop *l)
{
    const tp_input input = terminal_keys_input(&l->keys);
    input_merge(&l->next_input, &input);
    if (!l->keys.pause) {
        step(l);
    } else if (input_moves_camera(&input)) {
        tp_world_move_camera(l->what->world, &input);
        l->next_input = (tp_input){ 0 };
        l->stale = true;
    }
}

/* Makes the ticks due.  With --frames draws every frame and stops at the last one. */
static void advance(loop *l, uint64_t now)
{
    const show *what = l->what;
    l->owed += (now - l->clock) * TP_TICKS_PER_SECOND;
    l->clock = now;
    if (l->away)
        l->owed = 0;
    for (int i = 0; i < TICKS_AT_ONCE && l->owed >= SECOND_US; i++) {
        if (what->counted && (l->stale || l->frame >= what->last))
            break;
        tick(l);
        l->owed -= SECOND_US;
    }
    l->owed %= what->counted && l->stale ? 2 * SECOND_US : SECOND_US;
}

/* -- drawing ------------------------------------------------------------------------- */

/* Prepares pictures of the screen's current size. */
static int prepare(loop *l)
{
    const show *what = l->what;
    uint32_t width, height;
    what->port->size(l->on, &width, &height);
    width = width < SIDE_HIGH ? width : SIDE_HIGH;
    height = height < SIDE_HIGH ? height : SIDE_HIGH;
    if (width == l->width && height == l->height)
        return EXIT_DONE;
    l->width = width;
    l->height = height;
    l->stale = true;
    return what->prepare(what->user, width, height,
                         what->port->format ? what->port->format(l->on)
                                            : TP_FORMAT_XRGB8888);
}

static int draw(loop *l)
{
    const show *what = l->what;
    if (what->port->lacks && what->port->lacks(l->on))
        l->stale = true;        /* a monitor was plugged in */
    if (!l->stale || l->away || (what->port->ready && !what->port->ready(l->on)))
        return EXIT_DONE;
    const picture *p = what->draw(what->user, what->world, l->frame);
    const int code = what->port->show(l->on, p);
    l->stale = false;
    if (code)
        return code;
    if (what->hash) {
        hash_print(stdout, l->frame, picture_crc(p));
        fflush(stdout);
    }
    l->over = l->over || (what->counted && !what->hold && l->frame >= what->last);
    return EXIT_DONE;
}

/* -- signals, keys, device events ---------------------------------------------------- */

static int switch_console(loop *l)
{
    const screen_port *port = l->what->port;
    int code = EXIT_DONE;
    if (asked_away) {
        asked_away = 0;
        l->away = true;
        code = port->away ? port->away(l->on) : EXIT_DONE;
        console_give(l->tty);
    }
    if (asked_back && !code) {
        asked_back = 0;
        console_taken_back(l->tty);
        code = port->back ? port->back(l->on) : EXIT_DONE;
        l->away = false;
        l->stale = true;
    }
    return code;
}

/* Waits for an event, at most until the next tick. */
static int wait_events(loop *l)
{
    const screen_port *port = l->what->port;
    struct pollfd fds[CONSOLE_KEYS + 1];
    const int n = console_fds(l->tty, fds);
    const int event = port->fds ? port->fds(l->on) : -1;
    const uint64_t us = l->owed < SECOND_US ? (SECOND_US - l->owed) / TP_TICKS_PER_SECOND
                                            : 0;
    const struct timespec wait = { 0, (long)us * 1000 + 1000 };
    sigset_t open, closed;
    fds[n] = (struct pollfd){ .fd = event, .events = POLLIN };      /* not a key */
    sigprocmask(SIG_SETMASK, NULL, &open);
    for (size_t i = 0; i < sizeof heard / sizeof *heard; i++)
        sigdelset(&open, heard[i]);
    sigprocmask(SIG_SETMASK, &open, &closed);       /* opened briefly: ppoll delivers no */
    sigprocmask(SIG_SETMASK, &closed, NULL);        /* signal if an fd is always ready */
    const int came = ppoll(fds, (nfds_t)n + 1, &wait, &open);
    const uint64_t now = now_us();
    if (came > (fds[n].revents ? 1 : 0)) {
        console_read(l->tty, fds, n, &l->keys);
        l->key_at = now;
    } else if (now - l->key_at > ESC_US) {
        terminal_keys_flush(&l->keys);
    }
    if (l->keys.interrupt)
        ended_by = SIGINT;
    l->over = l->over || l->keys.quit || ended_by;
    const int code = switch_console(l);
    return code || came <= 0 || !fds[n].revents || !port->events ? code
                                                                 : port->events(l->on);
}

/* -- the loop ------------------------------------------------------------------------ */

static snapshot_progress place(const loop *l)
{
    const show *what = l->what;
    return (snapshot_progress){ l->frame, what->played ? what->played(what->user) : 0 };
}

static int turn(loop *l)
{
    int code = wait_events(l);
    if (!code)
        code = prepare(l);
    const uint64_t now = now_us();
    advance(l, now);
    if (!code && !l->over)
        code = draw(l);
    if (!code && l->frame != l->kept && now - l->kept_at >= KEEP_US) {
        l->kept_at = now;
        if (snapshot_thread_offer(l->keeper, l->what->world, place(l)))
            l->kept = l->frame;
    }
    return code;
}

/* Steps to the first frame without drawing. */
static int skip(loop *l)
{
    int code = EXIT_DONE;
    while (l->what->counted && l->frame < l->what->first && !l->over && !code) {
        step(l);
        if (l->frame % LOOK_FRAMES == 0)
            code = wait_events(l);
    }
    l->clock = l->kept_at = now_us();
    l->owed = 0;
    return code;
}

int loop_run(const show *what, screen *on, console *tty, const snapshot_store *kept,
             uint32_t frame, int *signal)
{
    loop l = { .what = what, .on = on, .tty = tty, .frame = frame, .kept = frame,
               .stale = true };
    snapshot_store last = *kept;
    listen_to_signals();
    l.keeper = kept->name ? snapshot_thread_begin(kept, what->world_bytes) : NULL;
    int code = prepare(&l);
    if (!code)
        code = console_take(tty);
    l.away = !console_front(tty);
    if (!code)
        code = skip(&l);
    while (!code && !l.over)
        code = turn(&l);
    last.failed = !snapshot_thread_end(l.keeper);
    const int end = snapshot_write(&last, what->world, what->world_bytes, place(&l));
    *signal = ended_by;
    code = code ? code : l.code;
    return code ? code : end;
}
