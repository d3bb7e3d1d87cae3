/* SPDX-License-Identifier: MIT */
/* Fuzzes scene files: the file, then behind a line "%%" lines in the form of --set. An
 * accepted scene is within the ranges of the table; saved over its own file after the
 * settings, the scene reads back the same, and without settings the file's bytes do not
 * change.  Rows that the file leaves out have their usual values, but for the rows that
 * follow the older grid. */
#include "fuzz.h"
#include "app/scene/scene_save.h"
#include "world/text.h"

static void write_file(const char *path, const uint8_t *data, size_t size)
{
    FILE *file = fopen(path, "wb");
    REQUIRE(file != NULL && fwrite(data, 1, size, file) == size);
    REQUIRE(fclose(file) == 0);
}

static void require_scene(const scene_file *file, unsigned lines)
{
    uint32_t count;
    const tp_param *rows = tp_params(&count);
    tp_scene usual;
    tp_scene_level(&usual);
    usual.tank.sea = older_grid_sea(&file->older);
    usual.grid.vertices = older_grid_vertices(&file->older, &file->scene);
    for (uint32_t i = 0; i < count; i++) {
        const size_t at = rows[i].offset, bytes = tp_param_is_text(&rows[i])
                                                ? TP_NAME_BYTES : sizeof(int32_t);
        const char *value = (const char *)&file->scene + at;
        REQUIRE(file->set_at[i] <= lines);
        REQUIRE(file->set_at[i]
                || memcmp(value, (const char *)&usual + at, bytes) == 0);
        int32_t number;
        memcpy(&number, value, sizeof number);
        if (tp_param_is_text(&rows[i]))
            REQUIRE(memchr(value, 0, TP_NAME_BYTES) != NULL);
        else
            REQUIRE(number >= rows[i].low && number <= rows[i].high);
    }
}

static void require_contents(const char *path, const uint8_t *data, size_t size)
{
    size_t bytes;
    uint8_t *now = fuzz_contents(path, &bytes);
    REQUIRE(bytes == size && memcmp(now, data, size) == 0);
    free(now);
}

/* Applies the settings. Returns true if a value has changed. */
static bool set_all(scene_file *file, const uint8_t *data, size_t size)
{
    const tp_scene before = file->scene;
    char *text = fuzz_text(data, size);
    for (char *line = text, *next; line; line = next) {
        next = fuzz_line(line);
        (void)scene_file_set(file, line);
    }
    free(text);
    return memcmp(&before, &file->scene, sizeof before) != 0;
}

/* Compares two scenes. File names from settings are stored relative to the scene file, in
 * another folder than the program: only file names may change. */
static void compare(const tp_scene *a, const tp_scene *b)
{
    uint32_t count;
    const tp_param *rows = tp_params(&count);
    for (uint32_t i = 0; i < count; i++)
        if (!tp_param_is_file(&rows[i]))
            REQUIRE(memcmp((const char *)a + rows[i].offset,
                           (const char *)b + rows[i].offset,
                           tp_param_is_text(&rows[i]) ? TP_NAME_BYTES
                                                      : sizeof(int32_t)) == 0);
}

static void save(const scene_file *file, bool changed, const uint8_t *data, size_t size)
{
    scene_file again;
    if (scene_save(file, file->path)) {
        fuzz_refused(file->path, 0);
        REQUIRE(changed);
        require_contents(file->path, data, size);
        return;
    }
    if (!changed)
        require_contents(file->path, data, size);
    REQUIRE(scene_file_open(&again, file->path) == EXIT_DONE);
    compare(&again.scene, &file->scene);
    scene_file_close(&again);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    char path[4200];
    size_t bytes;
    const uint8_t *text = fuzz_part(&data, &size, &bytes);
    const unsigned lines = fuzz_lines(text, bytes);
    scene_file file;

    snprintf(path, sizeof path, "%s/scene.ini", fuzz_folder());
    write_file(path, text, bytes);
    if (scene_file_open(&file, path)) {
        fuzz_refused(path, lines);
    } else {
        require_scene(&file, lines);
        const bool changed = size > 0 && set_all(&file, data, size);
        save(&file, changed, text, bytes);
    }
    scene_file_close(&file);
    return 0;
}
