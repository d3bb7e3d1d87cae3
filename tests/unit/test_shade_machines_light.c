/* SPDX-License-Identifier: MIT */
/* Light, glints, foam, solids, reflections, the dome and the tone curve have the same bits
 * in every build of the core that the present processor can run: over random spans of any
 * length. Loops over several samples at once are compared with loops over one. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include <stdlib.h>
#include "app/scene/machine.h"
#include "features/boat/boat.h"
#include "features/exposure/exposure.h"
#include "features/foam/foam.h"
#include "features/foam/foam_cover.h"
#include "features/reflection/reflection.h"
#include "tests/lib/shading.h"

enum { ROUNDS = 400, CELLS = 37, FACES = 64, MAP = 60 };

static uint64_t chance;
static uint32_t texels[2 * 64 * 32];
static tp_texture texture;
static tp_tones tones;

/* -- data of the modules, random in each round ----------------------------------------- */

static struct {
    tp_shade_foam   foam;
    tp_boat_shading boat;
    tp_mirror       mirror;
    tp_exposure     exposure;
    int             none;
} data;
static uint8_t cover[CELLS * CELLS], gloss[TP_GLOSS];
static tp_solid solid;
static tp_mesh_face face[FACES];
static tp_mesh mesh;
static uint32_t map[MAP * MAP];
static tp_mirrored_zi column[MAP];
static test_sky sky;
static tp_ripple_variance variance;

static uint32_t any_word(void)
{
    return (uint32_t)random_next(&chance);
}

/* A field with empty parts, at a random place; the window is inside of the span or not. */
static void make_foam(void)
{
    const uint32_t full = random_below(&chance, 3);
    const int floor = chance_int(&chance, 0, 1) ? TP_FOAM_BEACH : 0;

    for (int i = 0; i < CELLS * CELLS; i++)
        cover[i] = full && (full == 2 || i % 64 < 16) ? (uint8_t)any_word() : 0;
    data.foam = (tp_shade_foam){
        .cover = cover, .cells = CELLS, .col = random_below(&chance, CELLS),
        .row = random_below(&chance, CELLS), .low_s = chance_fx(&chance, -900, 900),
        .low_t = chance_fx(&chance, -900, 900), .side = CELLS * 32768,
        .per_metre = ((uint64_t)1 << 48) / 32768,
        .edge = chance_int(&chance, 0, 3) == 0 ? UINT32_MAX
              : (uint32_t)(((uint64_t)1 << 44) / (7ull * 128 * CELLS * 128 * CELLS)),
        .far_fresh = random_below(&chance, 3) * 9000, .far_old = random_below(&chance, 40),
        .per_square = random_below(&chance, 6000) + 100,
        .way_x = 9830, .way_z = -13107, .shore_x = 13107, .shore_z = 9830,
        .floor = (uint16_t)floor, .floor_cover = tp_foam_shore_cover,
        .stretch = CELLS * 32768 / 16 * 7,
        .colour = any_word() & 0xffffff, .repeats = 1 << 15, .wide_repeats = 1 << 13,
        .drift_s = any_word(), .drift_t = any_word(), .wide_drift_s = any_word(),
        .wide_drift_t = any_word(), .lod = chance_int(&chance, -2000, 3000),
        .texture = chance_int(&chance, 0, 3) ? &texture : NULL,
    };
    if (data.foam.texture)
        tp_shade_foam_make_ranks(&data.foam, &texture);
}

static void make_solid(const tp_shade *shade)
{
    for (int i = 0; i < TP_GLOSS; i++)
        gloss[i] = (uint8_t)any_word();
    for (int i = 0; i < FACES; i++)
        face[i].tangent = any_word();
    mesh.faces = face;
    solid = solid_any(gloss, &chance);
    solid.lod = chance_int(&chance, -2000, 3000);
    solid.bump = chance_int(&chance, 0, 1024);
    solid.diffuse_map = chance_int(&chance, 0, 1) ? &texture : NULL;
    solid.normal_map = chance_int(&chance, 0, 1) ? &texture : NULL;
    data.boat = (tp_boat_shading){ &mesh, &solid, shade->world };
}

/* The height of the eye, Q12 near planes, at which still water at the span's first sample
 * has the inverse depth zi. */
static int64_t eye_height(const tp_shade *s, const tp_run *run, uint32_t zi)
{
    const double u = 16 * run->x + 8 - s->u0, v = s->v0 - 16 * run->y - 8;
    const double rise = (u * s->world.right.y + v * s->world.up.y) / s->focal
                      - s->world.back.y;
    return (int64_t)(-rise / (1 << 30) * 65536 * (1 << 27) / zi);
}

/* A map near the span, of objects near the water's depth, at the height of the eye or at
 * any, beyond 32 bits too. */
static void make_mirror(const tp_shade *shade, const tp_run *run)
{
    const int halvings = chance_int(&chance, 0, 2);
    const int x0 = (run->x >> halvings) - chance_int(&chance, 0, 50);
    const int y0 = (run->y >> halvings) - chance_int(&chance, 0, 70);
    const uint32_t zi = tp_key_zi(run->key[0]);

    for (int i = 0; i < MAP * MAP; i++)
        map[i] = chance_int(&chance, 0, 3) ? any_word() : 0;
    for (int i = 0; i < MAP; i++) {
        const uint32_t near = zi / 8 * 7 + random_below(&chance, zi / 3 + 1);
        column[i].near = near < INT32_MAX ? near : INT32_MAX;
        column[i].far = column[i].near - random_below(&chance, zi / 4 + 1);
    }
    data.mirror = (tp_mirror){
        { map, x0, y0, x0 + MAP, y0 + MAP, halvings }, chance_int(&chance, 0, 1024),
        chance_int(&chance, 0, 9) ? eye_height(shade, run, zi)
                                  : chance_int(&chance, -4, 4) * ((int64_t)1 << 30),
        column,
    };
}

static tp_shade any_shade(void)
{
    tp_shade s = shade_any(&chance);
    const tp_fx shininess = chance_int(&chance, 10, 900) * TP_FX_ONE;
    const bool blinn = chance_int(&chance, 0, 1);

    s.per_focal = (uint32_t)(((uint64_t)1 << 32) / (uint32_t)s.focal);
    (blinn ? tp_shade_shine_blinn : tp_shade_shine)(shade_shine, shininess, TP_FX_ONE);
    s.lobe = tp_lobe_form_make(shininess, TP_FX_ONE);
    sky_dome(&sky, &s, &chance);
    s.env.least = chance_int(&chance, 0, 1) ? TP_DISC_END : 0;
    for (int i = 0; i < TP_TEXTURE_LEVELS; i++)
        variance.lost[i] = random_below(&chance, 1 << (i + 12));
    variance.gain_square = TP_FX_ONE;
    variance.levels = 8;
    s.ripple = chance_int(&chance, 0, 2) ? &variance : NULL;
    data.exposure.tones = &tones;
    tp_exposure_make_tone_curve(tones.tone, chance_fx(&chance, 0.2, 7));
    return s;
}

/* -- stages ----------------------------------------------------------------------------- */

typedef struct {
    const char *name;
    const struct tp_module *module;
    size_t      at;             /* in its table */
    const void *mine;
} stage_row;

#define X(name) { #name, &MODULE, TP_NTH_##name, MINE },
static const stage_row rows[] = {
#define MINE &data.none
#define MODULE tp_lighting_module
    TP_STAGES_OF_lighting(X)
#undef MODULE
#define MODULE tp_diffuse_module
    TP_STAGES_OF_diffuse(X)
#undef MODULE
#define MODULE tp_reflectance_module
    TP_STAGES_OF_reflectance(X)
#undef MODULE
#define MODULE tp_glint_module
    TP_STAGES_OF_glint(X)
#undef MODULE
#define MODULE tp_sky_dome_module
    TP_STAGES_OF_sky_dome(X)
#undef MODULE
#undef MINE
#define MINE &data.foam
#define MODULE tp_foam_module
    TP_STAGES_OF_foam(X)
#undef MODULE
#undef MINE
#define MINE &data.boat
#define MODULE tp_boat_module
    TP_STAGES_OF_boat(X)
#undef MODULE
#undef MINE
#define MINE &data.mirror
#define MODULE tp_mirror_module
    TP_STAGES_OF_mirror(X)
#undef MODULE
#undef MINE
#define MINE &data.exposure
#define MODULE tp_exposure_module
    TP_STAGES_OF_exposure(X)
};
enum { ROWS = sizeof rows / sizeof rows[0] };

static stage *stage_of(const machine *m, const stage_row *r)
{
    const tp_use *u = m->program->modules;

    while (u->module && u->module->id != r->module->id)
        u++;
    assert_non_null(u->module);
    return u->stage[r->at];
}

/* A part of a span of water or of a mesh: slopes up to 8, views and lights as in a
 * picture. */
static tp_run any_run(test_run *r, const tp_shade *shade)
{
    run_any(r, chance_int(&chance, 0, 3) ? chance_int(&chance, 1, 4096) : 32000, &chance);
    tp_run_fill_vectors_to_eye(shade, &shade->world, &r->run);
    const uint32_t key = (any_word() | 0x100) >> chance_int(&chance, 0, 8);
    for (int i = 0; i < TP_RUN; i++) {
        r->key[i] = key + random_below(&chance, 0x1000);
        r->s[i] = (uint32_t)data.foam.low_s + random_below(&chance, 45 * 32768) - 130000;
        r->t[i] = chance_int(&chance, 0, 1)
                ? (uint32_t)data.foam.low_t + random_below(&chance, 45 * 32768) - 130000
                : random_below(&chance, FACES);
        r->run.sx[i] = (int16_t)tp_clamp(chance_int(&chance, -9000, 9000), -32000, 32000);
        r->run.sz[i] = (int16_t)chance_int(&chance, -9000, 9000);
        r->run.nv[i] = (int16_t)chance_int(&chance, 0, 16384);
        r->run.up[i] = (int16_t)chance_int(&chance, -16384, 16384);
        r->run.glint[i] = (uint16_t)chance_int(&chance, 0, 1024);
        r->run.mirror[i] = chance_int(&chance, 0, 1) ? any_word() : any_word() & 0xffffff;
    }
    int32_t from = chance_int(&chance, 0, TP_RUN - 1);
    return run_part(&r->run, from, chance_int(&chance, from + 1, TP_RUN));
}

/* Compares all data that stages write: the span from its colours on. */
static void compare(const stage_row *r, const machine *a, const machine *b)
{
    const tp_shade shade = any_shade();
    const size_t skipped = offsetof(tp_run, colour);
    test_run samples;

    make_foam();
    make_solid(&shade);
    tp_run begin = any_run(&samples, &shade);
    if (r->mine == &data.boat)
        for (int i = 0; i < TP_RUN; i++)
            samples.t[i] %= FACES;
    make_mirror(&shade, &begin);
    tp_run by_a = begin, by_b = begin;
    by_a.mine = by_b.mine = r->mine;
    stage_of(a, r)(&shade, &by_a);
    stage_of(b, r)(&shade, &by_b);
    if (memcmp((const char *)&by_a + skipped, (const char *)&by_b + skipped,
               sizeof by_a - skipped))
        fail_msg("%s by %s is not as by %s", r->name, a->name, b->name);
}

static void every_machine_lights_alike(void **state)
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
        cmocka_unit_test(every_machine_lights_alike),
    };

    chance = random_seed();
    static uint32_t pixels[64 * 32];
    for (int i = 0; i < 64 * 32; i++)
        pixels[i] = any_word();
    if (tp_texture_init(&texture, pixels, 64, 32, texels, sizeof texels, NULL))
        abort();
    return cmocka_run_group_tests(tests, NULL, NULL);
}
