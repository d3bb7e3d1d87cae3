/* SPDX-License-Identifier: MIT */
/* From reset to pictures: takes memory, makes the world and the frame, opens the panel,
 * and repeats pictures and ticks.  Picture 60 is reported as a CRC, which must equal the
 * host's: `./scene.sh crc` prints it. */
#include "board.h"
#include "cortex-m/frame_crc.h"
#include "tidepool/tidepool.h"

/* scene.c, written by scene.sh; the program is that of the scene. */
extern const tp_scene  baked_scene;
extern const tp_config baked_config;
extern const size_t    baked_world_bytes, baked_scratch_bytes;
size_t baked_frame_bytes(void);
tp_status baked_frame_init(tp_frame **frame, void *memory, size_t bytes, tp_error *err);
tp_status baked_world_init(tp_world *world, size_t bytes, tp_error *err);

enum {
    CHECKED = 60,               /* the picture with the CRC: after one second */
    TICKS_PER_SECOND = 60,
    MOST_TICKS = 6,             /* ticks between two pictures: a slow board falls behind */
    EXIT_MEMORY = 3, EXIT_PANEL = 4
};

static size_t    used;          /* bytes of the arena */
static lcd       screen;
static tp_frame *frame;
static tp_world *world;
static void     *scratch;       /* one tile as it is drawn */

/* -- reports ------------------------------------------------------------------------- */

static void say_number(const char *before, uint32_t n, uint32_t base, int least_digits)
{
    char  text[12];
    char *c = text + sizeof text - 1;

    *c = '\0';
    for (; n || least_digits > 0; n /= base, least_digits--)
        *--c = "0123456789abcdef"[n % base];
    board_say(before);
    board_say(c);
}

static _Noreturn void stop(int code, const char *why)
{
    board_say(why);
    board_say("\n");
    board_end(code);
}

static void say_memory(void)
{
    say_number("ram ", (uint32_t)used, 10, 1);
    say_number(" of ", (uint32_t)(arena_end - arena_start), 10, 1);
    say_number(" bytes, stack ", board_stack_used(), 10, 1);
    say_number(" of ", board_stack_bytes(), 10, 1);
    board_say("\n");
}

/* -- memory -------------------------------------------------------------------------- */

/* Takes bytes of the arena, aligned to LCD_ALIGN for a DMA; later nothing is allocated. */
static void *take(size_t bytes, const char *what)
{
    const uintptr_t from = ((uintptr_t)arena_start + used + LCD_ALIGN - 1)
                         & ~(uintptr_t)(LCD_ALIGN - 1);
    const size_t left = (uintptr_t)arena_end > from ? (uintptr_t)arena_end - from : 0;

    if (bytes > left) {
        say_number("not enough RAM: ", (uint32_t)bytes, 10, 1);
        say_number(" bytes, left ", (uint32_t)left, 10, 1);
        stop(EXIT_MEMORY, what);
    }
    used = from + bytes - (uintptr_t)arena_start;
    return (void *)from;
}

static void make_world(void)
{
    const size_t frame_bytes = baked_frame_bytes();
    void *block = take(frame_bytes, ", for the frame");

    scratch = take(baked_scratch_bytes, ", for a tile");
    world = take(baked_world_bytes, ", for the world");
    if (baked_frame_init(&frame, block, frame_bytes, NULL))
        stop(EXIT_MEMORY, "the frame cannot be made");
    if (baked_world_init(world, baked_world_bytes, NULL))
        stop(EXIT_MEMORY, "the world cannot be made");
}

/* -- panel --------------------------------------------------------------------------- */

static bool is_turned(void)
{
    return baked_config.width > BOARD_PANEL.width
        || baked_config.height > BOARD_PANEL.height;
}

/* Half of the rest of the glass, even: a byte of a grey panel has two pixels. */
static int16_t margin(uint32_t glass, uint32_t picture)
{
    return (int16_t)(glass > picture ? (glass - picture) / 4 * 2 : 0);
}

static lcd_config panel_config(void)
{
    const bool turned = is_turned();
    const uint32_t width = turned ? BOARD_PANEL.height : BOARD_PANEL.width;
    const uint32_t height = turned ? BOARD_PANEL.width : BOARD_PANEL.height;

    return (lcd_config){
        .panel = &BOARD_PANEL, .wires = board_wires, .frame = baked_config, .turn = turned,
        .x = margin(width, baked_config.width), .y = margin(height, baked_config.height),
    };
}

/* Resets the panel, and clears it if the picture is smaller than the glass. */
static lcd_status open_panel(const lcd_config *c, void *buffers)
{
    const lcd_status status = lcd_open(&screen, c, buffers);
    return status == LCD_OK && (c->x || c->y) ? lcd_clear(&screen, 0) : status;
}

/* -- pictures and ticks -------------------------------------------------------------- */

/* Draws and sends a picture as lcd_show() does; returns the CRC of its tiles. */
static uint32_t show_checked(void)
{
    lcd_status status = LCD_OK;
    uint32_t   crc = 0;
    tp_tile    tile;

    tp_frame_begin(frame, world);
    lcd_begin(&screen);
    for (uint32_t i = 0; tp_frame_draw_tile(frame, i, scratch, &tile); i++) {
        crc = frame_crc_add_tile(crc, &baked_config, &tile);
        status = status == LCD_OK ? lcd_tile(&screen, &tile) : status;
    }
    status = status == LCD_OK ? lcd_end(&screen) : status;
    if (status != LCD_OK)
        stop(EXIT_PANEL, lcd_status_text(status));
    return crc;
}

static void check_picture(void)
{
    const uint32_t begin = board_ms();
    for (uint32_t tick = 0; tick < CHECKED; tick++)
        tp_world_step(NULL, world, &baked_scene, NULL);
    const uint32_t middle = board_ms(), sent = (uint32_t)screen.sent;
    const uint32_t crc = show_checked();

    say_number("frame ", CHECKED, 10, 4);
    say_number(" crc32 ", crc, 16, 8);
    say_number("\n60 ticks ", middle - begin, 10, 1);
    say_number(" ms, a picture ", board_ms() - middle, 10, 1);
    say_number(" ms, ", (uint32_t)screen.sent - sent, 10, 1);
    board_say(" bytes sent\n");
}

/* Returns the ticks that are due: 60 a second from `since` on, *done of them done.  A board
 * without a clock gets one a picture. */
static uint32_t due_ticks(uint32_t *done, uint32_t since)
{
    const uint32_t now = board_ms();
    const uint32_t all = (uint32_t)((uint64_t)(now - since) * TICKS_PER_SECOND / 1000);
    const uint32_t due = all - *done;

    if (now == 0)
        return 1;
    *done = all;
    return due < MOST_TICKS ? due : MOST_TICKS;
}

int main(void)
{
    const lcd_config c = panel_config();
    lcd_status why;
    const size_t buffer_bytes = lcd_bytes(&c, &why);

    if (why != LCD_OK)
        stop(EXIT_PANEL, lcd_status_text(why));
    void *buffers = take(buffer_bytes, ", for the panel");
    make_world();
    if (open_panel(&c, buffers) != LCD_OK)
        stop(EXIT_PANEL, lcd_status_text(LCD_E_BLOCKED));
    check_picture();
    say_memory();

    const uint32_t since = board_ms();
    uint32_t ticks = 0;
    for (uint32_t n = 1; BOARD_PICTURES == 0 || n < BOARD_PICTURES; n++) {
        for (uint32_t due = due_ticks(&ticks, since); due > 0; due--)
            tp_world_step(NULL, world, &baked_scene, NULL);
        tp_frame_begin(frame, world);
        if (lcd_show(&screen, frame, scratch) != LCD_OK)
            open_panel(&c, buffers);            /* the panel blocks: start again */
    }
    return 0;
}
