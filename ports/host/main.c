/* SPDX-License-Identifier: MIT */
/* The program: finds the command and runs it.  A new command is a line of the table. */
#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include "commands.h"
#include "nearest.h"
#include "say.h"

#ifndef TP_VERSION
#define TP_VERSION "0.1.0"
#endif

#ifndef TP_HAVE_SDL2     /* defined where ports/sdl2 is built in */
int view_command(int argc, char **argv)
{
    (void)argc;
    (void)argv;
    return fail(EXIT_INPUT, "tidepool view: built without the preview, which needs SDL2:"
                " install libsdl2-dev and build again; `tidepool render` needs none");
}
#endif

static const struct {
    const char *name, *takes, *help;
    int       (*run)(int argc, char **argv);
} commands[] = {
    { "render", "SCENE [OPTION]...", "frames to PNG files or a film; hashes, figures",
      render_command },
    { "view", "SCENE [OPTION]...", "a window to look around in", view_command },
    { "show", "SCENE [OPTION]...", "a scene on a raw screen, without a window system",
      show_command },
    { "scenes", "", "the scenes that come with the program", scenes_command },
    { "join", "FILM.y4m PART...", "one film of parts that were drawn apart",
      join_command },
    { "params", "[SCENE]", "what can be changed: names, units, ranges, values",
      params_command },
    { "bake", "SCENE -o FILE.c", "a scene as constant C, for a board without files",
      bake_command },
    { "plan", "SCENE [OPTION]...", "how a scene is drawn, and why: costs, errors, bytes",
      plan_command },
    { "check", "--vectors DIR", "the models against tables of known values",
      check_command },
    { "bench", "[OPTION]...", "times of one scene, beside other renderers'",
      bench_command },
    { "charts", "DIR [OPTION]...", "speed against accuracy: tables, pictures, a page",
      charts_command },
};

#define COMMANDS (sizeof commands / sizeof *commands)

int finish_stdout(void)
{
    errno = 0;
    if (!ferror(stdout) && fflush(stdout) == 0)
        return EXIT_DONE;
    return fail(EXIT_INPUT, "standard output: %s", strerror(errno ? errno : EIO));
}

static int print_help(void)
{
    puts("usage: tidepool COMMAND [ARGUMENT]...\n"
         "Water for small computers: seas, pools, drops and a boat, in fixed point.\n");
    for (size_t i = 0; i < COMMANDS; i++) {
        char left[48];
        snprintf(left, sizeof left, "%s %s", commands[i].name, commands[i].takes);
        printf("  %-25s %s\n", left, commands[i].help);
    }
    puts("\n`tidepool COMMAND --help` lists a command's options.  For a start:\n"
         "  tidepool view three-swells\n"
         "  tidepool render three-swells --out first.png\n"
         "  tidepool render three-swells --frames 300 --out film.y4m\n\n"
         "Exit: 0 done, 1 a check failed, 2 usage, 3 bad input or output.");
    return finish_stdout();
}

static int print_version(void)
{
    puts("tidepool " TP_VERSION);
    return finish_stdout();
}

static int refuse_command(const char *name)
{
    nearest best = nearest_to(name);
    for (size_t i = 0; i < COMMANDS; i++)
        nearest_offer(&best, commands[i].name);
    if (best.name)
        return fail(EXIT_USAGE, "tidepool: no command %s; did you mean %s?", name,
                    best.name);
    return fail(EXIT_USAGE, "tidepool: no command %s; see `tidepool --help`", name);
}

int main(int argc, char **argv)
{
    signal(SIGPIPE, SIG_IGN);           /* writing then fails, and that is reported */
    if (argc < 2)
        return fail(EXIT_USAGE, "tidepool: which command?  See `tidepool --help`");
    if (strcmp(argv[1], "--help") == 0 || strcmp(argv[1], "-h") == 0)
        return print_help();
    if (strcmp(argv[1], "--version") == 0)
        return print_version();
    for (size_t i = 0; i < COMMANDS; i++)
        if (strcmp(argv[1], commands[i].name) == 0)
            return commands[i].run(argc - 1, argv + 1);
    return refuse_command(argv[1]);
}
