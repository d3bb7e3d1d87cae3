/* SPDX-License-Identifier: MIT */
#include "command_help.h"
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include "args.h"
#include "commands.h"
#include "tools/bench/bench.h"
#include "tools/charts/charts.h"

/* Bit of one exit code in a command's set of exit codes. */
#define CODE(name) (1u << EXIT_##name)
enum { USUAL = CODE(DONE) | CODE(USAGE) | CODE(INPUT), CHECKS = USUAL | CODE(CHECK),
       SHOWS = USUAL | CODE(DISPLAY) | CODE(LOST) };

static const command_help_row rows[] = {
    { FOR_VIEW, "tidepool view [SCENE] [OPTION]...",
      "Shows SCENE, a shipped scene or an INI file, in a window; without SCENE it shows\n"
      "three-swells.  F1 lists the keys.  The state is saved each second, for --resume.\n",
      "", SHOWS, NULL },
    { FOR_RENDER, "tidepool render SCENE [OPTION]...",
      "Draws SCENE, a shipped scene or an INI file.  Without --out, --hash, --expect or\n"
      "--stats it writes SCENE.png into the current folder, or, for several frames,\n"
      "SCENE.apng, an animated PNG.  It replaces only a file that tidepool has made.\n",
      "", CHECKS, "a frame differs from --expect" },
    { FOR_SHOW, "tidepool show SCENE [OPTION]...",
      "Shows SCENE on a screen without a window system.  W A S D Q E and the arrows\n"
      "move, [ ] turn the light, F releases a drop, Space pauses, Esc ends.\n",
      "", SHOWS, NULL },
    { FOR_SCENES, "tidepool scenes", "Lists the shipped scenes and describes each.\n",
      "", USUAL, NULL },
    { FOR_JOIN, "tidepool join FILM.y4m PART.y4m...",
      "Joins the parts, in this order, into one film.  `render --frames A:B` draws the\n"
      "parts, on one machine or on several: the film has the same bits as a film drawn\n"
      "in one go.  FILM may be - for standard output.\n",
      "", USUAL, NULL },
    { FOR_PARAMS, "tidepool params [SCENE] [OPTION]...",
      "Lists every parameter with its default, or with its value in a scene.\n", "",
      USUAL, NULL },
    { FOR_BAKE, "tidepool bake SCENE -o FILE.c [OPTION]...",
      "Writes a scene, its mesh, pictures and maps as C constants for a board:\n"
      "NAME_scene and NAME_assets.  The head of the file declares them and gives their\n"
      "bytes.  --size or --format adds NAME_program, the modules that a scene needs at\n"
      "this size and format, and tables that the scene keeps as constants: a\n"
      "build that links it contains no other modules and draws the same bits.\n",
      "The file compiles with -I for the folder of tidepool/modules.h, nothing else.\n",
      CHECKS, "the program would draw another picture" },
    { FOR_PLAN, "tidepool plan SCENE [OPTION]...",
      "Prints the rungs that draw the scene: the cost of a frame on a Cortex-M4, the\n"
      "errors, and the bytes of the baked program.  The reference of an error is a\n"
      "mesh and pixels many times finer; a rung's error counts beyond that of the exact\n"
      "rung.  The plan takes the cheapest rungs within quality.error_px and\n"
      "quality.error_colour.  A rung that the scene names (quality.visibility, shading,\n"
      "rate) is taken whatever its error.\n"
      "For pools and foam it also estimates the cost of a tick, and lists values of the\n"
      "scene that make ticks cheaper or take less RAM, which only --set takes.\n",
      "", USUAL, NULL },
    { FOR_CHECK, "tidepool check SCENE [--write]\ntidepool check --vectors DIR",
      "Checks SCENE, a shipped scene or an INI file: every line, the files that it\n"
      "names, and whether its numbers make a world.  Old names of parameters are faults\n"
      "too; --write rewrites them, in a file without other bad lines.\n"
      "With --vectors, compares the fixed-point models with tables of known values, all\n"
      ".csv files of DIR.  Prints for each quantity the number of rows, the largest\n"
      "error, the rms error and the budget.\n",
      "A table has lines of parameters that begin with #, a line of column names, and\n"
      "rows.  The name of the file selects the model.\n",
      CHECKS, "an old name, or an error over its budget" },
    { FOR_BENCH, "tidepool bench [OPTION]...",
      "Times whole frames of one scene that other renderers can draw too: a sea of\n"
      "20 m x 20 m as a grid of points.  plain: a texture, light, depth.  full: waves\n"
      "distort three layers, bump, Fresnel, a cube map, glitter, exposure.  smooth:\n"
      "full with linear layers.\n",
      "`ratio` is the time divided by that of the case's first line, `dB` the PSNR of\n"
      "the picture.  --peers needs the project's folder and leaves pictures in\n"
      BENCH_FOLDER ".\n",
      USUAL, NULL },
    { FOR_CHARTS,
      "tidepool charts DIR [OPTION]...\n"
      "tidepool charts --list [OPTION]...\n"
      "tidepool charts --collect FILE... DIR [OPTION]...",
      "Runs the charts of " CHARTS_FOLDER ", in the project's folder, and writes tables,\n"
      "pictures (if gnuplot is installed) and README.md into DIR.  --list prints the\n"
      "jobs, one command a line; --collect merges the output of jobs, in any order\n"
      "(FILE may be - for standard input).\n",
      "", CHECKS, "a job failed" },
    { FOR_MANUAL, "tidepool manual [--scene]",
      "Prints the manual page tidepool(1), or with --scene tidepool-scene(5).  Save it\n"
      "as FILE and read it with `man -l FILE`; `make install` installs both.\n",
      "", USUAL, NULL },
    { FOR_COMPLETION, "tidepool completion SHELL",
      "Prints a script that completes commands, options, scenes, names and values in\n"
      "bash, zsh or fish.  `make install` installs it.  By hand, in ~/.bashrc:\n"
      "eval \"$(tidepool completion bash)\"; in config.fish: tidepool completion fish |\n"
      "source; for zsh: save it as _tidepool in a folder of its fpath.\n",
      "", USUAL, NULL },
    { FOR_HELP, "tidepool help [COMMAND]",
      "Lists the commands, or describes one command and its options, as\n"
      "`tidepool --help` and `tidepool COMMAND --help` do.\n",
      "", USUAL, NULL },
    { FOR_VERSION, "tidepool version",
      "Prints the version, as `tidepool --version` and `tidepool -V` do.\n", "", USUAL,
      NULL },
};

#define ROWS (sizeof rows / sizeof *rows)

const command_help_row *command_help_find(unsigned command)
{
    for (size_t i = 0; i < ROWS; i++)
        if (rows[i].command == command)
            return &rows[i];
    abort();                    /* command without a row; tested by cli.sh */
}

void command_help_exits(const command_help_row *row, char text[COMMAND_HELP_EXITS_BYTES])
{
    const char *comma = "Exit: ";
    size_t length = 0;
    for (int code = 0; code < EXIT_CODES; code++) {
        const bool own = code == EXIT_CHECK && row->check;
        if (!(row->exits >> code & 1))
            continue;
        length +=
            (size_t)snprintf(text + length, COMMAND_HELP_EXITS_BYTES - length, "%s%d %s",
                             comma, code, own ? row->check : exits[code].words);
        comma = ", ";
    }
    snprintf(text + length, COMMAND_HELP_EXITS_BYTES - length, ".");
}

void command_help_print(unsigned command)
{
    const command_help_row *row = command_help_find(command);
    fputs("usage: ", stdout);
    for (const char *c = row->usage; *c; c++) {
        putchar(*c);
        if (*c == '\n')
            fputs("       ", stdout);
    }
    printf("\n%s\n", row->text);
    args_print(command);
    if (*row->after)
        printf("\n%s", row->after);
    char codes[COMMAND_HELP_EXITS_BYTES];
    command_help_exits(row, codes);
    printf("\n%s\n", codes);
}
