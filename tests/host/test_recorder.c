/* SPDX-License-Identifier: MIT */
/* Films recorded live: by a fake ffmpeg that works, fails or dies, and without ffmpeg. */
#define _XOPEN_SOURCE 700
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include <dirent.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include "app/session/recorder.h"

#define WIDTH  160
#define HEIGHT 120
#define HEAD   "YUV4MPEG2 W160 H120 F60:1 Ip A1:1 C420jpeg XCOLORRANGE=LIMITED\n"
#define PICTURE_BYTES (6 + WIDTH * HEIGHT * 3 / 2)

static char folder[] = "/tmp/tidepool-film-XXXXXX";
static uint32_t pixels[WIDTH * HEIGHT];

static picture grey(uint32_t width)
{
    for (size_t i = 0; i < WIDTH * HEIGHT; i++)
        pixels[i] = 0x808080;
    return (picture){ TP_FORMAT_XRGB8888, width, HEIGHT, 4 * WIDTH, (uint8_t *)pixels };
}

/* Installs ffmpeg as a shell script; NULL: removes it. */
static void set_ffmpeg(const char *script)
{
    unlink("bin/ffmpeg");
    if (!script)
        return;
    FILE *file = fopen("bin/ffmpeg", "w");
    assert_non_null(file);
    fprintf(file, "#!/bin/sh\n%s\n", script);
    fclose(file);
    assert_int_equal(chmod("bin/ffmpeg", 0755), 0);
}

/* Writes its input to the last argument, and its arguments to the file args. */
#define TAKES "echo \"$*\" | sed 's/tidepool-[0-9a-z]*/X/' >args; " \
              "for to; do :; done; /bin/cat >\"$to\""

static long size_of(const char *name)
{
    struct stat info;
    return stat(name, &info) == 0 ? (long)info.st_size : -1;
}

/* Expects exactly these files in the folder, hidden files included. */
static void assert_files(size_t count, const char *const *names)
{
    size_t found = 0;
    DIR *dir = opendir(".");
    for (struct dirent *entry; (entry = readdir(dir)) != NULL;) {
        const char *name = entry->d_name;
        if (strcmp(name, ".") == 0 || strcmp(name, "..") == 0 || strcmp(name, "bin") == 0)
            continue;
        bool known = false;
        for (size_t i = 0; i < count; i++)
            known = known || strcmp(names[i], name) == 0;
        if (!known)
            fail_msg("%s was left", name);
        found++;
    }
    closedir(dir);
    assert_int_equal(found, count);
}

#define LIST(...)  (const char *const[]){ __VA_ARGS__ }
#define FILES(...) assert_files(sizeof LIST(__VA_ARGS__) / sizeof (char *), \
                                LIST(__VA_ARGS__))

static void record(recorder *r, uint32_t count)
{
    const picture p = grey(WIDTH);
    for (uint32_t i = 0; i < count; i++)
        assert_true(recorder_add(r, &p));
}

/* Messages go to a file. */
static int said;

static void listen(void)
{
    fflush(stderr);
    said = dup(STDERR_FILENO);
    assert_non_null(freopen("said", "w", stderr));
}

static void assert_said(const char *what)
{
    char text[1024] = "";
    fflush(stderr);
    dup2(said, STDERR_FILENO);
    close(said);
    FILE *file = fopen("said", "r");
    text[fread(text, 1, sizeof text - 1, file)] = 0;
    fclose(file);
    unlink("said");
    if (!strstr(text, what))
        fail_msg("'%s' is not in '%s'", what, text);
}

/* -- the cases ------------------------------------------------------------------- */

static void ffmpeg_gets_pictures_and_writes_the_film(void **state)
{
    (void)state;
    char text[256] = "";
    set_ffmpeg(TAKES);
    listen();
    recorder *r = recorder_begin("pond", WIDTH, HEIGHT);
    assert_non_null(r);
    assert_string_equal(recorder_name(r), "pond-0001.mp4");
    assert_int_equal(size_of("pond-0001.mp4"), -1);
    record(r, 90);
    assert_int_equal(recorder_pictures(r), 90);
    assert_int_equal(recorder_end(r), 0);
    assert_said("pond-0001.mp4: recording through ffmpeg\n"
                "pond-0001.mp4: 90 pictures, 1.50 s\n");
    assert_int_equal(size_of("pond-0001.mp4"), strlen(HEAD) + 90 * PICTURE_BYTES);
    FILE *file = fopen("args", "r");
    assert_non_null(fgets(text, sizeof text, file));
    fclose(file);
    assert_string_equal(text, "-v error -y -f yuv4mpegpipe -i - -pix_fmt yuv420p"
                        " .X.mp4\n");
    FILES("args", "pond-0001.mp4");
}

static void the_next_film_has_the_next_number(void **state)
{
    (void)state;
    set_ffmpeg(TAKES);
    fclose(fopen("pond-0001.mp4", "w"));
    fclose(fopen("pond-0002.y4m", "w"));
    recorder *r = recorder_begin("pond", WIDTH, HEIGHT);
    assert_string_equal(recorder_name(r), "pond-0003.mp4");
    assert_int_equal(recorder_end(r), 0);
    assert_int_equal(size_of("pond-0001.mp4"), 0);
}

static void odd_sides_are_padded(void **state)
{
    (void)state;
    char text[256] = "";
    set_ffmpeg(TAKES);
    recorder *r = recorder_begin("pond", WIDTH - 1, HEIGHT);
    const picture p = grey(WIDTH - 1);
    assert_true(recorder_add(r, &p));
    assert_int_equal(recorder_end(r), 0);
    FILE *file = fopen("args", "r");
    assert_non_null(fgets(text, sizeof text, file));
    fclose(file);
    assert_non_null(strstr(text, " -vf pad=ceil(iw/2)*2:ceil(ih/2)*2 .X.mp4\n"));
}

static void without_ffmpeg_it_is_y4m_and_said(void **state)
{
    (void)state;
    set_ffmpeg(NULL);
    listen();
    recorder *r = recorder_begin("pond", WIDTH, HEIGHT);
    assert_non_null(r);
    assert_string_equal(recorder_name(r), "pond-0001.y4m");
    record(r, 3);
    assert_int_equal(recorder_end(r), 0);
    assert_said("pond-0001.y4m: recording uncompressed, 1.7 MB a second: no ffmpeg"
                " for MP4\npond-0001.y4m: 3 pictures, 0.05 s\n");
    assert_int_equal(size_of("pond-0001.y4m"), strlen(HEAD) + 3 * PICTURE_BYTES);
    FILES("pond-0001.y4m");
}

static void a_picture_is_saved_while_a_film_is(void **state)
{
    (void)state;
    set_ffmpeg(NULL);
    recorder *r = recorder_begin("pond", WIDTH, HEIGHT);
    const picture p = grey(WIDTH);
    record(r, 2);
    assert_int_equal(picture_write_png(&p, "shot.png"), 0);
    record(r, 2);
    assert_int_equal(recorder_end(r), 0);
    assert_int_equal(size_of("pond-0001.y4m"), strlen(HEAD) + 4 * PICTURE_BYTES);
    FILES("pond-0001.y4m", "shot.png");
}

static void another_size_ends_the_film(void **state)
{
    (void)state;
    const picture other = grey(WIDTH - 16);
    const picture p = grey(WIDTH);
    set_ffmpeg(TAKES);
    listen();
    recorder *r = recorder_begin("pond", WIDTH, HEIGHT);
    record(r, 60);
    assert_false(recorder_add(r, &other));
    assert_int_equal(size_of("pond-0001.mp4"), strlen(HEAD) + 60 * PICTURE_BYTES);
    assert_false(recorder_add(r, &p));
    assert_int_equal(recorder_end(r), 0);
    assert_said("pond-0001.mp4: the size of the picture has changed, the film ends\n"
                "pond-0001.mp4: 60 pictures, 1.00 s\n");
    FILES("args", "pond-0001.mp4");
}

/* The pipe is larger than the first frames: a later frame finds the death. */
static void ffmpeg_dies_and_the_film_ends(void **state)
{
    (void)state;
    const picture p = grey(WIDTH);
    uint32_t taken = 0;
    set_ffmpeg("/bin/dd bs=1000 count=1 of=/dev/null 2>/dev/null; kill -9 $$");
    listen();
    recorder *r = recorder_begin("pond", WIDTH, HEIGHT);
    assert_non_null(r);
    while (recorder_add(r, &p))
        assert_in_range(++taken, 1, 1000);
    assert_false(recorder_add(r, &p));
    assert_int_equal(recorder_end(r), 0);
    assert_said("pond-0001.mp4: ffmpeg was ended by signal 9 after ");
    assert_files(0, NULL);
}

static void ffmpeg_that_fails_at_the_end_leaves_nothing(void **state)
{
    (void)state;
    set_ffmpeg("/bin/cat >/dev/null; exit 7");
    listen();
    recorder *r = recorder_begin("pond", WIDTH, HEIGHT);
    record(r, 2);
    assert_int_equal(recorder_end(r), 3);
    assert_said("pond-0001.mp4: ffmpeg ended with 7 after 2 pictures;"
                " no film was written\n");
    assert_files(0, NULL);
}

static void a_folder_that_cannot_be_written_is_said(void **state)
{
    (void)state;
    set_ffmpeg(NULL);
    char here[4096];
    assert_non_null(getcwd(here, sizeof here));
    assert_int_equal(mkdir("gone", 0777), 0);
    assert_int_equal(chdir("gone"), 0);
    assert_int_equal(rmdir("../gone"), 0);
    assert_null(recorder_begin("pond", WIDTH, HEIGHT));
    assert_int_equal(chdir(here), 0);
}

/* -- set-up ---------------------------------------------------------------------- */

static int begin(void **state)
{
    (void)state;
    char path[64];
    signal(SIGPIPE, SIG_IGN);                   /* as the program does */
    if (!mkdtemp(folder) || chdir(folder) || mkdir("bin", 0777))
        return -1;
    snprintf(path, sizeof path, "%s/bin:/bin:/usr/bin", folder);
    return setenv("PATH", path, 1);
}

/* Hides a real ffmpeg. */
static int alone(void **state)
{
    (void)state;
    char path[64];
    snprintf(path, sizeof path, "%s/bin", folder);
    return setenv("PATH", path, 1);
}

static int clear(void **state)
{
    (void)state;
    char path[64];
    snprintf(path, sizeof path, "%s/bin:/bin:/usr/bin", folder);
    setenv("PATH", path, 1);
    return system("rm -f * .tidepool-* bin/ffmpeg 2>/dev/null") < 0;
}

static int end(void **state)
{
    (void)state;
    char command[128];
    snprintf(command, sizeof command, "cd / && rm -rf %s", folder);
    return system(command);
}

#define CASE(name)  cmocka_unit_test_teardown(name, clear)
#define ALONE(name) cmocka_unit_test_setup_teardown(name, alone, clear)

int main(void)
{
    const struct CMUnitTest tests[] = {
        CASE(ffmpeg_gets_pictures_and_writes_the_film),
        CASE(the_next_film_has_the_next_number),
        CASE(odd_sides_are_padded),
        ALONE(without_ffmpeg_it_is_y4m_and_said),
        ALONE(a_picture_is_saved_while_a_film_is),
        CASE(another_size_ends_the_film),
        CASE(ffmpeg_dies_and_the_film_ends),
        CASE(ffmpeg_that_fails_at_the_end_leaves_nothing),
        ALONE(a_folder_that_cannot_be_written_is_said),
    };
    return cmocka_run_group_tests(tests, begin, end);
}
