/* SPDX-License-Identifier: MIT */
/* The panel in a window of its own, for tests/host/panel.sh and for a person:
 *     panel_demo [--window WxH] [--panel PX] [--scale F] [--frames N] [--shot PNG]
 *                [--search WORDS] [--times]
 *     panel_demo --has            exit code: 0 if this build has a panel
 *
 * The host has a scene's values in the real table; all else is made up.  Prints each
 * request of the panel on a line, each key and click the panel leaves to the picture,
 * and with --times the time of a panel_draw call. */
#define _POSIX_C_SOURCE 200809L
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include "../../ports/app/session/actions.h"
#include "../../ports/app/files/picture.h"
#include "../../ports/app/preview/panel.h"
#include "world/text.h"

enum { ROWS = 512, TIMES = 4096 };

typedef struct {
    tp_scene    scene, filed, normal;
    panel_row   row[ROWS];
    char        defaults[ROWS][32];
    panel_host  host;
    panel_performance performance;
    panel_compare compare;
    bool        on[ACTIONS];
    char        message[256];
    bool        stop;
    double      ms[TIMES];
    uint32_t    drawn;
} demo;

/* -- values ---------------------------------------------------------------------- */

static const tp_param *param(uint32_t row)
{
    uint32_t count;
    return tp_params(&count) + row;
}

static void get(void *user, uint32_t row, char text[PANEL_TEXT])
{
    tp_param_text(&((demo *)user)->scene, param(row), text, PANEL_TEXT);
}

static bool is_alike(const tp_scene *a, const tp_scene *b, uint32_t row)
{
    char x[PANEL_TEXT], y[PANEL_TEXT];
    tp_param_text(a, param(row), x, sizeof x);
    tp_param_text(b, param(row), y, sizeof y);
    return strcmp(x, y) == 0;
}

static bool is_normal(void *user, uint32_t row)
{
    const demo *const d = user;
    return is_alike(&d->scene, &d->normal, row);
}

static bool is_filed(void *user, uint32_t row)
{
    const demo *const d = user;
    return is_alike(&d->scene, &d->filed, row);
}

static bool set(void *user, uint32_t row, const char *text, bool going)
{
    demo *const d = user;
    const char *const name = param(row)->name;
    tp_error err;
    if (tp_param_set(&d->scene, param(row), text, strlen(text), &err) != TP_OK) {
        snprintf(d->message, sizeof d->message, "%s: not %s", name, text);
        printf("refused %s=%s\n", name, text);
        return false;
    }
    snprintf(d->message, sizeof d->message, "%s is %s", name, text);
    printf("set %s=%s%s\n", name, text, going ? " ..." : "");
    return true;
}

static void reset(void *user, uint32_t row)
{
    demo *const d = user;
    char text[PANEL_TEXT];
    tp_error err;
    const tp_scene *const to = is_filed(d, row) ? &d->normal : &d->filed;
    tp_param_text(to, param(row), text, sizeof text);
    tp_param_set(&d->scene, param(row), text, strlen(text), &err);
    printf("reset %s\n", param(row)->name);
}

static panel_kind kind_of(const tp_param *p)
{
    switch (p->kind) {
    case TP_PARAM_FX:     return PANEL_NUMBER;
    case TP_PARAM_INT:    return PANEL_COUNT;
    case TP_PARAM_BOOL:   return PANEL_SWITCH;
    case TP_PARAM_COLOUR: return PANEL_COLOUR;
    case TP_PARAM_CHOICE: return PANEL_CHOICE;
    case TP_PARAM_MESH:   return PANEL_MESH;
    case TP_PARAM_TEXT:   return PANEL_WORDS;
    default:              return PANEL_PICTURE;
    }
}

static void make_rows(demo *d)
{
    const tp_param *p = tp_params(&d->host.rows);
    for (uint32_t i = 0; i < d->host.rows && i < ROWS; i++, p++) {
        const double one = p->kind == TP_PARAM_FX ? 65536 : 1;
        tp_param_text(&d->normal, p, d->defaults[i], sizeof d->defaults[i]);
        d->row[i] = (panel_row){ p->name, p->unit, p->help, kind_of(p), p->low / one,
                                 p->high / one, d->defaults[i] };
    }
    d->host.row = d->row;
}

/* -- other callbacks ------------------------------------------------------------- */

static const char *const scenes[] = { "three-swells", "storm", "tank" };
static const char *const shows[] = {
    "three swells cross under a clear sky",
    "waves of nine metres before a gale, and a longship that has to live through it",
    "a glass tank whose floor is tiled",
};
static const char *const pictures[] = { "foam.png", "ripples.png", "sand.png" };

static void open_scene(void *user, uint32_t scene)
{
    demo *const d = user;
    tp_error err;
    d->host.scene = scene;
    d->scene = d->normal;
    if (scene == 0) {
        const tp_param *const x = tp_param_find("wave0.amplitude", 15);
        const tp_param *const y = tp_param_find("camera.y", 8);
        tp_param_set(&d->scene, x, "0.6", 3, &err);
        tp_param_set(&d->scene, y, "6", 1, &err);
    }
    d->filed = d->scene;
    printf("open %s\n", scenes[scene]);
}

static void act(void *user, int what)
{
    demo *const d = user;
    d->on[what] = !d->on[what];
    printf("act %s\n", actions[what].name);
}

static const char *keys(void *user, int what)
{
    (void)user;
    return actions[what].keys;
}

static bool is_on(void *user, int what)
{
    return ((const demo *)user)->on[what]
        && (what == ACT_PAUSE || what == ACT_FILM || what == ACT_TAPE);
}

static bool measures(void *user, bool on)
{
    demo *const d = user;
    d->performance.stage_count = on ? 3 : 0;
    printf("measures %s\n", on ? "on" : "off");
    return true;
}

static void make_figures(demo *d)
{
    panel_performance *const f = &d->performance;
    static const panel_time parts[] = {
        { "water moves", 812, 0.12f }, { "plan", 64, 0.01f }, { "vertices", 930, 0.14f },
        { "pixels", 4410, 0.66f }, { "window", 455, 0.07f },
    };
    static const panel_time stages[] = {
        { "light", 1620, 0.37f }, { "layers", 1240, 0.28f }, { "ripples", 730, 0.17f },
    };
    memcpy(f->parts, parts, sizeof parts);
    memcpy(f->stages, stages, sizeof stages);
    f->part_count = 5;
    f->limit_ms = 1000.0f / 60;
    f->median_ms = 6.7f;
    f->shown_per_s = 60;
    f->latency_ms = 21;
    f->ram = "world\t182,336\nframe\t1,204,992\ntextures\t262,144\npast\t8,388,608";
    f->plan = "visibility\trows\tnearer than half a pixel\nshading\tquick\tone light\n"
              "rate\tlayers\t2.0 levels off";
    f->state = "tick 1234, clock 1/2, orbit; tape of 20.5 s";
    d->compare = (panel_compare){ "split", "exact", 41.7, "" };
}

/* Adds an invented frame time. */
static void age(panel_performance *f)
{
    memmove(f->history, f->history + 1, sizeof f->history - sizeof *f->history);
    f->history[PANEL_HISTORY - 1] = 7 + 4 * sinf((float)f->pictures * 0.13f)
                                  + (f->pictures % 50 == 0 ? 9.0f : 0.0f);
    f->pictures++;
}

/* -- window ---------------------------------------------------------------------- */

static void shoot(SDL_Renderer *renderer, const char *name)
{
    int w, h;
    SDL_GetRendererOutputSize(renderer, &w, &h);
    uint32_t *const rows = calloc((size_t)w * (size_t)h, 4);
    picture p = { TP_FORMAT_XRGB8888, (uint32_t)w, (uint32_t)h, (size_t)w * 4,
                  (uint8_t *)rows };
    if (rows && SDL_RenderReadPixels(renderer, NULL, SDL_PIXELFORMAT_ARGB8888, rows,
                                     w * 4) == 0
        && picture_write_png(&p, name) == 0)
        printf("shot %s\n", name);
    free(rows);
}

static void tell(const SDL_Event *e)
{
    if (e->type == SDL_KEYDOWN && !e->key.repeat)
        printf("left key %s\n", SDL_GetKeyName(e->key.keysym.sym));
    if (e->type == SDL_MOUSEBUTTONDOWN)
        printf("left click %d,%d\n", e->button.x, e->button.y);
}

static void events(demo *d, panel *p, SDL_Rect *where, bool *hidden)
{
    SDL_Event e;
    while (SDL_PollEvent(&e)) {
        const bool taken = panel_event(p, &e);
        d->stop |= e.type == SDL_QUIT;
        if (e.type == SDL_WINDOWEVENT && e.window.event == SDL_WINDOWEVENT_SIZE_CHANGED) {
            where->x = e.window.data1 - where->w;
            where->h = e.window.data2;
        }
        if (taken)
            continue;
        tell(&e);
        if (e.type != SDL_KEYDOWN)
            continue;
        const SDL_Keycode key = e.key.keysym.sym;
        d->stop |= key == SDLK_ESCAPE;
        *hidden ^= key == SDLK_F2;
        if (key == SDLK_F3 || key == SDLK_SLASH)
            panel_search(p);
    }
}

static int by_size(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double now_ms(void)
{
    struct timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return (double)t.tv_sec * 1e3 + (double)t.tv_nsec / 1e6;
}

static void frame(demo *d, panel *p, SDL_Renderer *renderer, const SDL_Rect *where)
{
    SDL_SetRenderDrawColor(renderer, 58, 110, 165, 255);
    SDL_RenderClear(renderer);
    SDL_RenderFlush(renderer);
    const double start = now_ms();
    panel_draw(p, where);
    SDL_RenderFlush(renderer);
    d->ms[d->drawn++ % TIMES] = now_ms() - start;
    age(&d->performance);
}

static void print_times(demo *d)
{
    const size_t n = d->drawn < TIMES ? d->drawn : TIMES;
    qsort(d->ms, n, sizeof *d->ms, by_size);
    if (n > 0)
        printf("panel_draw %.3f ms, 90%% below %.3f\n", d->ms[n / 2], d->ms[n * 9 / 10]);
}

typedef struct {
    int         wide, high, panel, frames;
    float       scale;
    const char *shot, *search;
    bool        times;
} demo_wishes;

static demo_wishes read_wishes(char **arg)
{
    demo_wishes w = { 960, 600, 320, 0, 1, NULL, NULL, false };
    for (arg++; *arg; arg++) {
        const char *const value = arg[1];
        if (strcmp(*arg, "--times") == 0) {
            w.times = true;
            continue;
        }
        if (!value)
            break;
        if (strcmp(*arg, "--window") == 0)
            sscanf(value, "%dx%d", &w.wide, &w.high);
        else if (strcmp(*arg, "--panel") == 0)
            w.panel = atoi(value);
        else if (strcmp(*arg, "--scale") == 0)
            w.scale = strtof(value, NULL);
        else if (strcmp(*arg, "--frames") == 0)
            w.frames = atoi(value);
        else if (strcmp(*arg, "--shot") == 0)
            w.shot = value;
        else if (strcmp(*arg, "--search") == 0)
            w.search = value;
        arg++;
    }
    return w;
}

static void type(panel *p, const char *words)
{
    for (; *words; words++) {
        SDL_Event e = { .type = SDL_TEXTINPUT };
        e.text.text[0] = *words;
        panel_event(p, &e);
    }
}

static void run(demo *d, SDL_Window *window, SDL_Renderer *renderer, const demo_wishes *w)
{
    SDL_Rect where = { w->wide - w->panel, 0, w->panel, w->high };
    bool hidden = false;
    panel *const p = panel_open(window, renderer, &d->host);
    if (!p) {
        puts("no panel");
        return;
    }
    panel_scale(p, w->scale);
    puts("ready");
    for (int i = 0; !d->stop && (w->frames == 0 || i < w->frames); i++) {
        events(d, p, &where, &hidden);
        if (i == 1 && w->search) {
            panel_search(p);
            type(p, w->search);
        }
        frame(d, p, renderer, hidden ? NULL : &where);
        if (w->shot && i == w->frames - 1)
            shoot(renderer, w->shot);
        SDL_RenderPresent(renderer);
        SDL_Delay(w->times ? 0 : 8);
    }
    if (w->times)
        print_times(d);
    panel_close(p);
}

int main(int count, char **arg)
{
    static demo d;
    const demo_wishes w = read_wishes(arg);
    if (count > 1 && strcmp(arg[1], "--has") == 0)
        return panel_is_built() ? 0 : 1;
    setvbuf(stdout, NULL, _IOLBF, 0);
    tp_scene_level(&d.normal);
    d.host = (panel_host){
        .user = &d, .get = get, .is_normal = is_normal, .is_filed = is_filed, .set = set,
        .reset = reset, .scenes = scenes, .shows = shows, .scene_count = 3,
        .open = open_scene, .pictures = pictures, .picture_count = 3, .act = act,
        .keys = keys, .is_on = is_on, .performance = &d.performance, .compare = &d.compare,
        .measures = measures, .message = d.message, .saved_as = "./three-swells.ini",
    };
    make_rows(&d);
    open_scene(&d, 0);
    make_figures(&d);
    SDL_SetMainReady();
    if (SDL_Init(SDL_INIT_VIDEO) != 0)
        return 3;
    SDL_Window *const window = SDL_CreateWindow("panel demo", 0, 0, w.wide, w.high,
                                                SDL_WINDOW_RESIZABLE);
    SDL_Renderer *const renderer = window ? SDL_CreateRenderer(window, -1, 0) : NULL;
    if (renderer)
        run(&d, window, renderer, &w);
    SDL_DestroyRenderer(renderer);
    SDL_DestroyWindow(window);
    SDL_Quit();
    return renderer ? 0 : 3;
}
