/* SPDX-License-Identifier: MIT */
/* Fuzzes the bytes of a board's serial port. Each line is answered by "ok" or "error"; an
 * error changes nothing. After any settings the scene can still be drawn: some ticks and a
 * picture are made, in the memory of the start. */
#include "fuzz.h"
#include "interact/old_names.h"
#include "serial/control.h"
#include "tidepool/modules.h"

enum { TICKS = 12, SAID = 1 << 16 };

static const tp_assets none;
static const tp_config config = { .width = 32,
                                  .height = 16,
                                  .tile_width = 16,
                                  .tile_height = 8,
                                  .format = TP_FORMAT_RGB565BE,
                                  .assets = &none };

typedef struct {
    tp_scene      scene;
    tp_world     *world;
    tp_frame     *frame;
    void         *block, *scratch;
    control_setup setup;
    control       control;
    char          said[SAID];
    size_t        length;
} serial_board;

static void hear(void *to, const char *text)
{
    serial_board *b = to;
    const size_t bytes = strlen(text);
    REQUIRE(b->length + bytes < SAID);
    memcpy(b->said + b->length, text, bytes + 1);
    b->length += bytes;
}

static void state(void *to)
{
    hear(to, ", listening");
}

/* -- a board ----------------------------------------------------------------------- */

static void make_scene(tp_scene *s, uint8_t kind)
{
    tp_scene_level(s);
    s->grid.vertices = 64;
    s->wave[0].amplitude = TP_FX(0.4);
    s->drops.count = kind & 1 ? 4 : 0;
    s->pool.cols = kind & 2 ? 16 : 0;
    s->pool.rows = 16;
    s->floor.depth = kind & 4 ? 3 * TP_FX_ONE : 0;
    s->foam.cells = kind & 8 ? 8 : 0;
    s->spray.count = kind & 8 ? 4 : 0;
    s->water.clarity = kind & 16 ? 8 * TP_FX_ONE : 0;
    s->sky.kind = kind & 32 ? TP_SKY_DUSK : TP_SKY_GRADIENT;
}

/* Opens a board. `kind` decides if the scene lies in ROM; the blocks have exactly the bytes
 * asked for. */
static void board_open(serial_board *b, uint8_t kind)
{
    memset(b, 0, sizeof *b);
    make_scene(&b->scene, kind);
    const size_t bytes = tp_world_bytes(&tp_program_all, &b->scene, &none);
    b->world = malloc(bytes);
    b->block = malloc(tp_frame_bytes(&config, &b->scene));
    b->scratch = malloc(tp_frame_scratch_bytes(&config, &b->scene));
    REQUIRE(b->world && b->block && b->scratch);
    REQUIRE(tp_world_init(&tp_program_all, b->world, bytes, &b->scene, &none, NULL)
            == TP_OK);
    REQUIRE(tp_frame_init(&b->frame, &config, &b->scene, b->block,
                          tp_frame_bytes(&config, &b->scene), NULL)
            == TP_OK);
    b->setup = (control_setup){
        .shown = &b->scene,
        .scene = kind & 128 ? NULL : &b->scene,
        .config = &config,
        .world = b->world,
        .world_bytes = bytes,
        .write = hear,
        .state = kind & 64 ? state : NULL,
        .to = b,
        .find = kind & 128 ? NULL : old_name_param,
    };
    control_begin(&b->control, &b->setup);
}

static void board_close(serial_board *b)
{
    free(b->world);
    free(b->block);
    free(b->scratch);
}

/* -- lines ------------------------------------------------------------------------- */

/* True if the output is whole lines and the last line begins with `word`. */
static bool ends_with_line(const serial_board *b, const char *word)
{
    size_t at = b->length;
    if (at == 0 || b->said[at - 1] != '\n')
        return false;
    for (at--; at > 0 && b->said[at - 1] != '\n'; at--)
        ;
    return strncmp(b->said + at, word, strlen(word)) == 0
        && b->said[at + strlen(word)] > ' ';
}

/* Feeds a byte. Returns true if the byte ended a line. */
static bool feed(serial_board *b, uint8_t byte)
{
    const tp_scene scene = b->scene;
    const control before = b->control;
    b->length = 0;
    if (!control_byte(&b->control, byte)) {
        REQUIRE(b->length == 0);
        return false;
    }
    if (!ends_with_line(b, "ok ")) {
        REQUIRE(ends_with_line(b, "error "));
        REQUIRE(memcmp(&scene, &b->scene, sizeof scene) == 0);
        REQUIRE(memcmp(&before.input, &b->control.input, sizeof before.input) == 0);
        REQUIRE(before.paused == b->control.paused && before.steps == b->control.steps);
    }
    REQUIRE(tp_scene_check(&b->scene, NULL) == TP_OK);
    return true;
}

static void make_ticks(serial_board *b, int most)
{
    while (most-- > 0 && control_ticks(&b->control)) {
        const tp_input input = control_take(&b->control);
        tp_world_step(&tp_program_all, b->world, &b->scene, &input);
    }
}

static void draw(serial_board *b)
{
    tp_tile tile;
    tp_frame_begin(b->frame, b->world);
    for (uint32_t i = 0; tp_frame_draw_tile(b->frame, i, b->scratch, &tile); i++)
        REQUIRE(tile.pixels != NULL);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static serial_board b;
    int ticks = TICKS;
    board_open(&b, fuzz_byte(&data, &size));
    while (size > 0)
        if (feed(&b, fuzz_byte(&data, &size)) && ticks-- > 0)
            make_ticks(&b, 1);
    make_ticks(&b, ticks);
    draw(&b);
    board_close(&b);
    return 0;
}
