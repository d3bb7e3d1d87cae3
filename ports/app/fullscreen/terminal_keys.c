/* SPDX-License-Identifier: MIT */
/* Held keys from a terminal, which sends bytes only.  It repeats a held key after a
 * quarter of a second, then thirty times a second.  So a key counts as held until its
 * first repeat is due, and a repeating key until its next repeat is overdue.  The
 * opposite key ends it at once.  The keyboard's raw mode would report releases, but is
 * not used: after a crash the console would stay deaf. */
#include "terminal_keys.h"
#include <string.h>
#include "interact/input_merge.h"

#define HOLD_FIRST 16           /* ticks of 1/60 s until a repeat is due */
#define HOLD_NEXT  5
#define ESC        27
#define CTRL_C     3

static const struct { char letter; uint8_t key; } letters[] = {
    { 'w', KEY_AHEAD }, { 's', KEY_BACK }, { 'a', KEY_LEFT }, { 'd', KEY_RIGHT },
    { 'q', KEY_DOWN }, { 'e', KEY_UP }, { '[', KEY_LIGHT_LEFT },
    { ']', KEY_LIGHT_RIGHT },
    { 'i', KEY_STEER_FAR }, { 'k', KEY_STEER_NEAR }, { 'j', KEY_STEER_LEFT },
    { 'l', KEY_STEER_RIGHT },
};

static const struct { const char *text; uint8_t key; } sequences[] = {
    { "[A", KEY_TILT_UP }, { "[B", KEY_TILT_DOWN }, { "[C", KEY_TURN_RIGHT },
    { "[D", KEY_TURN_LEFT }, { "OA", KEY_TILT_UP }, { "OB", KEY_TILT_DOWN },
    { "OC", KEY_TURN_RIGHT }, { "OD", KEY_TURN_LEFT }, { "[5~", KEY_LIGHT_UP },
    { "[6~", KEY_LIGHT_DOWN },
};

/* Opposite keys differ in the lowest bit. */
static void press(terminal_keys *k, uint8_t key)
{
    k->held[key ^ 1] = 0;
    if (!k->held[key])
        k->held[key] = HOLD_FIRST;
    else if (k->held[key] < HOLD_NEXT)
        k->held[key] = HOLD_NEXT;
}

static void letter(terminal_keys *k, uint8_t c)
{
    const bool capital = c >= 'A' && c <= 'Z';
    const char small = (char)(capital ? c - 'A' + 'a' : c);
    for (size_t i = 0; i < sizeof letters / sizeof *letters; i++)
        if (letters[i].letter == small) {
            k->run = capital;
            press(k, letters[i].key);
        }
    switch (small) {
    case 'f': k->drops++; break;
    case ',': k->slower++; break;
    case '.': k->slower--; break;
    case ' ': k->pause = !k->pause; break;
    case CTRL_C: k->interrupt = true; break;
    default: break;
    }
}

/* Handles a byte of an escape sequence.  A sequence ends with the first byte from @ to ~
 * after the introducer; unknown sequences are ignored.  Linux sends "[[A" to "[[E" for
 * F1 to F5. */
static void sequence(terminal_keys *k, uint8_t c)
{
    const bool first = k->escapes == 0;
    if (first && c != '[' && c != 'O') {        /* the Esc key, or Alt and a letter */
        k->quit = true;
        return;
    }
    k->escape[k->escapes++] = c;
    const bool function = k->escapes == 2 && c == '[';
    if (!first && !function && (c >= '@' || k->escapes == sizeof k->escape)) {
        for (size_t i = 0; i < sizeof sequences / sizeof *sequences; i++)
            if (strlen(sequences[i].text) == k->escapes
                && memcmp(sequences[i].text, k->escape, k->escapes) == 0)
                press(k, sequences[i].key);
        k->within = false;
    }
}

void terminal_keys_add_bytes(terminal_keys *k, const uint8_t *bytes, size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (k->within) {
            sequence(k, bytes[i]);
        } else if (bytes[i] == ESC) {
            k->within = true;
            k->escapes = 0;
        } else {
            letter(k, bytes[i]);
        }
}

void terminal_keys_flush(terminal_keys *k)
{
    k->quit = k->quit || (k->within && !k->escapes);
    k->within = false;
}

/* Returns +1, 0 or -1 from two opposite keys. */
static int axis(const terminal_keys *k, int more, int less)
{
    return (k->held[more] > 0) - (k->held[less] > 0);
}

tp_input terminal_keys_input(terminal_keys *k)
{
    const tp_fx step = k->run ? INPUT_RUN : INPUT_WALK;
    const int far = axis(k, KEY_STEER_FAR, KEY_STEER_NEAR);
    const int right = axis(k, KEY_STEER_RIGHT, KEY_STEER_LEFT);
    const tp_input input = {
        .forward = step * axis(k, KEY_AHEAD, KEY_BACK),
        .strafe = step * axis(k, KEY_RIGHT, KEY_LEFT),
        .up = step * axis(k, KEY_UP, KEY_DOWN),
        .turn = INPUT_TURN * axis(k, KEY_TURN_RIGHT, KEY_TURN_LEFT),
        .tilt = INPUT_TURN * axis(k, KEY_TILT_UP, KEY_TILT_DOWN),
        .sphere_x = INPUT_STEER * right,
        .sphere_z = -INPUT_STEER * far,
        .throttle = INPUT_SAIL * far,
        .rudder = INPUT_RUDDER * right,
        .light_turn = INPUT_LIGHT * axis(k, KEY_LIGHT_RIGHT, KEY_LIGHT_LEFT),
        .light_tilt = INPUT_LIGHT * axis(k, KEY_LIGHT_UP, KEY_LIGHT_DOWN),
        .drops = k->drops,
        .slowdown = k->slower,
    };
    for (int i = 0; i < KEYS; i++)
        k->held[i] = (uint8_t)(k->held[i] - (k->held[i] > 0));
    k->drops = 0;
    k->slower = 0;
    return input;
}
