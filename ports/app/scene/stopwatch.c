/* SPDX-License-Identifier: MIT */
/* A timed stage reads the processor's counter, calls the original stage and reads the
 * counter again.  The duration of an empty measurement is subtracted.
 *
 * Threads share an array of counters; each thread takes the next entry at its first
 * measurement.  Threads of a pool therefore write to different cache lines.  If more
 * threads come and go than there are entries, the sums stay right, because counters are
 * incremented atomically.
 *
 * Cost: frames of 640x480 on one thread take 1.01 times as long (three-swells, 18.8 ms,
 * medians of 60, alternating in one run; x86-64, TP_SOAK=1 test_stopwatch). */
#define _POSIX_C_SOURCE 200809L
#include "stopwatch.h"
#include <stdatomic.h>
#include <time.h>
#include "world/module.h"
#if defined(__x86_64__)
#include <x86intrin.h>
#endif

#define UNSEEN(name)        /* modules without stages */

/* The program's stages, then those of each module, from FIRST_ to before END_. */
enum {
#define X(name) AT_##name,
#define MODULE(name) \
    FIRST_##name, BEFORE_##name = FIRST_##name - 1, TP_STAGES_OF_##name(X) END_##name, \
    LAST_##name = END_##name - 1,
    TP_STAGE_LIST(X)
    TP_MODULE_LIST(MODULE, UNSEEN, MODULE)
#undef MODULE
#undef X
    STAGES, PLACES = 16, MODULES = 40
};

const uint32_t stopwatch_stages = STAGES;

const char *const stopwatch_name[STAGES] = {
#define X(name) #name,
#define MODULE(name) TP_STAGES_OF_##name(X)
    TP_STAGE_LIST(X)
    TP_MODULE_LIST(MODULE, UNSEEN, MODULE)
#undef MODULE
#undef X
};

/* -- the clock ----------------------------------------------------------------------- */

static uint64_t now_ns(void)
{
    struct timespec now;

    clock_gettime(CLOCK_MONOTONIC, &now);
    return (uint64_t)now.tv_sec * 1000000000u + (uint64_t)now.tv_nsec;
}

/* Reads the fastest clock: on x86-64 the time stamp counter, which has its own unit. */
static inline uint64_t steps_now(void)
{
#if defined(__x86_64__)
    return __rdtsc();
#else
    return now_ns();
#endif
}

/* Returns the shortest difference of two consecutive readings. */
static uint64_t least_steps(void)
{
    uint64_t least = UINT64_MAX;

    for (int i = 0; i < 256; i++) {
        const uint64_t begin = steps_now(), passed = steps_now() - begin;
        least = passed < least ? passed : least;
    }
    return least;
}

/* -- counters ------------------------------------------------------------------------ */

/* Counters of one thread, aligned to a cache line. */
typedef struct {
    _Alignas(64) atomic_uint_least64_t steps[STAGES];
} counters;

static counters counted[PLACES];
static atomic_uint threads;
static _Thread_local counters *mine;

static tp_stage own[STAGES];            /* the original stages */
static uint64_t  empty;                 /* steps of an empty measurement */
static uint64_t  begin_steps, begin_ns; /* readings at the last zero */

static void count(uint32_t stage, uint64_t steps)
{
    if (!mine)
        mine = &counted[atomic_fetch_add(&threads, 1) % PLACES];
    atomic_fetch_add_explicit(&mine->steps[stage], steps > empty ? steps - empty : 0,
                              memory_order_relaxed);
}

void stopwatch_zero(void)
{
    for (int i = 0; i < PLACES; i++)
        for (int stage = 0; stage < STAGES; stage++)
            atomic_store_explicit(&counted[i].steps[stage], 0, memory_order_relaxed);
    begin_ns = now_ns();
    begin_steps = steps_now();
}

/* Converts steps to ns by the clock's time since the last zero. */
uint64_t stopwatch_ns(uint32_t stage)
{
    const uint64_t ns = now_ns() - begin_ns, steps = steps_now() - begin_steps;
    uint64_t sum = 0;

    for (int i = 0; i < PLACES && stage < STAGES; i++)
        sum += atomic_load_explicit(&counted[i].steps[stage], memory_order_relaxed);
    return steps ? (uint64_t)((double)sum * ((double)ns / (double)steps)) : 0;
}

/* -- timed stages -------------------------------------------------------------------- */

#define X(name) \
    static void timed_##name(const struct tp_shade *shade, struct tp_run *run) \
    { \
        const uint64_t begin = steps_now(); \
        own[AT_##name](shade, run); \
        count(AT_##name, steps_now() - begin); \
    }
#define MODULE(name) TP_STAGES_OF_##name(X)
TP_STAGE_LIST(X)
TP_MODULE_LIST(MODULE, UNSEEN, MODULE)
#undef MODULE
#undef X

static const tp_stage timed[STAGES] = {
#define X(name) timed_##name,
#define MODULE(name) TP_STAGES_OF_##name(X)
    TP_STAGE_LIST(X)
    TP_MODULE_LIST(MODULE, UNSEEN, MODULE)
#undef MODULE
#undef X
};

/* In the order of the whole list. */
static const struct { const struct tp_module *module; uint32_t first, end; } modules[] = {
#undef UNSEEN
#define UNSEEN(name) { &tp_##name##_module, 0, 0 },
#define MODULE(name) { &tp_##name##_module, FIRST_##name, END_##name },
    TP_MODULE_LIST(MODULE, UNSEEN, MODULE)
#undef MODULE
};
enum { LISTED = sizeof modules / sizeof *modules };

static tp_use   timed_use[MODULES + 1];
static tp_stage timed_stage[STAGES];    /* tables of timed_use */

/* Returns a timed use of a module with the stages `first` to before `end`. */
static tp_use make_timed_use(tp_use use, uint32_t first, uint32_t end)
{
    for (uint32_t i = first; use.stage && i < end; i++) {
        own[i] = use.stage[i - first];
        timed_stage[i] = own[i] ? timed[i] : NULL;
    }
    if (use.stage && end > first)
        use.stage = &timed_stage[first];
    return use;
}

/* Returns a timed use.  A program for another processor has copies of all modules, in the
 * order of the whole list.  In any other list the modules are found by address, and an
 * unknown module is not timed. */
static tp_use find_timed_use(const tp_use *list, size_t n, bool whole)
{
    for (size_t m = 0; m < LISTED; m++)
        if (whole ? m == n : modules[m].module == list[n].module)
            return make_timed_use(list[n], modules[m].first, modules[m].end);
    return list[n];
}

/* Returns a timed list; a list longer than MODULES is not timed. */
static const tp_use *timed_list(const tp_use *list)
{
    size_t n = 0, count = 0;

    while (list && list[count].module)
        count++;
    if (count > MODULES)
        return list;
    for (; n < count; n++)
        timed_use[n] = find_timed_use(list, n, count == LISTED);
    timed_use[n] = (tp_use){ 0 };
    return timed_use;
}

/* Replaces the stages; a stage that the program lacks stays NULL. */
void stopwatch_use(frame_renderer *c, bool on)
{
    const tp_program *its = c->machine->program;

    empty = least_steps();
    c->program.modules = on ? timed_list(its->modules) : its->modules;
#define X(name)                                                                          \
    own[AT_##name] = its->stage.name;                                                    \
    c->program.stage.name = on && its->stage.name ? timed_##name : its->stage.name;
    TP_STAGE_LIST(X)
#undef X
}
