/* SPDX-License-Identifier: MIT */
/* Fuzzes the preview's session file: the first byte decides if the rest is all of
 * session.ini, or the lines behind a correct name of the world. The settings are applied to
 * a scene, as --resume does. */
#include "fuzz.h"
#include "app/scene/scene_file.h"
#include "app/session/session.h"
#include "pixel/pixel.h"
#include <sys/stat.h>

#define HEAD "# State of `tidepool view`, for --resume.\n[session]\nworld = "

static char path[4096];

static void begin(void)
{
    const char *folder = getenv("TMPDIR");
    snprintf(path, sizeof path, "%s/fuzz-session-XXXXXX", folder ? folder : "/tmp");
    REQUIRE(mkdtemp(path) != NULL && setenv("XDG_STATE_HOME", path, 1) == 0);
    strcat(path, "/tidepool");
    REQUIRE(mkdir(path, 0700) == 0);
    strcat(path, "/session.ini");
}

static void write_session(const uint8_t *data, size_t size, bool whole)
{
    FILE *to = fopen(path, "wb");
    REQUIRE(to != NULL);
    if (!whole)
        fprintf(to, HEAD "world-%08x\n", (unsigned)tp_crc32(0, data, size));
    REQUIRE(fwrite(data, 1, size, to) == size && fclose(to) == 0);
}

/* Applies "name=value" lines; each names a row of the parameter table or is rejected. */
static void set_all(const session_state *state)
{
    scene_file file;
    REQUIRE(scene_file_open(&file, "assets/scenes/minimal.ini") == 0);
    for (uint32_t i = 0; i < state->count; i++) {
        const char *value;
        const tp_param *param = scene_file_check("--resume", state->settings[i], &value);
        if (param)
            scene_file_set(&file, state->settings[i]);
    }
    scene_file_close(&file);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    session_state state;
    if (!path[0])
        begin();
    const bool whole = fuzz_byte(&data, &size) % 4 == 3;
    write_session(data, size, whole);
    if (session_read(&state) == 0) {
        REQUIRE(state.scene != NULL || state.count == 0);   /* all or nothing is kept */
        set_all(&state);
    }
    session_free(&state);
    return 0;
}
