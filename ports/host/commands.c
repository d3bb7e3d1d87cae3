/* SPDX-License-Identifier: MIT */
/* The table of commands.  A new command needs one row. */
#include "commands.h"
#include "args.h"
#include "say.h"

#ifndef TP_HAVE_SDL2     /* defined if ports/sdl2 is part of the build */
int view_command(int argc, char **argv)
{
    (void)argc;
    (void)argv;
    return fail(EXIT_DISPLAY, "tidepool view: built without the preview, which needs"
                " SDL2: install libsdl2-dev and build again; `tidepool render` needs none");
}
#endif

const command_row commands[] = {
    { "view", "[SCENE] [OPTION]...", FOR_VIEW, false, view_command,
      "a window to look around in, and to change everything" },
    { "render", "SCENE [OPTION]...", FOR_RENDER, false, render_command,
      "frames to PNG files or a film; hashes, figures" },
    { "show", "SCENE [OPTION]...", FOR_SHOW, false, show_command,
      "a scene on a raw screen, without a window system" },
    { "scenes", "", FOR_SCENES, true, scenes_command,
      "the scenes that come with the program" },
    { "join", "FILM.y4m PART...", FOR_JOIN, false, join_command,
      "one film of parts that were drawn apart" },
    { "params", "[SCENE]", FOR_PARAMS, true, params_command,
      "what can be changed: names, units, ranges, values" },
    { "bake", "SCENE -o FILE.c", FOR_BAKE, false, bake_command,
      "a scene as constant C, for a board without files" },
    { "plan", "SCENE [OPTION]...", FOR_PLAN, true, plan_command,
      "how a scene is drawn, and why: costs, errors, bytes" },
    { "check", "--vectors DIR", FOR_CHECK, false, check_command,
      "the models against tables of known values" },
    { "bench", "[OPTION]...", FOR_BENCH, false, bench_command,
      "times of one scene, beside other renderers'" },
    { "charts", "DIR [OPTION]...", FOR_CHARTS, false, charts_command,
      "speed against accuracy: tables, pictures, a page" },
    { "manual", "[--scene]", FOR_MANUAL, true, manual_command,
      "the manual page, for man; --scene: of all parameters" },
    { "completion", "SHELL", FOR_COMPLETION, true, completion_command,
      "what bash, zsh or fish complete of all this" },
    { "help", "[COMMAND]", FOR_HELP, true, help_command,
      "this list, or a command and its options" },
    { "version", "", FOR_VERSION, true, version_command,
      "the version, which -V prints too" },
};

const size_t command_count = sizeof commands / sizeof *commands;

const exit_row exits[EXIT_CODES] = {
#define X(name, code, words, sentence) { words, sentence },
    EXIT_LIST(X)
#undef X
};
