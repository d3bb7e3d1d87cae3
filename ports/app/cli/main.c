/* SPDX-License-Identifier: MIT */
/* The main program: finds the command and runs it. */
#include <signal.h>
#include <stdbool.h>
#include <string.h>
#include "app/files/log.h"
#include "commands.h"

/* Translates options in place of a command, as --help, to the command. */
static char *command_name(char *word)
{
    static char help[] = "help", version[] = "version";
    if (strcmp(word, "--help") == 0 || strcmp(word, "-h") == 0)
        return help;
    if (strcmp(word, "--version") == 0 || strcmp(word, "-V") == 0)
        return version;
    return word;
}

/* True if the command only prints a list.  A list piped into `head` ends silently by
 * SIGPIPE.  For other commands a write to a closed pipe fails with a message. */
static bool is_list(const command_row *command, int argc, char **argv)
{
    bool help = false;
    for (int i = 2; i < argc; i++)
        help = help || strcmp(argv[i], "--help") == 0 || strcmp(argv[i], "-h") == 0;
    return command->lists || help;
}

int main(int argc, char **argv)
{
    streams_begin();
    if (argc > 1)
        argv[1] = command_name(argv[1]);
    const command_row *command = command_find(argc > 1 ? argv[1] : "");
    if (!command)
        return EXIT_USAGE;
    signal(SIGPIPE, is_list(command, argc, argv) ? SIG_DFL : SIG_IGN);
    return command->run(argc - 1, argv + 1);
}
