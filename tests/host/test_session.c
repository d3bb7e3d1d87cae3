/* SPDX-License-Identifier: MIT */
/* The preview's state on disk: written, read and resumed, alone and with a thread,
 * complete or not at all. */
#define _XOPEN_SOURCE 700
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>
#undef fail                     /* cmocka's, without arguments */
#include "app/session/session.h"
#include "app/scene/loaded_scene.h"
#include "world/world.h"

static char home[] = "/tmp/tidepool-state-XXXXXX";

/* -- helpers --------------------------------------------------------------------- */

static void open_stage(loaded_scene *s, const char *scene, char *const *settings,
                       uint32_t count)
{
    const options o = { .scene = scene };
    assert_int_equal(loaded_scene_load(s, &o), 0);
    for (uint32_t i = 0; i < count; i++)
        assert_int_equal(scene_file_set(&s->file, settings[i]), 0);
    assert_int_equal(loaded_scene_make_world(s), 0);
}

static void steps(loaded_scene *s, int count)
{
    for (; count > 0; count--)
        tp_world_step(&tp_program_all, s->world, &s->file.scene, NULL);
}

static int put(session *to, const loaded_scene *s, uint32_t number)
{
    return session_put(to, &s->file, &s->assets.names, s->world, s->world_bytes, number);
}

static bool offer(session *to, const loaded_scene *s, uint32_t number)
{
    return session_offer(to, &s->file, &s->assets.names, s->world, s->world_bytes,
                         number);
}

static char *state_path(const char *name)
{
    static char path[512];
    snprintf(path, sizeof path, "%s/state/tidepool/%s", home, name);
    return path;
}

/* Returns the number of kept worlds, and the name of one. */
static int worlds(char name[64])
{
    int count = 0;
    DIR *dir = opendir(state_path(""));
    for (struct dirent *entry; dir && (entry = readdir(dir)) != NULL;)
        if (strncmp(entry->d_name, "world-", 6) == 0) {
            snprintf(name, 64, "%.60s", entry->d_name);
            count++;
        }
    if (dir)
        closedir(dir);
    return count;
}

/* The last kept state equals this stage's, to the bit, at this frame. */
static void assert_resumes(const loaded_scene *was, uint32_t number)
{
    session_state state;
    loaded_scene now;
    uint32_t count, found = 0;
    const tp_param *params = tp_params(&count);
    assert_int_equal(session_read(&state), 0);
    assert_int_equal(state.scene[0], '/');
    open_stage(&now, state.scene, state.settings, state.count);
    for (uint32_t i = 0; i < count; i++) {
        char of_was[256], of_now[256];
        tp_param_text(&was->file.scene, &params[i], of_was, sizeof of_was);
        tp_param_text(&now.file.scene, &params[i], of_now, sizeof of_now);
        if (params[i].kind < TP_PARAM_MESH || params[i].kind > TP_PARAM_GREY)
            assert_string_equal(of_was, of_now);
    }
    assert_int_equal(now.world_bytes, was->world_bytes);
    assert_true(session_world(&now.file.scene, &now.assets.names, now.world,
                              now.world_bytes, &found));
    assert_int_equal(found, number);
    assert_memory_equal(now.world, was->world, was->world_bytes);
    loaded_scene_close(&now);
    session_free(&state);
}

static char said_text[2048];
static int said;

static const char *said_path(void)
{
    static char path[64];
    snprintf(path, sizeof path, "%s/said", home);
    return path;
}

static void listen(void)
{
    fflush(stderr);
    said = dup(STDERR_FILENO);
    assert_non_null(freopen(said_path(), "w", stderr));
}

static void heard(void)
{
    fflush(stderr);
    dup2(said, STDERR_FILENO);
    close(said);
    FILE *file = fopen(said_path(), "r");
    said_text[fread(said_text, 1, sizeof said_text - 1, file)] = 0;
    fclose(file);
}

static void assert_heard(const char *what)
{
    heard();
    if (!strstr(said_text, what))
        print_error("'%s' is not in '%s'\n", what, said_text);
    assert_non_null(strstr(said_text, what));
}

/* -- complete states ------------------------------------------------------------- */

static void what_was_put_is_read(void **state)
{
    (void)state;
    static char *const none[1], *const changes[] = {
        "wave0.amplitude=0.8", "scene.title=a ; 50%  b", "wave3.length=17.25",
        "scene.description=;", "boat.mesh=assets/boats/../boats/longship.obj",
    };
    char name[64];
    static const char *const scenes[] = { "three-swells", "pond", "raindrops",
                                          "shore-break" };
    session *to = session_begin();
    assert_non_null(to);
    for (int i = 0; i < 4; i++) {
        loaded_scene s;
        char path[64];
        snprintf(path, sizeof path, "assets/scenes/%s.ini", scenes[i]);
        open_stage(&s, path, i % 2 ? none : changes, i % 2 ? 0 : 5);
        steps(&s, 20 + i);
        assert_int_equal(put(to, &s, 7u + (uint32_t)i), 0);
        assert_resumes(&s, 7u + (uint32_t)i);
        assert_int_equal(worlds(name), 1);
        steps(&s, 5);
        assert_int_equal(put(to, &s, 90), 0);
        assert_resumes(&s, 90);
        loaded_scene_close(&s);
    }
    session_end(to);
}

/* Paths of scenes may be longer than a line of an INI file. */
static void long_paths_are_read(void **state)
{
    (void)state;
    char path[700], command[1600];
    static char *const none[1];
    snprintf(path, sizeof path, "%s/%0150d/a b;c/%0150d %%41/x.ini", home, 1, 2);
    snprintf(command, sizeof command, "d='%s'; mkdir -p \"${d%%/*}\" &&"
             " printf '[camera]\\nx = 3\\n' >\"$d\"", path);
    assert_int_equal(system(command), 0);
    loaded_scene s;
    session *to = session_begin();
    open_stage(&s, path, none, 0);
    assert_int_equal(put(to, &s, 1), 0);
    assert_resumes(&s, 1);
    loaded_scene_close(&s);
    session_end(to);
}

static void a_thread_writes_what_is_offered(void **state)
{
    (void)state;
    static char *const none[1];
    loaded_scene s;
    session *to = session_begin();
    open_stage(&s, "assets/scenes/pond.ini", none, 0);
    uint32_t taken = 0;
    for (uint32_t i = 1; i <= 60; i++) {
        steps(&s, 1);
        if (offer(to, &s, i))
            taken = i;
        if (i == 30) {                     /* now written from here too */
            assert_int_equal(put(to, &s, i), 0);
            assert_resumes(&s, i);
        }
    }
    assert_true(taken > 0);
    while (!offer(to, &s, 500))
        nanosleep(&(struct timespec){ 0, 1000000 }, NULL);
    session_end(to);
    assert_resumes(&s, 500);
    loaded_scene_close(&s);
}

/* Alternating scenes with worlds of different sizes. */
static void offers_follow_the_scene(void **state)
{
    (void)state;
    static char *const none[1], *const sea[] = { "wave0.length=31" };
    loaded_scene s[2];
    session *to = session_begin();
    open_stage(&s[0], "assets/scenes/pond.ini", none, 0);
    open_stage(&s[1], "assets/scenes/three-swells.ini", sea, 1);
    for (uint32_t i = 0; i < 20; i++)
        while (!offer(to, &s[i % 2], i))
            nanosleep(&(struct timespec){ 0, 1000000 }, NULL);
    session_end(to);
    assert_resumes(&s[1], 19);
    loaded_scene_close(&s[0]);
    loaded_scene_close(&s[1]);
}

/* -- incomplete states ----------------------------------------------------------- */

static long size_of(const char *path)
{
    struct stat info;
    return stat(path, &info) == 0 ? (long)info.st_size : -1;
}

/* Replaces a byte of a file and returns the old byte. */
static uint8_t put_byte(const char *path, long at, uint8_t byte)
{
    FILE *file = fopen(path, "r+b");
    uint8_t was;

    assert_non_null(file);
    fseek(file, at, SEEK_SET);
    assert_int_equal(fread(&was, 1, 1, file), 1);
    fseek(file, at, SEEK_SET);
    putc(byte, file);
    assert_int_equal(fclose(file), 0);
    return was;
}

static void put_pond(loaded_scene *s)
{
    static char *const change[] = { "wave0.amplitude=0.8" };
    session *to = session_begin();
    open_stage(s, "assets/scenes/pond.ini", change, 1);
    steps(s, 3);
    assert_int_equal(put(to, s, 3), 0);
    session_end(to);
}

static void a_cut_file_is_not_gone_on_with(void **state)
{
    (void)state;
    loaded_scene s;
    session_state got;
    put_pond(&s);
    char *path = strdup(state_path("session.ini"));
    for (long bytes = size_of(path) - 1; bytes >= 0; bytes -= 1) {
        assert_int_equal(truncate(path, bytes), 0);
        listen();
        assert_int_equal(session_read(&got), 0);
        assert_null(got.scene);
        session_free(&got);
        assert_heard("session.ini: incomplete: a fresh start\n");
    }
    free(path);
    loaded_scene_close(&s);
}

static bool take(loaded_scene *s)
{
    uint32_t number = 77;
    tp_world *was = malloc(s->world_bytes);
    memcpy(was, s->world, s->world_bytes);
    const bool taken = session_world(&s->file.scene, &s->assets.names, s->world,
                                     s->world_bytes, &number);
    if (!taken) {
        assert_memory_equal(was, s->world, s->world_bytes);
        assert_int_equal(number, 77);
    }
    free(was);
    return taken;
}

static void a_cut_or_foreign_world_is_not_taken(void **state)
{
    (void)state;
    char name[64];
    loaded_scene s;
    session_state got;
    put_pond(&s);
    assert_int_equal(worlds(name), 1);
    char *path = strdup(state_path(name));
    /* snapshot.c: magic, version, scene, build */
    const uint8_t build = put_byte(path, 12, 0);
    put_byte(path, 12, build ^ 1);
    listen();
    assert_false(take(&s));
    assert_heard("was saved by another build: a fresh start\n");
    put_byte(path, 12, build);
    assert_true(take(&s));
    put_byte(path, 7, TP_WORLD_VERSION - 1);
    listen();
    assert_false(take(&s));
    assert_heard("holds a world of version 5, this program has version 6: a fresh start\n");
    put_byte(path, 7, TP_WORLD_VERSION);
    assert_true(take(&s));
    assert_int_equal(truncate(path, size_of(path) - 1), 0);
    listen();
    assert_false(take(&s));
    assert_heard("incomplete: a fresh start\n");
    unlink(path);
    listen();
    assert_false(take(&s));
    assert_heard("No such file or directory: a fresh start\n");
    assert_int_equal(session_read(&got), 0);        /* the changes are still there */
    assert_int_equal(got.count, 1);
    assert_string_equal(got.settings[0], "wave0.amplitude=0.8");
    session_free(&got);
    free(path);
    loaded_scene_close(&s);
}

static void another_scene_is_not_taken(void **state)
{
    (void)state;
    loaded_scene s;
    put_pond(&s);
    assert_int_equal(scene_file_set(&s.file, "wave0.amplitude=0.9"), 0);
    listen();
    assert_false(take(&s));
    assert_heard("belongs to another scene: a fresh start\n");
    loaded_scene_close(&s);
}

/* -- no folder ------------------------------------------------------------------- */

static void nowhere_is_said_once(void **state)
{
    (void)state;
    session_state got;
    loaded_scene s;
    static char *const none[1];
    listen();
    setenv("XDG_STATE_HOME", said_path(), 1);       /* a file */
    assert_null(session_begin());
    unsetenv("XDG_STATE_HOME");
    unsetenv("HOME");
    assert_null(session_begin());
    heard();
    assert_string_equal(said_text, "tidepool view: Not a directory: nothing is saved for"
                        " --resume\n");
    listen();
    assert_int_equal(session_read(&got), 0);
    assert_null(got.scene);
    session_free(&got);
    assert_heard("neither XDG_STATE_HOME nor HOME is set: a fresh start\n");
    open_stage(&s, "assets/scenes/minimal.ini", none, 0);
    assert_false(offer(NULL, &s, 1));
    assert_int_equal(put(NULL, &s, 1), 3);
    session_end(NULL);
    assert_false(take(&s));
    loaded_scene_close(&s);
}

static void home_has_a_folder_for_it(void **state)
{
    (void)state;
    loaded_scene s;
    char path[128];
    struct stat info;
    setenv("XDG_STATE_HOME", "not/absolute", 1);
    put_pond(&s);
    snprintf(path, sizeof path, "%s/.local/state/tidepool", home);
    assert_int_equal(stat(path, &info), 0);
    assert_int_equal(info.st_mode & 0777, 0700);
    strcat(path, "/session.ini");
    assert_true(size_of(path) > 0);
    loaded_scene_close(&s);
}

static void nothing_kept_is_said(void **state)
{
    (void)state;
    session_state got;
    setenv("XDG_STATE_HOME", "/nonexistent", 1);
    listen();
    assert_int_equal(session_read(&got), 0);
    assert_null(got.scene);
    session_free(&got);
    assert_heard("/nonexistent/tidepool/session.ini: no saved state: a fresh start\n");
}

static void what_is_kept_and_cannot_be_read_is_refused(void **state)
{
    (void)state;
    loaded_scene s;
    session_state got;
    put_pond(&s);
    loaded_scene_close(&s);
    char *path = strdup(state_path("session.ini"));
    assert_int_equal(unlink(path), 0);
    assert_int_equal(mkdir(path, 0700), 0);
    listen();
    assert_int_equal(session_read(&got), 3);
    session_free(&got);
    assert_heard("session.ini: Is a directory: nothing to resume\n");
    assert_int_equal(rmdir(path), 0);
    free(path);
}

/* A folder removed during the run: reported once in a row. */
static void a_lost_folder_is_said(void **state)
{
    (void)state;
    loaded_scene s;
    static char *const none[1];
    char command[128];
    session *to = session_begin();
    open_stage(&s, "assets/scenes/minimal.ini", none, 0);
    snprintf(command, sizeof command, "rm -rf %s/state", home);
    assert_int_equal(system(command), 0);
    listen();
    assert_int_equal(put(to, &s, 1), 3);
    assert_int_equal(put(to, &s, 2), 3);
    heard();
    assert_non_null(strstr(said_text, ": cannot be saved: No such file or directory\n"));
    assert_ptr_equal(strchr(said_text, '\n'), strrchr(said_text, '\n'));
    loaded_scene_close(&s);
    session_end(to);
}

/* -- set-up ---------------------------------------------------------------------- */

static int begin(void **state)
{
    (void)state;
    return mkdtemp(home) ? 0 : -1;
}

static int place(void **state)
{
    (void)state;
    char path[128];
    snprintf(path, sizeof path, "%s/state", home);
    return setenv("HOME", home, 1) | setenv("XDG_STATE_HOME", path, 1);
}

static int end(void **state)
{
    (void)state;
    char command[64];
    snprintf(command, sizeof command, "rm -rf %s", home);
    return system(command);
}

#define CASE(name) cmocka_unit_test_setup(name, place)

int main(void)
{
    const struct CMUnitTest tests[] = {
        CASE(what_was_put_is_read),
        CASE(long_paths_are_read),
        CASE(a_thread_writes_what_is_offered),
        CASE(offers_follow_the_scene),
        CASE(a_cut_file_is_not_gone_on_with),
        CASE(a_cut_or_foreign_world_is_not_taken),
        CASE(another_scene_is_not_taken),
        CASE(home_has_a_folder_for_it),
        CASE(nothing_kept_is_said),
        CASE(what_is_kept_and_cannot_be_read_is_refused),
        CASE(a_lost_folder_is_said),
        CASE(nowhere_is_said_once),
    };
    return cmocka_run_group_tests(tests, begin, end);
}
