/* SPDX-License-Identifier: MIT */
/* The program: finds the command and runs it. */
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include "commands.h"
#include "nearest.h"
#include "say.h"
#include "tidepool/version.h"

static int print_help(void)
{
    puts("usage: tidepool COMMAND [ARGUMENT]...\n"
         "Water for small computers: seas, pools, drops and a boat, in fixed point.\n");
    for (size_t i = 0; i < command_count; i++) {
        char left[48];
        snprintf(left, sizeof left, "%s %s", commands[i].name, commands[i].takes);
        printf("  %-25s %s\n", left, commands[i].help);
    }
    fputs("\n`tidepool COMMAND --help` lists a command's options.  For a start:\n"
          "  tidepool view\n"
          "  tidepool render three-swells --out first.png\n"
          "  tidepool render three-swells --frames 300 --out film.y4m\n\nExit: ", stdout);
    for (int i = 0; i < EXIT_CODES; i++)
        printf("%d %s%s", i, exits[i].words, i + 1 == EXIT_CODES ? ".\n"
                                             : i == EXIT_DISPLAY ? ",\n      " : ", ");
    return finish_stdout();
}

static int print_version(void)
{
    printf("tidepool %s\n", tp_version());
    return finish_stdout();
}

static int refuse_command(const char *name)
{
    nearest best = nearest_to(name);
    for (size_t i = 0; i < command_count; i++)
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
    for (size_t i = 0; i < command_count; i++)
        if (strcmp(argv[1], commands[i].name) == 0)
            return commands[i].run(argc - 1, argv + 1);
    return refuse_command(argv[1]);
}
