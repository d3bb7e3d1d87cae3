/* SPDX-License-Identifier: MIT */
/* Events to wishes.  Keys are taken by their place on the keyboard, so that WASD lies
 * under the left hand on every layout. */
#include "control.h"
#include <stdio.h>
#include "../live/wish.h"

/* Of a pixel dragged; 400 of them are 80 degrees, far from where 32 bits wrap. */
#define DRAG     ((int32_t)TP_DEG(0.2))
#define DRAG_MAX 400

static void print_keys(void)
{
    puts("W A S D        forward, left, back, right      Shift  faster\n"
         "Q E            down, up\n"
         "arrows         turn and tilt, as dragging with the left mouse button does\n"
         "F              let a drop fall\n"
         "I J K L        steer the sphere of drops, or the boat\n"
         "right button   poke the pool\n"
         "[ ]            turn the light;  Page Up, Page Down  raise and lower it\n"
         ", .            slow motion, fast forward\n"
         "Space          pause: the water stands, the camera moves on\n"
         "P or F12       save a screenshot in the current folder\n"
         "F1             this list\n"
         "Esc            quit");
    fflush(stdout);
}

static void key(control *c, const SDL_KeyboardEvent *event)
{
    if (event->repeat)
        return;
    switch (event->keysym.sym) {
    case SDLK_ESCAPE: c->quit = true; break;
    case SDLK_SPACE:  c->pause = !c->pause; break;
    case SDLK_f:      c->drops++; break;
    case SDLK_COMMA:  c->slower++; break;
    case SDLK_PERIOD: c->slower--; break;
    case SDLK_p:
    case SDLK_F12:    c->shot = true; break;
    case SDLK_F1:     print_keys(); break;
    default:          break;
    }
}

static void window_event(control *c, const SDL_WindowEvent *event, uint64_t now)
{
    c->exposed = true;
    if (event->event != SDL_WINDOWEVENT_SIZE_CHANGED)
        return;
    c->resized = true;
    c->resized_at = now;
    c->width = event->data1;
    c->height = event->data2;
}

void control_event(control *c, const SDL_Event *event, uint64_t now)
{
    switch (event->type) {
    case SDL_QUIT:        c->quit = true; break;
    case SDL_KEYDOWN:     key(c, &event->key); break;
    case SDL_WINDOWEVENT: window_event(c, &event->window, now); break;
    case SDL_MOUSEMOTION:
        if (event->motion.state & SDL_BUTTON_LMASK) {
            c->drag_x = tp_clamp(c->drag_x + event->motion.xrel, -DRAG_MAX, DRAG_MAX);
            c->drag_y = tp_clamp(c->drag_y + event->motion.yrel, -DRAG_MAX, DRAG_MAX);
        }
        break;
    case SDL_MOUSEBUTTONDOWN:
        if (event->button.button == SDL_BUTTON_RIGHT) {
            c->poke = true;
            c->poke_x = event->button.x;
            c->poke_y = event->button.y;
        }
        break;
    default:
        break;
    }
}

/* +1, 0 or -1 by two keys. */
static int axis(const uint8_t *keys, SDL_Scancode more, SDL_Scancode less)
{
    return keys[more] - keys[less];
}

tp_input control_input(control *c)
{
    const uint8_t *keys = SDL_GetKeyboardState(NULL);
    const tp_fx step = SDL_GetModState() & KMOD_SHIFT ? WISH_RUN : WISH_WALK;
    const tp_input input = {
        .ahead = step * axis(keys, SDL_SCANCODE_W, SDL_SCANCODE_S),
        .aside = step * axis(keys, SDL_SCANCODE_D, SDL_SCANCODE_A),
        .up    = step * axis(keys, SDL_SCANCODE_E, SDL_SCANCODE_Q),
        .turn  = WISH_TURN * axis(keys, SDL_SCANCODE_RIGHT, SDL_SCANCODE_LEFT)
               + DRAG * c->drag_x,
        .tilt  = WISH_TURN * axis(keys, SDL_SCANCODE_UP, SDL_SCANCODE_DOWN)
               - DRAG * c->drag_y,
        .sphere_x = WISH_STEER * axis(keys, SDL_SCANCODE_L, SDL_SCANCODE_J),
        .sphere_z = WISH_STEER * axis(keys, SDL_SCANCODE_K, SDL_SCANCODE_I),
        .throttle = WISH_SAIL * axis(keys, SDL_SCANCODE_I, SDL_SCANCODE_K),
        .rudder   = WISH_RUDDER * axis(keys, SDL_SCANCODE_L, SDL_SCANCODE_J),
        .light_turn = WISH_LIGHT * axis(keys, SDL_SCANCODE_RIGHTBRACKET,
                                   SDL_SCANCODE_LEFTBRACKET),
        .light_tilt = WISH_LIGHT * axis(keys, SDL_SCANCODE_PAGEUP, SDL_SCANCODE_PAGEDOWN),
        .drops    = c->drops,
        .slower   = c->slower,
    };
    c->drag_x = 0;
    c->drag_y = 0;
    c->drops = 0;
    c->slower = 0;
    return input;
}
