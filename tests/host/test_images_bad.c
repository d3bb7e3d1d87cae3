/* SPDX-License-Identifier: MIT */
/* Unusable pictures in every place of a scene: refused in one line with the scene's
 * line, the file and a reason; nothing stays half loaded. */
#define _XOPEN_SOURCE 700
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include "pixel/pixel.h"
#include "tests/lib/png_files.h"

#define FILE_BYTES 65536

/* Expects one line "./case.ini:3: layer0.texture: ./bad.png: ...". */
static void assert_refused(const char *row, const char *name, const char *why)
{
    char start[160];
    assert_int_equal(open_one(row, name), EXIT_INPUT);
    snprintf(start, sizeof start, "./case.ini:3: %s: ./%s: ", row, name);
    if (strncmp(said, start, strlen(start)) != 0 || !strstr(said, why))
        fail_msg("expected \"%s...%s\", got \"%s\"", start, why, said);
    assert_ptr_equal(strchr(said, '\n'), said + strlen(said) - 1);
}

static void assert_refused_everywhere(const char *name, const char *why)
{
    for (int i = 0; i < TEXTURES; i++)
        assert_refused(textures[i], name, why);
    for (int i = 0; i < GREYS; i++)
        assert_refused(greys[i], name, why);
}

static uint8_t bytes[FILE_BYTES];

static size_t slurp(const char *name)
{
    FILE *file = fopen(name, "rb");
    assert_non_null(file);
    const size_t size = fread(bytes, 1, sizeof bytes, file);
    fclose(file);
    return size;
}

static void spill(const char *name, size_t size)
{
    FILE *file = fopen(name, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(bytes, 1, size, file), size);
    fclose(file);
}

static void put_word(uint8_t *to, uint32_t v)
{
    for (int i = 0; i < 4; i++)
        to[i] = (uint8_t)(v >> (24 - 8 * i));
}

/* Writes the correct CRC of the chunk at `at`. */
static void mend_crc(size_t at)
{
    const size_t length = (size_t)bytes[at] << 24 | (size_t)bytes[at + 1] << 16
                        | (size_t)bytes[at + 2] << 8 | bytes[at + 3];
    put_word(bytes + at + 8 + length, tp_crc32(0, bytes + at + 4, length + 4));
}

enum { IHDR = 8, IHDR_END = 33 };       /* offset of the IHDR chunk and its end */

static void files_cut_short_are_refused(void **state)
{
    (void)state;
    static const int cut_kinds[] = { 0, 5, 8, 14, 22 };
    for (size_t i = 0; i < sizeof cut_kinds / sizeof *cut_kinds; i++) {
        write_kind(&kinds[cut_kinds[i]], "kind.png");
        const size_t size = slurp("kind.png");
        const size_t cuts[] = { 0, 4, 8, 12, 20, IHDR_END, IHDR_END + 4, size / 2,
                                size - 16, size - 12, size - 4, size - 1 };
        for (size_t n = 0; n < sizeof cuts / sizeof *cuts; n++) {
            spill("bad.png", cuts[n]);
            assert_refused(textures[(i + n) % TEXTURES], "bad.png", "not a good PNG: ");
            assert_refused(greys[(i + n) % GREYS], "bad.png", "not a good PNG: ");
        }
    }
    spill("bad.png", 40);
    assert_refused_everywhere("bad.png", "the file ends too early");
}

static void headers_that_lie_are_refused(void **state)
{
    (void)state;
    static const struct { int at; uint32_t word; const char *why; } lies[] = {
        { 8,  0,          "width is zero" },
        { 12, 0,          "height is zero" },
        { 8,  4097,       "4097 x 29 pixels; 4096 x 4096 at the most" },
        { 12, 4097,       "13 x 4097 pixels" },
        { 8,  0x7fffffff, "2147483647 x 29 pixels" },
        { 12, 0x80000000, "out of range" },
        { 16, 0x03020000, "bit depth" },
        { 16, 0x08050000, "color type" },
        { 16, 0x08020100, "compression" },
        { 16, 0x08020001, "filter" },
        { 16, 0x08030000, "PLTE" },
    };
    for (size_t i = 0; i < sizeof lies / sizeof *lies; i++) {
        write_kind(&kinds[4], "kind.png");
        const size_t size = slurp("kind.png");
        put_word(bytes + IHDR + lies[i].at, lies[i].word);
        mend_crc(IHDR);
        spill("bad.png", size);
        assert_refused(textures[i % TEXTURES], "bad.png", lies[i].why);
        assert_refused(greys[i % GREYS], "bad.png", lies[i].why);
    }
}

/* One wrong bit in a critical chunk is found by the chunk's CRC. */
static void wrong_crcs_are_refused(void **state)
{
    (void)state;
    write_kind(&kinds[4], "kind.png");
    const size_t size = slurp("kind.png");
    const size_t flips[] = { IHDR_END - 1, IHDR_END + 10, size - 14 };
    for (size_t i = 0; i < sizeof flips / sizeof *flips; i++) {
        bytes[flips[i]] ^= 1;
        spill("bad.png", size);
        bytes[flips[i]] ^= 1;
        assert_refused_everywhere("bad.png", "not a good PNG: ");
    }
}

/* The data has fewer rows than the header says. */
static void too_little_data_is_refused(void **state)
{
    (void)state;
    write_kind(&kinds[4], "kind.png");
    const size_t size = slurp("kind.png");
    put_word(bytes + IHDR + 12, 30);
    mend_crc(IHDR);
    spill("bad.png", size);
    assert_refused_everywhere("bad.png", "not a good PNG: ");
}

static void other_files_are_refused(void **state)
{
    (void)state;
    static const struct { const char *name, *start, *why; } others[] = {
        { "bad.png", "\xff\xd8\xff\xe0 and so on", "JPEG, expected PNG\n" },
        { "bad.png", "GIF89a", "GIF, expected PNG\n" },
        { "bad.png", "BM", "BMP, expected PNG\n" },
        { "bad.png", "RIFF....WEBP", "WebP, expected PNG\n" },
        { "bad.tga", "\1\2\3", "TGA, expected PNG\n" },
        { "bad.png", "# a scene", "not a PNG\n" },
        { "bad.png", "\x89", "not a good PNG: " },
    };
    for (size_t i = 0; i < sizeof others / sizeof *others; i++) {
        memcpy(bytes, others[i].start, strlen(others[i].start));
        spill(others[i].name, strlen(others[i].start));
        assert_refused_everywhere(others[i].name, others[i].why);
        remove(others[i].name);
    }
    assert_refused_everywhere("bad.png", "No such file");
    assert_refused("boat.mesh", "bad.obj", "No such file");
}

static void a_cube_without_a_side_is_refused(void **state)
{
    (void)state;
    write_kind(&kinds[0], "kind.png");
    for (int missing = 6; missing < 12; missing++) {
        scene_file scene;
        asset_set a;
        char start[120];
        FILE *file = fopen("case.ini", "w");
        assert_non_null(file);
        for (int i = 6; i < 12; i++)
            if (i != missing)
                put_setting(file, textures[i], "kind.png");
        put_setting(file, "sky.kind", "cube");
        fclose(file);
        listen();
        assert_int_equal(scene_file_open(&scene, "./case.ini"), EXIT_DONE);
        const int code = assets_open(&a, &scene);
        scene_file_close(&scene);
        stop_listening();
        assert_int_equal(code, EXIT_INPUT);
        snprintf(start, sizeof start, "./case.ini:12: sky.kind: a cube needs six pictures; "
                 "%s names none\n", textures[missing]);
        assert_string_equal(said, start);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(files_cut_short_are_refused),
        cmocka_unit_test(headers_that_lie_are_refused),
        cmocka_unit_test(wrong_crcs_are_refused),
        cmocka_unit_test(too_little_data_is_refused),
        cmocka_unit_test(other_files_are_refused),
        cmocka_unit_test(a_cube_without_a_side_is_refused),
    };
    return cmocka_run_group_tests_name("images_bad", tests, enter, leave);
}
