/* SPDX-License-Identifier: MIT */
/* A virtual gamepad by SDL: sticks, triggers, buttons, plugging. */
#define _POSIX_C_SOURCE 200809L
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <stdlib.h>
#include <cmocka.h>
#include "../../ports/interact/input_merge.h"
#include "../../ports/app/preview/gamepad.h"

static pad p;
static int device = -1;
static SDL_Joystick *stick;

/* Handles the waiting events.  Returns the last action. */
static action events(void)
{
    SDL_Event event;
    action last = ACTIONS;
    SDL_JoystickUpdate();
    while (SDL_PollEvent(&event)) {
        const action asked = pad_event(&p, &event);
        last = asked < ACTIONS ? asked : last;
    }
    return last;
}

static int plug(void)
{
    return SDL_JoystickAttachVirtual(SDL_JOYSTICK_TYPE_GAMECONTROLLER,
                                     SDL_CONTROLLER_AXIS_MAX, SDL_CONTROLLER_BUTTON_MAX, 0);
}

static int begin(void **state)
{
    (void)state;
    device = plug();
    events();
    if (device < 0 || !p.pad)
        return -1;
    stick = SDL_GameControllerGetJoystick(p.pad);
    SDL_JoystickSetVirtualAxis(stick, SDL_CONTROLLER_AXIS_TRIGGERLEFT, INT16_MIN);
    SDL_JoystickSetVirtualAxis(stick, SDL_CONTROLLER_AXIS_TRIGGERRIGHT, INT16_MIN);
    events();
    return 0;
}

static int end(void **state)
{
    (void)state;
    while (SDL_NumJoysticks() > 0)
        SDL_JoystickDetachVirtual(0);
    events();
    pad_close(&p);
    return 0;
}

static tp_input pushed(SDL_GameControllerAxis axis, int to, SDL_GameControllerAxis also,
                       int also_to)
{
    tp_input input = { 0 };
    SDL_JoystickSetVirtualAxis(stick, axis, (int16_t)to);
    SDL_JoystickSetVirtualAxis(stick, also, (int16_t)also_to);
    events();
    pad_input(&p, &input);
    SDL_JoystickSetVirtualAxis(stick, axis, 0);
    SDL_JoystickSetVirtualAxis(stick, also, 0);
    return input;
}

static action button(SDL_GameControllerButton of)
{
    SDL_JoystickSetVirtualButton(stick, of, 1);
    const action asked = events();
    SDL_JoystickSetVirtualButton(stick, of, 0);
    assert_int_equal(events(), ACTIONS);
    return asked;
}

static void the_left_stick_walks(void **state)
{
    (void)state;
    tp_input input = pushed(SDL_CONTROLLER_AXIS_LEFTY, INT16_MIN,
                            SDL_CONTROLLER_AXIS_LEFTX, 0);
    assert_int_equal(input.forward, INPUT_WALK);
    assert_int_equal(input.strafe, 0);
    assert_int_equal(input.turn | input.tilt | input.up, 0);
    input = pushed(SDL_CONTROLLER_AXIS_LEFTY, INT16_MAX, SDL_CONTROLLER_AXIS_LEFTX, 0);
    assert_int_equal(input.forward, -INPUT_WALK);
    input = pushed(SDL_CONTROLLER_AXIS_LEFTY, 0, SDL_CONTROLLER_AXIS_LEFTX, INT16_MAX);
    assert_int_equal(input.strafe, INPUT_WALK);
}

static void a_corner_is_no_faster(void **state)
{
    (void)state;
    const tp_input input = pushed(SDL_CONTROLLER_AXIS_LEFTY, INT16_MIN,
                                  SDL_CONTROLLER_AXIS_LEFTX, INT16_MAX);
    assert_in_range(input.forward, INPUT_WALK * 70 / 100, INPUT_WALK * 71 / 100);
    assert_in_range(input.strafe, INPUT_WALK * 70 / 100, INPUT_WALK * 71 / 100);
}

static void the_right_stick_turns(void **state)
{
    (void)state;
    tp_input input = pushed(SDL_CONTROLLER_AXIS_RIGHTX, INT16_MAX,
                            SDL_CONTROLLER_AXIS_RIGHTY, 0);
    assert_int_equal(input.turn, INPUT_TURN);
    assert_int_equal(input.forward | input.strafe | input.up | input.tilt, 0);
    input = pushed(SDL_CONTROLLER_AXIS_RIGHTX, 0, SDL_CONTROLLER_AXIS_RIGHTY, INT16_MIN);
    assert_int_equal(input.tilt, INPUT_TURN);
    input = pushed(SDL_CONTROLLER_AXIS_RIGHTX, INT16_MIN, SDL_CONTROLLER_AXIS_RIGHTY, 0);
    assert_int_equal(input.turn, -INPUT_TURN);
}

static void sticks_that_are_let_go_do_nothing(void **state)
{
    const tp_input none = { 0 };
    (void)state;
    tp_input input = pushed(SDL_CONTROLLER_AXIS_LEFTX, 5000,
                            SDL_CONTROLLER_AXIS_LEFTY, -5000);
    assert_memory_equal(&input, &none, sizeof none);
    input = pushed(SDL_CONTROLLER_AXIS_RIGHTX, -7000, SDL_CONTROLLER_AXIS_RIGHTY, 0);
    assert_memory_equal(&input, &none, sizeof none);
    input = pushed(SDL_CONTROLLER_AXIS_LEFTX, 7600, SDL_CONTROLLER_AXIS_LEFTY, 0);
    assert_in_range(input.strafe, 1, INPUT_WALK / 32); /* no step at the dead zone's edge */
    input = pushed(SDL_CONTROLLER_AXIS_LEFTX, 20000, SDL_CONTROLLER_AXIS_LEFTY, 0);
    assert_in_range(input.strafe, INPUT_WALK * 49 / 100, INPUT_WALK * 51 / 100);
}

static void triggers_sink_and_rise(void **state)
{
    (void)state;
    tp_input input = { 0 };
    SDL_JoystickSetVirtualAxis(stick, SDL_CONTROLLER_AXIS_TRIGGERRIGHT, INT16_MAX);
    events();
    pad_input(&p, &input);
    assert_int_equal(input.up, INPUT_WALK);
    SDL_JoystickSetVirtualAxis(stick, SDL_CONTROLLER_AXIS_TRIGGERLEFT, INT16_MAX);
    events();
    pad_input(&p, &input);
    assert_int_equal(input.up, INPUT_WALK);              /* both triggers add 0 */
    SDL_JoystickSetVirtualAxis(stick, SDL_CONTROLLER_AXIS_TRIGGERRIGHT, INT16_MIN);
    events();
    pad_input(&p, &input);
    assert_int_equal(input.up, 0);
}

static void buttons_ask_for_what_the_help_says(void **state)
{
    (void)state;
    assert_int_equal(button(SDL_CONTROLLER_BUTTON_A), ACT_DROP);
    assert_int_equal(button(SDL_CONTROLLER_BUTTON_B), ACT_PAUSE);
    assert_int_equal(button(SDL_CONTROLLER_BUTTON_X), ACT_CAMERA_ORBIT);
    assert_int_equal(button(SDL_CONTROLLER_BUTTON_Y), ACT_CAMERA_BOAT);
    assert_int_equal(button(SDL_CONTROLLER_BUTTON_LEFTSHOULDER), ACT_SLOWER);
    assert_int_equal(button(SDL_CONTROLLER_BUTTON_RIGHTSHOULDER), ACT_FASTER);
    assert_int_equal(button(SDL_CONTROLLER_BUTTON_START), ACT_HELP);
    assert_int_equal(button(SDL_CONTROLLER_BUTTON_BACK), ACT_PANEL);
    assert_int_equal(button(SDL_CONTROLLER_BUTTON_GUIDE), ACTIONS);
}

static void an_unplugged_pad_lets_go(void **state)
{
    const tp_input none = { 0 };
    tp_input input = { 0 };
    (void)state;
    SDL_JoystickSetVirtualAxis(stick, SDL_CONTROLLER_AXIS_LEFTX, INT16_MAX);
    events();
    SDL_JoystickDetachVirtual(device);
    events();
    assert_null(p.pad);
    pad_input(&p, &input);
    assert_memory_equal(&input, &none, sizeof none);
    device = plug();
    events();
    assert_non_null(p.pad);
}

static void a_second_pad_waits_and_takes_over(void **state)
{
    (void)state;
    SDL_GameController *first = p.pad;
    assert_true(plug() >= 0);
    events();
    assert_ptr_equal(p.pad, first);
    SDL_JoystickDetachVirtual(device);
    events();
    assert_non_null(p.pad);
    stick = SDL_GameControllerGetJoystick(p.pad);
    assert_int_equal(button(SDL_CONTROLLER_BUTTON_A), ACT_DROP);
}

int main(void)
{
#define TEST(name) cmocka_unit_test_setup_teardown(name, begin, end)
    const struct CMUnitTest tests[] = {
        TEST(the_left_stick_walks),
        TEST(a_corner_is_no_faster),
        TEST(the_right_stick_turns),
        TEST(sticks_that_are_let_go_do_nothing),
        TEST(triggers_sink_and_rise),
        TEST(buttons_ask_for_what_the_help_says),
        TEST(an_unplugged_pad_lets_go),
        TEST(a_second_pad_waits_and_takes_over),
    };
    setenv("SDL_VIDEODRIVER", "dummy", 1);
    SDL_SetHint(SDL_HINT_JOYSTICK_HIDAPI, "0");         /* ignores real gamepads */
    SDL_SetHint(SDL_HINT_JOYSTICK_ALLOW_BACKGROUND_EVENTS, "1");
    SDL_SetMainReady();
    if (SDL_Init(SDL_INIT_GAMECONTROLLER) != 0)
        return 1;
    const int failed = cmocka_run_group_tests_name("pad", tests, NULL, NULL);
    SDL_Quit();
    return failed;
}
