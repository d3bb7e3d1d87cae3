/* SPDX-License-Identifier: MIT */
/* Fuzzes whole tape files for a scene called "pond". An accepted tape is recorded again and
 * reads back the same; then the tape is played to the scene for the first ticks. */
#include "fuzz.h"
#include "app/scene/replay.h"

enum { TICKS = 8 };

/* -- the tape ---------------------------------------------------------------------- */

static bool is_nothing(const tp_input *input)
{
    const tp_input none = { 0 };
    return memcmp(input, &none, sizeof none) == 0;
}

static void require_order(const tape_file *d, unsigned lines)
{
    for (size_t i = 0; i < d->count; i++) {
        const tape_file_entry *e = &d->entries[i];
        REQUIRE(e->line > 1 && e->line <= lines);
        REQUIRE((e->kind == TAPE_FILE_SET) == (e->setting != NULL));
        if (i == 0)
            continue;
        REQUIRE(e->line > e[-1].line && e->tick >= e[-1].tick);
        REQUIRE(e->tick > e[-1].tick || e[-1].kind != TAPE_FILE_STEP);
    }
}

/* Records a tape. A recording has no line for an entry without input. */
static void record(const tape_file *d, const char *path)
{
    tape_file to;
    REQUIRE(tape_file_record(&to, path, "pond") == EXIT_DONE);
    for (size_t i = 0; i < d->count; i++) {
        const tape_file_entry *e = &d->entries[i];
        if (e->kind == TAPE_FILE_STEP)
            tape_file_add_input(&to, e->tick, &e->input);
        else if (e->kind == TAPE_FILE_LOOK)
            tape_file_add_look(&to, e->tick, &e->input);
        else
            tape_file_add_setting(&to, e->tick, e->setting);
    }
    REQUIRE(tape_file_close(&to) == EXIT_DONE);
}

static void compare(const tape_file *d, const tape_file *again)
{
    size_t k = 0;
    for (size_t i = 0; i < d->count; i++) {
        const tape_file_entry *e = &d->entries[i];
        if (e->kind != TAPE_FILE_SET && is_nothing(&e->input))
            continue;
        REQUIRE(k < again->count);
        const tape_file_entry *r = &again->entries[k];
        REQUIRE(r->tick == e->tick && r->kind == e->kind);
        REQUIRE(memcmp(&r->input, &e->input, sizeof e->input) == 0);
        REQUIRE(!e->setting || strcmp(r->setting, e->setting) == 0);
        k++;
    }
    REQUIRE(k == again->count);
}

/* Reads a tape. Returns false if the tape was rejected. */
static bool read_tape(const char *path, unsigned lines)
{
    tape_file d, again;
    const int code = tape_file_read(&d, path, "pond");
    if (code) {
        REQUIRE(code == EXIT_INPUT);
        fuzz_refused(path, lines);
    } else {
        const char *copy = fuzz_file(1, "", 0);
        require_order(&d, lines);
        record(&d, copy);
        REQUIRE(tape_file_read(&again, copy, "pond") == EXIT_DONE);
        compare(&d, &again);
        tape_file_close(&again);
    }
    tape_file_close(&d);
    return code == EXIT_DONE;
}

/* -- its scene --------------------------------------------------------------------- */

/* Path of the smallest scene with waves, pool and drops. */
static const char *scene_path(void)
{
    static const char text[] = "[grid]\ncols = 4\nrows = 4\n[pool]\ncols = 16\nrows = 16\n"
                               "[drops]\ncount = 2\n[wave0]\namplitude = 0.3\n";
    static char path[4200];
    if (!path[0]) {
        snprintf(path, sizeof path, "%s/pond.ini", fuzz_folder());
        FILE *file = fopen(path, "w");
        REQUIRE(file != NULL && fputs(text, file) >= 0 && fclose(file) == 0);
    }
    return path;
}

static int play_ticks(replay *r, loaded_scene *s, const options *o)
{
    bool opened = false;
    int code = EXIT_DONE;
    for (int tick = 0; tick < TICKS && !code; tick++) {
        code = replay_acts(r, s, o, &opened);
        if (!code)
            tp_world_step(&tp_program_all, s->world, &s->file.scene, replay_step(r));
    }
    return code;
}

static void play(const char *path, unsigned lines)
{
    const options o = { .scene = scene_path(), .tape = path, .width = 16, .height = 16 };
    loaded_scene s;
    replay r;
    REQUIRE(loaded_scene_load(&s, &o) == EXIT_DONE);
    if (replay_open(&r, &s, &o, REPLAY_ALL))
        fuzz_refused(path, lines);
    else
        REQUIRE(play_ticks(&r, &s, &o) == EXIT_DONE);   /* validated before */
    replay_close(&r);
    loaded_scene_close(&s);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    const unsigned lines = fuzz_lines(data, size);
    const char *path = fuzz_file(0, data, size);
    if (read_tape(path, lines))
        play(path, lines);
    return 0;
}
