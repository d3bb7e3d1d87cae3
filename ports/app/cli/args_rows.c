/* SPDX-License-Identifier: MIT */
/* The table of options.  A row names an option, lists the commands that take the option,
 * and reads its value.  A new option needs one row and one function of a few lines. */
#include "args_rows.h"
#include <string.h>
#include "app/files/log.h"
#include "app/scene/frame_renderer.h"
#include "app/scene/scene_file.h"
#include "pixel/pixel.h"
#include "quality/rung_sets.h"
#include "tools/bench/bench_scene.h"
#include "world/text.h"

#define SIDE_LOW   16           /* bounds of a picture's side, px, as in the core */
#define SIDE_HIGH  4096
#define FRAME_HIGH 999999999u   /* ticks: half a year */
#define EVERY_HIGH 3600         /* one picture per minute */
#define KEPT_HIGH  (16u << 20)      /* bytes */

/* Reads a number in low..high of decimal digits.  end == NULL: the digits must fill the
 * text; else *end points after the last digit. */
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

static const char *read_every(options *o, const char *value)
{
    return read_count(value, NULL, 1, EVERY_HIGH, &o->every) ? NULL : "1..3600";
}

/* Reads a plain count; the first frame is 0. */
static const char *read_pictures(options *o, const char *value)
{
    uint32_t count;
    if (!read_count(value, NULL, 1, FRAME_HIGH, &count))
        return "a count from 1";
    o->counted = true;
    o->first = 0;
    o->last = count - 1;
    return NULL;
}

static const char *read_set(options *o, const char *value)
{
    o->settings[o->n_settings++] = value;
    return NULL;
}

static const char *read_format(options *o, const char *value)
{
    const int format = tp_format_find(value, (uint32_t)strlen(value));
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
    return read_count(value, NULL, 1, FRAME_RENDERER_THREADS, &o->threads) ? NULL : "1..64";
}

/* The suffixes k and M mean 1024 and 1024 k, as in the data sheets of boards. */
static bool read_bytes(const char *value, uint64_t *bytes)
{
    const char *end;
    uint32_t count;
    if (!read_count(value, &end, 1, UINT32_MAX, &count))
        return false;
    const uint32_t unit = *end == 'k' ? 1u << 10 : *end == 'M' ? 1u << 20 : 1;
    *bytes = (uint64_t)count * unit;
    return !end[unit > 1];
}

static const char *read_memory(options *o, const char *value)
{
    return read_bytes(value, &o->memory) ? NULL : "bytes from 1, such as 96k or 2M";
}

static const char *read_kept(options *o, const char *value)
{
    uint64_t bytes;
    if (!read_bytes(value, &bytes) || bytes > KEPT_HIGH)
        return "bytes, 1..16M, such as 2k";
    o->kept = (uint32_t)bytes;
    o->stream = true;
    return NULL;
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

static const char *read_rung(options *o, const char *value)
{
    o->rung = value;
    return scene_file_knows_rung(value) ? NULL : "exact, planned, named or fast";
}

static const char *read_board(options *o, const char *value)
{
    o->board = board_find(value);
    return o->board ? NULL : BOARD_NAMES;
}

static const char *read_fps(options *o, const char *value)
{
    return read_count(value, NULL, 1, 240, &o->fps) ? NULL : "pictures a second, 1..240";
}

static const char *read_step(options *o, const char *value)
{
    o->stepped = true;
    return read_count(value, NULL, 0, TP_SET_STEPS - 1, &o->step)
               ? NULL : "a step that `tidepool plan SCENE --ladder` lists";
}

static const char *read_machine(options *o, const char *value)
{
    size_t count;
    const machine *of = machine_list(&count);
    for (size_t i = 0; i < count; i++)
        if (!strcmp(of[i].name, value))
            o->machine = &of[i];
    return o->machine ? NULL : "a program that runs here: baseline, x86-64-v3";
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

static const char *read_scale(options *o, const char *value)
{
    return read_count(value, NULL, 1, 16, &o->scale) ? NULL : "1..16";
}

static const char *read_ui(options *o, const char *value)
{
    return read_count(value, NULL, 50, 400, &o->ui) ? NULL : "percent, 50..400";
}

static const char *read_jobs(options *o, const char *value)
{
    return read_count(value, NULL, 1, 1024, &o->jobs) ? NULL : "1..1024";
}

/* SWITCH: an option without a value.  WORD: an option with any value except the empty
 * text. */
#define SWITCH(name) \
    static const char *read_##name(options *o, const char *value) \
    { (void)value; o->name = true; return NULL; }
#define WORD(name, what) \
    static const char *read_##name(options *o, const char *value) \
    { o->name = value; return *value ? NULL : what; }
SWITCH(stream)
SWITCH(strict)
SWITCH(hash)
SWITCH(rungs)
SWITCH(peers)
SWITCH(small)
SWITCH(list)
SWITCH(collect)
SWITCH(resume)
SWITCH(hold)
SWITCH(scene_page)
SWITCH(no_panel)
SWITCH(no_input)
SWITCH(stats)
SWITCH(csv)
SWITCH(ladder)
SWITCH(help)
SWITCH(write)
WORD(out, "a file name")
WORD(expect, "a file name")
WORD(vectors, "a folder")
WORD(tape, "a file name")
WORD(play, "a file name")
WORD(keys, "a file name")
WORD(only, "the beginning of a name")
WORD(name, "a C identifier")
WORD(from, "a folder")
WORD(on, "fb or kms")
WORD(device, "a path")
WORD(keep, "a file name")
WORD(with, "names separated by commas")
WORD(without, "names separated by commas")

static const char *read_verbose(options *o, const char *value)
{
    (void)o;
    (void)value;
    log_set_verbose();
    return NULL;
}

const option_row args_rows[] = {
    { "--size", "WxH", FOR_RENDER | FOR_VIEW | FOR_PLAN, read_size,
      "size of the picture, 640x480 by default" },
    { "--size", "WxH", FOR_BAKE, read_size,
      "add a program that draws at this size; 320x240 by default" },
    { "--size", "WxH", FOR_BENCH, read_size,
      "size of the picture; by default 640x480 and 320x240" },
    { "--points", "N", FOR_BENCH, read_points,
      "points along a side; by default 64, 100, 128 and 256" },
    { "--work", "WORK", FOR_BENCH, read_work, "only plain, full or smooth" },
    { "--frames", "N", FOR_BENCH, read_pictures,
      "frames in each of three rounds, 10 by default" },
    { "--rungs", NULL, FOR_BENCH, read_rungs,
      "measure every rung of the plan, 128 points" },
    { "--peers", NULL, FOR_BENCH, read_peers,
      "build and measure other renderers too, 128 points" },
    { "--frames", "N|A:B", FOR_RENDER, read_frames,
      "frames 0..N-1 or A..B; frame n shows tick n, 1/60 s each" },
    { "--every", "N", FOR_RENDER, read_every,
      "only every Nth frame; 3: a film of 20 pictures a second" },
    { "--on", "PORT", FOR_SHOW, read_on, "fb (frame buffer) or kms; fb by default" },
    { "--device", "PATH", FOR_SHOW, read_device,
      "device file; by default /dev/fb0 or /dev/dri/card0" },
    { "--size", "WxH", FOR_SHOW, read_size,
      "size of the picture; the screen's by default" },
    { "--frames", "N|A:B", FOR_SHOW, read_frames,
      "draw every frame of 0..N-1 or A..B and end; else no end" },
    { "--hold", NULL, FOR_SHOW, read_hold, "keep showing the last frame of --frames" },
    { "--keep", "FILE", FOR_SHOW, read_keep,
      "save the world there each second, and continue from it" },
    { "-o", "FILE", FOR_BAKE, read_out,
      "the C file, or - for standard output; required" },
    { "--name", "NAME", FOR_BAKE, read_name,
      "prefix of the C names; the scene's name by default" },
    { "--set", "NAME=VALUE", DRAWERS | FOR_PARAMS | FOR_BAKE | FOR_PLAN, read_set,
      "change one parameter of the scene; may be repeated" },
    { "--rung", "NAME", RARE | DRAWERS | FOR_BAKE | FOR_PLAN, read_rung,
      "quality of all effects: exact, planned, named, fast" },
    { "--only", "GROUP", FOR_PARAMS, read_only,
      "only names that begin with GROUP: water, wave0., boat.m" },
    { "--out", "FILE", FOR_RENDER, read_out,
      "f-%04d.png, film.apng, film.y4m, or - for Y4M on stdout" },
    { "--format", "FORMAT", DRAWERS | FOR_PLAN, read_format,
      "xrgb8888 rgb565 rgb565be p8 l8 i1" },
    { "--format", "FORMAT", FOR_BAKE, read_format,
      "xrgb8888 rgb565 rgb565be p8 l8 i1; rgb565 by default" },
    { "--csv", NULL, FOR_PLAN | FOR_BENCH, read_csv, "print the table as CSV" },
    { "--ladder", NULL, FOR_PLAN, read_ladder,
      "list the steps from the exact picture to the cheapest" },
    { "--board", "NAME", FOR_PLAN, read_board,
      "find the step that the board draws in real time" },
    { "--fps", "N", FOR_PLAN, read_fps, "pictures a second on the board; by default 10" },
    { "--step", "N", RARE | FOR_RENDER | FOR_BAKE, read_step,
      "draw step N of the scene's ladder" },
    { "--band", "ROWS", RARE | FOR_BAKE, read_band,
      "rows of the program's tiles, 16 by default" },
    { "--strip", "COLS", RARE | FOR_BAKE, read_strip,
      "columns of the program's tiles; all by default" },
    { "--stream", NULL, RARE | FOR_BAKE, read_stream,
      "the program stores no vertices: less memory, same bits" },
    { "--kept", "BYTES", RARE | FOR_BAKE, read_kept,
      "stream, and keep lines from tile to tile of a strip; 2k" },
    { "--no-input", NULL, FOR_BAKE, read_no_input,
      "the program takes no input: only the scene's camera" },
    { "--with", "NAME,...", FOR_BAKE, read_with,
      "modules that may be switched on later; refuses others" },
    { "--without", "NAME,...", FOR_BAKE, read_without,
      "modules the program lacks; it draws without them" },
    { "--band", "ROWS", RARE | FOR_RENDER | FOR_PLAN, read_band,
      "draw in bands of ROWS rows" },
    { "--strip", "COLS", RARE | FOR_RENDER | FOR_PLAN, read_strip,
      "draw in strips of COLS columns, a multiple of 16" },
    { "--threads", "N", RARE | DRAWERS, read_threads, "draw tiles in N threads" },
    { "--memory", "BYTES", DRAWERS, read_memory,
      "refuse to draw if a board needs more RAM; 96k, 2M" },
    { "--stream", NULL, RARE | DRAWERS | FOR_PLAN, read_stream,
      "store no vertices of the water: less memory, same bits" },
    { "--kept", "BYTES", RARE | DRAWERS | FOR_PLAN, read_kept,
      "stream, and keep lines from tile to tile of a strip; 2k" },
    { "--texels", "N", RARE | DRAWERS | FOR_BAKE | FOR_PLAN, read_texels,
      "use pictures of at most N texels a side" },
    { "--strict", NULL, DRAWERS | FOR_PLAN, read_strict,
      "refuse a mesh that lacks a picture or material" },
    { "--strict", NULL, FOR_BAKE, read_strict,
      "refuse missing pictures, materials or modules" },
    { "--jobs", "N", FOR_CHARTS, read_jobs,
      "N jobs at a time; by default one per processor" },
    { "--only", "NAME,...", FOR_CHARTS, read_only, "run these charts only" },
    { "--small", NULL, FOR_CHARTS, read_small,
      "leave out long jobs, times and pictures" },
    { "--resume", NULL, FOR_CHARTS, read_resume,
      "reuse the jobs that an interrupted sweep finished" },
    { "--list", NULL, FOR_CHARTS, read_list, "print the jobs, run none" },
    { "--collect", NULL, FOR_CHARTS, read_collect,
      "run no job; merge files of rows that jobs printed" },
    { "--from", "FOLDER", FOR_CHARTS, read_from,
      "charts of another folder; nothing is built" },
    { "--visibility", "HOW", RARE | DRAWERS | FOR_PLAN, read_visibility,
      "auto triangles rows projected flat" },
    { "--hash", NULL, FOR_RENDER | FOR_SHOW, read_hash,
      "print the CRC-32 of every frame" },
    { "--expect", "FILE", FOR_RENDER, read_expect,
      "compare with a list of --hash; exit 1 if a frame differs" },
    { "--write", NULL, FOR_CHECK, read_write,
      "replace old names of parameters in SCENE's file" },
    { "--vectors", "DIR", FOR_CHECK, read_vectors,
      "compare the models with the tables in DIR" },
    { "--tape", "FILE", FOR_RENDER | FOR_SHOW, read_tape,
      "play the inputs recorded in FILE" },
    { "--scale", "N", FOR_VIEW, read_scale, "pixels N times as large, 1..16" },
    { "--no-panel", NULL, FOR_VIEW, read_no_panel, "start with the panel hidden" },
    { "--ui", "PERCENT", FOR_VIEW, read_ui, "size of the letters, 50..400" },
    { "--keys", "FILE", FOR_VIEW, read_keys,
      "file of keys; by default ~/.config/tidepool/keys.ini" },
    { "--tape", "FILE", FOR_VIEW, read_tape, "record your input in FILE" },
    { "--play", "FILE", FOR_VIEW, read_play, "play a recorded tape" },
    { "--resume", NULL, FOR_VIEW, read_resume,
      "continue where the last session ended" },
    { "--frames", "N", FOR_VIEW, read_pictures,
      "draw N pictures as fast as possible, and end" },
    { "--machine", "NAME", RARE | FOR_RENDER | FOR_SHOW, read_machine,
      "baseline or x86-64-v3, same bits; the best by default" },
    { "--stats", NULL, FOR_RENDER | FOR_VIEW, read_stats,
      "print times, counts and RAM as JSON" },
    { "--scene", NULL, FOR_MANUAL, read_scene_page,
      "print tidepool-scene(5), the page of all parameters" },
    { "--verbose", NULL, ALL, read_verbose,
      "print the source line of a check that fails" },
    { "--help", NULL, ALL, read_help, "print this text" },
};

const size_t args_row_count = sizeof args_rows / sizeof *args_rows;
