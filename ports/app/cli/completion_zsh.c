/* SPDX-License-Identifier: MIT */
/* The script for zsh, with the help texts of the tables.  _arguments completes options and
 * their values; two functions in the script complete scenes and settings. */
#include <stdio.h>
#include <string.h>
#include "completion.h"

/* Prints a text of an _arguments specification: brackets and colons need a backslash. */
static void print_spec_text(const char *text)
{
    for (; *text; text++)
        if (*text == '\'')
            fputs("'\\''", stdout);
        else if (strchr("[]:\\", *text))
            printf("\\%c", *text);
        else
            putchar(*text);
}

static void print_action(const char *kind)
{
    switch (argument_type_find(kind)) {
    case ARGUMENT_ANY:     break;
    case ARGUMENT_FILE:    fputs("_files", stdout); break;
    case ARGUMENT_FOLDER:  fputs("_files -/", stdout); break;
    case ARGUMENT_SCENE:   fputs("_tidepool_scene", stdout); break;
    case ARGUMENT_SETTING: fputs("_tidepool_setting", stdout); break;
    case ARGUMENT_WORD:
        putchar('(');
        completion_print_words(kind);
        putchar(')');
        break;
    }
}

static void print_option(const option_row *row)
{
    const bool single = row->name[1] != '-';
    printf("            '%s%s%s[",
           row->value && argument_type_find(row->value) == ARGUMENT_SETTING ? "*" : "",
           row->name, row->value && !single ? "=" : "");
    print_spec_text(row->help);
    putchar(']');
    if (row->value) {
        putchar(':');
        print_spec_text(row->value);
        putchar(':');
        print_action(row->value);
    }
    puts("' \\");
}

static void print_command(const command_row *of)
{
    printf("        (%s) _arguments \\\n", of->name);
    for (size_t k = 0; k < args_row_count; k++)
        if (args_rows[k].commands & of->options)
            print_option(&args_rows[k]);
    if (argument_type_find(of->takes) == ARGUMENT_ANY) {
        puts("            && return ;;");
        return;
    }
    fputs("            '*:", stdout);
    print_spec_text(of->takes);
    putchar(':');
    print_action(of->takes);
    puts("' && return ;;");
}

static void print_setting(void)
{
    puts("_tidepool_setting()\n{\n    local name=${PREFIX%%=*}\n"
         "    if ! compset -P '*='; then");
    fputs("        compadd -S = -- ", stdout);
    completion_print_names("");
    puts("\n        return\n    fi\n    case $name in");
    for (const char *choice = completion_next_choice(NULL); choice;
         choice = completion_next_choice(choice)) {
        fputs("    (", stdout);
        completion_print_choosers(choice, "");
        fputs(") compadd -- ", stdout);
        completion_print_choice(choice);
        puts(";;");
    }
    fputs("    (", stdout);
    completion_print_file_names("");
    puts(") _files ;;\n    esac\n}");
}

void completion_zsh(void)
{
    puts("#compdef tidepool\n# Made by `tidepool completion zsh`.");
    fputs("_tidepool_scene()\n{\n    compadd -- ", stdout);
    completion_print_words("SCENE");
    puts("\n    _files -g '*.ini'\n}");
    print_setting();
    puts("_tidepool()\n{\n    local context state state_descr line ret=1\n"
         "    typeset -A opt_args\n    local -a commands=(");
    for (size_t i = 0; i < command_count; i++) {
        printf("        '%s:", commands[i].name);
        print_spec_text(commands[i].help);
        puts("'");
    }
    puts("    )\n    _arguments -C '--help[the commands]' '--version[the version]' \\\n"
         "        '1:command:->command' '*::argument:->argument' && ret=0\n"
         "    case $state in\n"
         "    (command) _describe command commands && ret=0 ;;\n"
         "    (argument)\n        case $line[1] in");
    for (size_t i = 0; i < command_count; i++)
        print_command(&commands[i]);
    puts("        esac ;;\n    esac\n    return ret\n}\n"
         "if [[ $funcstack[1] = _tidepool ]]; then\n    _tidepool \"$@\"\nelse\n"
         "    compdef _tidepool tidepool\nfi");
}
