/* SPDX-License-Identifier: MIT */
/* Checks the reference's meshes against closed forms: textures, normal maps and specular
 * lobes in air and under water, and lids. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/lib/reference_scenes.h"

static uint64_t seed;

/* Squares of 2 m with textures of the same size: upright and facing the mesh's back, or
 * lying and facing up. */
typedef struct {
    tp_mesh        mesh;
    tp_mesh_vertex vertex[8];
    tp_mesh_face   face[4];
    tp_material    material[2];
} board_mesh;

static void lay(board_mesh *b, int which, bool lying, tp_fx high)
{
    for (int i = 0; i < 4; i++) {
        const int32_t x = i == 1 || i == 2 ? 1 : -1, y = i >= 2 ? 1 : -1;
        b->vertex[4 * which + i] = (tp_mesh_vertex){
            .position = { x * TP_FX_ONE, lying ? high : y * TP_FX_ONE,
                          lying ? -y * TP_FX_ONE : 0 },
            .normal = lying ? 511u << 10 : 511u << 20,
            .s = (x + 1) * TP_FX_ONE / 2, .t = (1 - y) * TP_FX_ONE / 2,
        };
    }
    for (uint32_t i = 0; i < 2; i++) {
        const uint32_t at = 4 * (uint32_t)which;
        b->face[2 * which + (int)i] = (tp_mesh_face){
            .vertex = { at, at + 1 + i, at + 2 + i }, .tangent = 511,
            .material = (uint32_t)which,
        };
    }
    b->mesh = (tp_mesh){ .vertices = b->vertex, .faces = b->face,
                         .materials = b->material,
                         .n_vertices = 4 * (uint32_t)which + 4,
                         .n_faces = 2 * (uint32_t)which + 2,
                         .n_materials = (uint32_t)which + 1 };
}

/* Opens `v` with the board at a pose. */
static void open_posed(view_of_ref *v, const board_mesh *b, tp_pose pose)
{
    strcpy(v->scene.boat.mesh, "board.obj");
    v->assets.boat = &b->mesh;
    v->world = scene_world(&v->scene, &v->assets);
    v->world->boat = v->world->last_boat = pose;
    ref_scene_open(&v->ref, &v->scene, &v->assets, v->world, 64, 48, false);
}

/* Phong's lobe for a look, or Blinn's lobe with four times the exponent. */
static double gloss_of(int32_t model, sight_angles light, sight_angles normal,
                       sight_angles to, double power)
{
    const sight_angles eye = { to.azimuth + PI, -to.elevation };
    const double nl = sight_cos(normal, light), ne = sight_cos(normal, eye);
    const double le = sight_cos(light, eye);

    if (nl <= 0)
        return 0;
    if (model == TP_LIGHT_BLINN)
        return pow(fmax(0, (nl + ne) / (2 * cos(acos(le) / 2))), 4 * power);
    return pow(fmax(0, 2 * nl * ne - le), power);
}

/* Random material with the normal map's texel (nx, ny, 100). */
static void paint(board_mesh *b, noise_picture *p, plain_picture *bump, int32_t nx,
                  int32_t ny)
{
    b->material[0] = (tp_material){
        .diffuse = (uint32_t)chance_int(&seed, 0, 0xffffff),
        .specular = (uint32_t)chance_int(&seed, 0, 0xffffff),
        .shininess = chance_int(&seed, 1, 60) * TP_FX_ONE, .opacity = TP_FX_ONE,
        .bump = chance_fx(&seed, 0, 2), .diffuse_map = noise_of(p, &seed),
        .normal_map = plain_of(bump, (uint32_t)(128 + nx) << 16
                                     | (uint32_t)(128 + ny) << 8 | 228),
        .texels = 16 * TP_FX_ONE,
    };
}

/* Measures a random point (x, y) of an upright, turned board 5 m ahead. */
static void measure_board(measure *off, int *bright, view_of_ref *v, int32_t heading)
{
    static noise_picture p;
    plain_picture bump;
    board_mesh b;
    const int32_t nx = chance_int(&seed, -60, 60), ny = chance_int(&seed, -60, 60);
    const double x = chance_double(&seed, -1, 1), y = chance_double(&seed, -1, 1);
    const double turn = heading * (2 * PI / 4294967296.0);
    const double east = x * cos(turn), north = 5 - x * sin(turn);
    const sight_angles to = { atan2(east, north), atan2(y, hypot(east, north)) };

    lay(&b, 0, false, 0);
    paint(&b, &p, &bump, nx, ny);
    open_posed(v, &b, (tp_pose){ .place = { 0, 4 * TP_FX_ONE, -5 * TP_FX_ONE },
                                 .heading = (tp_turn)heading });
    const tp_material *m = &b.material[0];
    const double bold = m->bump / 65536.0;
    const sight_angles normal = { turn + atan2(nx * bold, -100),
                                  atan2(ny * bold, hypot(nx * bold, 100)) };
    const double lit = lit_of(&v->scene, sight_cos(normal, sight_light(v)));
    const double gloss = gloss_of(v->scene.light.model, sight_light(v), normal, to,
                                  m->shininess / TP_FX_ONE);
    const ref_seen seen = sight_look(v, to);
    *bright += gloss > 0.3;
    assert_int_equal(seen.kind, REF_BOAT);
    for (int k = 0; k < 3; k++) {
        const double own = texel_at(&p, (x + 1) / 2, (1 - y) / 2, k) / 255
                         * channel((int32_t)m->diffuse, k) * tint_of(&v->scene, k);
        const double shine = channel((int32_t)m->specular, k) / 255
                           * channel(v->scene.light.colour, k) * gloss;
        if (!isnan(own))
            measure_add(off, seen.colour.c[k] - fmin(255, own * lit + shine), heading, k,
                        0);
    }
    view_close(v);
}

static void a_mesh_has_its_pictures_and_its_gloss(void **state)
{
    measure off = { .what = "mesh", .unit = "of 255" };
    int bright = 0;

    (void)state;
    for (int n = 0; n < 3000; n++) {
        view_of_ref v = { .scene = scene_clear_any(&seed) };
        v.scene.light.model = n % 2 ? TP_LIGHT_BLINN : TP_LIGHT_PHONG;
        v.scene.camera.pitch = 0;
        measure_board(&off, &bright, &v, chance_int(&seed, -600000000, 600000000));
    }
    measure_print(&off);
    printf("    %d of 3000 bright\n", bright);
    assert_true(bright > 50);
    assert_true(off.worst < 1e-9);
}

/* Under water the refracted beam is narrower and steeper; the width of the lobe does not
 * change. */
static void a_sunken_mesh_shines_in_the_bent_light(void **state)
{
    measure off = { .what = "sunken", .unit = "of 255" };

    (void)state;
    for (int n = 0; n < 1500; n++) {
        view_of_ref v = { .scene = scene_clear_any(&seed) };
        board_mesh b;
        lay(&b, 0, true, 0);
        b.material[0] = (tp_material){ .diffuse = 0x402010, .specular = 0xffffff,
                                       .shininess = 6 * TP_FX_ONE,
                                       .opacity = TP_FX_ONE };
        v.scene.light.model = n % 2 ? TP_LIGHT_BLINN : TP_LIGHT_PHONG;
        v.scene.light.heading = chance_fx(&seed, -40, 40);
        v.scene.camera.y = 2 * TP_FX_ONE;
        v.scene.camera.pitch = -40 * TP_FX_ONE;
        v.scene.water.reflection = 0;
        open_posed(&v, &b, (tp_pose){ .place = { 0, -TP_FX_ONE, -3 * TP_FX_ONE } });
        const double met = chance_double(&seed, 0.75, 0.95);    /* from straight down */
        const double bent = asin(sin(met) / WATER), north = 2 * tan(met) + tan(bent);
        const sight_angles light = sight_light(&v);
        const double steep = acos(cos(light.elevation) / WATER);
        const double beam = sin(light.elevation) / sin(steep);
        const ref_seen seen = sight_look(&v, (sight_angles){ 0, met - PI / 2 });
        const sight_angles down = { light.azimuth, steep };
        const double gloss =
            gloss_of(v.scene.light.model, down, (sight_angles){ 0, PI / 2 },
                     (sight_angles){ 0, bent - PI / 2 }, 6);
        assert_true(north > 2 && north < 4);
        for (int k = 0; k < 3; k++) {
            const double lit = lit_of(&v.scene, sin(light.elevation));
            const double own = channel(0x402010, k) * lit * tint_of(&v.scene, k)
                             + channel(v.scene.light.colour, k) * beam * gloss;
            const double body = between(channel(v.scene.water.deep_colour, k),
                                        channel(v.scene.water.colour, k) * lit, 0.25);
            measure_add(&off, seen.colour.c[k]
                        - beer_of(&v.scene, fmin(255, own), body, 1 / cos(bent), k), n, k,
                        0);
        }
        view_close(&v);
    }
    measure_print(&off);
    assert_true(off.worst < 1e-9);
}

/* A floor below the water level and a lid above the floor: no water is seen inside, except
 * where the water stands higher than the lid. The lid itself is never seen. */
static void a_lid_keeps_water_out(void **state)
{
    (void)state;
    for (int n = 0; n < 500; n++) {
        view_of_ref v = { .scene = scene_clear_any(&seed) };
        const double x = chance_double(&seed, -1.5, 1.5);
        const double z = chance_double(&seed, -1.5, 1.5);
        const double high = chance_double(&seed, -0.6, 0.6);   /* height of the lid, m */
        board_mesh b;
        lay(&b, 0, true, -TP_FX_ONE);
        lay(&b, 1, true, 0);
        b.material[0] = (tp_material){ .diffuse = 0x804020, .shininess = TP_FX_ONE,
                                       .opacity = TP_FX_ONE };
        b.material[1] = (tp_material){ .diffuse = 0xffffff, .shininess = TP_FX_ONE };
        v.scene.camera.y = 90 * TP_FX_ONE;
        v.scene.camera.pitch = -89 * TP_FX_ONE;
        v.scene.water.clarity = 0;
        open_posed(&v, &b, (tp_pose){ .place = { 0, (tp_fx)(high * 65536),
                                                 -2 * TP_FX_ONE } });
        const sight_angles to = { atan2(x, 2 - z), -atan2(90 - high, hypot(x, 2 - z)) };
        const bool covered = fabs(x) < 0.9 && fabs(z) < 0.9;
        const ref_seen seen = sight_look(&v, to);
        const double lit = lit_of(&v.scene, sin(sight_light(&v).elevation));
        if (covered || fabs(x) > 1.1 || fabs(z) > 1.1)
            assert_int_equal(seen.kind, covered && high > 0 ? REF_BOAT : REF_WATER);
        for (int k = 0; k < 3 && seen.kind == REF_BOAT; k++)
            assert_true(fabs(seen.colour.c[k] - channel(0x804020, k) * lit
                                                    * tint_of(&v.scene, k)) < 1e-9);
        view_close(&v);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_mesh_has_its_pictures_and_its_gloss),
        cmocka_unit_test(a_sunken_mesh_shines_in_the_bent_light),
        cmocka_unit_test(a_lid_keeps_water_out),
    };
    seed = random_seed();
    return cmocka_run_group_tests(tests, NULL, NULL);
}
