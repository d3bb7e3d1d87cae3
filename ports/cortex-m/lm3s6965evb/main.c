/* SPDX-License-Identifier: MIT */
/* The baked scene, live on the evaluation board's OLED.  Ticks follow the clock; buttons
 * and command lines over the serial port change the scene (serial/buttons.h,
 * serial/control.h).
 *
 * Input is echoed as lines of a tape (world/text.h): with the head "tape 2 SCENE" and
 * `tidepool render SCENE --tape` they reproduce the same pictures elsewhere.  The scene
 * lies in RAM, where commands change it; board.mk names the modules that commands may
 * switch on.  In QEMU's window the arrow keys and Ctrl are the buttons:
 *
 *     make BOARD=cortex-m/lm3s6965evb SCENE=tarn elf
 *     qemu-system-arm -M lm3s6965evb -serial stdio \
 *         -kernel build/lm3s6965evb/scenes/tarn.elf */
#include "base/base.h"
#include "cortex-m/baked.h"
#include "cortex-m/board.h"
#include "cortex-m/live.h"
#include "cortex-m/trace_marks.h"
#include "evb.h"
#include "frame/tools.h"
#include "lcd/lcd.h"
#include "pixel/pixel.h"
#include "serial/buttons.h"

#define TICK_CLOCKS (EVB_HZ / TP_TICKS_PER_SECOND)

static const tp_program *const program = &baked_program;
static const tp_config *const picture = &baked_config;

static tp_scene  scene;
static control   lines;
static buttons   pressed;
static lcd       panel;
static tp_world *world;
static tp_frame *frame;
static void     *scratch;
static uint32_t  owed;              /* clocks of ticks due */
static uint64_t  sent_before;       /* bytes sent before the last frame */
static uint32_t  clocks;            /* duration of the last frame, clocks */

TRACE_MARK(count_as_frame)
TRACE_MARK(count_as_tiles)
TRACE_MARK(count_end)

/* -- memory -------------------------------------------------------------------------- */

static void open_scene(void)
{
    const lcd_config config = {
        .panel = &lcd_ssd0323,
        .frame = *picture,
        .wires = { NULL, evb_command, evb_data, NULL, evb_pause },
    };
    const size_t bytes = tp_world_bytes(program, &baked_scene, &baked_assets);
    tp_arena arena = tp_arena_init(arena_start, (size_t)(arena_end - arena_start));
    tp_error err;
    char     text[160];

    scene = baked_scene;
    world = live_take(&arena, "ram world ", bytes);
    scratch = live_take(&arena, " scratch ", tp_frame_scratch_bytes(picture, &scene));
    const size_t frame_bytes = tp_frame_bytes(picture, &scene);
    void *block = live_take(&arena, " frame ", frame_bytes);
    void *sends = live_take(&arena, " panel ", lcd_bytes(&config, NULL));
    live_say(" left ", arena.bytes - arena.used);
    const lcd_status status = lcd_open(&panel, &config, sends);
    if (status != LCD_OK)
        live_halt(lcd_status_text(status));
    if (tp_world_init(program, world, bytes, &scene, &baked_assets, &err)
        || tp_frame_init(&frame, picture, &scene, block, frame_bytes, &err)) {
        tp_error_text(&err, text, sizeof text);
        live_halt(text);
    }
    const tp_ram_use ram = tp_frame_ram(frame);
    live_say(" vertices ", ram.vertices);
    live_say(" mirror ", ram.mirror);
    live_say(" reserve ", board_stack_bytes());
    live_say("\npicture ", picture->width);
    live_say("x", picture->height);
    live_text(NULL, " ");
    live_text(NULL, tp_format_name(picture->format));
    live_say(" ", picture->tile_width ? picture->tile_width : picture->width);
    live_say("x", picture->tile_height);
    live_text(NULL, "\n");
}

/* -- replies ------------------------------------------------------------------------- */

/* Draws the picture again, only for its CRC; the marks enclose the core's work. */
static uint32_t crc_of_picture(void)
{
    tp_tile  tile;
    uint32_t crc = 0;
    count_as_frame();
    tp_frame_begin(frame, world);
    count_as_tiles();
    for (uint32_t i = 0; tp_frame_draw_tile(frame, i, scratch, &tile); i++) {
        count_end();
        for (uint32_t y = tile.y0; y < tile.y1; y++)
            crc = tp_crc32_pixels(crc, picture->format,
                                  (const uint8_t *)tile.pixels
                                      + (y - tile.y0) * tile.stride,
                                  (int)picture->width);
        count_as_tiles();
    }
    count_end();
    return crc;
}

static void say_state(void *unused)
{
    live_text(unused, " crc32 ");
    live_number(crc_of_picture(), 16, 8);
    live_say(", bytes sent ", (size_t)(panel.sent - sent_before));
    live_say(", clocks ", clocks);
    live_say(", dropped ", tp_frame_stats(frame).dropped);
    live_say(", stack ", board_stack_used());
}

static const control_setup setup = {
    .shown = &scene, .scene = &scene, .config = &baked_config,
    .write = live_text, .state = say_state,
};

/* -- time ---------------------------------------------------------------------------- */

static void tick(void)
{
    const tp_input input = control_take(&lines);
    live_echo(world, &input);
    tp_world_step(program, world, &scene, &input);
}

static bool make_ticks(void)
{
    owed += evb_clocks();
    return live_make_ticks(&owed, TICK_CLOCKS, &lines, tick);
}

static void show(void)
{
    owed += evb_clocks();
    sent_before = panel.sent;
    lines.changed = false;
    tp_frame_begin(frame, world);
    lcd_show(&panel, frame, scratch);       /* cannot fail: the wires have no wait */
    clocks = evb_clocks();
    owed += clocks;
}

int main(void)
{
    static control_setup here;
    uint8_t byte;

    evb_open();
    open_scene();
    here = setup;
    here.world = world;
    here.world_bytes = tp_world_bytes(program, &baked_scene, &baked_assets);
    control_begin(&lines, &here);
    pressed.lines = evb_buttons();
    live_text(NULL, "ok ");
    live_text(NULL, scene.title);
    live_text(NULL, "\n");
    show();
    for (;;) {
        while (control_reads(&lines) && evb_byte(&byte))
            control_byte(&lines, byte);
        buttons_read(&pressed, evb_buttons(), world, &scene, &lines.input);
        if (make_ticks() || lines.changed)
            show();
    }
}
