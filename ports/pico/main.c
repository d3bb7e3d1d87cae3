/* SPDX-License-Identifier: MIT */
/* The baked scene, live on a Raspberry Pi Pico with an SPI panel.  Both cores draw tiles:
 * each takes the next tile, draws it into a scratch of its own and passes it to the panel's
 * driver, which sends it by DMA while the cores draw on.  Core 0 also makes the ticks.
 *
 * Ticks follow the clock; buttons and command lines over the serial port change the scene
 * (serial/buttons.h, serial/control.h).  Input is echoed as lines of a tape
 * (world/text.h).  The scene lies in RAM, where commands change it; board.mk names the
 * modules that commands may switch on. */
#include "base/base.h"
#include "cortex-m/baked.h"
#include "cortex-m/frame_crc.h"
#include "cortex-m/live.h"
#include "cortex-m/trace_marks.h"
#include "frame/tools.h"
#include "pico.h"
#include "pixel/pixel.h"
#include "serial/buttons.h"

#ifndef PICO_PANEL
#define PICO_PANEL lcd_ili9341
#endif
#ifndef PICO_CORES
#define PICO_CORES 2
#endif
enum { CORES = PICO_CORES };

#define SECOND_US     1000000u

static const tp_program *const program = &baked_program;
static const tp_config *const picture = &baked_config;

static tp_scene  scene;
static control   lines;
static buttons   pressed;
static lcd       panel;
static void     *sends;             /* the panel's buffers */
static tp_world *world;
static tp_frame *frame;
static void     *scratch[CORES];
static uint32_t  next_tile;         /* under LOCK_TILES */
static lcd_status status;           /* of this frame; under LOCK_PANEL */
static uint32_t  last_us;           /* clock at the last call of elapsed */
static uint32_t  owed;              /* ticks due, in 1/60 us of the clock */
static uint32_t  sent_bytes;        /* sent for the last frame */
static uint32_t  frame_us;          /* duration of the last frame, us */

TRACE_MARK(count_as_frame)
TRACE_MARK(count_as_tiles)
TRACE_MARK(count_as_tick)
TRACE_MARK(count_end)

/* -- replies ------------------------------------------------------------------------- */

/* Draws the picture again, by this core alone, only for its CRC. */
static uint32_t crc_of_picture(void)
{
    tp_tile  tile;
    uint32_t crc = 0;
    tp_frame_begin(frame, world);
    for (uint32_t i = 0; tp_frame_draw_tile(frame, i, scratch[0], &tile); i++)
        crc = frame_crc_add_tile(crc, picture, &tile);
    return crc;
}

static void say_state(void *unused)
{
    live_text(unused, " crc32 ");
    live_number(crc_of_picture(), 16, 8);
    live_say(", bytes sent ", sent_bytes);
    live_say(", us ", frame_us);
    live_say(", dropped ", tp_frame_stats(frame).dropped);
    live_say(", stack ", start_stack_used(0));
    live_say(" ", start_stack_used(1));
}

/* -- memory -------------------------------------------------------------------------- */

static lcd_config panel_config(void)
{
    return (lcd_config){
        .panel = &PICO_PANEL,
        .turn = 1,
        .frame = *picture,
        .wires = { NULL, panel_command, panel_data, panel_wait, panel_pause },
    };
}

static void open_panel(void)
{
    const lcd_config config = panel_config();
    panel_open();
    const lcd_status opened = lcd_open(&panel, &config, sends);
    if (opened != LCD_OK && opened != LCD_E_BLOCKED)
        live_halt(lcd_status_text(opened));
}

static void open_scene(void)
{
    const lcd_config config = panel_config();
    const size_t bytes = tp_world_bytes(program, &baked_scene, &baked_assets);
    tp_arena arena = tp_arena_init(arena_start, (size_t)(arena_end - arena_start));
    tp_error err;
    char     text[160];

    scene = baked_scene;
    world = live_take(&arena, "ram world ", bytes);
    for (int core = 0; core < CORES; core++) {
        scratch[core] = live_take(&arena, " scratch ",
                                  tp_frame_scratch_bytes(picture, &scene));
        memset(scratch[core], 0, tp_frame_scratch_bytes(picture, &scene));
    }
    const size_t frame_bytes = tp_frame_bytes(picture, &scene);
    void *block = live_take(&arena, " frame ", frame_bytes);
    sends = live_take(&arena, " panel ", lcd_bytes(&config, NULL));
    live_say(" left ", arena.bytes - arena.used);
    if (tp_world_init(program, world, bytes, &scene, &baked_assets, &err)
        || tp_frame_init(&frame, picture, &scene, block, frame_bytes, &err)) {
        tp_error_text(&err, text, sizeof text);
        live_halt(text);
    }
    live_text(NULL, "\n");
}

/* -- pictures ------------------------------------------------------------------------ */

static uint32_t take_tile(void)
{
    cores_lock(LOCK_TILES);
    const uint32_t i = next_tile++;
    cores_unlock(LOCK_TILES);
    return i;
}

static bool draw_tile(tp_tile *tile)
{
    const uint32_t i = take_tile();
    count_as_tiles();
    const bool drawn = tp_frame_draw_tile(frame, i, scratch[pico_core()], tile);
    count_end();
    return drawn;
}

/* Draws and sends tiles until none is left; each core runs this function.  Tiles reach the
 * panel in any order, each in a window of its own. */
static void draw_tiles(void)
{
    tp_tile tile;
    while (draw_tile(&tile)) {
        cores_lock(LOCK_PANEL);
        if (status == LCD_OK)
            status = lcd_tile(&panel, &tile);
        cores_unlock(LOCK_PANEL);
    }
}

/* Core 1: draws when core 0 sends a word, and answers when no tile is left. */
static void help(void)
{
    start_guard_stack();
    for (;;) {
        const uint32_t word = cores_receive();
        draw_tiles();
        cores_send(word);
    }
}

static void draw_and_send(void)
{
    count_as_frame();
    tp_frame_begin(frame, world);
    count_end();
    lcd_begin(&panel);
    next_tile = 0;
    status = LCD_OK;
    if (CORES > 1)
        cores_send(1);
    draw_tiles();
    if (CORES > 1)
        cores_receive();
    if (status == LCD_OK)
        status = lcd_end(&panel);
}

static void show(void)
{
    const uint64_t sent_before = panel.sent;
    const uint32_t from = pico_us();

    lines.changed = false;
    draw_and_send();
    frame_us = pico_us() - from;
    sent_bytes = (uint32_t)(panel.sent - sent_before);
    if (status != LCD_OK)
        open_panel();                   /* the panel blocks: start again */
}

/* -- time ---------------------------------------------------------------------------- */

static void tick(void)
{
    const tp_input input = control_take(&lines);
    live_echo(world, &input);
    count_as_tick();
    tp_world_step(program, world, &scene, &input);
    count_end();
}

static uint32_t elapsed(void)
{
    const uint32_t now = pico_us(), us = now - last_us;
    last_us = now;
    return us < SECOND_US ? us : SECOND_US;
}

/* Makes the ticks now due.  A microsecond of the clock is TP_TICKS_PER_SECOND units. */
static bool make_ticks(void)
{
    owed += elapsed() * TP_TICKS_PER_SECOND;
    return live_make_ticks(&owed, SECOND_US, &lines, tick);
}

static void check_stacks(void)
{
    for (uint32_t core = 0; core < CORES; core++)
        if (!start_stack_holds(core))
            live_halt(core ? "the stack of core 1 overflowed"
                                 : "the stack of core 0 overflowed");
}

int main(void)
{
    static control_setup setup;
    uint8_t byte;

    start_guard_stack();
    pico_open();
    open_scene();
    open_panel();
    if (CORES > 1)
        cores_start(help);
    setup = (control_setup){
        .shown = &scene, .scene = &scene, .config = picture, .world = world,
        .world_bytes = tp_world_bytes(program, &baked_scene, &baked_assets),
        .write = live_text, .state = say_state,
    };
    control_begin(&lines, &setup);
    pressed.lines = pico_buttons();
    live_text(NULL, "ok ");
    live_text(NULL, scene.title);
    live_text(NULL, "\n");
    lines.changed = true;
    for (;;) {
        check_stacks();
        while (control_reads(&lines) && pico_byte(&byte))
            control_byte(&lines, byte);
        buttons_read(&pressed, pico_buttons(), world, &scene, &lines.input);
        if (make_ticks() || lines.changed)
            show();
    }
}
