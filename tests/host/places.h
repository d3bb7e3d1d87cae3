/* SPDX-License-Identifier: MIT */
/* Scenes naming a picture in one place, for tests: the result of loading, and the
 * messages. */
#ifndef TP_TESTS_PLACES_H
#define TP_TESTS_PLACES_H
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "../../ports/host/assets.h"
#include "../../ports/host/say.h"
#include <cmocka.h>

static const char *const textures[] = {
    "layer0.texture", "layer1.texture", "layer2.texture", "distortion.texture",
    "ripple.texture", "foam.texture", "sky.east", "sky.west", "sky.up", "sky.down",
    "sky.south", "sky.north", "tank.wall", "tank.floor", "floor.texture",
};
static const char *const greys[] = { "floor.map", "pool.mask", "field.mask" };

enum { TEXTURES = sizeof textures / sizeof *textures,
       GREYS = sizeof greys / sizeof *greys };

_Static_assert((int)TEXTURES == (int)ASSETS_PICTURES, "every place of a texture is tried");

/* -- messages ------------------------------------------------------------------------ */

static int kept_stderr;
static char said[8192];

static inline void listen(void)
{
    fflush(stderr);
    kept_stderr = dup(STDERR_FILENO);
    assert_non_null(freopen("said", "w", stderr));
}

static inline void stop_listening(void)
{
    fflush(stderr);
    dup2(kept_stderr, STDERR_FILENO);
    close(kept_stderr);
    FILE *file = fopen("said", "rb");
    assert_non_null(file);
    said[fread(said, 1, sizeof said - 1, file)] = '\0';
    fclose(file);
}

/* -- scenes with a picture ------------------------------------------------------------- */

static inline void put_setting(FILE *file, const char *row, const char *value)
{
    const char *dot = strchr(row, '.');
    fprintf(file, "[%.*s]\n%s = %s\n", (int)(dot - row), row, dot + 1, value);
}

/* Loads a scene naming a picture in its third line.  Returns the code; messages go to
 * `said`. */
static inline int open_one(const char *row, const char *name)
{
    scene_file scene;
    asset_set a;
    FILE *file = fopen("case.ini", "w");
    assert_non_null(file);
    fprintf(file, "; a case\n");
    put_setting(file, row, name);
    fclose(file);
    listen();
    int code = scene_file_open(&scene, "./case.ini");
    assert_int_equal(code, EXIT_DONE);
    code = assets_open(&a, &scene);
    if (!code)
        assets_close(&a);
    else
        assert_null(a.blocks);
    scene_file_close(&scene);
    stop_listening();
    return code;
}

/* -- a temporary folder ---------------------------------------------------------------- */

static char folder[4096];

static inline int enter(void **state)
{
    const char *place = getenv("TMPDIR");

    (void)state;
    snprintf(folder, sizeof folder, "%s/tidepool-images-XXXXXX",
             place && *place ? place : P_tmpdir);
    return mkdtemp(folder) && chdir(folder) == 0 ? 0 : -1;
}

static inline int leave(void **state)
{
    static const char *const made[] = { "kind.png", "bad.png", "case.ini", "said" };
    (void)state;
    for (size_t i = 0; i < sizeof made / sizeof *made; i++)
        remove(made[i]);
    return chdir("/") == 0 && rmdir(folder) == 0 ? 0 : -1;
}
#endif
