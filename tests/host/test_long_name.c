/* SPDX-License-Identifier: MIT */
/* Files with a path longer than a scene can hold: they load, and each file naming them
 * has the full path. */
#define _XOPEN_SOURCE 700
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#undef log_fail                     /* cmocka's, without arguments */
#include "app/scene/tape_file.h"
#include "app/scene/long_name.h"
#include "app/files/log.h"
#include "app/scene/scene_save.h"
#include "app/session/session.h"
#include "app/scene/loaded_scene.h"
#include "world/text.h"

enum { FOLDERS = 15, FOLDER = 240 };

static char home[] = "/tmp/tidepool-long-XXXXXX";
static char folder[4096], mesh[4096];           /* of the mesh; about 3700 bytes */

/* -- short names -------------------------------------------------------------------- */

/* Returns a path of `bytes` bytes with the given end. */
static char *path_of(size_t bytes, char fill, const char *end)
{
    char *path = malloc(bytes + 1);
    memset(path, fill, bytes + 1);
    path[0] = '/';
    strcpy(path + bytes - strlen(end), end);
    return path;
}

static void assert_short(const char *whole)
{
    const char *text = long_name_shorten(whole, strlen(whole));
    assert_non_null(text);
    assert_true(strlen(text) < TP_NAME_BYTES);
    assert_string_equal(long_name_whole(text), whole);
    assert_ptr_equal(long_name_shorten(whole, strlen(whole)), text);
}

static void a_short_name_stands_for_a_long_one(void **state)
{
    (void)state;
    static const size_t bytes[] = { 128, 129, 200, 4095 };
    static const char *const ends[] = { "", "/", "/boat.obj", "/boats/long/boat.obj" };
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < 4; k++)
            for (char fill = 'a'; fill <= 'e'; fill++) {
                char *path = path_of(bytes[i], fill, ends[k]);
                assert_short(path);
                free(path);
            }
    assert_string_equal(long_name_whole("boat.obj"), "boat.obj");
    assert_string_equal(long_name_whole(""), "");
}

static void it_shows_the_last_folders(void **state)
{
    (void)state;
    char *path = path_of(300, 'x', "/ships/small/boat.obj");
    assert_string_equal(long_name_shorten(path, 300), ".../ships/small/boat.obj");
    path[5] = 'y';
    assert_string_equal(long_name_shorten(path, 300), "...2.../ships/small/boat.obj");
    free(path);
}

/* UTF-8 letters of two bytes are not cut in half. */
static void letters_stay_whole(void **state)
{
    (void)state;
    for (size_t odd = 0; odd < 2; odd++) {
        char path[300] = "";
        strcpy(path, odd ? "x" : "");
        for (int i = 0; i < 100; i++)
            strcat(path, "\xc3\xb6");
        const char *text = long_name_shorten(path, strlen(path));
        assert_memory_equal(text + strspn(text, ".2"), "\xc3\xb6", 2);
    }
}

/* -- scenes ------------------------------------------------------------------------- */

static void write_text(const char *name, const char *text)
{
    FILE *file = fopen(name, "w");
    assert_non_null(file);
    fputs(text, file);
    assert_int_equal(fclose(file), 0);
}

/* Returns "boat.mesh=" with the full path. */
static const char *setting(void)
{
    static char text[4200];
    snprintf(text, sizeof text, "boat.mesh=%s", mesh);
    return text;
}

static const tp_param *row(void)
{
    return tp_param_find("boat.mesh", 9);
}

static void assert_loads(const char *scene, const char *set)
{
    loaded_scene s;
    const options o = { .scene = scene, .settings = &set, .n_settings = set ? 1 : 0,
                        .strict = true };
    assert_int_equal(loaded_scene_load(&s, &o), EXIT_DONE);
    assert_non_null(s.assets.names.boat);
    char *path = scene_file_resolve_path(&s.file, row());
    assert_string_equal(path, mesh);
    free(path);
    loaded_scene_close(&s);
}

static void it_loads_from_the_command_line(void **state)
{
    (void)state;
    write_text("plain.ini", "");
    assert_loads("./plain.ini", setting());
}

static void it_loads_from_a_scene_file(void **state)
{
    (void)state;
    char text[4300];
    snprintf(text, sizeof text, "; a case\n[boat]\n  mesh =\t%s ; the long one\r\n", mesh);
    write_text("long.ini", text);
    assert_loads("./long.ini", NULL);
}

/* Sets the name, undoes and sets again, as the panel does. */
static void it_is_set_while_the_world_moves(void **state)
{
    (void)state;
    loaded_scene s;
    char text[TP_NAME_BYTES + 64], again[TP_NAME_BYTES + 96];
    bool opened = false;
    const options o = { .scene = "./plain.ini" };
    assert_int_equal(loaded_scene_load(&s, &o), EXIT_DONE);
    assert_int_equal(loaded_scene_set(&s, &o, "a test", setting(), &opened), EXIT_DONE);
    assert_non_null(s.assets.names.boat);
    scene_file_text(&s.file, row(), text, sizeof text);
    assert_string_equal(long_name_whole(text), mesh);
    assert_int_equal(loaded_scene_set(&s, &o, "a test", "boat.mesh=", &opened), EXIT_DONE);
    assert_null(s.assets.names.boat);
    snprintf(again, sizeof again, "boat.mesh=%s", text);
    assert_int_equal(loaded_scene_set(&s, &o, "a test", again, &opened), EXIT_DONE);
    assert_non_null(s.assets.names.boat);
    loaded_scene_close(&s);
}

static void a_saved_scene_names_it_in_full(void **state)
{
    (void)state;
    scene_file file;
    assert_int_equal(scene_file_open(&file, "./plain.ini"), EXIT_DONE);
    assert_int_equal(scene_file_set(&file, setting()), EXIT_DONE);
    assert_int_equal(scene_save(&file, "saved.ini"), EXIT_DONE);
    assert_int_equal(scene_save(&file, "saved.ini"), EXIT_DONE);    /* over the same file */
    scene_file_close(&file);
    assert_int_equal(scene_file_open(&file, "./saved.ini"), EXIT_DONE);
    char *path = scene_file_resolve_path(&file, row());
    assert_int_equal(access(path, R_OK), 0);
    assert_non_null(strstr(path, "/boat.obj"));
    free(path);
    scene_file_close(&file);
}

static void a_tape_names_it_in_full(void **state)
{
    (void)state;
    tape_file d;
    const char *value;
    char text[4200];
    assert_int_equal(tape_file_record(&d, "long.tape", "plain"), EXIT_DONE);
    assert_ptr_equal(scene_file_check("a test", setting(), &value), row());
    snprintf(text, sizeof text, "boat.mesh=%s", value);
    assert_true(strlen(text) < 200);
    tape_file_add_setting(&d, 3, text);
    assert_int_equal(tape_file_close(&d), EXIT_DONE);
    assert_int_equal(tape_file_read(&d, "long.tape", "plain"), EXIT_DONE);
    assert_int_equal(d.count, 1);
    assert_string_equal(d.entries[0].setting, setting());
    assert_int_equal(tape_file_close(&d), EXIT_DONE);
}

static void a_session_names_it_in_full(void **state)
{
    (void)state;
    loaded_scene s;
    session_state kept;
    const char *set = setting();
    const options o = { .scene = "./plain.ini", .settings = &set, .n_settings = 1 };
    setenv("XDG_STATE_HOME", home, 1);
    assert_int_equal(loaded_scene_load(&s, &o), EXIT_DONE);
    session *to = session_begin();
    assert_non_null(to);
    assert_int_equal(session_put(to, &s.file, &s.assets.names, s.world, s.world_bytes, 1),
                     EXIT_DONE);
    session_end(to);
    loaded_scene_close(&s);
    assert_int_equal(session_read(&kept), EXIT_DONE);
    assert_int_equal(kept.count, 1);
    assert_string_equal(kept.settings[0], setting());
    session_free(&kept);
}

/* -- a temporary folder --------------------------------------------------------------- */

static int enter(void **state)
{
    (void)state;
    if (!mkdtemp(home) || chdir(home) != 0)
        return -1;
    strcpy(folder, home);
    for (int i = 0; i < FOLDERS; i++) {
        snprintf(folder + strlen(folder), sizeof folder - strlen(folder), "/%0*d", FOLDER,
                 i);
        if (mkdir(folder, 0700) != 0)
            return -1;
    }
    snprintf(mesh, sizeof mesh, "%.4000s/boat.obj", folder);
    write_text(mesh, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    return 0;
}

static int leave(void **state)
{
    (void)state;
    char command[64];
    snprintf(command, sizeof command, "rm -rf %s", home);
    return chdir("/") == 0 ? system(command) : -1;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_short_name_stands_for_a_long_one),
        cmocka_unit_test(it_shows_the_last_folders),
        cmocka_unit_test(letters_stay_whole),
        cmocka_unit_test(it_loads_from_the_command_line),
        cmocka_unit_test(it_loads_from_a_scene_file),
        cmocka_unit_test(it_is_set_while_the_world_moves),
        cmocka_unit_test(a_saved_scene_names_it_in_full),
        cmocka_unit_test(a_tape_names_it_in_full),
        cmocka_unit_test(a_session_names_it_in_full),
    };
    return cmocka_run_group_tests_name("long_name", tests, enter, leave);
}
