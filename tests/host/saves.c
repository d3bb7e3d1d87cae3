/* SPDX-License-Identifier: MIT */
/* saves [-r] KIND COUNT PLACE SCENE: writes, or with -r reads, a file of one kind COUNT
 * times:
 *     keep FILE       a kept world
 *     session FOLDER  the preview's state, in FOLDER/tidepool
 *     scene FILE      the scene as INI
 *     picture FILE    a PNG
 * Two versions of the content alternate.  Prints the number of failures; exits with 3 if
 * there is one. */
#define _POSIX_C_SOURCE 200809L
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "app/files/picture.h"
#include "app/files/log.h"
#include "app/scene/scene_save.h"
#include "app/session/session.h"
#include "app/scene/loaded_scene.h"
#include "app/files/snapshot.h"

/* Defined by faults.c, if loaded. */
void faults_begin(void) __attribute__((weak));

typedef struct {
    loaded_scene       loaded;
    const char *place;
    snapshot_store        keep;
    session    *session;
    picture     picture;
} saver;

static int save_keep(saver *s, uint32_t number)
{
    return snapshot_write(&s->keep, s->loaded.world, s->loaded.world_bytes,
                          (snapshot_progress){ .frame = number });
}

static int read_keep(saver *s)
{
    snapshot_progress at;
    return snapshot_read(&s->keep, s->loaded.world, s->loaded.world_bytes, &at) ? EXIT_DONE
                                                                         : EXIT_INPUT;
}

static int save_session(saver *s, uint32_t number)
{
    return session_put(s->session, &s->loaded.file, &s->loaded.assets.names,
                       s->loaded.world, s->loaded.world_bytes, number);
}

static int read_session(saver *s)
{
    session_state state;
    const int code = session_read(&state);
    session_free(&state);
    (void)s;
    return code;
}

static int save_scene(saver *s, uint32_t number)
{
    (void)number;
    return scene_save(&s->loaded.file, s->place);
}

/* Returns 0 if the scene is one of the two saved versions, complete to the last line. */
static int read_scene(saver *s)
{
    scene_file file;
    int code = scene_file_open(&file, s->place);
    if (!code && file.scene.wave[0].phase != 10 * TP_FX_ONE
        && file.scene.wave[0].phase != 200 * TP_FX_ONE)
        code = EXIT_INPUT;
    scene_file_close(&file);
    return code;
}

static int save_picture(saver *s, uint32_t number)
{
    s->picture.rows[0] = (uint8_t)number;
    return picture_write_png(&s->picture, s->place);
}

static int read_picture(saver *s)
{
    uint32_t w, h, *pixels = picture_read_png(s->place, "saves", &w, &h);
    free(pixels);
    return pixels ? EXIT_DONE : EXIT_INPUT;
}

static const struct {
    const char *name;
    int (*save)(saver *s, uint32_t number);
    int (*read)(saver *s);
} kinds[] = {
    { "keep", save_keep, read_keep }, { "session", save_session, read_session },
    { "scene", save_scene, read_scene }, { "picture", save_picture, read_picture },
};

enum { KINDS = sizeof kinds / sizeof *kinds };

static size_t kind_of(const char *name)
{
    size_t kind = 0;
    while (kind < KINDS && strcmp(kinds[kind].name, name) != 0)
        kind++;
    return kind;
}

static int begin(saver *s, size_t kind, const char *scene)
{
    static uint8_t rows[64 * 48];
    const options o = { .scene = scene };
    const int code = loaded_scene_load(&s->loaded, &o);
    if (code)
        return code;
    s->keep = snapshot_begin(s->place, &s->loaded.file.scene, &s->loaded.assets.names);
    s->picture = (picture){ TP_FORMAT_L8, 64, 48, 64, rows };
    if (kinds[kind].save != save_session)
        return EXIT_DONE;
    setenv("XDG_STATE_HOME", s->place, 1);
    s->session = session_begin();
    return s->session ? EXIT_DONE : EXIT_INPUT;
}

static uint32_t repeat(saver *s, size_t kind, uint32_t count, bool reads)
{
    uint32_t failed = 0;
    for (uint32_t i = 0; i < count; i++) {
        const char *version = i % 2 ? "wave0.phase=10" : "wave0.phase=200";
        int code = scene_file_set(&s->loaded.file, version);
        if (!code)
            code = reads ? kinds[kind].read(s) : kinds[kind].save(s, i);
        failed += code != EXIT_DONE;
    }
    return failed;
}

int main(int argc, char **argv)
{
    saver s;
    const bool reads = argc > 1 && strcmp(argv[1], "-r") == 0;
    char **words = argv + reads;
    const size_t kind = argc - reads == 5 ? kind_of(words[1]) : KINDS;
    if (kind == KINDS)
        return EXIT_USAGE;
    memset(&s, 0, sizeof s);
    s.place = words[3];
    int code = begin(&s, kind, words[4]);
    if (!code && faults_begin)
        faults_begin();
    const uint32_t failed = code ? 0 : repeat(&s, kind, (uint32_t)atoi(words[2]), reads);
    session_end(s.session);
    loaded_scene_close(&s.loaded);
    if (!code)
        printf("%u\n", (unsigned)failed);
    return code ? code : failed ? EXIT_INPUT : EXIT_DONE;
}
