/* SPDX-License-Identifier: MIT */
/* Command interface: bytes to lines, lines to commands.  A line that is too long or
 * contains a byte that is not text is dropped and answered with an error at its end; the
 * next line is read normally. */
#include "control.h"
#include "../interact/poke.h"
#include "features/drops/drops.h"
#include "reply.h"
#include "world/pools.h"
#include "world/text.h"

#define DROPS_MOST 1024         /* limit of tp_input */
#define STEPS_MOST 100000

/* -- commands ------------------------------------------------------------------------ */

static void get(const control *c, control_word rest)
{
    const tp_param *param = control_find(c, control_next(&rest, '\0'));
    if (!param)
        return;
    reply_text(c, "ok ");
    reply_value(c, param);
    reply_range(c, " of ", param);
    reply_text(c, "\n");
}

static bool begins(const char *name, control_word prefix)
{
    size_t n = 0;
    while (n < prefix.bytes && name[n] == prefix.text[n])
        n++;
    return n == prefix.bytes;
}

static void list(const control *c, control_word rest)
{
    uint32_t count, n = 0;
    const tp_param *params = tp_params(&count);
    const control_word prefix = control_next(&rest, '\0');
    for (uint32_t i = 0; i < count; i++)
        if (begins(params[i].name, prefix)) {
            reply_value(c, &params[i]);
            reply_text(c, "\n");
            n++;
        }
    reply_text(c, n ? "ok " : "error ");
    reply_number(c, n);
    reply_text(c, n == 1 ? " parameter\n" : " parameters\n");
}

/* Reads the next word as a number in m; returns false if the word is anything else. */
static bool next_metres(control_word *rest, tp_fx *metres)
{
    const control_word word = control_next(rest, '\0');
    int beyond = 0;
    return word.bytes > 0
        && tp_fx_read(word.text, (uint32_t)word.bytes, metres, &beyond) == word.bytes
        && !beyond;
}

/* Refuses a push that exceeds the next tick's input; the sender must repeat it. */
static void refuse_full(const control *c)
{
    reply_text(c, "error ");
    reply_number(c, TP_PUSHES);
    reply_text(c, " pokes wait for the next tick, the most it takes\n");
}

static void poke(control *c, control_word rest)
{
    const tp_world *world = c->setup->world;
    tp_push push = { .height = c->setup->shown->pool.splash_height };
    bool read = next_metres(&rest, &push.x) && next_metres(&rest, &push.z);
    if (read && rest.bytes > 0)
        read = next_metres(&rest, &push.height) && rest.bytes == 0;
    if (!read)
        reply_error(c, "expected poke X Z [HEIGHT], in m");
    else if (!tp_world_pool(world) && !tp_world_field(world))
        reply_error(c, "the scene has no pool");
    else if (push.height != 0 && !poke_put(&c->input, &push))
        refuse_full(c);
    else
        reply_text(c, "ok poke\n");
}

static void drop(control *c)
{
    if (!tp_world_drops(c->setup->world)) {
        reply_error(c, "the scene has no drops");
        return;
    }
    c->input.drops += c->input.drops < DROPS_MOST;
    reply_text(c, "ok drop\n");
}

/* Adds pushes to an input; returns false if some have no room. */
static bool add_pushes(tp_input *to, const tp_push push[TP_PUSHES])
{
    bool all = true;
    for (int i = 0; i < TP_PUSHES; i++)
        all = (push[i].height == 0 || poke_put(to, &push[i])) && all;
    return all;
}

/* Parses "input ..." as a line of a tape.  The line's tick is replaced: "input" becomes "0
 * ", and the input applies to the next tick.  Drops and pushes already queued are kept. */
static void input(control *c)
{
    tp_tape_entry entry;
    tp_error err = { 0 };
    memset(c->line, ' ', sizeof "input" - 1);
    c->line[0] = '0';
    if (tp_tape_read(&entry, c->line, c->length, &err)) {
        reply_input_error(c, &err);
        return;
    }
    tp_input next = entry.input;
    memcpy(next.push, c->input.push, sizeof next.push);
    next.drops = tp_clamp(c->input.drops + next.drops, 0, DROPS_MOST);
    if (!add_pushes(&next, entry.input.push)) {
        refuse_full(c);
        return;
    }
    c->input = next;
    reply_text(c, "ok input\n");
}

static void pause(control *c, bool on)
{
    c->paused = on;
    reply_text(c, on ? "ok pause\n" : "ok go\n");
}

/* Parses "step" or "step N". */
static void step(control *c, control_word rest)
{
    const control_word word = control_next(&rest, '\0');
    uint32_t ticks = 0;
    size_t   n = 0;
    while (n < word.bytes && word.text[n] >= '0' && word.text[n] <= '9'
           && ticks <= STEPS_MOST)
        ticks = ticks * 10 + (uint32_t)(word.text[n++] - '0');
    if (word.bytes == 0)
        ticks = 1;
    if (n < word.bytes || ticks > STEPS_MOST || rest.bytes > 0) {
        reply_error(c, "expected step [TICKS], at most 100000");
        return;
    }
    c->paused = true;
    c->steps = ticks;
    reply_text(c, "ok step ");
    reply_number(c, ticks);
    reply_text(c, "\n");
}

/* Starts the world again at tick 0, with the scene's present numbers. */
static void restart(control *c)
{
    const control_setup *s = c->setup;
    tp_error err = { 0 };
    if (tp_world_init(s->config->program, s->world, s->world_bytes, s->shown,
                      s->config->assets, &err)) {
        reply_input_error(c, &err);
        return;
    }
    memset(&c->input, 0, sizeof c->input);
    c->changed = true;
    reply_text(c, "ok restart\n");
}

static void state(const control *c)
{
    const control_setup *s = c->setup;
    reply_text(c, "ok tick ");
    reply_number(c, (uint32_t)tp_world_tick(s->world));
    if (s->state)
        s->state(s->to);
    reply_text(c, "\n");
}

static void obey(control *c)
{
    control_word rest = { c->line, c->length };
    const control_word word = control_next(&rest, '\0');
    if (control_is(word, "set"))
        control_set(c, rest);
    else if (control_is(word, "get"))
        get(c, rest);
    else if (control_is(word, "list"))
        list(c, rest);
    else if (control_is(word, "poke"))
        poke(c, rest);
    else if (control_is(word, "drop"))
        drop(c);
    else if (control_is(word, "input"))
        input(c);
    else if (control_is(word, "pause") || control_is(word, "go"))
        pause(c, control_is(word, "pause"));
    else if (control_is(word, "step"))
        step(c, rest);
    else if (control_is(word, "restart"))
        restart(c);
    else if (control_is(word, "state"))
        state(c);
    else
        reply_error(c, "expected set get list drop poke input pause go step restart state");
}

/* -- lines --------------------------------------------------------------------------- */

/* Removes blanks before the first word.  A line of blanks only becomes empty. */
static void trim(control *c)
{
    uint32_t blanks = 0;
    while (blanks < c->length && (c->line[blanks] == ' ' || c->line[blanks] == '\t'))
        blanks++;
    c->length -= blanks;
    for (uint32_t i = 0; i < c->length; i++)
        c->line[i] = c->line[blanks + i];
}

static bool end_line(control *c)
{
    if (c->odd) {
        reply_text(c, "error line with byte ");
        reply_number(c, c->odd - 1);
        reply_text(c, ", which is not text\n");
    } else if (c->length > CONTROL_LINE) {
        reply_text(c, "error line longer than ");
        reply_number(c, CONTROL_LINE);
        reply_text(c, " bytes\n");
    } else {
        trim(c);
        if (c->length == 0)
            return false;
        obey(c);
    }
    return true;
}

void control_begin(control *c, const control_setup *setup)
{
    memset(c, 0, sizeof *c);
    c->setup = setup;
    c->frame_bytes = (uint32_t)tp_frame_bytes(setup->config, setup->shown);
}

bool control_reads(const control *c)
{
    return c->steps == 0;
}

bool control_ticks(control *c)
{
    if (c->steps > 0) {
        c->steps--;
        return true;
    }
    return !c->paused;
}

bool control_byte(control *c, uint8_t byte)
{
    if (byte == '\r' || byte == '\n') {
        const bool done = end_line(c);
        c->length = 0;
        c->odd = 0;
        return done;
    }
    if (c->odd == 0 && byte != '\t' && (byte < ' ' || byte > '~'))
        c->odd = byte + 1u;
    if (c->length < CONTROL_LINE)
        c->line[c->length] = (char)byte;
    c->length += c->length <= CONTROL_LINE;
    return false;
}

tp_input control_take(control *c)
{
    const tp_input taken = c->input;
    memset(&c->input, 0, sizeof c->input);
    return taken;
}
