/* SPDX-License-Identifier: MIT */
/* The baked scene on a Raspberry Pi Pico by the Pico SDK.  Both cores take tiles and draw
 * them; the panel's driver sends a tile by DMA while the cores draw on.  The pins are those
 * of ports/pico. */
#include <pico/stdlib.h>
#include <pico/multicore.h>
#include <pico/mutex.h>
#include <hardware/dma.h>
#include <hardware/spi.h>
#include "cortex-m/baked.h"
#include "lcd/lcd.h"
#include "tidepool/tidepool.h"

enum { PIN_CS = 17, PIN_CLOCK = 18, PIN_DATA = 19, PIN_DC = 20, PIN_RESET = 21,
       PIN_LIGHT = 22 };
enum { CORES = 2, STACK_WORDS = 1024, TIMEOUT_US = 100000 };

static uint64_t  memory[17 << 10];      /* 136 KB */
static uint32_t  stack1[STACK_WORDS];   /* of core 1; the SDK's own has 2 KB */
static lcd       panel;
static tp_frame *frame;
static void     *scratch[CORES];
static uint      dma;
static mutex_t   tiles, wires;
static uint32_t  next_tile;             /* under `tiles` */
static lcd_status status;               /* of this frame; under `wires` */

/* -- wires --------------------------------------------------------------------------- */

static void command(void *unused, uint8_t byte)
{
    (void)unused;
    gpio_put(PIN_DC, 0);
    spi_write_blocking(spi0, &byte, 1);
}

static void data(void *unused, const uint8_t *bytes, size_t count)
{
    dma_channel_config c = dma_channel_get_default_config(dma);

    (void)unused;
    channel_config_set_transfer_data_size(&c, DMA_SIZE_8);
    channel_config_set_dreq(&c, spi_get_dreq(spi0, true));
    gpio_put(PIN_DC, 1);
    dma_channel_configure(dma, &c, &spi_get_hw(spi0)->dr, bytes, (uint)count, true);
}

static bool await_wires(void *unused, lcd_until until)
{
    const uint32_t from = time_us_32();

    (void)unused, (void)until;
    while (dma_channel_is_busy(dma) || spi_is_busy(spi0))
        if (time_us_32() - from > TIMEOUT_US) {
            dma_channel_abort(dma);
            return false;
        }
    return true;
}

static void pause_ms(void *unused, uint32_t ms)
{
    (void)unused;
    sleep_ms(ms);
}

static void open_pin(uint pin, bool high)
{
    gpio_init(pin);
    gpio_put(pin, high);
    gpio_set_dir(pin, GPIO_OUT);
}

static void reset_panel(void)
{
    gpio_put(PIN_RESET, 0);
    sleep_ms(1);
    gpio_put(PIN_RESET, 1);
    sleep_ms(120);
}

static void open_wires(void)
{
    spi_init(spi0, 33250000);
    gpio_set_function(PIN_CLOCK, GPIO_FUNC_SPI);
    gpio_set_function(PIN_DATA, GPIO_FUNC_SPI);
    open_pin(PIN_DC, true);
    open_pin(PIN_RESET, true);
    open_pin(PIN_LIGHT, true);
    open_pin(PIN_CS, false);            /* the panel is alone on these wires */
    dma = (uint)dma_claim_unused_channel(true);
    reset_panel();
}

/* -- memory -------------------------------------------------------------------------- */

static void *take(size_t bytes)         /* the next part; NULL: not enough left */
{
    static size_t used;
    const size_t at = used;

    used += (bytes + 7) / 8;
    return bytes && used <= sizeof memory / sizeof *memory ? &memory[at] : NULL;
}

/* Makes frame and world; returns NULL if the memory is too small. */
static tp_world *open_scene(void)
{
    const size_t frame_bytes = baked_frame_bytes();
    void     *block = take(frame_bytes);
    tp_world *world = take(baked_world_bytes);

    for (int core = 0; core < CORES; core++) {
        scratch[core] = take(baked_scratch_bytes);
        if (!scratch[core])
            return NULL;
    }
    if (!world || baked_frame_init(&frame, block, frame_bytes, NULL)
        || baked_world_init(world, baked_world_bytes, NULL))
        return NULL;
    return world;
}

/* -- pictures ------------------------------------------------------------------------ */

static uint32_t take_tile(void)
{
    mutex_enter_blocking(&tiles);
    const uint32_t i = next_tile++;
    mutex_exit(&tiles);
    return i;
}

/* Draws and sends tiles until none is left; each core runs this function. */
static void draw_tiles(void *own_scratch)
{
    tp_tile tile;

    while (tp_frame_draw_tile(frame, take_tile(), own_scratch, &tile)) {
        mutex_enter_blocking(&wires);
        if (status == LCD_OK)
            status = lcd_tile(&panel, &tile);
        mutex_exit(&wires);
    }
}

/* Core 1: draws when core 0 sends a word, and answers when no tile is left. */
static void help(void)
{
    for (;;) {
        const uint32_t word = multicore_fifo_pop_blocking();
        draw_tiles(scratch[1]);
        multicore_fifo_push_blocking(word);
    }
}

static void show(const tp_world *world)
{
    tp_frame_begin(frame, world);
    lcd_begin(&panel);
    next_tile = 0;
    status = LCD_OK;
    multicore_fifo_push_blocking(1);
    draw_tiles(scratch[0]);
    multicore_fifo_pop_blocking();
    if (status == LCD_OK)
        status = lcd_end(&panel);
}

int main(void)
{
    const lcd_config config = {
        .panel = &lcd_ili9341, .turn = 1, .frame = baked_config,
        .wires = { NULL, command, data, await_wires, pause_ms },
    };
    set_sys_clock_khz(133000, true);
    open_wires();
    void     *sends = take(lcd_bytes(&config, NULL));
    tp_world *world = open_scene();

    if (!sends || !world)
        return 3;
    if (lcd_open(&panel, &config, sends))
        return 4;
    mutex_init(&tiles);
    mutex_init(&wires);
    multicore_launch_core1_with_stack(help, stack1, sizeof stack1);
    for (;;) {
        show(world);
        if (status != LCD_OK) {         /* the panel blocks: start again */
            reset_panel();
            lcd_open(&panel, &config, sends);
        }
        tp_world_step(&baked_program, world, &baked_scene, NULL);
    }
}
