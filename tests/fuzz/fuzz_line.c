/* SPDX-License-Identifier: MIT */
/* Fuzzes lines written by people: the first byte selects a tape's head, a tape's line, or a
 * parameter with the rest as its value. An accepted line reads back the same from its
 * printed form. */
#include "fuzz.h"
#include "world/text.h"

static void try_head(const char *text, size_t bytes)
{
    char scene[TP_NAME_BYTES], line[TP_TAPE_LINE], again[TP_NAME_BYTES];
    tp_error err;

    if (tp_tape_head_read(scene, sizeof scene, text, bytes, &err) != TP_OK)
        return;
    REQUIRE(strlen(scene) < sizeof scene);
    const size_t length = tp_tape_head_write(scene, line, sizeof line);
    REQUIRE(length < sizeof line);
    REQUIRE(tp_tape_head_read(again, sizeof again, line, length, &err) == TP_OK);
    REQUIRE(strcmp(scene, again) == 0);
}

static void try_entry(const char *text, size_t bytes)
{
    tp_tape_entry entry, again;
    char line[TP_TAPE_LINE];
    tp_error err;

    memset(&entry, 0, sizeof entry);
    memset(&again, 0, sizeof again);
    if (tp_tape_read(&entry, text, bytes, &err) != TP_OK)
        return;
    const size_t length = tp_tape_write(&entry, line, sizeof line);
    REQUIRE(length < sizeof line);
    if (length == 0)                /* the line has set nothing */
        return;
    REQUIRE(tp_tape_read(&again, line, length, &err) == TP_OK);
    REQUIRE(again.tick == entry.tick);
    REQUIRE(memcmp(&again.input, &entry.input, sizeof entry.input) == 0);
}

static void try_value(uint32_t row, const char *text, size_t bytes)
{
    static tp_scene scene, again;
    uint32_t count;
    const tp_param *const params = tp_params(&count), *const param = &params[row % count];
    char value[256];
    tp_error err;

    tp_scene_level(&scene);
    tp_scene_level(&again);
    if (tp_param_set(&scene, param, text, bytes, &err) != TP_OK) {
        REQUIRE(memcmp(&scene, &again, sizeof scene) == 0);     /* nothing half-done */
        return;
    }
    const size_t length = tp_param_text(&scene, param, value, sizeof value);
    REQUIRE(length < sizeof value);
    REQUIRE(tp_param_set(&again, param, value, length, &err) == TP_OK);
    REQUIRE(memcmp(&scene, &again, sizeof scene) == 0);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    if (size < 2)
        return 0;
    char *const text = fuzz_copy(data + 2, size - 2);
    if (data[0] == 0)
        try_head(text, size - 2);
    else if (data[0] == 1)
        try_entry(text, size - 2);
    else
        try_value((uint32_t)(data[0] - 2) << 8 | data[1], text, size - 2);
    free(text);
    return 0;
}
