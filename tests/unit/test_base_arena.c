/* SPDX-License-Identifier: MIT */
/* The bump allocator: counting and allocating agree, and no size makes it overflow. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <string.h>
#include <cmocka.h>
#include "base/base.h"

static void takes_are_aligned_and_do_not_overlap(void **state)
{
    (void)state;
    _Alignas(8) uint8_t block[64];
    tp_arena arena = tp_arena_init(block, sizeof block);
    assert_ptr_equal(tp_arena_alloc(&arena, 3, 1), block);
    assert_ptr_equal(tp_arena_alloc(&arena, 1, 8), block + 8);
    assert_ptr_equal(tp_arena_alloc(&arena, 3, 4), block + 16);
    assert_ptr_equal(tp_arena_alloc(&arena, 1, 1), block + 32);
    assert_int_equal(arena.used, 40);
    assert_false(arena.failed);
}

static void counting_tells_exactly_what_carving_needs(void **state)
{
    (void)state;
    static const struct { size_t count, size; } parts[] = {
        { 1, 1 }, { 7, 3 }, { 0, 5 }, { 5, 0 }, { 2, 8 }, { 1, 9 },
    };
    enum { PARTS = sizeof parts / sizeof parts[0] };
    tp_arena counter = tp_arena_init(NULL, 0);
    for (int i = 0; i < PARTS; i++)
        assert_null(tp_arena_alloc(&counter, parts[i].count, parts[i].size));
    assert_false(counter.failed);
    assert_int_equal(counter.used, 8 + 24 + 0 + 0 + 16 + 16);

    _Alignas(8) uint8_t block[128];
    memset(block, 0xa5, sizeof block);
    tp_arena arena = tp_arena_init(block, counter.used);
    for (int i = 0; i < PARTS; i++) {
        void *const part = tp_arena_alloc(&arena, parts[i].count, parts[i].size);
        assert_non_null(part);
        memset(part, 0, parts[i].count * parts[i].size);
    }
    assert_false(arena.failed);
    assert_int_equal(arena.used, counter.used);
    assert_int_equal(block[arena.used], 0xa5);
}

static void a_take_that_does_not_fit_fails_and_tells_the_need(void **state)
{
    (void)state;
    _Alignas(8) uint8_t block[16];
    tp_arena arena = tp_arena_init(block, sizeof block);
    assert_non_null(tp_arena_alloc(&arena, 1, 8));
    assert_null(tp_arena_alloc(&arena, 2, 8));
    assert_true(arena.failed);
    assert_null(tp_arena_alloc(&arena, 1, 1));
    assert_int_equal(arena.used, 32);
}

static void sizes_that_overflow_fail(void **state)
{
    (void)state;
    static const struct { size_t count, size; } parts[] = {
        { SIZE_MAX, 1 }, { 1, SIZE_MAX }, { SIZE_MAX, SIZE_MAX }, { SIZE_MAX / 2 + 1, 2 },
        { SIZE_MAX - 6, 1 }, { SIZE_MAX / 8 + 1, 8 }, { SIZE_MAX / 4, 5 },
    };
    _Alignas(8) uint8_t block[64];
    for (size_t i = 0; i < sizeof parts / sizeof parts[0]; i++)
        for (int counting = 0; counting < 2; counting++) {
            tp_arena arena = tp_arena_init(counting ? NULL : block, sizeof block);
            tp_arena_alloc(&arena, 1, 8);
            assert_null(tp_arena_alloc(&arena, parts[i].count, parts[i].size));
            assert_true(arena.failed);
            assert_null(tp_arena_alloc(&arena, 1, 8));   /* no later request fits either */
            assert_int_equal(arena.used, SIZE_MAX);
        }
}

static void sums_that_overflow_fail(void **state)
{
    (void)state;
    tp_arena arena = tp_arena_init(NULL, 0);
    tp_arena_alloc(&arena, SIZE_MAX / 2, 1);
    assert_false(arena.failed);
    tp_arena_alloc(&arena, SIZE_MAX / 2, 1);
    assert_true(arena.failed);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(takes_are_aligned_and_do_not_overlap),
        cmocka_unit_test(counting_tells_exactly_what_carving_needs),
        cmocka_unit_test(a_take_that_does_not_fit_fails_and_tells_the_need),
        cmocka_unit_test(sizes_that_overflow_fail),
        cmocka_unit_test(sums_that_overflow_fail),
    };
    return cmocka_run_group_tests_name("base arena", tests, NULL, NULL);
}
