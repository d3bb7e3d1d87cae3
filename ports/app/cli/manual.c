/* SPDX-License-Identifier: MIT */
/* tidepool manual: prints tidepool(1), from the tables of commands, options, keys and exit
 * codes, and tidepool-scene(5), from the table of parameters. */
#include "manual.h"
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "app/session/actions.h"
#include "args_rows.h"
#include "command_help.h"
#include "commands.h"
#include "roff.h"
#include "tidepool/tidepool.h"

typedef struct { const char *name, *help; } manual_entry;

static const manual_entry environment[] = {
    { "DISPLAY, WAYLAND_DISPLAY", "The display on which the preview opens its window."
                                  " Without them `make run` draws to files." },
    { "SDL_VIDEODRIVER, SDL_RENDER_DRIVER", "SDL's drivers of the preview's window." },
    { "PATH", "The folders searched for ffmpeg, which encodes the preview's films; without"
      " ffmpeg films are Y4M." },
    { "XDG_CONFIG_HOME", "The folder of tidepool/keys.ini, ~/.config by default." },
    { "XDG_STATE_HOME", "The folder of the state that --resume restores,"
                        " ~/.local/state by default." },
    { "TERM", "A terminal other than dumb shows the progress of a long drawing." },
};

static const manual_entry files[] = {
    { "~/.config/tidepool/keys.ini", "The preview's keys, as under KEYS." },
    { "~/.local/state/tidepool/", "The state of the preview, for --resume." },
    { "FILE of --keep", "The world that `tidepool show` draws. Every number in the file is"
      " checked before use. If the file was altered, or saved by another build or for"
      " another scene, a message says so and the scene starts from the beginning." },
    { "SCENE-0001.png, .mp4, .y4m, .tape", "Recordings of the preview, in its current"
                                           " folder, with the next free number." },
    { "SCENE.png, SCENE.apng", "The pictures of `tidepool render SCENE` without --out." },
    { "share/tidepool/scenes/", "The shipped scenes, under the prefix of the"
                                " installation." },
};

static const manual_entry examples[] = {
    { "tidepool view", "A window on three swells; F1 lists the keys." },
    { "tidepool render storm", "A picture: storm.png." },
    { "tidepool render storm --frames 180 --every 3",
      "Three seconds of the storm as an animated PNG, storm.apng, for web pages." },
    { "tidepool render storm --frames 300 --out storm.y4m",
      "A film of five seconds, for players and encoders." },
    { "tidepool params storm --only wave0.", "The parameters of a wave." },
    { "tidepool render storm --set wave0.amplitude=2 --out high.png",
      "A picture of a higher sea." },
};

#define COUNT(table) (sizeof (table) / sizeof *(table))

void manual_head(const char *name, int section, const char *book, const char *what)
{
    roff_macro(".\\\" Made by `tidepool manual`.");
    roff_macro(".TH %s %d %s \"tidepool %s\" \"%s\"", name, section, TP_VERSION_DATE,
               tp_version(), book);
    roff_macro(".SH NAME");
    roff_text(what);
}

static void print_entries(const char *title, const manual_entry *of, size_t count)
{
    roff_macro(".SH %s", title);
    for (size_t i = 0; i < count; i++) {
        roff_macro(".TP");
        roff_bold(of[i].name);
        roff_end();
        roff_text(of[i].help);
    }
}

/* Prints "tidepool view [SCENE]..."; words with capitals are placeholders, in italics. */
static void print_usage_line(const char *at, size_t bytes)
{
    const char *end = at + bytes;
    while (at < end) {
        char word[32];
        const size_t length = strcspn(at, " \n");
        snprintf(word, sizeof word, "%.*s", (int)length, at);
        if (word[strcspn(word, "ABCDEFGHIJKLMNOPQRSTUVWXYZ")])
            roff_italic(word);
        else
            roff_bold(word);
        at += length + 1;
        roff_text(at < end ? " " : "");
    }
    roff_end();
}

static void print_usage(const command_help_row *of)
{
    const char *line = of->usage;
    for (;;) {
        const size_t bytes = strcspn(line, "\n");
        print_usage_line(line, bytes);
        if (!line[bytes])
            break;
        roff_macro(".br");
        line += bytes + 1;
    }
}

/* Prints lines as filled paragraphs; an empty line begins a new paragraph. */
static void print_lines(const char *text)
{
    bool begun = false;
    while (*text) {
        char line[96];
        const size_t bytes = strcspn(text, "\n");
        snprintf(line, sizeof line, "%.*s", (int)bytes, text);
        if (!bytes)
            begun = false;
        if (bytes && !begun)
            roff_macro(".PP");
        begun = begun || bytes;
        roff_text(line);
        roff_end();
        text += bytes + 1;
    }
}

static void print_option(const option_row *row)
{
    roff_macro(".TP");
    roff_bold(row->name);
    if (row->value) {
        roff_text(" ");
        roff_italic(row->value);
    }
    roff_end();
    roff_text(row->help);
}

static void print_commands(void)
{
    roff_macro(".SH COMMANDS");
    for (size_t i = 0; i < command_count; i++) {
        roff_macro(".SS %s", commands[i].name);
        const command_help_row *about = command_help_find(commands[i].options);
        print_usage(about);
        print_lines(about->text);
        for (size_t k = 0; k < args_row_count; k++)
            if (args_rows[k].commands != ALL
                && (args_rows[k].commands & commands[i].options))
                print_option(&args_rows[k]);
        print_lines(about->after);
        char codes[COMMAND_HELP_EXITS_BYTES];
        command_help_exits(about, codes);
        roff_macro(".PP");
        roff_text(codes);
        roff_end();
    }
    roff_macro(".SH OPTIONS OF EVERY COMMAND");
    for (size_t k = 0; k < args_row_count; k++)
        if (args_rows[k].commands == ALL)
            print_option(&args_rows[k]);
}

static void print_key(const char *keys, const char *name, const char *help)
{
    roff_macro(".TP");
    roff_bold(keys);
    if (name) {
        roff_text(" (");
        roff_italic(name);
        roff_text(")");
    }
    roff_end();
    roff_text(help);
}

/* Prints the keys by groups, in the order of first occurrence. */
static void print_keys(void)
{
    bool done[ACTIONS] = { false };
    roff_macro(".SH KEYS");
    roff_text("The preview's default keys, each with the name of its action. A file of keys"
              " changes them: a line");
    roff_macro(".PP");
    roff_text("    drop = Return Ctrl+D");
    roff_macro(".PP");
    roff_text("sets the keys of an action; a line without a key removes them.");
    for (int i = 0; i < ACTIONS; i++) {
        if (done[i])
            continue;
        roff_macro(".SS %s", actions[i].group);
        for (int k = i; k < ACTIONS; k++)
            if (strcmp(actions[k].group, actions[i].group) == 0) {
                print_key(actions[k].keys, actions[k].name, actions[k].help);
                done[k] = true;
            }
    }
    roff_macro(".SS mouse and gamepad");
    for (size_t i = 0; i < action_note_count; i++)
        print_key(action_notes[i].keys, NULL, action_notes[i].help);
}

static void print_exits(void)
{
    roff_macro(".SH EXIT STATUS");
    for (int i = 0; i < EXIT_CODES; i++) {
        char code[12];
        snprintf(code, sizeof code, "%d", i);
        print_key(code, exits[i].words, exits[i].sentence);
    }
    print_key("128 + N", "as shells report it", "Signal N ended the program; the"
              " screen was restored first.");
}

static void print_program(void)
{
    manual_head("TIDEPOOL", 1, "User Commands", "tidepool - water for small computers");
    roff_macro(".SH SYNOPSIS");
    for (size_t i = 0; i < command_count; i++) {
        if (i)
            roff_macro(".br");
        print_usage(command_help_find(commands[i].options));
    }
    roff_macro(".SH DESCRIPTION");
    roff_text("Models seas, pools, drops and a boat in 16.16 fixed point and draws them:"
              " in a window, on a screen without a window system, into pictures and"
              " films. Every machine draws the same bits.");
    roff_macro(".PP");
    roff_italic("SCENE");
    roff_text(" is the name of a shipped scene or the path of an INI file, see ");
    roff_bold("tidepool-scene");
    roff_text("(5).");
    print_commands();
    print_keys();
    print_exits();
    print_entries("ENVIRONMENT", environment, COUNT(environment));
    print_entries("FILES", files, COUNT(files));
    print_entries("EXAMPLES", examples, COUNT(examples));
    roff_macro(".SH SEE ALSO");
    roff_bold("tidepool-scene");
    roff_text("(5)");
    roff_end();
}

int manual_command(int argc, char **argv)
{
    options o;
    int code = args_read(&o, FOR_MANUAL, argc, argv);
    if (!code && o.help) {
        command_help_print(FOR_MANUAL);
    } else if (!code && o.scene_page) {
        manual_scene();
    } else if (!code) {
        print_program();
    }
    free(o.settings);
    const int end = streams_finish();
    return code ? code : end;
}
