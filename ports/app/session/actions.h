/* SPDX-License-Identifier: MIT */
/* The actions of the preview, each with its default keys.  The help overlay, the file of
 * keys, the manual page and `--help` are all made from the one list below. */
#ifndef TP_APP_SESSION_ACTIONS_H
#define TP_APP_SESSION_ACTIONS_H
#include <stdbool.h>
#include <stddef.h>

/* Columns: id, group, name in a file of keys, default keys, held, help.  A key is SDL's
 * name of a position on the keyboard, with the prefix Ctrl+ or Shift+; blanks separate
 * several keys.  A held action is active as long as its key is down; any other acts once
 * per press. */
#define ACTION_LIST(X) \
    X(FORWARD,    "camera", "forward",    "W", true, "move forward") \
    X(BACKWARD,   "camera", "backward",   "S", true, "move back") \
    X(LEFT,       "camera", "left",       "A", true, "move left") \
    X(RIGHT,      "camera", "right",      "D", true, "move right") \
    X(UP,         "camera", "up",         "E", true, "move up") \
    X(DOWN,       "camera", "down",       "Q", true, "move down") \
    X(RUN,        "camera", "run",        "LeftShift RightShift", true, \
      "move four times as fast") \
    X(MOUSE,      "camera", "mouse",      "M", false, \
      "the mouse turns the camera; again: release") \
    X(CAMERA_FREE,  "camera", "look_free",  "F", false, "look and fly freely") \
    X(CAMERA_ORBIT, "camera", "look_orbit", "O", false, "orbit the point in view") \
    X(CAMERA_TOP,   "camera", "look_top",   "T", false, "look from above") \
    X(CAMERA_BOAT,  "camera", "look_boat",  "B", false, "look from the boat's deck") \
    X(BEGIN_HERE, "camera", "begin_here", "Ctrl+C", false, \
      "start the scene at this camera") \
    X(NORTH,      "water",  "north",      "Up", true, "move the sphere of drops away") \
    X(SOUTH,      "water",  "south",      "Down", true, "move it nearer") \
    X(WEST,       "water",  "west",       "Left", true, "move it left") \
    X(EAST,       "water",  "east",       "Right", true, "move it right") \
    X(DROP,       "water",  "drop",       "Space", false, "release a drop") \
    X(POKE1,      "water",  "poke1",      "1", false, "poke the pool: far left") \
    X(POKE2,      "water",  "poke2",      "2", false, "far middle") \
    X(POKE3,      "water",  "poke3",      "3", false, "far right") \
    X(POKE4,      "water",  "poke4",      "4", false, "near left") \
    X(POKE5,      "water",  "poke5",      "5", false, "near middle") \
    X(POKE6,      "water",  "poke6",      "6", false, "near right") \
    X(SAIL,       "boat",   "sail",       "I", true, "sail faster") \
    X(BRAKE,      "boat",   "brake",      "K", true, "sail slower, astern") \
    X(PORT,       "boat",   "port",       "J", true, "rudder to the left") \
    X(STARBOARD,  "boat",   "starboard",  "L", true, "rudder to the right") \
    X(LIGHT_LEFT, "light",  "light_left", "Home", true, "turn the sun left") \
    X(LIGHT_RIGHT, "light", "light_right", "End", true, "turn the sun right") \
    X(LIGHT_UP,   "light",  "light_up",   "PageUp", true, "raise the sun") \
    X(LIGHT_DOWN, "light",  "light_down", "PageDown", true, "lower the sun") \
    X(PAUSE,      "time",   "pause",      "P", false, "pause; again: go on") \
    X(SLOWER,     "time",   "slower",     "[", false, "halve the speed of time, to 1/8") \
    X(FASTER,     "time",   "faster",     "]", false, "double the speed of time, to 4") \
    X(STEP,       "time",   "step",       ".", false, "pause, one picture forward") \
    X(STEP_BACK,  "time",   "step_back",  ",", false, "pause, one picture back") \
    X(REWIND,     "time",   "rewind",     "Backspace", true, "run backwards") \
    X(RESTART,    "time",   "restart",    "F5", false, \
      "restart the scene, keep your changes") \
    X(NEXT_SCENE, "scene",  "next_scene", "N", false, "the next scene") \
    X(LAST_SCENE, "scene",  "last_scene", "Shift+N", false, "the previous scene") \
    X(RELOAD,     "scene",  "reload",     "Ctrl+R", false, \
      "reload the file, drop your changes") \
    X(SAVE,       "scene",  "save",       "Ctrl+S", false, \
      "save the scene as an INI file") \
    X(UNDO,       "scene",  "undo",       "Ctrl+Z", false, "undo the last change") \
    X(REDO,       "scene",  "redo",       "Ctrl+Y", false, "redo the last change undone") \
    X(PANEL,      "window", "panel",      "F2", false, "hide or show the panel") \
    X(SIDE,       "window", "side",       "Shift+F2", false, \
      "move the panel to the other side") \
    X(SEARCH,     "window", "search",     "F3 /", false, "search the panel's parameters") \
    X(FIGURES,    "window", "figures",    "F4", false, \
      "times and stages over the picture") \
    X(FORMAT,     "window", "format",     "F6", false, "next pixel format") \
    X(SCALE,      "window", "scale",      "F7", false, \
      "enlarge pixels 1, 2, 3 or 4 times") \
    X(COMPARE,    "window", "compare",    "F8", false, \
      "compare methods: split, difference, off") \
    X(AGAINST,    "window", "against",    "Shift+F8", false, \
      "next method to compare with") \
    X(LARGER,     "window", "larger",     "Ctrl+=", false, "larger letters") \
    X(SMALLER,    "window", "smaller",    "Ctrl+-", false, "smaller letters") \
    X(FULL,       "window", "full",       "F11", false, "full screen; again: a window") \
    X(FILM,       "record", "film",       "F9", false, "record a film; again: end it") \
    X(TAPE,       "record", "tape",       "F10", false, \
      "restart and record a tape; again: end it") \
    X(SHOT,       "record", "shot",       "F12", false, "save a picture in this folder") \
    X(HELP,       "window", "help",       "F1", false, "list of keys") \
    X(QUIT,       "window", "quit",       "Escape Ctrl+Q", false, "quit")

typedef enum {
#define X(id, group, name, keys, held, help) ACT_##id,
    ACTION_LIST(X)
#undef X
    ACTIONS
} action;

typedef struct {
    const char *group, *name, *keys, *help;
    bool        held;
} action_row;

extern const action_row actions[ACTIONS];

/* Mouse and gamepad controls: fixed, listed in the same help. */
typedef struct { const char *keys, *help; } action_note;
extern const action_note action_notes[];
extern const size_t      action_note_count;
#endif
