/* SPDX-License-Identifier: MIT */
/* The program: finds the command and runs it. */
#include <signal.h>
#include <string.h>
#include "commands.h"
#include "say.h"

/* Options that stand where a command does, as other programs have them. */
static char *command_name(char *word)
{
    static char help[] = "help", version[] = "version";
    if (strcmp(word, "--help") == 0 || strcmp(word, "-h") == 0)
        return help;
    if (strcmp(word, "--version") == 0 || strcmp(word, "-V") == 0)
        return version;
    return word;
}

int main(int argc, char **argv)
{
    signal(SIGPIPE, SIG_IGN);           /* writing then fails, and that is reported */
    if (argc < 2)
        return fail(EXIT_USAGE, "tidepool: which command?  See `tidepool help`");
    argv[1] = command_name(argv[1]);
    const command_row *command = command_find(argv[1]);
    return command ? command->run(argc - 1, argv + 1) : EXIT_USAGE;
}
