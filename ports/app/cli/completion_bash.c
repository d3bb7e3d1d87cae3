/* SPDX-License-Identifier: MIT */
/* The script for bash 4.3 and later.  Four functions hold the contents of the tables; the
 * fifth chooses from them by the words before the cursor.  Bash may split words at '=';
 * then a reply is only the part after the last '='. */
#include <stdio.h>
#include <string.h>
#include "completion.h"

static void print_options(void)
{
    puts("_tidepool_options()     # COMMAND\n{\n    case $1 in");
    for (size_t i = 0; i < command_count; i++) {
        printf("    %s) echo '", commands[i].name);
        for (size_t k = 0; k < args_row_count; k++)
            if (args_rows[k].commands & commands[i].options)
                printf("%s ", args_rows[k].name);
        puts("' ;;");
    }
    puts("    esac\n}");
}

/* Prints the kind of an option's value, or of an argument without an option. */
static void print_kinds(void)
{
    puts("_tidepool_kind()        # COMMAND [OPTION]\n{\n    case \"$1 $2\" in");
    for (size_t i = 0; i < command_count; i++) {
        if (argument_type_find(commands[i].takes) != ARGUMENT_ANY)
            printf("    '%s ') echo %.*s ;;\n", commands[i].name,
                   (int)strcspn(commands[i].takes + (*commands[i].takes == '['), " ]"),
                   commands[i].takes + (*commands[i].takes == '['));
        for (size_t k = 0; k < args_row_count; k++)
            if (args_rows[k].value && (args_rows[k].commands & commands[i].options))
                printf("    '%s %s') echo '%s' ;;\n", commands[i].name, args_rows[k].name,
                       args_rows[k].value);
    }
    puts("    esac\n}");
}

static void print_kind(const char *kind)
{
    printf("    '%s') ", kind);
    switch (argument_type_find(kind)) {
    case ARGUMENT_FILE:    puts("compgen -f -- \"$2\" ;;"); break;
    case ARGUMENT_FOLDER:  puts("compgen -d -- \"$2\" ;;"); break;
    case ARGUMENT_SETTING: puts("_tidepool_setting \"$2\" ;;"); break;
    case ARGUMENT_ANY:     puts(";;"); break;
    case ARGUMENT_WORD:
    case ARGUMENT_SCENE:
        fputs("compgen -W '", stdout);
        completion_print_words(kind);
        puts("' -- \"$2\"");
        if (argument_type_find(kind) == ARGUMENT_SCENE)
            puts("        compgen -f -X '!*.ini' -- \"$2\"; compgen -d -- \"$2\"");
        puts("        ;;");
        break;
    }
}

static bool is_repeated_kind(const char *kind, size_t row)
{
    for (size_t k = 0; k < row; k++)
        if (args_rows[k].value && strcmp(args_rows[k].value, kind) == 0)
            return true;
    return false;
}

static void print_values(void)
{
    puts("_tidepool_values()      # KIND BEGINNING\n{\n    case $1 in");
    print_kind("SCENE");
    print_kind("SHELL");
    print_kind("COMMAND");
    print_kind("FILM.y4m");
    for (size_t k = 0; k < args_row_count; k++)
        if (args_rows[k].value && !is_repeated_kind(args_rows[k].value, k)
            && argument_type_find(args_rows[k].value) != ARGUMENT_ANY)
            print_kind(args_rows[k].value);
    puts("    esac\n}");
}

/* Completes groups first, then names: all names together are more than a screen. */
static void print_setting(void)
{
    puts("_tidepool_setting()     # NAME=VALUE as far as it goes\n{\n"
         "    local name=${1%%=*}= value=${1#*=}\n    case $1 in");
    for (const char *choice = completion_next_choice(NULL); choice;
         choice = completion_next_choice(choice)) {
        fputs("    ", stdout);
        completion_print_choosers(choice, "=*");
        fputs(") compgen -P \"$name\" -W '", stdout);
        completion_print_choice(choice);
        puts("' -- \"$value\" ;;");
    }
    fputs("    ", stdout);
    completion_print_file_names("=*");
    puts(") compgen -P \"$name\" -f -- \"$value\" ;;\n    *=*) ;;");
    fputs("    *.*) compgen -W '", stdout);
    completion_print_names("=");
    fputs("' -- \"$1\" ;;\n    *) compgen -W '", stdout);
    completion_print_words("GROUP");
    puts("' -- \"$1\" ;;\n    esac\n}");
}

void completion_bash(void)
{
    puts("# Made by `tidepool completion bash`.");
    print_options();
    print_kinds();
    print_setting();
    print_values();
    fputs("_tidepool()\n{\n"
          "    local i kind word whole last=\n"
          "    local -a line=()\n"
          "    COMPREPLY=()\n"
          "    for ((i = 1; i <= COMP_CWORD; i++)); do\n"
          "        if ((i > 1)) && [[ ${COMP_WORDS[i]} == = || ${COMP_WORDS[i-1]} == = ]];"
          " then\n"
          "            line[-1]+=${COMP_WORDS[i]}\n"
          "        else\n"
          "            line+=(\"${COMP_WORDS[i]}\")\n"
          "        fi\n"
          "    done\n"
          "    whole=${line[-1]} word=$whole\n"
          "    ((${#line[@]} < 3)) || last=${line[-2]}\n"
          "    if ((${#line[@]} == 1)); then\n"
          "        mapfile -t COMPREPLY < <(compgen -W '--help --version", stdout);
    for (size_t i = 0; i < command_count; i++)
        printf(" %s", commands[i].name);
    puts("' -- \"$word\")\n"
         "        return\n"
         "    elif [[ $last == -* ]] && kind=$(_tidepool_kind \"${line[0]}\" \"$last\") "
         "&&\n"
         "            [[ $kind ]]; then\n"
         "        :\n"
         "    elif [[ $word == -*=* ]]; then\n"
         "        kind=$(_tidepool_kind \"${line[0]}\" \"${word%%=*}\")\n"
         "        word=${word#*=}\n"
         "    elif [[ $word == -* ]]; then\n"
         "        mapfile -t COMPREPLY < <(compgen -W"
         " \"$(_tidepool_options \"${line[0]}\")\" -- \"$word\")\n"
         "        return\n"
         "    else\n"
         "        kind=$(_tidepool_kind \"${line[0]}\")\n"
         "    fi\n"
         "    mapfile -t COMPREPLY < <(_tidepool_values \"$kind\""
         " \"$word\")\n"
         "    if [[ $COMP_WORDBREAKS != *=* ]]; then\n"
         "        COMPREPLY=(\"${COMPREPLY[@]/#/${whole%\"$word\"}}\")\n"
         "    elif [[ $word == *=* ]]; then\n"
         "        COMPREPLY=(\"${COMPREPLY[@]#\"${word%=*}=\"}\")\n"
         "    fi\n"
         "    case ${COMPREPLY[0]-} in\n"
         "    *[=.]) compopt -o nospace 2>/dev/null ;;\n"
         "    *) case $kind in\n"
         "       SCENE|FILE|FILM*|PATH|DIR|FOLDER|*=VALUE) compopt -o filenames "
         "2>/dev/null"
         " ;;\n"
         "       esac ;;\n"
         "    esac\n}\n"
         "complete -F _tidepool tidepool");
}
