/* SPDX-License-Identifier: MIT */
/* The table of commands.  A new command needs one row. */
#include "commands.h"
#include "app/files/log.h"
#include "args.h"

#ifndef TP_HAVE_SDL2     /* defined if ports/app/preview is part of the build */
int view_command(int argc, char **argv)
{
    (void)argc;
    (void)argv;
    return log_fail(EXIT_DISPLAY, "tidepool view: built without the preview, which needs"
                " SDL2: install libsdl2-dev and build again; `tidepool render` needs none");
}
#endif

const command_row commands[] = {
    { "view", "[SCENE] [OPTION]...", FOR_VIEW, false, view_command,
      "show a scene in a window, change its parameters" },
    { "render", "SCENE [OPTION]...", FOR_RENDER, false, render_command,
      "draw frames to PNG files or a film; print hashes" },
    { "show", "SCENE [OPTION]...", FOR_SHOW, false, show_command,
      "show a scene on a screen without a window system" },
    { "scenes", "", FOR_SCENES, true, scenes_command,
      "list the shipped scenes" },
    { "join", "FILM.y4m PART...", FOR_JOIN, false, join_command,
      "join parts of a film into one film" },
    { "params", "[SCENE]", FOR_PARAMS, true, params_command,
      "list parameters: names, units, ranges, values" },
    { "bake", "SCENE -o FILE.c", FOR_BAKE, false, bake_command,
      "write a scene as C constants, for a board" },
    { "plan", "SCENE [OPTION]...", FOR_PLAN, true, plan_command,
      "explain how a scene is drawn: costs, errors, bytes" },
    { "check", "SCENE | --vectors DIR", FOR_CHECK, false, check_command,
      "find faults in a scene, or in the models" },
    { "bench", "[OPTION]...", FOR_BENCH, false, bench_command,
      "time one scene, also with other renderers" },
    { "charts", "DIR [OPTION]...", FOR_CHARTS, false, charts_command,
      "measure speed against accuracy: tables, pictures" },
    { "manual", "[--scene]", FOR_MANUAL, true, manual_command,
      "print the manual page; --scene: of all parameters" },
    { "completion", "SHELL", FOR_COMPLETION, true, completion_command,
      "print completions for bash, zsh or fish" },
    { "help", "[COMMAND]", FOR_HELP, true, help_command,
      "list the commands, or describe one of them" },
    { "version", "", FOR_VERSION, true, version_command,
      "print the version; -V does the same" },
};

const size_t command_count = sizeof commands / sizeof *commands;

const exit_row exits[EXIT_CODES] = {
#define X(name, code, words, sentence) { words, sentence },
    EXIT_LIST(X)
#undef X
};
