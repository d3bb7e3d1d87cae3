/* SPDX-License-Identifier: MIT */
/* Fuzzes PNG files, as textures and as grey maps. Mutations keep the chunks' CRCs correct;
 * otherwise the reader would reject nearly each file by its first CRC. An accepted picture
 * becomes a texture; written as a drawn picture it reads back the same. */
#include "fuzz.h"
#include "app/files/picture.h"
#include "pixel/pixel.h"

enum { PIXELS_MOST = 4096 };        /* most pixels to write and read again */

size_t LLVMFuzzerMutate(uint8_t *data, size_t size, size_t most);
size_t LLVMFuzzerCustomMutator(uint8_t *data, size_t size, size_t most, unsigned seed);

/* -- correct CRCs ------------------------------------------------------------------ */

static uint32_t word_at(const uint8_t *at)
{
    return (uint32_t)at[0] << 24 | (uint32_t)at[1] << 16 | (uint32_t)at[2] << 8 | at[3];
}

static void put_word(uint8_t *at, uint32_t word)
{
    for (int i = 0; i < 4; i++)
        at[i] = (uint8_t)(word >> (24 - 8 * i));
}

size_t LLVMFuzzerCustomMutator(uint8_t *data, size_t size, size_t most, unsigned seed)
{
    (void)seed;
    size = LLVMFuzzerMutate(data, size, most);
    for (size_t at = 8; at + 12 <= size;) {
        const size_t bytes = word_at(data + at);
        if (bytes > size - at - 12)
            break;
        put_word(data + at + 8 + bytes, tp_crc32(0, data + at + 4, bytes + 4));
        at += bytes + 12;
    }
    return size;
}

/* -- use of accepted pictures ------------------------------------------------------ */

static void make_texture(const uint32_t *pixels, uint32_t w, uint32_t h)
{
    tp_texture texture;
    void *memory = malloc(tp_texture_bytes(w, h));
    REQUIRE(memory != NULL);
    REQUIRE(tp_texture_init(&texture, pixels, w, h, memory, tp_texture_bytes(w, h), NULL)
            == TP_OK);
    free(memory);
}

static void write_and_read(const uint32_t *pixels, uint32_t w, uint32_t h)
{
    char path[4200];
    uint32_t again_w, again_h, *drawn = malloc(sizeof *drawn * w * h);
    REQUIRE(drawn != NULL);
    for (uint32_t i = 0; i < w * h; i++)
        drawn[i] = pixels[i] & 0xffffff;
    const picture p = { TP_FORMAT_XRGB8888, w, h, 4 * (size_t)w, (uint8_t *)drawn };
    snprintf(path, sizeof path, "%s/again.png", fuzz_folder());
    REQUIRE(picture_write_png(&p, path) == EXIT_DONE);
    uint32_t *again = picture_read_png(path, "fuzz", &again_w, &again_h);
    REQUIRE(again != NULL && again_w == w && again_h == h);
    for (uint32_t i = 0; i < w * h; i++)
        REQUIRE(again[i] == (drawn[i] | 0xff000000));
    free(again);
    free(drawn);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    uint32_t w = 0, h = 0, grey_w = 0, grey_h = 0;
    const char *path = fuzz_file(0, data, size);
    uint32_t *pixels = picture_read_png(path, "fuzz", &w, &h);
    if (!pixels)
        fuzz_refused("fuzz", 0);
    uint16_t *greys = picture_read_grey(path, "fuzz", &grey_w, &grey_h);
    if (!greys)
        fuzz_refused("fuzz", 0);
    if (pixels && greys)
        REQUIRE(w == grey_w && h == grey_h);
    if (pixels) {
        REQUIRE(w >= 1 && w <= 4096 && h >= 1 && h <= 4096);
        if ((uint64_t)w * h <= PIXELS_MOST) {
            make_texture(pixels, w, h);
            write_and_read(pixels, w, h);
        }
    }
    free(pixels);
    free(greys);
    return 0;
}
