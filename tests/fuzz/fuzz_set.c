/* SPDX-License-Identifier: MIT */
/* Fuzzes lines as words behind --set. A rejected word changes nothing and is reported; an
 * accepted word prints as a text for the same value. */
#include "fuzz.h"
#include "app/scene/scene_file.h"
#include "world/text.h"

enum { ROWS = 1024, LINES = 8 };

static scene_file file_of(uint32_t *set_at)
{
    scene_file file = { .name = "fuzz", .path = "fuzz.ini", .set_at = set_at };
    uint32_t count;
    tp_params(&count);
    REQUIRE(count <= ROWS);
    memset(set_at, 0, ROWS * sizeof *set_at);
    tp_scene_level(&file.scene);
    return file;
}

/* Requires a message whose place is "--set", or a message about a word without a name. */
static void require_message(void)
{
    unsigned count;
    const char *message = log_last(&count);
    REQUIRE(fuzz_says(message, "--set", 0)
            || strncmp(message, "tidepool: --set ", 16) == 0);
}

static void require_row(const scene_file *file, const char *setting)
{
    uint32_t count;
    const char *value;
    const tp_param *param = scene_file_check("--set", setting, &value);
    REQUIRE(param != NULL);     /* a long file name is replaced by a short text */
    REQUIRE(tp_param_is_file(param) || value == strchr(setting, '=') + 1);
    REQUIRE(file->set_at[param - tp_params(&count)] == SET_BY_COMMAND);
    if (tp_param_is_text(param))
        return;
    const int32_t *number = (const int32_t *)(const void *)((const char *)&file->scene
                                                            + param->offset);
    REQUIRE(*number >= param->low && *number <= param->high);
}

/* Each changed row, printed as text, sets another scene to the same value. */
static void set_again(const scene_file *file)
{
    static uint32_t set_at[ROWS];
    scene_file again = file_of(set_at);
    uint32_t count;
    const tp_param *rows = tp_params(&count);
    for (uint32_t i = 0; i < count; i++) {
        char setting[512];
        if (!file->set_at[i])
            continue;
        const int name = snprintf(setting, sizeof setting, "%s=", rows[i].name);
        tp_param_text(&file->scene, &rows[i], setting + name,
                      sizeof setting - (size_t)name);
        REQUIRE(scene_file_set(&again, setting) == EXIT_DONE);
    }
    REQUIRE(memcmp(&again.scene, &file->scene, sizeof again.scene) == 0);
    REQUIRE(memcmp(again.set_at, file->set_at, ROWS * sizeof *set_at) == 0);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static uint32_t set_at[ROWS], before_at[ROWS];
    scene_file file = file_of(set_at);
    char *text = fuzz_text(data, size);
    char *line = text, *next;
    for (int i = 0; line && i < LINES; line = next, i++) {
        const tp_scene before = file.scene;
        const char *value;
        next = fuzz_line(line);
        memcpy(before_at, set_at, sizeof set_at);
        const int code = scene_file_set(&file, line);
        if (code == EXIT_DONE) {
            require_row(&file, line);
            continue;
        }
        REQUIRE(code == EXIT_USAGE);
        require_message();
        REQUIRE(memcmp(&before, &file.scene, sizeof before) == 0);
        REQUIRE(memcmp(before_at, set_at, sizeof set_at) == 0);
        REQUIRE(scene_file_check("--set", line, &value) == NULL);
    }
    set_again(&file);
    free(text);
    return 0;
}
