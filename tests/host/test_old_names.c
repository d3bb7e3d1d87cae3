/* SPDX-License-Identifier: MIT */
/* Old names of rows: the table fits the table of parameters; a file, --set, a change while
 * the water moves and a tape read every old name as the present one, with one warning. */
#define _XOPEN_SOURCE 700
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "app/scene/loaded_scene.h"
#include "app/scene/scene_lines.h"
#include "app/scene/tape_file.h"
#include "tests/lib/messages.h"
#include "world/text.h"

#define UNTIL "; old names are read until version " OLD_NAMES_END

static char folder[] = "/tmp/tidepool-old-XXXXXX";

static void spill(const char *name, const char *text)
{
    FILE *file = fopen(name, "wb");
    assert_non_null(file);
    fputs(text, file);
    fclose(file);
}

static const tp_param *row_of(const char *name)
{
    return tp_param_find(name, strlen(name));
}

/* Returns a valid text unlike the default: the last choice, a colour, a word, or a number
 * close to an end of the range. */
static const char *other_value(const tp_param *row)
{
    static char text[64];
    switch (row->kind) {
    case TP_PARAM_COLOUR: return "#123456";
    case TP_PARAM_TEXT:   return "others";
    default:
        tp_param_number_text(row, row->normal == row->high ? row->low : row->high, text,
                             sizeof text);
        return text;
    }
}

static const char *text_of(const tp_scene *scene, const tp_param *row)
{
    static char text[TP_NAME_BYTES];
    tp_param_text(scene, row, text, sizeof text);
    return text;
}

/* -- the table --------------------------------------------------------------------- */

static void every_old_name_leads_to_a_row_of_its_section(void **state)
{
    (void)state;
    uint32_t count;
    const old_name *names = old_names(&count);
    for (uint32_t i = 0; i < count; i++) {
        const char *old = names[i].old, *now = names[i].now;
        const size_t section = strcspn(now, ".") + 1;
        assert_null(row_of(old));
        assert_non_null(row_of(now));
        assert_int_equal(strncmp(old, now, section), 0);
        assert_ptr_equal(old_name_find(old, strlen(old)), &names[i]);
        assert_ptr_equal(old_name_param(old, strlen(old)), row_of(now));
        assert_ptr_equal(old_name_param(now, strlen(now)), row_of(now));
        for (uint32_t k = 0; k < i; k++) {
            assert_string_not_equal(names[k].old, old);
            assert_string_not_equal(names[k].now, now);
        }
    }
    assert_null(old_name_param("pool.fee", 8));
    assert_null(old_name_find("pool.feeds", 10));
    assert_non_null(old_name_find("pool.feeds", 9));
}

/* -- scene files and --set --------------------------------------------------------- */

static void a_file_reads_each_old_name(void **state)
{
    (void)state;
    uint32_t count;
    const old_name *names = old_names(&count);
    for (uint32_t i = 0; i < count; i++) {
        const tp_param *row = row_of(names[i].now);
        char text[256], want[64];
        scene_file file;
        snprintf(want, sizeof want, "%s", other_value(row));
        snprintf(text, sizeof text, "\n[%.*s]\n%s = %s\n",
                 (int)strcspn(names[i].old, "."), names[i].old,
                 strchr(names[i].old, '.') + 1, want);
        spill("one.ini", text);
        assert_int_equal(scene_file_open(&file, "./one.ini"), 0);
        assert_string_equal(text_of(&file.scene, row), want);
        assert_ptr_equal(file.old_in_file.first, &names[i]);
        assert_int_equal(file.old_in_file.line, 3);
        assert_int_equal(file.old_in_file.count, 1);
        assert_int_equal(file.old_by_command.count, 0);
        scene_file_close(&file);
    }
}

static void a_setting_reads_each_old_name(void **state)
{
    (void)state;
    uint32_t count;
    const old_name *names = old_names(&count);
    scene_file file;
    spill("none.ini", "");
    assert_int_equal(scene_file_open(&file, "./none.ini"), 0);
    for (uint32_t i = 0; i < count; i++) {
        const tp_param *row = row_of(names[i].now);
        char text[256], want[64];
        snprintf(want, sizeof want, "%s", other_value(row));
        snprintf(text, sizeof text, "%s=%s", names[i].old, want);
        assert_int_equal(scene_file_set(&file, text), 0);
        assert_string_equal(text_of(&file.scene, row), want);
    }
    assert_int_equal(file.old_by_command.count, count);
    assert_int_equal(file.old_in_file.count, 0);
    scene_file_close(&file);
}

/* Loads a scene like the commands; `said` receives the messages. */
static void load(const char *const *settings, uint32_t count, bool quiet, char said[1024])
{
    const options o = { .scene = "./lake.ini", .settings = (const char **)settings,
                        .n_settings = count, .quiet = quiet };
    scene_file file;
    messages m = messages_begin();
    const int code = loaded_scene_read(&file, &o);
    messages_end(&m, said, 1024);
    assert_int_equal(code, 0);
    scene_file_close(&file);
}

static void there_is_one_warning_a_file_and_one_for_the_command_line(void **state)
{
    (void)state;
    static const char *const settings[] = { "field.feed=0.2", "camera.y=3", "surf.k0=1" };
    char said[1024];
    spill("lake.ini", "[pool]\ncols = 32\nrows = 32\npoke = 0.3\nrange = 2\n"
                      "[drops]\nevery = 2\n");
    load(settings, 2, false, said);
    assert_string_equal(said,
        "./lake.ini:4: pool.poke is now called pool.splash_height (and 2 more old names)"
        UNTIL "; `tidepool check ./lake.ini --write` rewrites them\n"
        "--set: field.feed is now called field.drive_amplitude" UNTIL "\n");
    load(settings, 3, true, said);
    assert_string_equal(said, "");
    spill("lake.ini", "[pool]\nsplash_height = 0.3\n");
    load(settings + 2, 1, false, said);
    assert_string_equal(said, "--set: surf.k0 is now called surf.tilt_decay" UNTIL "\n");
}

static void a_refused_value_has_both_names(void **state)
{
    (void)state;
    static const struct { const char *setting, *message; } bad[] = {
        { "pool.poke=99",
          "--set: pool.splash_height (once called pool.poke) = 99 is outside -16..16 m\n" },
        { "mirror.objects=no", "--set: mirror.method (once called mirror.objects) = no is"
                               " none of none|stencil|cube\n" },
        { "water.deep=red", "--set: water.deep_colour (once called water.deep): expected a"
                            " colour such as #204060, found red\n" },
        { "pool.feed_lwo=1", "--set: no parameter is called pool.feed_lwo; did you mean"
                             " pool.drive_min, once called pool.feed_low?\n" },
        { "drops.intervl=1", "--set: no parameter is called drops.intervl; did you mean"
                             " drops.interval?\n" },
    };
    scene_file file;
    spill("none.ini", "");
    assert_int_equal(scene_file_open(&file, "./none.ini"), 0);
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        char said[1024];
        messages m = messages_begin();
        const int code = scene_file_set(&file, bad[i].setting);
        messages_end(&m, said, sizeof said);
        assert_string_equal(said, bad[i].message);
        assert_int_equal(code, 2);
    }
    assert_int_equal(file.old_by_command.count, 0);
    scene_file_close(&file);
}

/* -- while the water moves --------------------------------------------------------- */

static void a_change_reads_an_old_name(void **state)
{
    (void)state;
    const options o = { .scene = "./none.ini", .width = 32, .height = 32 };
    const loaded_scene_setting all[] = { { "--resume", "drops.every=3" },
                                         { "--resume", "drops.scatter=2" } };
    loaded_scene s;
    char said[1024];
    bool opened = false;
    spill("none.ini", "");
    assert_int_equal(loaded_scene_load(&s, &o), 0);
    messages m = messages_begin();
    assert_int_equal(loaded_scene_set(&s, &o, "here", "drops.radius=0.1", &opened), 0);
    assert_int_equal(loaded_scene_set(&s, &o, "here", "drops.attack=1", &opened), 0);
    assert_int_equal(loaded_scene_set_all(&s, &o, all, 2, &opened), 0);
    messages_end(&m, said, sizeof said);
    assert_string_equal(said,
        "here: drops.attack is now called drops.ring_rise_time" UNTIL "\n"
        "--resume: drops.every is now called drops.interval (and 1 more old name)" UNTIL
        "\n");
    assert_int_equal(s.file.scene.drops.ring_rise_time, TP_FX_ONE);
    assert_int_equal(s.file.scene.drops.interval, 3 * TP_FX_ONE);
    assert_int_equal(s.file.scene.drops.scatter_radius, 2 * TP_FX_ONE);
    loaded_scene_close(&s);
}

static void a_tape_reads_old_names_with_one_warning(void **state)
{
    (void)state;
    tape_file d;
    char said[1024];
    spill("old.tape", "tape 2 lake\n3 ahead=1\n4 set camera.y=3\n4 set pool.feed=0.2\n"
                      "9 set scene.shows=a = b\n");
    messages m = messages_begin();
    const int code = tape_file_read(&d, "old.tape", "lake");
    messages_end(&m, said, sizeof said);
    assert_int_equal(code, 0);
    assert_string_equal(said, "old.tape:4: pool.feed is now called pool.drive_amplitude"
                              " (and 1 more old name)" UNTIL "\n");
    assert_string_equal(d.entries[1].setting, "camera.y=3");
    assert_string_equal(d.entries[2].setting, "pool.drive_amplitude=0.2");
    assert_string_equal(d.entries[3].setting, "scene.description=a = b");
    assert_int_equal(tape_file_close(&d), 0);
    spill("bad.tape", "tape 2 lake\n4 set pool.feed=0.2\n5 set pool.feeds=99\n");
    m = messages_begin();
    assert_int_equal(tape_file_read(&d, "bad.tape", "lake"), 3);
    messages_end(&m, said, sizeof said);
    assert_string_equal(said, "bad.tape:3: no parameter is called pool.feeds; did you mean"
                              " pool.drive_amplitude, once called pool.feed?\n");
    (void)tape_file_close(&d);
}

/* -- lines ------------------------------------------------------------------------- */

static void only_the_name_of_a_line_changes(void **state)
{
    (void)state;
    static const struct { const char *line, *want; } lines[] = {
        { "feed=1\n", "drive_amplitude=1\n" },
        { "  feed\t: feed ; feed\r\n", "  drive_amplitude\t: feed ; feed\r\n" },
        { "pool.feed = 1 ; a = b", "pool.drive_amplitude = 1 ; a = b" },
        { "\xef\xbb\xbf" "feed =1\n", "\xef\xbb\xbf" "drive_amplitude =1\n" },
        { "feed_low = feed\n", NULL }, { "; feed = 1\n", NULL }, { "feed\n", NULL },
        { "\n", NULL }, { "= feed\n", NULL },
        { "feeds = 1\n", NULL }, { "my_feed = 1\n", NULL }, { "a feed = 1\n", NULL },
    };
    for (size_t i = 0; i < sizeof lines / sizeof *lines; i++) {
        scene_lines l = { 0 };
        char text[128];
        size_t bytes;
        spill("line.ini", lines[i].line);
        assert_int_equal(scene_lines_read(&l, "line.ini"), 0);
        const bool done = scene_lines_rename(&l, 1, "feed", "drive_amplitude");
        FILE *out = fmemopen(text, sizeof text, "w");
        assert_non_null(out);
        scene_lines_write(&l, out);
        bytes = (size_t)ftell(out);
        fclose(out);
        text[bytes] = '\0';
        assert_int_equal(done, lines[i].want != NULL);
        assert_string_equal(text, lines[i].want ? lines[i].want : lines[i].line);
        assert_false(scene_lines_rename(&l, 0, "feed", "drive_amplitude"));
        assert_false(scene_lines_rename(&l, 2, "feed", "drive_amplitude"));
        scene_lines_free(&l);
    }
}

/* -- the folder -------------------------------------------------------------------- */

static int make_folder(void **state)
{
    (void)state;
    return !mkdtemp(folder) || chdir(folder);
}

static int remove_folder(void **state)
{
    (void)state;
    static const char *const files[] = { "one.ini", "none.ini", "lake.ini", "line.ini",
                                         "old.tape", "bad.tape" };
    for (size_t i = 0; i < sizeof files / sizeof *files; i++)
        unlink(files[i]);
    return chdir("/") || rmdir(folder);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_old_name_leads_to_a_row_of_its_section),
        cmocka_unit_test(a_file_reads_each_old_name),
        cmocka_unit_test(a_setting_reads_each_old_name),
        cmocka_unit_test(there_is_one_warning_a_file_and_one_for_the_command_line),
        cmocka_unit_test(a_refused_value_has_both_names),
        cmocka_unit_test(a_change_reads_an_old_name),
        cmocka_unit_test(a_tape_reads_old_names_with_one_warning),
        cmocka_unit_test(only_the_name_of_a_line_changes),
    };
    return cmocka_run_group_tests(tests, make_folder, remove_folder);
}
