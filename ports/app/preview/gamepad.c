/* SPDX-License-Identifier: MIT */
/* Sticks act as analog keys: at full deflection they move and turn as fast as a key
 * does. */
#include "gamepad.h"
#include <math.h>
#include "interact/input_merge.h"

/* Dead zones, of 32767: a released stick may rest anywhere within. */
#define STICK_DEAD   7200
#define TRIGGER_DEAD 2400

static const struct {
    SDL_GameControllerButton button;
    action                   asks;
} buttons[] = {
    { SDL_CONTROLLER_BUTTON_A,             ACT_DROP },
    { SDL_CONTROLLER_BUTTON_B,             ACT_PAUSE },
    { SDL_CONTROLLER_BUTTON_X,             ACT_CAMERA_ORBIT },
    { SDL_CONTROLLER_BUTTON_Y,             ACT_CAMERA_BOAT },
    { SDL_CONTROLLER_BUTTON_LEFTSHOULDER,  ACT_SLOWER },
    { SDL_CONTROLLER_BUTTON_RIGHTSHOULDER, ACT_FASTER },
    { SDL_CONTROLLER_BUTTON_START,         ACT_HELP },
    { SDL_CONTROLLER_BUTTON_BACK,          ACT_PANEL },
};

static bool is_its(const pad *p, SDL_JoystickID id)
{
    return p->pad
        && SDL_JoystickInstanceID(SDL_GameControllerGetJoystick(p->pad)) == id;
}

static void open_first(pad *p)
{
    const int count = SDL_NumJoysticks();
    for (int i = 0; i < count && !p->pad; i++)
        if (SDL_IsGameController(i))
            p->pad = SDL_GameControllerOpen(i);
}

action pad_event(pad *p, const SDL_Event *event)
{
    switch (event->type) {
    case SDL_CONTROLLERDEVICEADDED:
        open_first(p);
        break;
    case SDL_CONTROLLERDEVICEREMOVED:
        if (is_its(p, event->cdevice.which)) {
            pad_close(p);
            open_first(p);              /* continue with another gamepad */
        }
        break;
    case SDL_CONTROLLERBUTTONDOWN:
        for (size_t i = 0; i < SDL_arraysize(buttons); i++)
            if (is_its(p, event->cbutton.which)
                && event->cbutton.button == buttons[i].button)
                return buttons[i].asks;
        break;
    default:
        break;
    }
    return ACTIONS;
}

void pad_close(pad *p)
{
    if (p->pad)
        SDL_GameControllerClose(p->pad);
    p->pad = NULL;
}

/* -- sticks -------------------------------------------------------------------------- */

/* Returns 0 within the dead zone, then linear from its edge to 1 at full deflection. */
static double beyond(double way, double dead)
{
    return way <= dead ? 0 : fmin((way - dead) / (SDL_JOYSTICK_AXIS_MAX - dead), 1);
}

/* Reads a stick with axes `across` and `across` + 1.  The vector's length is 0..1; the
 * dead zone is circular, and the vector keeps the stick's direction. */
static void stick(const pad *p, SDL_GameControllerAxis across, double *x, double *y)
{
    const double u = SDL_GameControllerGetAxis(p->pad, across);
    const double v = SDL_GameControllerGetAxis(p->pad, across + 1);
    const double way = sqrt(u * u + v * v), of = beyond(way, STICK_DEAD);
    *x = of > 0 ? u / way * of : 0;
    *y = of > 0 ? v / way * of : 0;
}

static double trigger(const pad *p, SDL_GameControllerAxis axis)
{
    return beyond(SDL_GameControllerGetAxis(p->pad, axis), TRIGGER_DEAD);
}

static int32_t part(int32_t of, double share)
{
    return (int32_t)lround(of * share);
}

void pad_input(const pad *p, tp_input *input)
{
    double x, y;
    if (!p->pad)
        return;
    stick(p, SDL_CONTROLLER_AXIS_LEFTX, &x, &y);
    input->strafe += part(INPUT_WALK, x);
    input->forward -= part(INPUT_WALK, y);
    stick(p, SDL_CONTROLLER_AXIS_RIGHTX, &x, &y);
    input->turn += part(INPUT_TURN, x);
    input->tilt -= part(INPUT_TURN, y);
    input->up += part(INPUT_WALK, trigger(p, SDL_CONTROLLER_AXIS_TRIGGERRIGHT)
                                      - trigger(p, SDL_CONTROLLER_AXIS_TRIGGERLEFT));
}
