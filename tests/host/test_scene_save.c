/* SPDX-License-Identifier: MIT */
/* Scenes saved and read again: unchanged shipped scenes keep every byte; changed scenes
 * are equal when read again and keep every comment; small files of unusual spelling are
 * compared line by line. */
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
#include <time.h>
#include <unistd.h>
#include "app/files/path.h"
#include "app/scene/scene_save.h"
#include "world/text.h"

static char folder[] = "/tmp/tidepool-save-XXXXXX";
static char scenes[4096];       /* assets/scenes, absolute */

static char *in_folder(const char *name)
{
    return path_join(folder, name, "");
}

static char *slurp(const char *path)
{
    FILE *file = fopen(path, "rb");
    assert_non_null(file);
    char *text = calloc(1, 65536);
    assert_true(fread(text, 1, 65535, file) < 65535);
    fclose(file);
    return text;
}

static void spill(const char *path, const char *text)
{
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    fputs(text, file);
    fclose(file);
}

/* Compares every value, names by the files they lead to. */
static void assert_same_scene(const scene_file *a, const scene_file *b)
{
    uint32_t count;
    const tp_param *params = tp_params(&count);
    for (uint32_t i = 0; i < count; i++) {
        char of_a[256], of_b[256];
        tp_param_text(&a->scene, &params[i], of_a, sizeof of_a);
        tp_param_text(&b->scene, &params[i], of_b, sizeof of_b);
        const tp_param_kind kind = params[i].kind;
        if (kind >= TP_PARAM_MESH && kind <= TP_PARAM_GREY && of_a[0]) {
            char *file_a = scene_file_resolve_path(a, &params[i]);
            char *file_b = scene_file_resolve_path(b, &params[i]);
            char *real_a = realpath(file_a, NULL), *real_b = realpath(file_b, NULL);
            if (!real_a || !real_b || strcmp(real_a, real_b) != 0)
                fail_msg("%s: %s is not %s", params[i].name, file_b, file_a);
            free(real_a);
            free(real_b);
            free(file_a);
            free(file_b);
        } else if (strcmp(of_a, of_b) != 0) {
            fail_msg("%s: %s is not %s", params[i].name, of_b, of_a);
        }
    }
}

static void assert_reread(const scene_file *file, const char *name)
{
    scene_file again;
    assert_int_equal(scene_file_open(&again, name), 0);
    assert_same_scene(file, &again);
    scene_file_close(&again);
}

/* -- small files ----------------------------------------------------------------- */

/* Opens a file with the text `before`, applies settings, saves, and expects the text
 * `after`. */
static void check(const char *before, const char *const *settings, const char *after)
{
    scene_file file;
    char *name = in_folder("small.ini");
    spill(name, before);
    assert_int_equal(scene_file_open(&file, name), 0);
    for (; *settings; settings++)
        assert_int_equal(scene_file_set(&file, *settings), 0);
    assert_int_equal(scene_save(&file, name), 0);
    char *text = slurp(name);
    assert_string_equal(text, after);
    assert_reread(&file, name);
    free(text);
    scene_file_close(&file);
    free(name);
}

#define CHECK(before, after, ...) \
    check(before, (const char *const[]){ __VA_ARGS__, NULL }, after)

static void values_change_behind_their_equals(void **state)
{
    (void)state;
    CHECK("# a\n[camera]\nx = 1\ny=2\n\tz\t:\t3  \n",
          "# a\n[camera]\nx = 4\ny=5\n\tz\t:\t6  \n",
          "camera.x=4", "camera.y=5", "camera.z=6");
    CHECK("[camera]\nx = 1   ; metres\ny = 2 ;b\n",
          "[camera]\nx = 4   ; metres\ny = 5 ;b\n",
          "camera.x=4", "camera.y=5");
    CHECK("[water]\ncolour = #ff0000 ; red\n", "[water]\ncolour = #00ff00 ; red\n",
          "water.colour=#00ff00");
    CHECK("[scene]\ntitle =\n", "[scene]\ntitle = Sea\n", "scene.title=Sea");
    CHECK("[scene]\ntitle = ; none\n", "[scene]\ntitle = Sea ; none\n",
          "scene.title=Sea");
    CHECK("[camera]\nx = 1", "[camera]\nx = 4", "camera.x=4");
    CHECK("camera.x = 1\n", "camera.x = 4\n", "camera.x=4");
    CHECK("[camera]\nx = 1\nx = 2\n", "[camera]\nx = 1\nx = 4\n", "camera.x=4");
}

static void old_names_stay(void **state)
{
    (void)state;
    CHECK("[pool]\npoke = 0.3 ; high\nfeed=1\n", "[pool]\npoke = 0.5 ; high\nfeed=1\n",
          "pool.splash_height=0.5");
}

static void unchanged_values_keep_their_spelling(void **state)
{
    (void)state;
    CHECK("[camera]\nx = 1.50\ny = +2e0\n", "[camera]\nx = 1.50\ny = +2e0\n",
          "camera.x=1.5");
    CHECK("[tank]\nsea = yes\n[camera]\nx=0\n",
          "[tank]\nsea = yes\n[camera]\nx=0\n",
          "tank.sea=on", "camera.x=0");
}

static void defaults_go(void **state)
{
    (void)state;
    CHECK("[camera]\nx = 1\ny = 2\n", "[camera]\ny = 2\n", "camera.x=0");
    CHECK("[camera]\nx = 1\n\n[wave0]\nlength = 5\n", "[wave0]\nlength = 5\n",
          "camera.x=0");
    CHECK("[camera]\n# where\nx = 1 ; east\ny = 2\n",
          "[camera]\n# where\n; east\ny = 2\n",
          "camera.x=0");
    CHECK("[camera]\nx = 1\nx = 2\ny = 1\n", "[camera]\ny = 1\n", "camera.x=0");
    CHECK("[camera]\nx = 1\n\n# of waves\n[wave0]\nlength = 5\n",
          "[camera]\nz = 9\n\n# of waves\n[wave0]\nlength = 5\n", "camera.x=0",
          "camera.z=9");
}

static void new_values_end_their_section(void **state)
{
    (void)state;
    CHECK("[camera]\nx = 1\n\n# of waves\n[wave0]\nlength = 5\n",
          "[camera]\nx = 1\nz = 9\npitch = -3\n\n# of waves\n[wave0]\nlength = 5\n",
          "camera.z=9", "camera.pitch=-3");
    CHECK("[camera]\nx = 1", "[camera]\nx = 1\nz = 9\n", "camera.z=9");
    CHECK("[camera]\n; nothing\n", "[camera]\nz = 9\n; nothing\n", "camera.z=9");
    CHECK("[camera]\nx = 1", "[camera]\nx = 1\n\n[wave0]\namplitude = 1\nlength = 5\n"
          "\n[wave1]\namplitude = 2\n", "wave0.length=5", "wave0.amplitude=1",
          "wave1.amplitude=2");
    CHECK("", "[camera]\nz = 9\n", "camera.z=9");
    CHECK("[camera]\nx = 1\n[wave0]\nlength = 5\n[camera]\ny = 2\n",
          "[camera]\nx = 1\n[wave0]\nlength = 5\n[camera]\ny = 2\nz = 9\n", "camera.z=9");
}

static void line_ends_and_marks_stay(void **state)
{
    (void)state;
    CHECK("[camera]\r\nx = 1 ; m\r\n\r\n[wave0]\r\nlength = 5\r\n",
          "[camera]\r\nx = 4 ; m\r\nz = 9\r\n\r\n[wave0]\r\nlength = 5\r\n"
          "\r\n[wave1]\r\nlength = 6\r\n", "camera.x=4", "camera.z=9", "wave1.length=6");
    CHECK("\xef\xbb\xbf[camera]\nx = 1\n", "\xef\xbb\xbf[camera]\nx = 1\nz = 9\n",
          "camera.z=9");
}

static void a_long_comment_makes_room(void **state)
{
    (void)state;
    char comment[190], title[128], before[512], after[512], setting[256];
    memset(comment, '-', sizeof comment - 1);
    comment[sizeof comment - 1] = 0;
    memset(title, 'T', sizeof title - 1);
    title[sizeof title - 1] = 0;
    snprintf(before, sizeof before, "[scene]\ntitle = a ;%.180s\n", comment);
    snprintf(after, sizeof after, "[scene]\n;%.180s\ntitle = %s\n", comment, title);
    snprintf(setting, sizeof setting, "scene.title=%s", title);
    CHECK(before, after, setting);
}

/* -- scenes that cannot be saved ------------------------------------------------- */

static void texts_that_begin_comments_are_refused(void **state)
{
    (void)state;
    static const char *const titles[] = { "scene.title=a ;b", "scene.title=;b" };
    char *name = in_folder("small.ini");
    for (size_t i = 0; i < 2; i++) {
        scene_file file;
        spill(name, "[scene]\ntitle = old\n");
        assert_int_equal(scene_file_open(&file, name), 0);
        assert_int_equal(scene_file_set(&file, titles[i]), 0);
        assert_int_equal(scene_save(&file, name), 3);
        char *text = slurp(name);
        assert_string_equal(text, "[scene]\ntitle = old\n");
        free(text);
        scene_file_close(&file);
    }
    CHECK("", "[scene]\ntitle = a;b #c\n", "scene.title=a;b #c");
    free(name);
}

static void a_folder_that_is_not_there_is_said(void **state)
{
    (void)state;
    scene_file file;
    assert_int_equal(scene_file_open(&file, "assets/scenes/pond.ini"), 0);
    assert_int_equal(scene_save(&file, "/nonexistent/x/y.ini"), 3);
    scene_file_close(&file);
}

static void a_file_that_is_gone_is_written_anew(void **state)
{
    (void)state;
    scene_file file;
    char *name = in_folder("gone.ini");
    spill(name, "# lost\n[camera]\nx = 1\n");
    assert_int_equal(scene_file_open(&file, name), 0);
    unlink(name);
    assert_int_equal(scene_save(&file, name), 0);
    assert_reread(&file, name);
    scene_file_close(&file);
    free(name);
}

static void what_cannot_be_read_is_put_right(void **state)
{
    (void)state;
    scene_file file;
    char *name = in_folder("small.ini");
    spill(name, "[camera]\ny = 1\n");
    assert_int_equal(scene_file_open(&file, name), 0);
    spill(name, "[camera]\nx = wide\ny = high\nw = 5\n");
    assert_int_equal(scene_save(&file, name), 0);
    char *text = slurp(name);
    assert_string_equal(text, "[camera]\ny = 1\nw = 5\n");
    free(text);
    scene_file_close(&file);
    free(name);
}

/* -- shipped scenes -------------------------------------------------------------- */

/* Counts lines that begin with # or ;. */
static size_t comments(const char *text)
{
    size_t n = 0;
    for (const char *line = text; line; line = strchr(line, '\n')) {
        line += *line == '\n';
        n += *line == '#' || *line == ';';
    }
    return n;
}

/* A copy in a similar folder, so that the same relative names work. */
static void unchanged_scenes_are_the_same_bytes(void **state)
{
    (void)state;
    size_t count;
    char **names = path_scene_names("assets/scenes", &count);
    assert_true(count >= 17);
    for (size_t i = 0; i < count; i++) {
        scene_file file;
        char *from = path_join("assets/scenes", names[i], ".ini");
        char *beside = path_join(folder, "scenes", "/saved.ini");
        assert_int_equal(scene_file_open(&file, from), 0);
        assert_int_equal(scene_save(&file, beside), 0);
        char *before = slurp(from), *after = slurp(beside);
        assert_string_equal(after, before);
        assert_reread(&file, beside);
        unlink(beside);
        scene_file_close(&file);
        free(before);
        free(after);
        free(beside);
        free(from);
    }
    path_free_names(names, count);
}

static uint32_t seed;

static uint32_t chance(uint32_t most)
{
    seed = seed * 1664525u + 1013904223u;
    return (uint32_t)((uint64_t)seed * most >> 32);
}

/* Sets a random value; names are left alone. */
static void change(scene_file *file, const tp_param *param)
{
    char text[64], setting[128];
    const int64_t span = (int64_t)param->high - param->low;
    if (param->kind >= TP_PARAM_MESH)
        return;
    const int32_t value = chance(4) == 0 ? param->normal
        : (int32_t)(param->low + (int64_t)((double)span * chance(1u << 30) / (1u << 30)));
    tp_param_number_text(param, value, text, sizeof text);
    snprintf(setting, sizeof setting, "%s=%s", param->name, text);
    assert_int_equal(scene_file_set(file, setting), 0);
}

static void random_changes_read_back(void **state)
{
    (void)state;
    size_t count;
    uint32_t rows;
    const tp_param *params = tp_params(&rows);
    char **names = path_scene_names("assets/scenes", &count);
    const char *given = getenv("TP_SEED");
    seed = given ? (uint32_t)strtoul(given, NULL, 10) : (uint32_t)time(NULL);
    print_message("seed %u\n", (unsigned)seed);
    for (size_t i = 0; i < 10 * count; i++) {
        scene_file file;
        char *from = path_join("assets/scenes", names[i % count], ".ini");
        char *other = in_folder(i % 2 ? "a/b/other.ini" : "other.ini");
        assert_int_equal(scene_file_open(&file, from), 0);
        for (uint32_t n = 1 + chance(i % 3 ? 12 : 300); n > 0; n--)
            change(&file, &params[chance(rows)]);
        assert_int_equal(scene_save(&file, other), 0);
        assert_reread(&file, other);
        char *before = slurp(from), *after = slurp(other);
        assert_int_equal(comments(after), comments(before));
        unlink(other);
        free(before);
        free(after);
        scene_file_close(&file);
        free(other);
        free(from);
    }
    path_free_names(names, count);
}

static void names_of_the_command_line_are_told_from_the_file(void **state)
{
    (void)state;
    scene_file file;
    char *other = in_folder("a/b/other.ini");
    assert_int_equal(scene_file_open(&file, "assets/scenes/minimal.ini"), 0);
    assert_int_equal(scene_file_set(&file, "boat.mesh=assets/boats/longship.obj"), 0);
    assert_int_equal(scene_save(&file, other), 0);
    assert_reread(&file, other);
    char *text = slurp(other);
    assert_non_null(strstr(text, "\nmesh = ../../"));
    unlink(other);
    free(text);
    scene_file_close(&file);
    free(other);
}

/* -- destinations ---------------------------------------------------------------- */

static void a_persons_file_is_written_in_place(void **state)
{
    (void)state;
    scene_file file;
    char *own = in_folder("small.ini");
    spill(own, "[camera]\nx = 1\n");
    assert_int_equal(scene_file_open(&file, own), 0);
    char *name = scene_save_name(&file);
    assert_string_equal(name, own);
    free(name);
    scene_file_close(&file);
    free(own);
}

/* Run as another program with scenes beside it, in an empty folder: prints the names for
 * saving a shipped scene, first without and then with a file of that name. */
static int print_names(const char *given)
{
    scene_file file;
    int code = scene_file_open(&file, given);
    for (int i = 0; i < 2 && !code; i++) {
        char *name = scene_save_name(&file);
        printf("%s\n", name);
        spill(name, "");
        free(name);
    }
    scene_file_close(&file);
    return code;
}

static void shipped_scenes_are_saved_in_the_current_folder(void **state)
{
    (void)state;
    char command[16384], line[64] = "";
    snprintf(command, sizeof command, "mkdir -p %s/p/bin %s/p/share/tidepool %s/p/here &&"
             " cp /proc/%ld/exe %s/p/bin/t && ln -s %s %s/p/share/tidepool/scenes &&"
             " cd %s/p/here && ../bin/t pond && rm -r %s/p", folder, folder, folder,
             (long)getpid(), folder, scenes, folder, folder, folder);
    FILE *from = popen(command, "r");
    assert_non_null(from);
    assert_non_null(fgets(line, sizeof line, from));
    assert_string_equal(line, "pond.ini\n");
    assert_non_null(fgets(line, sizeof line, from));
    assert_string_equal(line, "pond-2.ini\n");
    assert_int_equal(pclose(from), 0);
}

/* -- set-up ---------------------------------------------------------------------- */

/* Makes a temporary folder, with a folder beside links to the files named by scenes. */
static int begin(void **state)
{
    (void)state;
    static const char *const linked[] = { "boats", "textures", "skies" };
    if (!realpath("assets/scenes", scenes) || !mkdtemp(folder))
        return -1;
    static const char *const made[] = { "scenes", "a", "a/b" };
    for (size_t i = 0; i < 3; i++) {
        char *path = in_folder(made[i]), *link = in_folder(linked[i]), to[4200];
        snprintf(to, sizeof to, "%s/../%s", scenes, linked[i]);
        const int bad = mkdir(path, 0777) | symlink(to, link);
        free(path);
        free(link);
        if (bad)
            return -1;
    }
    return 0;
}

static int end(void **state)
{
    (void)state;
    static const char *const made[] = { "small.ini", "gone.ini", "boats", "textures",
                                        "skies", "scenes", "a/b", "a", "" };
    for (size_t i = 0; i < sizeof made / sizeof *made; i++) {
        char *path = in_folder(made[i]);
        remove(path);
        free(path);
    }
    return 0;
}

int main(int argc, char **argv)
{
    if (argc > 1)
        return print_names(argv[1]);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(values_change_behind_their_equals),
        cmocka_unit_test(old_names_stay),
        cmocka_unit_test(unchanged_values_keep_their_spelling),
        cmocka_unit_test(defaults_go),
        cmocka_unit_test(new_values_end_their_section),
        cmocka_unit_test(line_ends_and_marks_stay),
        cmocka_unit_test(a_long_comment_makes_room),
        cmocka_unit_test(texts_that_begin_comments_are_refused),
        cmocka_unit_test(a_folder_that_is_not_there_is_said),
        cmocka_unit_test(a_file_that_is_gone_is_written_anew),
        cmocka_unit_test(what_cannot_be_read_is_put_right),
        cmocka_unit_test(unchanged_scenes_are_the_same_bytes),
        cmocka_unit_test(random_changes_read_back),
        cmocka_unit_test(names_of_the_command_line_are_told_from_the_file),
        cmocka_unit_test(a_persons_file_is_written_in_place),
        cmocka_unit_test(shipped_scenes_are_saved_in_the_current_folder),
    };
    return cmocka_run_group_tests(tests, begin, end);
}
