/* SPDX-License-Identifier: MIT */
/* The baked scene on a Raspberry Pi's screen, without an operating system.
 *
 * The GPU owns the screen.  A mailbox request allocates a frame buffer of two pages, one
 * below the other.  Bands are drawn directly into the hidden page, then the visible window
 * is moved to that page.  Each answer is compared with its request: if they differ, one
 * line says so and the program ends with 3.
 *
 * On the serial port (PL011, 115200 8n1, pins 14 and 15) requested frames are reported by
 * their CRC, read back from the page; it must equal the host's.  An emulator with
 * semihosting passes the task in its command line, by names and numbers:
 *     depth 16 or 32 (32), width, height (640x480), first tick (0),
 *     frames, after which the picture stays (0: continues in real time)
 *
 * Commands of serial/control.h set the scene's numbers; while the water is paused, each
 * frame that they cause is reported.  The program links every module: size and depth of
 * the screen are known at run time, commands may switch on features that the scene lacks,
 * and memory is ample.
 *
 * For a board: make BOARD=rpi/raspi2b SCENE=x elf, then objcopy -O binary to the name in
 * board.ld, on the card beside the firmware's files.  Tested in QEMU only. */
#include "rpi.h"
#include "base/base.h"
#include "interact/old_names.h"
#include "pixel/pixel.h"
#include "serial/control.h"
#include "tidepool/modules.h"

extern const tp_scene  baked_scene;
extern const tp_assets baked_assets;

void *memcpy(void *restrict to, const void *restrict from, size_t bytes);

enum { BAND = 16,                       /* rows per band */
       TICK_US = 16667, MOST_TICKS = 8 };       /* ticks between two frames, at most */

static _Noreturn void stop(const char *why)
{
    say(why);
    say("\n");
    halt(3);
}

/* -- the task ------------------------------------------------------------------------ */

typedef struct { uint32_t depth, width, height, first, frames; } rpi_request;

/* Sets *number to the number after a name in the command line; leaves it if the name is
 * missing. */
static void parse_option(const char *line, const char *name, uint32_t *number)
{
    for (; *line; line++) {
        const char *c = line, *n = name;
        while (*n && *c == *n)
            c++, n++;
        if (*n || *c != ' ')
            continue;
        for (*number = 0, c++; *c >= '0' && *c <= '9'; c++)
            *number = *number * 10 + (uint32_t)(*c - '0');
        return;
    }
}

static rpi_request what_to_draw(void)
{
    rpi_request w = { 32, 640, 480, 0, 0 };
    char line[128] = "";
    struct { char *text; size_t size; } block = { line, sizeof line };

    if (semihost(0x15, &block) == 0) {
        parse_option(line, "depth", &w.depth);
        parse_option(line, "width", &w.width);
        parse_option(line, "height", &w.height);
        parse_option(line, "first", &w.first);
        parse_option(line, "frames", &w.frames);
    }
    return w;
}

/* -- the screen ---------------------------------------------------------------------- */

typedef struct {
    uint8_t  *pixels;               /* first page */
    uint32_t  pitch, width, height;
    uint32_t  seen;                 /* visible page, 0 or 1 */
    tp_format format;
} rpi_screen;

/* Stops the program unless a property was answered exactly as requested. */
static void got(const char *what, const property *p, uint32_t a, uint32_t b)
{
    if (p->code & ANSWERED && p->value[0] == a && p->value[1] == b)
        return;
    say("no frame buffer: asked for ");
    say(what);
    say_number(" ", a, 10, 1);
    say_number(" ", b, 10, 1);
    say_number(", got ", p->value[0], 10, 1);
    say_number(" ", p->value[1], 10, 1);
    stop("");
}

/* Opens the screen.  At 16 bits the order called RGB has red in the high bits, at 32 bits
 * the other order.  Pages are wider than the screen, because QEMU moves its window only
 * over such a frame buffer. */
static rpi_screen screen_open(const rpi_request *w)
{
    const uint32_t order = w->depth == 16, wide = w->width + 16;
    property p[] = {
        { .id = SET_SIZE, .value = { w->width, w->height } },
        { .id = SET_VIRTUAL_SIZE, .value = { wide, 2 * w->height } },
        { .id = SET_DEPTH, .value = { w->depth } },
        { .id = SET_ORDER, .value = { order } },
        { .id = SET_OFFSET },
        { .id = ALLOCATE, .value = { 16 } },
        { .id = GET_PITCH },
    };
    rpi_screen s = { .width = w->width, .height = w->height };

    if (w->depth != 16 && w->depth != 32)
        stop("no frame buffer: the depth is 16 or 32");
    if (!gpu_ask(p, sizeof p / sizeof *p))
        stop("no frame buffer: the GPU does not answer");
    got("size", &p[0], w->width, w->height);
    got("virtual size", &p[1], wide, 2 * w->height);
    got("depth", &p[2], w->depth, 0);
    got("order", &p[3], order, 0);
    got("offset", &p[4], 0, 0);
    s.format = w->depth == 16 ? TP_FORMAT_RGB565 : TP_FORMAT_XRGB8888;
    s.pixels = (uint8_t *)(uintptr_t)(p[5].value[0] & 0x3fffffff);
    s.pitch = p[6].value[0];
    const uintptr_t room = (uintptr_t)peripherals - (uintptr_t)s.pixels;
    if (!s.pixels || s.pitch < wide * (w->depth / 8) || p[5].value[1] > room
        || p[5].value[1] / s.pitch < 2 * w->height)
        stop("no frame buffer: too little memory");
    return s;
}

static uint8_t *screen_page(const rpi_screen *s, uint32_t page)
{
    return s->pixels + (size_t)page * s->height * s->pitch;
}

/* Shows the other page; returns when the screen no longer reads the previous page. */
static void screen_flip(rpi_screen *s)
{
    const uint32_t row = (1 - s->seen) * s->height;
    property p[] = { { .id = SET_OFFSET, .value = { 0, row } }, { .id = SET_VSYNC } };

    barrier();
    if (!gpu_ask(p, 2))
        stop("no frame buffer: the GPU does not answer");
    got("offset", &p[0], 0, row);
    s->seen = 1 - s->seen;
}

/* -- pictures ------------------------------------------------------------------------ */

typedef struct {
    tp_config config;
    tp_frame *frame;
    tp_world *world;
    void     *scratch;
    control_setup setup;
    control   control;
    uint32_t  drawn_in;             /* time of the last frame, us */
} rpi_work;

static tp_scene scene;              /* RAM copy of the baked scene, changed by commands */

static void write(void *to, const char *text)
{
    (void)to;
    say(text);
}

static void say_state(void *to)
{
    const rpi_work *w = to;
    say_number(" stack ", stack_used(), 10, 1);
    say_number(" bytes, a frame in ", w->drawn_in, 10, 1);
    say(" us");
}

static void work_begin(rpi_work *w, const rpi_screen *s)
{
    memcpy(&scene, &baked_scene, sizeof scene);
    w->config = (tp_config){ .width = s->width,
                             .height = s->height,
                             .tile_height = BAND,
                             .format = s->format,
                             .assets = &baked_assets };
    const size_t bytes = tp_frame_bytes(&w->config, &scene);
    const size_t world_bytes = tp_world_bytes(&tp_program_all, &scene, &baked_assets);
    tp_arena arena = tp_arena_init(arena_start, (size_t)(arena_end - arena_start));
    void    *block = tp_arena_alloc(&arena, 1, bytes);
    tp_error err;

    w->scratch =
        tp_arena_alloc(&arena, 1, tp_frame_direct_scratch_bytes(&w->config, &scene));
    w->world = tp_arena_alloc(&arena, 1, world_bytes);
    if (arena.failed || tp_frame_init(&w->frame, &w->config, &scene, block, bytes, &err))
        stop("the frame does not fit");
    if (tp_world_init(&tp_program_all, w->world, world_bytes, &scene, &baked_assets,
                      &err))
        stop("the world cannot be made");
    w->setup = (control_setup){
        .shown = &scene,
        .scene = &scene,
        .config = &w->config,
        .world = w->world,
        .world_bytes = world_bytes,
        .write = write,
        .state = say_state,
        .to = w,
        .find = old_name_param,
    };
    control_begin(&w->control, &w->setup);
}

static void tick(rpi_work *w)
{
    const tp_input input = control_take(&w->control);
    tp_world_step(&tp_program_all, w->world, &scene, &input);
}

static void draw(rpi_work *w, rpi_screen *s)
{
    const uint32_t begun = microseconds();
    uint8_t *page = screen_page(s, 1 - s->seen);
    tp_tile  tile;
    tp_frame_begin(w->frame, w->world);
    for (uint32_t i = 0;
         tp_frame_draw_tile_direct(w->frame, i, w->scratch, page, s->pitch, &tile); i++)
        uart_listen();
    w->drawn_in = microseconds() - begun;
    screen_flip(s);
}

static void tell(const rpi_work *w, const rpi_screen *s)
{
    const uint8_t *row = screen_page(s, s->seen);
    uint32_t crc = 0;
    for (uint32_t y = 0; y < s->height; y++, row += s->pitch)
        crc = tp_crc32_pixels(crc, s->format, row, (int)s->width);
    say_number("frame ", (uint32_t)tp_world_tick(w->world), 10, 4);
    say_number(" crc32 ", crc, 16, 8);
    say("\n");
}

/* -- main loop ----------------------------------------------------------------------- */

/* Returns the ticks since `clock` and advances `clock`; if a scene is too slow some ticks
 * are lost. */
static uint32_t ticks_due(uint32_t *clock)
{
    const uint32_t n = (microseconds() - *clock) / TICK_US;
    *clock += n * TICK_US;
    return n < MOST_TICKS ? n : MOST_TICKS;
}

/* Runs for ever.  While the water is paused, frames are drawn and reported when step and
 * set commands ask for them. */
static _Noreturn void live(rpi_work *w, rpi_screen *s)
{
    control *c = &w->control;
    uint32_t clock = microseconds();
    for (;;) {
        int byte;
        while (control_reads(c) && (byte = uart_byte()) >= 0)
            control_byte(c, (uint8_t)byte);
        uint32_t due = ticks_due(&clock);
        for (due = due > c->steps ? due : c->steps; due && control_ticks(c); due--) {
            tick(w);
            c->changed = true;
        }
        if (!c->changed)
            continue;
        c->changed = false;
        draw(w, s);
        if (c->paused)
            tell(w, s);
    }
}

int main(void)
{
    static rpi_work w;
    uart_open();
    const rpi_request asked = what_to_draw();
    rpi_screen s = screen_open(&asked);
    work_begin(&w, &s);
    say_number("screen ", s.width, 10, 1);
    say_number("x", s.height, 10, 1);
    say_number(" of bits ", asked.depth, 10, 1);
    say("\n");

    while (tp_world_tick(w.world) < asked.first)
        tick(&w);
    for (uint32_t n = 0; n < asked.frames; n++) {
        if (n)
            tick(&w);
        draw(&w, &s);
        tell(&w, &s);
    }
    w.control.paused = asked.frames > 0;
    live(&w, &s);
}
