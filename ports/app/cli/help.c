/* SPDX-License-Identifier: MIT */
/* tidepool help and tidepool version. */
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "app/files/did_you_mean.h"
#include "app/files/log.h"
#include "app/files/path.h"
#include "args.h"
#include "command_help.h"
#include "commands.h"
#include "tidepool/tidepool.h"

/* True for a shipped scene, and for any name that ends in .ini. */
static bool is_scene(const char *name)
{
    char *folder = path_ends(name, ".ini") ? NULL : path_of_scenes();
    char *path = folder && !strchr(name, '/') ? path_join(folder, name, ".ini") : NULL;
    const bool shipped = path && path_is_file(path);
    free(path);
    free(folder);
    return shipped || path_ends(name, ".ini");
}

static void refuse(const char *name)
{
    did_you_mean best = did_you_mean_make(name);
    for (size_t i = 0; i < command_count; i++)
        did_you_mean_offer(&best, commands[i].name);
    if (!*name)
        log_line("tidepool: COMMAND is missing; see `tidepool help`");
    else if (name[0] == '-')
        log_line("tidepool: no option %.60s; it takes --help, --version or a command",
                 name);
    else if (best.name)
        log_line("tidepool: no command %.60s; did you mean %s?", name, best.name);
    else if (is_scene(name))
        log_line("tidepool: no command %.60s; did you mean `tidepool view %.60s`?", name,
                 name);
    else
        log_line("tidepool: no command %.60s; see `tidepool help`", name);
}

const command_row *command_find(const char *name)
{
    for (size_t i = 0; i < command_count; i++)
        if (strcmp(name, commands[i].name) == 0)
            return &commands[i];
    refuse(name);
    return NULL;
}

/* Prints the commands on a screen of 24 lines. */
static void print_commands(void)
{
    puts("usage: tidepool COMMAND [ARGUMENT]...\n"
         "Water for small computers: seas, pools, drops and a boat, in fixed point.\n");
    for (size_t i = 0; i < command_count; i++) {
        char left[48];
        snprintf(left, sizeof left, "%s %s", commands[i].name, commands[i].takes);
        printf("  %-25s %s\n", left, commands[i].help);
    }
    fputs("\nFor a start: tidepool view; tidepool render storm; tidepool help render.\n\n"
          "Exit: ", stdout);
    for (int i = 0; i < EXIT_CODES; i++)
        printf("%d %s%s", i, exits[i].words, i + 1 == EXIT_CODES ? ".\n"
                                             : i == EXIT_DISPLAY ? ",\n      " : ", ");
}

static int print_help(const options *o)
{
    if (!o->scene) {
        print_commands();
        return EXIT_DONE;
    }
    const command_row *command = command_find(o->scene);
    if (!command)
        return EXIT_USAGE;
    command_help_print(command->options);
    return EXIT_DONE;
}

int help_command(int argc, char **argv)
{
    options o;
    int code = args_read(&o, FOR_HELP, argc, argv);
    if (!code && o.help)
        command_help_print(FOR_HELP);
    else if (!code)
        code = print_help(&o);
    free(o.settings);
    const int end = streams_finish();
    return code ? code : end;
}

int version_command(int argc, char **argv)
{
    options o;
    const int code = args_read(&o, FOR_VERSION, argc, argv);
    if (!code && o.help)
        command_help_print(FOR_VERSION);
    else if (!code)
        printf("tidepool %s\n", tp_version());
    free(o.settings);
    const int end = streams_finish();
    return code ? code : end;
}
