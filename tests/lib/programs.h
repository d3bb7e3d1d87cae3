/* SPDX-License-Identifier: MIT */
/* Programs with random pointers removed. */
#ifndef TP_TESTS_LIB_PROGRAMS_H
#define TP_TESTS_LIB_PROGRAMS_H
#include <string.h>
#include "tests/lib/random.h"
#include "tidepool/modules.h"

/* Sets about one pointer in `in` to NULL; the stores, sky and plain pointers stay. */
static inline void thin_out(void *pointers, size_t bytes, uint32_t in, uint64_t *state)
{
    void **p = pointers;
    for (size_t i = 0; i < bytes / sizeof *p; i++)
        if (random_below(state, in) == 0)
            p[i] = NULL;
}

enum { THIN_MODULES = 48, THIN_STAGES = 64 };

/* Number of stages of each module, in the order of the module list. */
static const uint8_t thin_stages[] = {
#define ONE(name) + 1
#define SEEN(name) 0 TP_STAGES_OF_##name(ONE),
#define UNSEEN(name) 0,
    TP_MODULE_LIST(SEEN, UNSEEN, SEEN)
#undef UNSEEN
#undef SEEN
#undef ONE
};

/* The module list with random uses, drawings and stages left out.  The last four results
 * stay valid. */
static inline const tp_use *thin_modules(const tp_use *list, uint32_t in, uint64_t *state)
{
    static tp_use use[4][THIN_MODULES];
    static tp_stage stage[4][THIN_MODULES][THIN_STAGES];
    static uint32_t turn;
    tp_use *to = use[++turn % 4];
    const bool stages = random_below(state, 2);

    for (uint32_t i = 0; list[i].module; i++) {
        tp_stage *own = stage[turn % 4][i];
        if (random_below(state, in) == 0)
            continue;
        *to = list[i];
        if (random_below(state, in) == 0)
            to->drawing = NULL;
        if (stages && thin_stages[i] > 0) {
            memcpy(own, list[i].stage, thin_stages[i] * sizeof *own);
            thin_out(own, thin_stages[i] * sizeof *own, in, state);
            to->stage = own;
        }
        to++;
    }
    *to = (tp_use){ 0 };
    return use[turn % 4];
}

/* Removes one stage of one module from the program's list.  The arguments name the module
 * and the stage. */
#define WITHOUT_STAGE(program, use, table, module, stage)                                \
    without_stage(&(program), use, table, tp_##module##_stages, TP_COUNT_OF_##module,    \
                  TP_NTH_##stage)

/* Copies the program's list to `use`, and the stage table of the module with the stages
 * `of` to `table`, without stage `nth`. */
static inline void without_stage(tp_program *program, tp_use use[THIN_MODULES],
                                 tp_stage *table, const tp_stage *of, uint32_t count,
                                 uint32_t nth)
{
    uint32_t n = 0;

    for (const tp_use *u = program->modules; u->module; u++, n++) {
        use[n] = *u;
        if (u->stage != of)
            continue;
        memcpy(table, of, count * sizeof *table);
        table[nth] = NULL;
        use[n].stage = table;
    }
    use[n] = (tp_use){ 0 };
    program->modules = use;
}

static inline tp_program thin_program(uint64_t *state)
{
    const uint32_t in = 1 + random_below(state, 12);
    tp_program any = tp_program_all;

    if (random_below(state, 2))
        thin_out(&any.stage, sizeof any.stage, in, state);
    if (random_below(state, 2))
        thin_out(&any.water, sizeof any.water, in, state);
    if (random_below(state, 2))
        thin_out(&any.draw, sizeof any.draw, in, state);
    if (random_below(state, 2))
        any.modules = thin_modules(any.modules, in, state);
    if (random_below(state, 8) == 0)
        thin_out(&any.method, sizeof any.method, in, state);
    any.stage.sky = tp_stage_sky;
    any.stage.plain = tp_stage_plain;
    return any;
}
#endif
