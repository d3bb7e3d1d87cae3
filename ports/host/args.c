/* SPDX-License-Identifier: MIT */
/* Reading options.  A row of the table names an option, says which commands take it,
 * and reads its value: a new option is a row and a function of a few lines. */
#include "args.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "bench_scene.h"
#include "canvas.h"
#include "nearest.h"
#include "say.h"

#define SIDE_LOW   16           /* of a picture, as the core takes it */
#define SIDE_HIGH  4096
#define FRAME_HIGH 999999999u   /* half a year of ticks */

/* Reads a value into *o; NULL, or what was expected instead. */
typedef const char *(*reader)(options *o, const char *value);

typedef struct {
    const char *name, *value;   /* value: NULL for a switch */
    unsigned    commands;
    reader      read;
    const char *help;
} option_row;

/* Decimal digits alone, low..high; *end, if asked for, is where they stop. */
static bool read_count(const char *text, const char **end, uint32_t low, uint32_t high,
                       uint32_t *count)
{
    uint64_t n = 0;
    const char *c = text;
    for (; *c >= '0' && *c <= '9'; c++) {
        n = n * 10 + (uint64_t)(*c - '0');
        if (n > high)
            return false;
    }
    if (c == text || n < low || (!end && *c))
        return false;
    *count = (uint32_t)n;
    if (end)
        *end = c;
    return true;
}

static const char *read_size(options *o, const char *value)
{
    const char *end;
    if (read_count(value, &end, SIDE_LOW, SIDE_HIGH, &o->width) && *end == 'x'
        && read_count(end + 1, NULL, SIDE_LOW, SIDE_HIGH, &o->height)) {
        o->sized = true;
        return NULL;
    }
    return "WIDTHxHEIGHT, each 16..4096";
}

static const char *read_frames(options *o, const char *value)
{
    const char *end;
    uint32_t count;
    o->counted = true;
    if (read_count(value, NULL, 1, FRAME_HIGH, &count)) {
        o->first = 0;
        o->last = count - 1;
        return NULL;
    }
    if (read_count(value, &end, 0, FRAME_HIGH, &o->first) && *end == ':'
        && read_count(end + 1, NULL, o->first, FRAME_HIGH, &o->last))
        return NULL;
    return "a count from 1, or FIRST:LAST with 0 <= FIRST <= LAST <= 999999999";
}

static const char *read_set(options *o, const char *value)
{
    o->settings[o->n_settings++] = value;
    return NULL;
}

static const char *read_format(options *o, const char *value)
{
    const int format = tp_format_of(value, (uint32_t)strlen(value));
    o->format = (tp_format)(format < 0 ? 0 : format);
    o->formatted = true;
    return format < 0 ? "xrgb8888, rgb565, rgb565be, p8, l8 or i1" : NULL;
}

static const char *read_band(options *o, const char *value)
{
    return read_count(value, NULL, 1, SIDE_HIGH, &o->band) ? NULL : "rows, 1..4096";
}

static const char *read_strip(options *o, const char *value)
{
    return read_count(value, NULL, 16, SIDE_HIGH, &o->strip) && o->strip % 16 == 0
           ? NULL : "columns, a multiple of 16 in 16..4096";
}

static const char *read_threads(options *o, const char *value)
{
    return read_count(value, NULL, 1, CANVAS_THREADS, &o->threads) ? NULL : "1..64";
}

/* k and M are 1024 and 1024 k, as boards' data sheets count. */
static const char *read_memory(options *o, const char *value)
{
    const char *end;
    uint32_t count;
    if (!read_count(value, &end, 1, UINT32_MAX, &count))
        return "bytes from 1, or with a k or M behind";
    const uint32_t unit = *end == 'k' ? 1u << 10 : *end == 'M' ? 1u << 20 : 1;
    o->memory = (uint64_t)count * unit;
    return end[unit > 1] ? "bytes from 1, or with a k or M behind" : NULL;
}

static const char *read_visibility(options *o, const char *value)
{
    const tp_param *row = tp_param_find("quality.visibility", 18);
    tp_scene scene;
    tp_error err;
    if (tp_param_set(&scene, row, value, strlen(value), &err))
        return "auto, triangles, rows, projected or flat";
    o->visibility = scene.quality.visibility;
    return NULL;
}

static const char *read_kit(options *o, const char *value)
{
    size_t count;
    const machine *of = machine_kits(&count);
    for (size_t i = 0; i < count; i++)
        if (!strcmp(of[i].name, value))
            o->machine = &of[i];
    return o->machine ? NULL : "a kit that runs here: baseline, x86-64-v3";
}

static const char *read_texels(options *o, const char *value)
{
    return read_count(value, NULL, 1, SIDE_HIGH, &o->texels) ? NULL : "texels, 1..4096";
}

static const char *read_points(options *o, const char *value)
{
    return read_count(value, NULL, 2, 1024, &o->points) ? NULL : "2..1024";
}

static const char *read_work(options *o, const char *value)
{
    for (int i = 0; i < BENCH_WORKS; i++)
        if (strcmp(value, bench_work_name[i]) == 0)
            o->work = i;
    return o->work < 0 ? "plain, full or smooth" : NULL;
}

static const char *read_jobs(options *o, const char *value)
{
    return read_count(value, NULL, 1, 1024, &o->jobs) ? NULL : "1..1024";
}

/* Switches, and words that may be anything but empty. */
#define SWITCH(name) \
    static const char *read_##name(options *o, const char *value) \
    { (void)value; o->name = true; return NULL; }
#define WORD(name, what) \
    static const char *read_##name(options *o, const char *value) \
    { o->name = value; return *value ? NULL : what; }
SWITCH(stream)
SWITCH(hash)
SWITCH(rungs)
SWITCH(peers)
SWITCH(small)
SWITCH(list)
SWITCH(collect)
SWITCH(resume)
SWITCH(hold)
SWITCH(stats)
SWITCH(csv)
SWITCH(help)
WORD(out, "a file name")
WORD(expect, "a file name")
WORD(vectors, "a folder")
WORD(tape, "a file name")
WORD(only, "the beginning of a name")
WORD(name, "a name in C")
WORD(from, "a folder")
WORD(on, "fb or kms")
WORD(device, "a path")
WORD(keep, "a file name")

static const char *read_verbose(options *o, const char *value)
{
    (void)o;
    (void)value;
    say_verbose();
    return NULL;
}

#define ALL (FOR_RENDER | FOR_VIEW | FOR_PARAMS | FOR_SCENES | FOR_CHECK | FOR_BAKE \
             | FOR_PLAN | FOR_BENCH | FOR_CHARTS | FOR_JOIN | FOR_SHOW)
#define DRAWERS (FOR_RENDER | FOR_VIEW | FOR_SHOW)
#define MANY (FOR_CHARTS | FOR_JOIN)

static const option_row rows[] = {
    { "--size", "WxH", FOR_RENDER | FOR_VIEW | FOR_PLAN, read_size,
      "picture, 640x480 by default" },
    { "--size", "WxH", FOR_BENCH, read_size, "of the picture; else 640x480 and 320x240" },
    { "--points", "N", FOR_BENCH, read_points, "of a side; else 64, 100, 128 and 256" },
    { "--work", "WORD", FOR_BENCH, read_work, "plain, full or smooth alone" },
    { "--frames", "N", FOR_BENCH, read_frames, "of each of three rounds, 10 by default" },
    { "--rungs", NULL, FOR_BENCH, read_rungs, "by every rung of the plan, 128 points" },
    { "--peers", NULL, FOR_BENCH, read_peers,
      "and by other renderers that are built now, 128 points" },
    { "--frames", "N|A:B", FOR_RENDER, read_frames,
      "0..N-1 or A..B; n is the world after n ticks of 1/60 s" },
    { "--on", "PORT", FOR_SHOW, read_on, "fb, the frame buffer, or kms; fb by default" },
    { "--device", "PATH", FOR_SHOW, read_device, "else /dev/fb0 or /dev/dri/card0" },
    { "--size", "WxH", FOR_SHOW, read_size, "of the picture; the screen's by default" },
    { "--frames", "N|A:B", FOR_SHOW, read_frames,
      "0..N-1 or A..B, each of them, and end; else for ever" },
    { "--hold", NULL, FOR_SHOW, read_hold, "stay on the last of them" },
    { "--keep", "FILE", FOR_SHOW, read_keep,
      "keep the world there each second, and go on from it" },
    { "-o", "FILE", FOR_BAKE, read_out, "the C file, or - for standard output; needed" },
    { "--name", "NAME", FOR_BAKE, read_name,
      "what its names begin with; else the scene's name" },
    { "--set", "NAME=VALUE", DRAWERS | FOR_PARAMS | FOR_BAKE | FOR_PLAN, read_set,
      "change one parameter of the scene; may be repeated" },
    { "--only", "WORD", FOR_PARAMS, read_only,
      "names that begin so: water, wave0., boat.m" },
    { "--out", "FILE", FOR_RENDER, read_out,
      "f-%04d.png, film.y4m, or - for a film to stdout" },
    { "--format", "NAME", DRAWERS | FOR_PLAN, read_format,
      "xrgb8888 rgb565 rgb565be p8 l8 i1" },
    { "--csv", NULL, FOR_PLAN | FOR_BENCH, read_csv, "a table for programs" },
    { "--band", "ROWS", FOR_RENDER | FOR_PLAN, read_band, "draw in bands of so many rows" },
    { "--strip", "COLS", FOR_RENDER | FOR_PLAN, read_strip, "draw in strips, columns in 16s" },
    { "--threads", "N", DRAWERS, read_threads, "draw tiles in N threads" },
    { "--memory", "BYTES", DRAWERS, read_memory,
      "refuse to draw with more; 96k, 2M" },
    { "--stream", NULL, DRAWERS, read_stream,
      "keep no vertices of the water: less memory, same bits" },
    { "--texels", "N", DRAWERS | FOR_BAKE, read_texels,
      "use pictures of no more than N texels a side" },
    { "--jobs", "N", FOR_CHARTS, read_jobs, "so many at a time; else one a processor" },
    { "--only", "NAME,...", FOR_CHARTS, read_only, "these charts alone" },
    { "--small", NULL, FOR_CHARTS, read_small, "without what takes long, times and pictures" },
    { "--resume", NULL, FOR_CHARTS, read_resume,
      "take the jobs that an interrupted sweep finished" },
    { "--list", NULL, FOR_CHARTS, read_list, "print the jobs, and run none" },
    { "--collect", NULL, FOR_CHARTS, read_collect, "run none: merge files of their rows" },
    { "--from", "FOLDER", FOR_CHARTS, read_from,
      "other charts than the project's; nothing is built" },
    { "--visibility", "HOW", DRAWERS | FOR_PLAN, read_visibility,
      "auto triangles rows projected flat" },
    { "--hash", NULL, FOR_RENDER | FOR_SHOW, read_hash, "print the CRC-32 of every frame" },
    { "--expect", "FILE", FOR_RENDER, read_expect,
      "compare with such a list; exit 1 where it differs" },
    { "--vectors", "DIR", FOR_CHECK, read_vectors, "the folder of tables; needed" },
    { "--tape", "FILE", FOR_RENDER | FOR_SHOW, read_tape, "play the inputs recorded there" },
    { "--tape", "FILE", FOR_VIEW, read_tape, "record your inputs there" },
    { "--kit", "NAME", FOR_RENDER | FOR_SHOW, read_kit,
      "baseline or x86-64-v3, the same bits; else the best" },
    { "--stats", NULL, FOR_RENDER, read_stats, "print times, counts and RAM as JSON" },
    { "--verbose", NULL, ALL, read_verbose, "name the check that refused something" },
    { "--help", NULL, ALL, read_help, "this text" },
};

#define ROWS (sizeof rows / sizeof *rows)

void args_print(unsigned command)
{
    for (size_t i = 0; i < ROWS; i++) {
        const option_row *row = &rows[i];
        char left[32];
        if (!(row->commands & command))
            continue;
        snprintf(left, sizeof left, "%s %s", row->name, row->value ? row->value : "");
        printf("  %-18s %s\n", left, row->help);
    }
}

static int refuse(const options *o, const char *what)
{
    return fail(EXIT_USAGE, "tidepool %s: %s; see `tidepool %s --help`", o->command, what,
                o->command);
}

static int refuse_option(const options *o, unsigned command, const char *name)
{
    char what[160];
    nearest best = nearest_to(name);
    for (size_t i = 0; i < ROWS; i++)
        if (rows[i].commands & command)
            nearest_offer(&best, rows[i].name);
    snprintf(what, sizeof what, best.name ? "no option %.60s; did you mean %s?"
                                          : "no option %.60s", name, best.name);
    return refuse(o, what);
}

static const option_row *row_of(unsigned command, const char *word, size_t length)
{
    for (const option_row *row = rows; row < rows + ROWS; row++)
        if ((row->commands & command) && strlen(row->name) == length
            && memcmp(row->name, word, length) == 0)
            return row;
    return NULL;
}

/* "--name value" or "--name=value"; *i moves on if the value is its own word. */
static int read_option(options *o, unsigned command, int argc, char **argv, int *i)
{
    const char *word = argv[*i], *equals = strchr(word, '=');
    const size_t length = equals ? (size_t)(equals - word) : strlen(word);
    char what[160];
    const option_row *row = row_of(command, word, length);
    if (!row || (!row->value && equals))
        return refuse_option(o, command, word);
    const char *value = equals ? equals + 1 : row->value ? argv[++*i] : "";
    if (row->value && *i >= argc) {
        snprintf(what, sizeof what, "%s needs a value", row->name);
        return refuse(o, what);
    }
    const char *expected = row->read(o, value);
    if (!expected)
        return EXIT_DONE;
    snprintf(what, sizeof what, "%s %.40s: expected %s", row->name, value, expected);
    return refuse(o, what);
}

/* What must be there, and what cannot be together. */
static int check(const options *o, unsigned command)
{
    const bool all = !o->help;
    if (o->band && o->strip)
        return refuse(o, "--band and --strip exclude each other");
    if (o->rungs && o->peers)
        return refuse(o, "--rungs and --peers exclude each other");
    if (o->list + o->collect + o->resume > 1)
        return refuse(o, "--list, --collect and --resume exclude each other");
    if (!o->scene && all && (command & (DRAWERS | FOR_BAKE | FOR_PLAN)))
        return refuse(o, "which scene?");
    if (!o->out && all && (command & FOR_BAKE))
        return refuse(o, "which file?  It takes -o FILE.c");
    if (o->hold && !o->counted)
        return refuse(o, "--hold is of the last of --frames");
    if (!o->vectors && all && (command & FOR_CHECK))
        return refuse(o, "which folder?  It takes --vectors DIR");
    if (!all || !(command & MANY))
        return EXIT_DONE;
    const uint32_t least = o->list ? 0 : command & FOR_JOIN || o->collect ? 2 : 1;
    if (o->n_names < least)
        return refuse(o, least == 1 ? "which folder?" : command & FOR_JOIN
                      ? "which film, and which parts?" : "which files, and which folder?");
    if (command & FOR_CHARTS && !o->collect && o->n_names > least)
        return refuse(o, "too many names");
    return EXIT_DONE;
}

int args_read(options *o, unsigned command, int argc, char **argv)
{
    *o = (options){ .command = argv[0], .width = 640, .height = 480,
                      .work = -1 };
    o->settings = calloc(2 * (size_t)argc, sizeof *o->settings);
    if (!o->settings)
        return fail_memory(2 * (size_t)argc * sizeof *o->settings);
    o->names = o->settings + argc;
    for (int i = 1; i < argc; i++) {
        int code = EXIT_DONE;
        if (argv[i][0] == '-' && (argv[i][1] || !(command & MANY)))
            code = read_option(o, command, argc, argv, &i);
        else if (command & MANY)
            o->names[o->n_names++] = argv[i];
        else if (o->scene || (command & (FOR_SCENES | FOR_CHECK | FOR_BENCH)))
            code = refuse(o, "too many names");
        else
            o->scene = argv[i];
        if (code)
            return code;
    }
    return check(o, command);
}
