/* SPDX-License-Identifier: MIT */
/* The actions of the preview, each with its default keys.  The help overlay, the file of
 * keys, the manual page and `--help` are all made from the one list below. */
#ifndef HOST_ACTIONS_H
#define HOST_ACTIONS_H
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
    X(RUN,        "camera", "run",        "LeftShift RightShift", true, "four times as fast") \
    X(MOUSE,      "camera", "mouse",      "M", false, "the mouse turns the camera; again: free") \
    X(LOOK_FREE,  "camera", "look_free",  "F", false, "fly where you like") \
    X(LOOK_ORBIT, "camera", "look_orbit", "O", false, "go round what you look at") \
    X(LOOK_TOP,   "camera", "look_top",   "T", false, "from above") \
    X(LOOK_BOAT,  "camera", "look_boat",  "B", false, "from the boat's deck") \
    X(BEGIN_HERE, "camera", "begin_here", "Ctrl+C", false, "the scene begins where you are") \
    X(NORTH,      "water",  "north",      "Up", true, "move the sphere of drops away") \
    X(SOUTH,      "water",  "south",      "Down", true, "and nearer") \
    X(WEST,       "water",  "west",       "Left", true, "and left") \
    X(EAST,       "water",  "east",       "Right", true, "and right") \
    X(DROP,       "water",  "drop",       "Space", false, "let a drop fall") \
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
    X(LIGHT_RIGHT, "light", "light_right", "End", true, "and right") \
    X(LIGHT_UP,   "light",  "light_up",   "PageUp", true, "raise it") \
    X(LIGHT_DOWN, "light",  "light_down", "PageDown", true, "lower it") \
    X(PAUSE,      "time",   "pause",      "P", false, "the water stands; again: it goes on") \
    X(SLOWER,     "time",   "slower",     "[", false, "half as fast, to 1/8") \
    X(FASTER,     "time",   "faster",     "]", false, "twice as fast, to 4") \
    X(STEP,       "time",   "step",       ".", false, "pause, and one picture on") \
    X(STEP_BACK,  "time",   "step_back",  ",", false, "pause, and one picture back") \
    X(REWIND,     "time",   "rewind",     "Backspace", true, "run backwards") \
    X(RESTART,    "time",   "restart",    "F5", false, "from the beginning, with your changes") \
    X(NEXT_SCENE, "scene",  "next_scene", "N", false, "the next scene") \
    X(LAST_SCENE, "scene",  "last_scene", "Shift+N", false, "the one before") \
    X(RELOAD,     "scene",  "reload",     "Ctrl+R", false, \
      "the scene's file, without your changes") \
    X(SAVE,       "scene",  "save",       "Ctrl+S", false, "save the scene as an INI file") \
    X(UNDO,       "scene",  "undo",       "Ctrl+Z", false, "take the last change back") \
    X(REDO,       "scene",  "redo",       "Ctrl+Y", false, "make it again") \
    X(PANEL,      "window", "panel",      "F2", false, "hide or show the panel") \
    X(SIDE,       "window", "side",       "Shift+F2", false, "the panel at the other side") \
    X(SEARCH,     "window", "search",     "F3 /", false, "search the panel's parameters") \
    X(FIGURES,    "window", "figures",    "F4", false, "times and stages over the picture") \
    X(FORMAT,     "window", "format",     "F6", false, "the next format of pixels") \
    X(SCALE,      "window", "scale",      "F7", false, "pixels 1, 2, 3 or 4 times as large") \
    X(COMPARE,    "window", "compare",    "F8", false, \
      "beside another way to draw: split, difference, off") \
    X(AGAINST,    "window", "against",    "Shift+F8", false, "which other way") \
    X(LARGER,     "window", "larger",     "Ctrl+=", false, "larger letters") \
    X(SMALLER,    "window", "smaller",    "Ctrl+-", false, "smaller letters") \
    X(FULL,       "window", "full",       "F11", false, "the whole screen; again: a window") \
    X(FILM,       "record", "film",       "F9", false, "record a film; again: end it") \
    X(TAPE,       "record", "tape",       "F10", false, \
      "restart and record a tape; again: end it") \
    X(SHOT,       "record", "shot",       "F12", false, "save a picture in this folder") \
    X(HELP,       "window", "help",       "F1", false, "these keys") \
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
