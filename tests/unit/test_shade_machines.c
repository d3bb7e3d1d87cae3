/* SPDX-License-Identifier: MIT */
/* The water's textures, ripples and views have the same bits in every build of the core
 * that the present processor can run: over random spans of any length, slopes up to 8,
 * textures of any side, and with mipmap levels that change within a span. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "app/scene/machine.h"
#include "tests/lib/layers.h"
#include "tests/lib/shading.h"

enum { ROUNDS = 4000 };

static uint64_t chance;
static tp_texture texture[SIDES];

/* A stage of a module, or of the program, and the module data that the stage reads. */
typedef struct {
    const char *name;
    const struct tp_module *module; /* NULL: the program's */
    size_t      at;             /* in its table, or the pointer's place in tp_stages */
    const void *mine;
} stage_row;

static const stage_row rows[] = {
#define X(name) { #name, NULL, offsetof(tp_stages, name), NULL },
    X(plain) X(view)
#undef X
#define X(name) { #name, &tp_base_layer_module, TP_NTH_##name, &own.base },
        TP_STAGES_OF_base_layer(X)
#undef X
#define X(name) { #name, &tp_layers_module, TP_NTH_##name, &own.layers },
            TP_STAGES_OF_layers(X)
#undef X
#define X(name) { #name, &tp_ripple_module, TP_NTH_##name, &own.ripple },
                TP_STAGES_OF_ripple(X)
#undef X
};
enum { ROWS = sizeof rows / sizeof rows[0] };

static stage *stage_of(const machine *m, const stage_row *r)
{
    const tp_use *u = m->program->modules;
    stage *s;

    while (r->module && u->module != r->module)
        u++;
    if (r->module)
        return u->stage[r->at];
    memcpy(&s, (const char *)&m->program->stage + r->at, sizeof s);
    return s;
}

static tp_layer any_layer(void)
{
    tp_layer layer = layer_any(&chance, &texture[chance_int(&chance, 0, SIDES - 1)]);
    layer.lod = chance_int(&chance, -2000, 3000);
    return layer;
}

static tp_grade any_grade(void)
{
    const tp_fx saturation = chance_int(&chance, 0, TP_FX(4));

    return tp_grade_make(saturation, chance_int(&chance, 0, TP_FX(0.95)),
                         (uint32_t)random_next(&chance) & 0xffffff);
}

static tp_shade any_shade(void)
{
    tp_shade s = shade_any(&chance);

    own.base.layer = any_layer();
    own.ripple = (tp_ripple){ any_layer(), chance_int(&chance, 0, 1024) };
    own.layers.bend = any_layer();
    own.layers.strength = chance_int(&chance, 0, TP_FX(20));
    own.base.grade = any_grade();
    for (int k = 0; k < TP_LAYERS_ADDED; k++) {
        own.layers.added[k] = any_layer();
        own.layers.grade[k] = any_grade();
        own.layers.colour[k] = (uint32_t)random_next(&chance) & 0xffffff;
        own.layers.graded[k] = chance_int(&chance, 0, 1);
    }
    return s;
}

static tp_run any_run(test_run *r)
{
    run_any(r, chance_int(&chance, 0, 3) ? chance_int(&chance, 1, 4096) : 32767, &chance);
    if (chance_int(&chance, 0, 3) == 0)
        r->n[chance_int(&chance, 0, TP_RUN - 1)] = 0x80008000u;
    for (int i = 0; i < TP_RUN; i++) {
        if (i % 16 && chance_int(&chance, 0, 1))
            r->key[i] = r->key[i - 1];
        r->run.sx[i] = (int16_t)chance_int(&chance, -32000, 32000);
        r->run.sz[i] = (int16_t)chance_int(&chance, -32000, 32000);
    }
    int32_t from = chance_int(&chance, 0, TP_RUN - 1);
    return run_part(&r->run, from, chance_int(&chance, from + 1, TP_RUN));
}

/* Compares all data that stages write: the span from its colours on. */
static void compare(const stage_row *r, const machine *a, const machine *b)
{
    const tp_shade shade = any_shade();
    test_run samples;
    const tp_run begin = any_run(&samples);
    tp_run by_a = begin, by_b = begin;
    const size_t skipped = offsetof(tp_run, colour);

    run_by(stage_of(a, r), &shade, r->mine, &by_a);
    run_by(stage_of(b, r), &shade, r->mine, &by_b);
    if (memcmp((const char *)&by_a + skipped, (const char *)&by_b + skipped,
               sizeof by_a - skipped))
        fail_msg("%s by %s is not as by %s", r->name, a->name, b->name);
}

static void every_machine_lays_and_bends_water_alike(void **state)
{
    size_t count;
    const machine *machines = machine_list(&count);
    (void)state;

    for (size_t m = 0; m + 1 < count; m++)
        for (int k = 0; k < ROWS; k++)
            for (int n = 0; n < ROUNDS; n++)
                compare(&rows[k], &machines[m], &machines[count - 1]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_machine_lays_and_bends_water_alike),
    };

    chance = random_seed();
    for (int i = 0; i < SIDES; i++)
        texture[i] = layer_texture(&chance, sides[i][0], sides[i][1]);
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    for (int i = 0; i < SIDES; i++)
        layer_free(&texture[i]);
    return failed;
}
