/* SPDX-License-Identifier: MIT */
/* tidepool completion SHELL, and the functions shared by the scripts of all shells. */
#include "completion.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "command_help.h"
#include "world/text.h"

/* Prints a text in single quotes.  An apostrophe is placed outside of the quotes:
 * 'it'\''s'.  A backslash, treated differently by the shells, becomes a slash. */
void completion_print_quoted(const char *text)
{
    putchar('\'');
    for (; *text; text++)
        if (*text == '\'')
            fputs("'\\''", stdout);
        else
            putchar(*text == '\\' ? '/' : *text);
    putchar('\'');
}

void completion_print_words(const char *kind)
{
    string_list list = { 0 };
    argument_type_words(&list, kind);
    for (size_t i = 0; i < list.count; i++)
        printf("%s%s", i ? " " : "", list.of[i]);
    string_list_free(&list);
}

void completion_print_names(const char *tail)
{
    uint32_t count;
    const tp_param *of = tp_params(&count);
    for (uint32_t i = 0; i < count; i++)
        printf("%s%s%s", i ? " " : "", of[i].name, tail);
}

void completion_print_file_names(const char *tail)
{
    uint32_t count;
    const tp_param *of = tp_params(&count);
    const char *bar = "";
    for (uint32_t i = 0; i < count; i++)
        if (tp_param_is_file(&of[i])) {
            printf("%s%s%s", bar, of[i].name, tail);
            bar = "|";
        }
}

static bool same(const char *a, const char *b)
{
    return a && b && strcmp(a, b) == 0;
}

/* Returns the index of the first parameter with a list of choices. */
static uint32_t first_choice_row(const char *choice)
{
    uint32_t count, i = 0;
    const tp_param *of = tp_params(&count);
    while (i < count && !same(argument_type_choices(&of[i]), choice))
        i++;
    return i;
}

const char *completion_next_choice(const char *last)
{
    uint32_t count;
    const tp_param *of = tp_params(&count);
    for (uint32_t i = last ? first_choice_row(last) + 1 : 0; i < count; i++) {
        const char *choice = argument_type_choices(&of[i]);
        if (choice && first_choice_row(choice) == i)
            return choice;
    }
    return NULL;
}

void completion_print_choosers(const char *choice, const char *tail)
{
    uint32_t count;
    const tp_param *of = tp_params(&count);
    const char *bar = "";
    for (uint32_t i = 0; i < count; i++)
        if (same(argument_type_choices(&of[i]), choice)) {
            printf("%s%s%s", bar, of[i].name, tail);
            bar = "|";
        }
}

void completion_print_choice(const char *choice)
{
    for (const char *c = choice; *c; c++)
        putchar(*c == '|' ? ' ' : *c);
    putchar(' ');
}

static const struct { const char *name; void (*print)(void); } shells[] = {
    { "bash", completion_bash }, { "zsh", completion_zsh }, { "fish", completion_fish },
};

static int print_script(const char *shell)
{
    for (size_t i = 0; i < sizeof shells / sizeof *shells; i++)
        if (strcmp(shells[i].name, shell) == 0) {
            shells[i].print();
            return EXIT_DONE;
        }
    return log_fail(EXIT_USAGE, "tidepool completion: %.40s: expected bash, zsh or fish",
                    shell);
}

int completion_command(int argc, char **argv)
{
    options o;
    int code = args_read(&o, FOR_COMPLETION, argc, argv);
    if (!code && o.help) {
        command_help_print(FOR_COMPLETION);
    } else if (!code) {
        code = print_script(o.scene);
    }
    free(o.settings);
    const int end = streams_finish();
    return code ? code : end;
}
