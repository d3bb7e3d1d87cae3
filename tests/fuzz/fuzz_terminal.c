/* SPDX-License-Identifier: MIT */
/* Fuzzes the bytes of a terminal, as `show` reads keys: a first byte of 0 is a tick, 1 is a
 * pause between Esc and a sequence, other values are a number of bytes at once. After any
 * bytes the input stays small, and all keys are released. */
#include "fuzz.h"
#include "interact/input_merge.h"
#include "app/fullscreen/terminal_keys.h"

static bool is_within(int32_t number, int64_t most)
{
    return number >= -most && number <= most;
}

static void require_input(const tp_input *in, size_t bytes)
{
    REQUIRE(is_within(in->forward, INPUT_RUN) && is_within(in->strafe, INPUT_RUN)
            && is_within(in->up, INPUT_RUN));
    REQUIRE(is_within(in->turn, INPUT_TURN) && is_within(in->tilt, INPUT_TURN));
    REQUIRE(is_within(in->sphere_x, INPUT_STEER) && is_within(in->sphere_z, INPUT_STEER));
    REQUIRE(is_within(in->throttle, INPUT_SAIL) && is_within(in->rudder, INPUT_RUDDER));
    REQUIRE(is_within(in->light_turn, INPUT_LIGHT)
            && is_within(in->light_tilt, INPUT_LIGHT));
    REQUIRE(in->drops >= 0 && (size_t)in->drops <= bytes);
    REQUIRE(is_within(in->slowdown, (int64_t)bytes));
    for (int i = 0; i < TP_PUSHES; i++)
        REQUIRE(in->push[i].height == 0);
}

/* Without more bytes no key is held after 256 ticks, the most that a byte can count. */
static void let_go(terminal_keys *k, size_t bytes)
{
    for (int i = 0; i < 256; i++) {
        const tp_input in = terminal_keys_input(k);
        require_input(&in, bytes);
    }
    const tp_input none = { 0 }, last = terminal_keys_input(k);
    REQUIRE(memcmp(&none, &last, sizeof none) == 0);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    terminal_keys k = { .run = false };
    const size_t whole = size;
    while (size > 0) {
        const size_t count = fuzz_byte(&data, &size);
        if (count == 0) {
            const tp_input in = terminal_keys_input(&k);
            require_input(&in, whole);
        } else if (count == 1) {
            terminal_keys_flush(&k);
            REQUIRE(!k.within);
        } else {
            const size_t bytes = count < size ? count : size;
            char *copy = fuzz_copy(data, bytes);
            terminal_keys_add_bytes(&k, (const uint8_t *)copy, bytes);
            free(copy);
            data += bytes;
            size -= bytes;
        }
    }
    let_go(&k, whole);
    return 0;
}
