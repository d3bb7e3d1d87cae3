/* SPDX-License-Identifier: MIT */
/* Routing of keys and clicks between panel and picture. */
#include "panel_keys.h"
#include <string.h>

#define PATIENCE 8              /* frames a letter waits for its field */

bool panel_keys_types(const panel_keys *k)
{
    return k->searching || k->typing || k->writes;
}

/* -- keys for the panel -------------------------------------------------------------- */

/* True for a printable key; SDL sends its letter as a text event too. */
static bool is_plain(SDL_Keycode key)
{
    return key > SDLK_SPACE && key < SDLK_DELETE;
}

static bool moves_about(SDL_Keycode key)
{
    static const SDL_Keycode those[] = {
        SDLK_TAB, SDLK_UP, SDLK_DOWN, SDLK_LEFT, SDLK_RIGHT, SDLK_SPACE, SDLK_RETURN,
        SDLK_KP_ENTER, SDLK_PAGEUP, SDLK_PAGEDOWN, SDLK_HOME, SDLK_END,
    };
    for (size_t i = 0; i < SDL_arraysize(those); i++)
        if (those[i] == key)
            return true;
    return false;
}

static bool is_of_function(SDL_Scancode code)
{
    return (code >= SDL_SCANCODE_F1 && code <= SDL_SCANCODE_F12)
        || (code >= SDL_SCANCODE_F13 && code <= SDL_SCANCODE_F24);
}

static bool is_modifier(SDL_Scancode code)
{
    return code >= SDL_SCANCODE_LCTRL && code <= SDL_SCANCODE_RGUI;
}

/* True if an edited field uses the key: all keys but Ctrl+letter, plus its own Ctrl+A C
 * V X Z Y.  Ctrl+S and Ctrl+Q stay with the picture. */
static bool is_of_field(const SDL_Keysym *key)
{
    return !(key->mod & KMOD_CTRL) || !is_plain(key->sym)
        || strchr("acvxzy", (int)key->sym);
}

/* True if the panel takes a key press. */
static bool takes(panel_keys *k, const SDL_Keysym *key)
{
    if (k->leave || is_of_function(key->scancode) || is_modifier(key->scancode))
        return false;
    if (panel_keys_types(k) || (k->here && k->events > 0))
        return is_of_field(key);
    if (key->mod & (KMOD_CTRL | KMOD_ALT | KMOD_GUI))
        return false;
    if (key->sym == SDLK_ESCAPE)
        return k->here || k->open;
    if (key->sym == SDLK_TAB)
        k->here = true;
    return (k->here || k->open) && moves_about(key->sym);
}

/* -- the queue ----------------------------------------------------------------------- */

static void queue_event(panel_keys *k, const SDL_Event *event)
{
    if (k->events < PANEL_KEYS)
        k->event[k->events++] = *event;
}

static void wait_as(panel_keys *k, const SDL_Event *event, SDL_Scancode code,
                    SDL_Keycode sym)
{
    SDL_Event e = *event;
    e.key.keysym.scancode = code;
    e.key.keysym.sym = sym;
    queue_event(k, &e);
}

/* Queues a key press.  Tab becomes an arrow key, to move to the next widget out of a
 * field too. */
static void queue_key_press(panel_keys *k, const SDL_Event *event)
{
    const SDL_Keysym *const key = &event->key.keysym;
    if (event->key.repeat || (is_plain(key->sym) && !(key->mod & KMOD_CTRL)))
        return;
    if (key->sym == SDLK_TAB && (key->mod & KMOD_SHIFT))
        wait_as(k, event, SDL_SCANCODE_UP, SDLK_UP);
    else if (key->sym == SDLK_TAB)
        wait_as(k, event, SDL_SCANCODE_DOWN, SDLK_DOWN);
    else
        queue_event(k, event);
}

/* Queues the release of a key under every code its press may have been queued as. */
static void queue_key_release(panel_keys *k, const SDL_Event *event)
{
    const SDL_Keycode key = event->key.keysym.sym;
    if (key == SDLK_TAB) {
        wait_as(k, event, SDL_SCANCODE_UP, SDLK_UP);
        wait_as(k, event, SDL_SCANCODE_DOWN, SDLK_DOWN);
        return;
    }
    if (key == SDLK_RETURN || key == SDLK_KP_ENTER)
        wait_as(k, event, SDL_SCANCODE_SPACE, SDLK_SPACE);
    queue_event(k, event);
}

static bool key_event(panel_keys *k, const SDL_Event *event)
{
    if (event->type == SDL_KEYUP) {
        queue_key_release(k, event);
        return false;
    }
    k->taken = takes(k, &event->key.keysym);
    if (!k->taken)
        return false;
    if (event->key.keysym.sym == SDLK_ESCAPE && !k->open)
        k->leave = true;
    else
        queue_key_press(k, event);
    return true;
}

/* A letter belongs to the panel if its key press did.  The "/" that opens the search and
 * the blank that presses a button are not typed. */
static bool text_event(panel_keys *k, const SDL_Event *event)
{
    const char *const none = k->searching ? "/" : panel_keys_types(k) ? "" : " ";
    if (k->leave || (!panel_keys_types(k) && !k->taken))
        return false;
    if (strcmp(event->text.text, none) != 0)
        queue_event(k, event);
    return true;
}

/* Turns Enter into the space bar, Dear ImGui's key to press a button, unless the focus
 * is on a number or a field.  Done on leaving the queue: earlier events of the queue may
 * move the focus. */
static void turn_enter(const panel_keys *k, SDL_Event *event)
{
    SDL_Keysym *const key = &event->key.keysym;
    if (event->type != SDL_KEYDOWN || panel_keys_types(k) || k->on_number
        || (key->sym != SDLK_RETURN && key->sym != SDLK_KP_ENTER))
        return;
    key->scancode = SDL_SCANCODE_SPACE;
    key->sym = SDLK_SPACE;
}

void panel_keys_leave(panel_keys *k)
{
    uint32_t n = 0;
    for (uint32_t i = 0; i < k->events; i++)
        if (k->event[i].type == SDL_KEYUP)
            k->event[n++] = k->event[i];
    k->events = n;
    k->leave = k->here = k->searching = k->typing = k->writes = false;
}

void panel_keys_begin(panel_keys *k)
{
    k->up = k->down = false;
    k->waited++;
}

/* Gives several releases and letters per frame, or one key press.  A letter waits for
 * the focus of its field, but at most PATIENCE frames. */
bool panel_keys_next(panel_keys *k, SDL_Event *event)
{
    if (k->events == 0 || k->down)
        return false;
    const SDL_Event *const e = &k->event[0];
    if ((e->type == SDL_TEXTINPUT && !k->writes && k->waited < PATIENCE)
        || (e->type == SDL_KEYDOWN && k->up))
        return false;
    k->up |= e->type == SDL_KEYUP;
    k->down = e->type == SDL_KEYDOWN;
    k->waited = 0;
    *event = *e;
    turn_enter(k, event);
    k->events--;
    memmove(k->event, k->event + 1, k->events * sizeof *k->event);
    return true;
}

/* -- the mouse ----------------------------------------------------------------------- */

static bool has_pointer(const panel_keys *k, int x, int y)
{
    const SDL_Point at = { x, y };
    return SDL_PointInRect(&at, &k->where) || k->over;
}

/* A button pressed in the panel or in the picture keeps the mouse there until release. */
static bool mouse_event(panel_keys *k, const SDL_Event *event)
{
    int x, y;
    const uint32_t held = SDL_GetMouseState(&x, &y);
    if (SDL_GetRelativeMouseMode())
        return false;
    switch (event->type) {
    case SDL_MOUSEBUTTONDOWN:
        if ((held & ~(uint32_t)SDL_BUTTON(event->button.button)) == 0)
            k->held = has_pointer(k, event->button.x, event->button.y);
        k->leave |= !k->held && (k->here || k->writes);
        return k->held;
    case SDL_MOUSEBUTTONUP:
        return k->held;
    case SDL_MOUSEMOTION:
        return held ? k->held : has_pointer(k, event->motion.x, event->motion.y);
    default:
        return held ? k->held : has_pointer(k, x, y);
    }
}

bool panel_keys_event(panel_keys *k, const SDL_Event *event)
{
    switch (event->type) {
    case SDL_KEYDOWN:
    case SDL_KEYUP:
        return key_event(k, event);
    case SDL_TEXTINPUT:
        return text_event(k, event);
    case SDL_MOUSEMOTION:
    case SDL_MOUSEBUTTONDOWN:
    case SDL_MOUSEBUTTONUP:
    case SDL_MOUSEWHEEL:
        return mouse_event(k, event);
    default:
        return false;
    }
}
