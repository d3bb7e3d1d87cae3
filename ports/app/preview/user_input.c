/* SPDX-License-Identifier: MIT */
/* Converts events to input.  Keys are taken by scancode: WASD lies under the left hand
 * on every keyboard layout. */
#include "user_input.h"
#include <stdio.h>
#include "fixed/arithmetic.h"
#include "interact/input_merge.h"

/* DRAG: rotation per px of dragging.  DRAG_MAX px make 80 degrees, far from the wrap of
 * 32 bits. */
#define DRAG     ((int32_t)TP_DEG(0.2))
#define DRAG_MAX 400

#define NOTCH (12 * INPUT_RUN)   /* m per notch of the wheel: 3.2 */

static void window_event(user_input *c, const SDL_WindowEvent *event, uint64_t now)
{
    c->exposed = true;
    switch (event->event) {
    case SDL_WINDOWEVENT_SIZE_CHANGED:
        c->resized = true;
        c->resized_at = now;
        break;
    case SDL_WINDOWEVENT_MINIMIZED:
    case SDL_WINDOWEVENT_HIDDEN:
        c->hidden = true;
        break;
    case SDL_WINDOWEVENT_RESTORED:
    case SDL_WINDOWEVENT_SHOWN:
    case SDL_WINDOWEVENT_MAXIMIZED:
        c->hidden = false;
        break;
    case SDL_WINDOWEVENT_FOCUS_LOST:
        c->turning = c->stirring = false;
        break;
    default:
        break;
    }
}

static void add_place(user_input *c, int x, int y, bool stir)
{
    const int at = c->places < USER_INPUT_PLACES ? c->places++ : USER_INPUT_PLACES - 1;
    c->place[at] = (user_input_place){ x, y, stir };
}

static void press_button(user_input *c, const SDL_MouseButtonEvent *event)
{
    if (event->button == SDL_BUTTON_LEFT) {
        c->turning = true;
    } else if (event->button == SDL_BUTTON_RIGHT) {
        c->stirring = true;
        add_place(c, event->x, event->y, false);
    }
}

static void release_button(user_input *c, const SDL_MouseButtonEvent *event)
{
    if (event->button == SDL_BUTTON_LEFT)
        c->turning = false;
    else if (event->button == SDL_BUTTON_RIGHT)
        c->stirring = false;
}

static void moved(user_input *c, const SDL_MouseMotionEvent *event)
{
    if (c->turning || c->captured) {
        c->drag_x = tp_clamp(c->drag_x + event->xrel, -DRAG_MAX, DRAG_MAX);
        c->drag_y = tp_clamp(c->drag_y + event->yrel, -DRAG_MAX, DRAG_MAX);
    }
    if (c->stirring)
        add_place(c, event->x, event->y, true);
}

bool user_input_event(user_input *c, const SDL_Event *event, uint64_t now)
{
    switch (event->type) {
    case SDL_QUIT:            c->quit = true; break;
    case SDL_WINDOWEVENT:     window_event(c, &event->window, now); break;
    case SDL_MOUSEMOTION:     moved(c, &event->motion); break;
    case SDL_MOUSEBUTTONDOWN: press_button(c, &event->button); break;
    case SDL_MOUSEBUTTONUP:   release_button(c, &event->button); break;
    case SDL_MOUSEWHEEL:      c->wheel += event->wheel.y; break;
    case SDL_DROPFILE:
        snprintf(c->dropped, sizeof c->dropped, "%s", event->drop.file);
        SDL_free(event->drop.file);
        break;
    default:
        return false;
    }
    return true;
}

void user_input_capture(user_input *c, bool on)
{
    c->captured = SDL_SetRelativeMouseMode(on ? SDL_TRUE : SDL_FALSE) == 0 && on;
    c->drag_x = c->drag_y = 0;
}

/* -- input of a tick ----------------------------------------------------------------- */

typedef struct {
    const keymap  *keys;
    const uint8_t *down;
    SDL_Keymod     mod;
} held;

/* Returns +1, 0 or -1 from two opposite actions. */
static int axis(const held *h, action more, action less)
{
    return keymap_held(h->keys, more, h->down, h->mod)
         - keymap_held(h->keys, less, h->down, h->mod);
}

static tp_input input_of_keys(const held *h)
{
    const tp_fx step = keymap_held(h->keys, ACT_RUN, h->down, h->mod) ? INPUT_RUN
                                                                      : INPUT_WALK;
    return (tp_input){
        .forward = step * axis(h, ACT_FORWARD, ACT_BACKWARD),
        .strafe = step * axis(h, ACT_RIGHT, ACT_LEFT),
        .up = step * axis(h, ACT_UP, ACT_DOWN),
        .sphere_x = INPUT_STEER * axis(h, ACT_EAST, ACT_WEST),
        .sphere_z = INPUT_STEER * axis(h, ACT_SOUTH, ACT_NORTH),
        .throttle = INPUT_SAIL * axis(h, ACT_SAIL, ACT_BRAKE),
        .rudder = INPUT_RUDDER * axis(h, ACT_STARBOARD, ACT_PORT),
        .light_turn = INPUT_LIGHT * axis(h, ACT_LIGHT_RIGHT, ACT_LIGHT_LEFT),
        .light_tilt = INPUT_LIGHT * axis(h, ACT_LIGHT_UP, ACT_LIGHT_DOWN),
    };
}

tp_input user_input_read(user_input *c, const keymap *keys, const pad *stick, bool typing)
{
    const held h = { keys, SDL_GetKeyboardState(NULL), SDL_GetModState() };
    tp_input input = typing ? (tp_input){ 0 } : input_of_keys(&h);
    input.forward += NOTCH * tp_clamp(c->wheel, -8, 8);
    input.turn += DRAG * c->drag_x;
    input.tilt -= DRAG * c->drag_y;
    pad_input(stick, &input);
    c->wheel = c->drag_x = c->drag_y = 0;
    return input;
}
