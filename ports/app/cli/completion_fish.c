/* SPDX-License-Identifier: MIT */
/* The script for fish: one line per command and per row of options, with the help texts of
 * the tables.  Settings are listed in full, as NAME= or with each of their choices: fish
 * searches the list itself. */
#include <stdio.h>
#include <string.h>
#include "completion.h"
#include "world/text.h"

static void print_condition(unsigned of)
{
    fputs("complete -c tidepool -n '__fish_seen_subcommand_from", stdout);
    for (size_t i = 0; i < command_count; i++)
        if (commands[i].options & of)
            printf(" %s", commands[i].name);
    putchar('\'');
}

static void print_candidates(const char *kind)
{
    switch (argument_type_find(kind)) {
    case ARGUMENT_ANY:     fputs(" -x", stdout); break;
    case ARGUMENT_FILE:    fputs(" -r -F", stdout); break;
    case ARGUMENT_FOLDER:  fputs(" -x -a '(__fish_complete_directories)'", stdout); break;
    case ARGUMENT_SETTING: fputs(" -x -a '(__tidepool_settings)'", stdout); break;
    case ARGUMENT_SCENE:
    case ARGUMENT_WORD:
        fputs(" -x -a '", stdout);
        completion_print_words(kind);
        fputs(argument_type_find(kind) == ARGUMENT_SCENE ? " (__fish_complete_suffix .ini)'"
                                                   : "'",
              stdout);
        break;
    }
}

static void print_option(const option_row *row)
{
    print_condition(row->commands);
    if (row->name[1] == '-')
        printf(" -l %s", row->name + 2);
    else
        printf(" -s %s", row->name + 1);
    if (row->value)
        print_candidates(row->value);
    fputs(" -d ", stdout);
    completion_print_quoted(row->help);
    puts("");
}

static void print_command(const command_row *of)
{
    printf("complete -c tidepool -n __fish_use_subcommand -f -a %s -d ", of->name);
    completion_print_quoted(of->help);
    puts("");
    if (argument_type_find(of->takes) == ARGUMENT_ANY)
        return;
    print_condition(of->options);
    print_candidates(of->takes);
    puts("");
}

/* Prints "water.filter=linear", a tab, the help text. */
static void print_setting(const tp_param *param, const char *value)
{
    printf("        ");
    completion_print_quoted(param->name);
    printf("=%s\\t", value);
    completion_print_quoted(param->help);
    puts(" \\");
}

static void print_settings(void)
{
    uint32_t count;
    const tp_param *of = tp_params(&count);
    puts("function __tidepool_settings\n    printf '%s\\n' \\");
    for (uint32_t i = 0; i < count; i++) {
        string_list list = { 0 };
        if (argument_type_choices(&of[i]))
            string_list_split(&list, argument_type_choices(&of[i]), "|");
        for (size_t k = 0; k < list.count; k++)
            print_setting(&of[i], list.of[k]);
        if (list.count == 0)
            print_setting(&of[i], "");
        string_list_free(&list);
    }
    fputs("        ''\n    switch (commandline -ct)\n    case ", stdout);
    uint32_t n = 0;
    for (uint32_t i = 0; i < count; i++)
        if (tp_param_is_file(&of[i]))
            printf("%s'*%s=*'", n++ ? " " : "", of[i].name);
    puts("\n        set -l at (string match -r '.*=' -- (commandline -ct))\n"
         "        set -l file (string replace -r '.*=' '' -- (commandline -ct))\n"
         "        printf \"$(string replace -r '^--set=' '' -- $at)%s\\n\""
         " (complete -C \"'' $file\")\n    end\nend");
}

void completion_fish(void)
{
    puts("# Made by `tidepool completion fish`.");
    print_settings();
    puts("complete -c tidepool -f\n"
         "complete -c tidepool -n __fish_use_subcommand -l help -d 'the commands'\n"
         "complete -c tidepool -n __fish_use_subcommand -l version -d 'the version'");
    for (size_t i = 0; i < command_count; i++)
        print_command(&commands[i]);
    for (size_t k = 0; k < args_row_count; k++)
        print_option(&args_rows[k]);
}
