/* SPDX-License-Identifier: MIT */
#include "about.h"
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include "args.h"
#include "bench.h"
#include "charts.h"
#include "commands.h"

/* Bit of one exit code in a command's set of exit codes. */
#define CODE(name) (1u << EXIT_##name)
enum { USUAL = CODE(DONE) | CODE(USAGE) | CODE(INPUT), CHECKS = USUAL | CODE(CHECK),
       SHOWS = USUAL | CODE(DISPLAY) | CODE(LOST) };

static const about_row rows[] = {
    { FOR_VIEW, "tidepool view [SCENE] [OPTION]...",
      "Opens a window on SCENE, a shipped one or an INI file, else three-swells; F1\n"
      "there lists the keys.  What it shows is kept each second, for --resume.\n",
      "", SHOWS, NULL },
    { FOR_RENDER, "tidepool render SCENE [OPTION]...",
      "Draws SCENE, a shipped one or an INI file.  Without --out, --hash, --expect or\n"
      "--stats the picture becomes SCENE.png in this folder; several become SCENE.apng,\n"
      "an animated PNG.  A file that is no picture of tidepool's is not replaced so.\n",
      "", CHECKS, "a frame differs from --expect" },
    { FOR_SHOW, "tidepool show SCENE [OPTION]...",
      "Shows SCENE on a raw screen.  W A S D Q E and the arrows move, [ ] turns the\n"
      "light, F lets a drop fall, Space pauses, Esc ends.\n",
      "", SHOWS, NULL },
    { FOR_SCENES, "tidepool scenes", "Lists the shipped scenes and what each shows.\n",
      "", USUAL, NULL },
    { FOR_JOIN, "tidepool join FILM.y4m PART.y4m...",
      "Makes one film of parts in their order, as `render --frames A:B` draws them on\n"
      "one machine or on many: the same bits as drawn in one go.  FILM may be -.\n",
      "", USUAL, NULL },
    { FOR_PARAMS, "tidepool params [SCENE] [OPTION]...",
      "Lists every parameter with its default, or with its value in a scene.\n", "",
      USUAL, NULL },
    { FOR_BAKE, "tidepool bake SCENE -o FILE.c [OPTION]...",
      "Writes a scene, its mesh, pictures and maps as constants in C, for a board:\n"
      "NAME_scene and NAME_assets, which the file's head declares and measures.\n"
      "With --size or --format NAME_program too, which lists what the scene needs to\n"
      "be drawn so: what is linked by it has no other code, and draws the same bits.\n",
      "The file needs -I for the folder of tidepool/modules.h and nothing else.\n", CHECKS,
      "a list draws another picture" },
    { FOR_PLAN, "tidepool plan SCENE [OPTION]...",
      "Prints by which methods the scene is drawn: for each what a frame costs a\n"
      "Cortex-M4 with it, how far outlines and colours may be off, and its bytes.\n"
      "Both are measured against the truth, a mesh and pixels many times finer;\n"
      "what counts is how much farther off it a rung is than the exact one.\n"
      "The cheapest within quality.error_px and quality.error_colour are taken;\n"
      "what the scene names (quality.visibility, shading, rate, lod) is taken\n"
      "whatever its error.\n",
      "", USUAL, NULL },
    { FOR_CHECK, "tidepool check --vectors DIR",
      "Compares the fixed-point models with tables of known values: every .csv\n"
      "of the folder.  Prints of each quantity how many rows there are, its\n"
      "largest and rms error, and the budget.\n",
      "A table is lines beginning with # that hold parameters, a line of\n"
      "column names, and rows.  Its name says which model it belongs to.\n",
      CHECKS, "some are not within their budgets" },
    { FOR_BENCH, "tidepool bench [OPTION]...",
      "Times whole frames of one scene, on which others were measured too: a sea of\n"
      "20 m x 20 m as a grid of points, plain (a texture, light, depth), full (waves\n"
      "that bend three layers, bump, Fresnel, a cube map, glitter, exposure) and\n"
      "smooth (full, with linear layers).\n",
      "`ratio` is the time over that of the case's first line, `dB` its picture's PSNR.\n"
      "--peers runs in the project's folder and leaves pictures in " BENCH_FOLDER ".\n",
      USUAL, NULL },
    { FOR_CHARTS,
      "tidepool charts DIR [OPTION]...\n"
      "tidepool charts --list [OPTION]...\n"
      "tidepool charts --collect FILE... DIR [OPTION]...",
      "Runs what " CHARTS_FOLDER " describes, in the project's folder, into DIR:\n"
      "tables, pictures (if gnuplot is there) and README.md.  --list prints the jobs,\n"
      "a command a line; --collect merges what they print, in any order (FILE may be\n"
      "- for standard input).\n",
      "", CHECKS, "a job failed" },
    { FOR_MANUAL, "tidepool manual [--scene]",
      "Prints the manual page tidepool(1), or tidepool-scene(5): into a FILE, which\n"
      "`man -l FILE` shows.  `make install` puts both where man finds them.\n",
      "", USUAL, NULL },
    { FOR_COMPLETION, "tidepool completion SHELL",
      "Prints what bash, zsh or fish complete: commands, options, scenes, names and\n"
      "values.  `make install` puts it where they look.  By hand, in ~/.bashrc:\n"
      "eval \"$(tidepool completion bash)\"; in config.fish: tidepool completion fish |\n"
      "source; for zsh as _tidepool in a folder of its fpath.\n",
      "", USUAL, NULL },
    { FOR_HELP, "tidepool help [COMMAND]",
      "Lists the commands, or tells of one of them and of its options: the same as\n"
      "`tidepool --help` and `tidepool COMMAND --help`.\n",
      "", USUAL, NULL },
    { FOR_VERSION, "tidepool version",
      "Prints the version, as `tidepool --version` and `tidepool -V` do.\n", "", USUAL,
      NULL },
};

#define ROWS (sizeof rows / sizeof *rows)

const about_row *about_find_row(unsigned command)
{
    for (size_t i = 0; i < ROWS; i++)
        if (rows[i].command == command)
            return &rows[i];
    abort();                    /* command without a row; tested by cli.sh */
}

void about_exits(const about_row *row, char text[ABOUT_EXITS_BYTES])
{
    const char *comma = "Exit: ";
    size_t length = 0;
    for (int code = 0; code < EXIT_CODES; code++) {
        const bool own = code == EXIT_CHECK && row->check;
        if (!(row->exits >> code & 1))
            continue;
        length += (size_t)snprintf(text + length, ABOUT_EXITS_BYTES - length, "%s%d %s",
                                   comma, code, own ? row->check : exits[code].words);
        comma = ", ";
    }
    snprintf(text + length, ABOUT_EXITS_BYTES - length, ".");
}

void about_print(unsigned command)
{
    const about_row *row = about_find_row(command);
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
    char codes[ABOUT_EXITS_BYTES];
    about_exits(row, codes);
    printf("\n%s\n", codes);
}
