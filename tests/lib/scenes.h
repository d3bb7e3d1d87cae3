/* SPDX-License-Identifier: MIT */
/* Scenes for tests: plain scenes, and scenes with any value that the parameter table
 * allows; with a boat of twelve triangles, two materials and textures with odd sides. */
#ifndef TP_TESTS_LIB_SCENES_H
#define TP_TESTS_LIB_SCENES_H
#include <string.h>
#include "mesh/mesh.h"
#include "fixed/arithmetic.h"
#include "world/pools.h"
#include "tests/lib/random.h"
#include "tidepool/modules.h"

/* Three swells under a camera at 4 m, a small grid. */
static inline tp_scene scene_plain(void)
{
    tp_scene s;

    tp_scene_level(&s);
    for (int i = 0; i < 3; i++) {
        s.wave[i].amplitude = TP_FX(0.4);
        s.wave[i].length = (12 + 5 * i) * TP_FX_ONE;
        s.wave[i].heading = (40 * i - 30) * TP_FX_ONE;
    }
    s.grid.vertices = 1000;
    strcpy(s.boat.mesh, "boat.obj");    /* the caller gives the mesh, if any */
    return s;
}

static inline int32_t *scene_number(tp_scene *scene, const tp_param *row)
{
    return (int32_t *)(void *)((char *)scene + row->offset);
}

static inline bool scene_is_number(const tp_param *row)
{
    return row->kind != TP_PARAM_MESH && row->kind != TP_PARAM_TEXTURE
        && row->kind != TP_PARAM_GREY
        && row->kind != TP_PARAM_TEXT;
}

/* Sets every row to its minimum, its maximum, its default or a value between. */
static inline tp_scene scene_any(uint64_t *state)
{
    uint32_t count = 0;
    const tp_param *rows = tp_params(&count);
    const uint32_t bold = random_below(state, 4);       /* rows at an end of their range */
    tp_scene s;

    tp_scene_level(&s);
    for (uint32_t i = 0; i < count; i++) {
        const tp_param *row = &rows[i];
        if (!scene_is_number(row))
            continue;
        const uint32_t kind = random_below(state, 2 + 2 * bold);
        *scene_number(&s, row) = kind == 0 ? row->normal
                               : kind == 1 ? chance_int(state, row->low, row->high)
                               : kind % 2 ? row->low : row->high;
    }
    return s;
}

/* The scene's world in memory of its own; the caller frees it.  NULL if the scene is
 * invalid. */
static inline tp_world *scene_world(const tp_scene *scene, const tp_assets *assets)
{
    const size_t bytes = tp_world_bytes(&tp_program_all, scene, assets);
    tp_world *world = bytes ? malloc(bytes) : NULL;
    if (world
        && tp_world_init(&tp_program_all, world, bytes, scene, assets, NULL) != TP_OK)
        abort();
    return world;
}

/* -- a boat -------------------------------------------------------------------------- */

typedef struct {
    tp_mesh        mesh;
    tp_mesh_vertex vertex[8];
    tp_mesh_face   face[12];
    tp_material    material[2];
    tp_texture     texture[3];
    uint32_t       texels[3][2048];
} test_boat;

static inline void boat_texture(test_boat *b, int i, uint32_t w, uint32_t h,
                                uint64_t *state)
{
    uint32_t pixels[512];

    for (uint32_t k = 0; k < w * h; k++)
        pixels[k] = (uint32_t)random_next(state) | 0xff000000u;
    if (tp_texture_init(&b->texture[i], pixels, w, h, b->texels[i],
                        tp_texture_bytes(w, h), NULL)
        != TP_OK)
        abort();
}

static inline void boat_box(test_boat *b, tp_fx x, tp_fx y, tp_fx z)
{
    /* Two triangles a side, counter-clockwise from outside.  In a corner's index bit 0 is
     * +x, bit 1 +y, bit 2 +z. */
    static const uint8_t side[6][4] = { { 0, 4, 6, 2 }, { 1, 3, 7, 5 }, { 0, 1, 5, 4 },
                                        { 2, 6, 7, 3 }, { 0, 2, 3, 1 }, { 4, 5, 7, 6 } };

    for (int i = 0; i < 8; i++) {
        const int32_t sx = i & 1 ? 1 : -1, sy = i & 2 ? 1 : -1, sz = i & 4 ? 1 : -1;
        b->vertex[i] = (tp_mesh_vertex){
            .position = { sx * x, sy * y, sz * z },
            .normal = tp_dir_pack(tp_normalise(sx, sy, sz)),
            .s = sx * TP_FX_ONE, .t = sy * TP_FX(0.7),
        };
    }
    for (uint32_t i = 0; i < 12; i++) {
        const uint8_t *c = side[i / 2];
        b->face[i] = (tp_mesh_face){
            .vertex = { c[0], c[i % 2 ? 2 : 1], c[i % 2 ? 3 : 2] },
            .tangent = tp_dir_pack((tp_dir3){ TP_Q30_ONE, 0, 0 })
                     | (i % 3 ? TP_TANGENT_MIRRORED : 0),
            .material = i % 2,
        };
    }
}

/* A box of 2 x 1 x 4 m with textures, normal map and gloss. */
static inline void boat_make(test_boat *b, uint64_t *state)
{
    boat_box(b, TP_FX_ONE, TP_FX(0.5), 2 * TP_FX_ONE);
    boat_texture(b, 0, 16, 8, state);
    boat_texture(b, 1, 1, 32, state);
    boat_texture(b, 2, 1, 1, state);
    b->material[0] = (tp_material){ 0xffc080, 0x808080, 40 * TP_FX_ONE, TP_FX_ONE,
                                    TP_FX_ONE, &b->texture[0], &b->texture[1],
                                    8 * TP_FX_ONE };
    b->material[1] = (tp_material){ 0x4060ff, 0xffffff, 1000 * TP_FX_ONE, TP_FX(0.5),
                                    16 * TP_FX_ONE, &b->texture[2], NULL, TP_FX_ONE };
    b->mesh = (tp_mesh){ .vertices = b->vertex,
                         .faces = b->face,
                         .materials = b->material,
                         .n_vertices = 8,
                         .n_faces = 12,
                         .n_materials = 2 };
}

/* The plain scene with a boat of 4 x 2 m ahead, from any height; by `pitch` the picture has
 * water or none. */
static inline tp_scene scene_of_boat_ahead(tp_fx pitch, uint64_t *state)
{
    tp_scene s = scene_plain();

    s.camera.y = chance_fx(state, 1, 8);
    s.camera.heading = chance_fx(state, -20, 20);
    s.camera.pitch = pitch;
    s.boat.length = 4 * TP_FX_ONE;
    s.boat.beam = 2 * TP_FX_ONE;
    s.boat.x = s.camera.x + chance_fx(state, -4, 4);
    s.boat.z = s.camera.z - 9 * TP_FX_ONE;
    return s;
}

/* The boat, and its textures as a layer and as ripples of the water. */
static inline tp_assets boat_assets(const test_boat *b)
{
    return (tp_assets){ .boat = &b->mesh, .layer[0] = &b->texture[0],
                        .ripple = &b->texture[1] };
}

/* -- every asset --------------------------------------------------------------------- */

/* Every asset that a scene can name, small and awkward: textures with odd sides, six sky
 * faces, a height map, masks, a boat with a lid as second material; and scenes with all of
 * these assets in front of the camera. */

enum { KIT_PICTURES = 6, KIT_TEXELS = 2048 };

typedef struct {
    test_boat  boat;
    tp_texture picture[KIT_PICTURES];
    uint32_t   texel[KIT_PICTURES][KIT_TEXELS];
    uint16_t   high[24 * 16], solid[24 * 16];
    tp_grey    floor, mask;
} test_kit;

static inline void kit_picture(test_kit *kit, int i, uint32_t w, uint32_t h,
                               uint64_t *state)
{
    uint32_t pixels[1024];

    for (uint32_t k = 0; k < w * h; k++)        /* two in three: full alpha */
        pixels[k] = (uint32_t)random_next(state) | (i % 3 ? 0xff000000u : 0);
    if (tp_texture_bytes(w, h) > sizeof kit->texel[i]
        || tp_texture_init(&kit->picture[i], pixels, w, h, kit->texel[i],
                           tp_texture_bytes(w, h), NULL)
               != TP_OK)
        abort();
}

static inline void kit_make(test_kit *kit, uint64_t *state)
{
    static const uint32_t side[KIT_PICTURES][2] = { { 32, 32 }, { 1, 1 }, { 16, 4 },
                                                    { 1, 64 }, { 13, 9 }, { 8, 8 } };

    boat_make(&kit->boat, state);
    for (int i = 0; i < KIT_PICTURES; i++)
        kit_picture(kit, i, side[i][0], side[i][1], state);
    for (uint32_t i = 0; i < 24 * 16; i++) {    /* rises to the north-east, with a hole */
        kit->high[i] = (uint16_t)(i % 24 * 2000 + (16 - i / 24) * 1000);
        kit->solid[i] = i % 24 / 2 == i / 24 / 2 && i % 5 ? 0 : 65535;
    }
    kit->high[24 * 8 + 12] = 0;
    kit->floor = (tp_grey){ 24, 16, kit->high };
    kit->mask = (tp_grey){ 24, 16, kit->solid };
}

static inline const tp_texture *kit_any(const test_kit *kit, uint64_t *state)
{
    const uint32_t i = random_below(state, KIT_PICTURES + 2);
    return i < KIT_PICTURES ? &kit->picture[i] : NULL;
}

/* Picks random assets; sets the name in the scene for assets that count only when named. */
static inline tp_assets kit_assets(test_kit *kit, tp_scene *s, uint64_t *state)
{
    tp_assets a = { .boat = random_below(state, 4) ? &kit->boat.mesh : NULL };

    for (int i = 0; i < TP_LAYERS; i++)
        a.layer[i] = kit_any(kit, state);
    for (int i = 0; i < TP_FACES; i++)
        a.sky[i] = &kit->picture[random_below(state, KIT_PICTURES)];
    if (random_below(state, 8) == 0)
        a.sky[random_below(state, TP_FACES)] = NULL;
    a.distortion = kit_any(kit, state);
    a.ripple = kit_any(kit, state);
    a.foam = kit_any(kit, state);
    a.tank_wall = kit_any(kit, state);
    a.tank_floor = kit_any(kit, state);
    a.floor_texture = kit_any(kit, state);
    a.floor = random_below(state, 3) ? NULL : &kit->floor;
    a.pool_mask = random_below(state, 2) ? NULL : &kit->mask;
    a.field_mask = random_below(state, 4) ? NULL : &kit->mask;
    strcpy(s->boat.mesh, a.boat ? "boat.obj" : "");
    strcpy(s->floor.map, a.floor ? "floor.png" : "");
    strcpy(s->pool.mask, a.pool_mask ? "mask.png" : "");
    kit->boat.material[1].opacity = random_below(state, 2) ? 0 : TP_FX(0.5);
    return a;
}

/* Limits a pool's Courant number and damping to what its interval allows. */
static inline void kit_hold_steps(tp_scene_pool *pool)
{
    if (pool->courant > TP_FX(0.48) >> pool->interval)
        pool->courant = TP_FX(0.48) >> pool->interval;
    if (pool->damping < 4 + pool->interval)
        pool->damping = 4 + pool->interval;
}

/* Limits grids and counts to sizes that a test can wait for. */
static inline void kit_hold(tp_scene *s, int32_t vertices, int32_t cells)
{
    int32_t *const side[] = { &s->pool.cols, &s->pool.rows, &s->field.cols, &s->field.rows,
                              &s->foam.cells, &s->water.caustic_cells, &s->drops.count,
                              &s->drops.rings, &s->spray.count };

    for (size_t i = 0; i < sizeof side / sizeof *side; i++)
        if (*side[i] > cells)
            *side[i] = cells;
    if (tp_fan_budget(s) > (uint32_t)vertices)
        s->grid.vertices = vertices;
    kit_hold_steps(&s->pool);
    kit_hold_steps(&s->field);
}

/* Gathers pool, boat, drops and camera around the origin: the camera is above the water,
 * under water, in a tank, or aboard. */
static inline void kit_gather(tp_scene *s, uint64_t *state)
{
    const uint32_t where = random_below(state, 5);

    s->pool.x = s->pool.z = s->drops.x = s->drops.z = 0;
    s->pool.cell = chance_fx(state, 0.1, 0.6);
    if (random_below(state, 3))
        s->pool.cols = s->pool.rows = 16 + (int32_t)random_below(state, 17);
    s->boat.x = chance_fx(state, -2, 2);
    s->boat.z = chance_fx(state, -2, 2);
    s->boat.scale = chance_fx(state, 0.1, 1.5);
    s->boat.length = chance_fx(state, 0.2, 4);
    s->boat.beam = chance_fx(state, 0.1, 2);
    s->boat.lift = chance_fx(state, -0.5, 0.5);
    s->boat.speed = chance_fx(state, -1, 1);
    s->drops.y = chance_fx(state, 0, 3);
    s->foam.cell = chance_fx(state, 0.1, 1);
    s->tank.depth = chance_fx(state, 0.2, 6);
    s->tank.rim = chance_fx(state, 0, 1);
    s->camera.near = chance_fx(state, 0.05, 0.5);
    s->camera.x = chance_fx(state, -12, 12);
    s->camera.z = chance_fx(state, -12, 12);
    s->camera.y = where == 0 ? chance_fx(state, -5, 0) : chance_fx(state, 0.1, 9);
    s->camera.pitch = where == 0 ? chance_fx(state, -60, 80) : chance_fx(state, -60, 5);
    s->camera.heading = (tp_fx)lround(atan2(-s->camera.x, s->camera.z) * 57.29578 * 65536);
    s->camera.follow = where == 1 ? TP_FOLLOW_BOAT : TP_FOLLOW_NONE;
    if (where < 3) {            /* within the walls or the hull */
        s->camera.x /= where == 1 ? 12 : 6;
        s->camera.z /= where == 1 ? 12 : 6;
        s->camera.heading = chance_fx(state, -180, 180);
    }
    for (int i = 0; i < TP_WAVES; i++)
        s->wave[i].amplitude /= random_below(state, 3) ? 64 : 1;
    if (random_below(state, 2))
        s->sky.haze = 500 * TP_FX_ONE;
}

/* Switches on every feature that a row can switch on or off. */
static inline void kit_switch_on(tp_scene *s, uint64_t *state)
{
    s->sky.kind = chance_int(state, TP_SKY_GRADIENT, TP_SKY_CUBE);
    s->hdr.share = chance_fx(state, 0.1, 1);
    s->hdr.exposure = TP_EXPOSURE_AUTO;
    s->water.clarity = chance_scale(state, 0.2, 60);
    s->water.caustics = chance_fx(state, 0.1, 4);
    s->water.dispersion = chance_int(state, 0, 1) * chance_fx(state, 0.01, 1);
    s->water.reflection = chance_fx(state, 0.1, 1);
    s->water.pool_normal_strength = chance_int(state, 0, 1) * chance_fx(state, 0.1, 4);
    s->water.specular = chance_int(state, 0, 2) * TP_FX_ONE;
    s->mirror.method = chance_int(state, TP_MIRROR_NONE, TP_MIRROR_CUBE);
    s->mirror.size = chance_int(state, TP_MIRROR_HALF, TP_MIRROR_FULL);
    s->mirror.colours = s->water.reflection % 2 ? TP_MIRROR_RGB565 : TP_MIRROR_RGB888;
    s->tank.kind = chance_int(state, TP_TANK_NONE, TP_TANK_GLASS);
    s->foam.cells = chance_int(state, 1, 40);
    s->spray.count = chance_int(state, 1, 60);
    s->spray.size = chance_fx(state, 0.001, 0.2);
    s->ripple.bump = chance_fx(state, 0.1, 4);
    s->distortion.strength = chance_fx(state, 0.1, 20);
    s->drops.count = chance_int(state, 0, 12);
    s->drops.interval = TP_FX(0.05);
}

/* Takes the floor and the tank away; drawn after all other numbers. */
static inline void kit_deepen(tp_scene *s, uint64_t *state)
{
    s->floor.depth = 0;
    s->floor.map[0] = '\0';
    s->tank.kind = TP_TANK_NONE;
    if (random_below(state, 2))
        s->wind.strength = 0;
    if (random_below(state, 3) == 0)
        s->camera.y = chance_fx(state, 0.1, 160);
}

/* A scene of random numbers; three in four scenes have all assets in front of the
 * camera. */
static inline tp_scene kit_scene(uint64_t *state, int32_t vertices, int32_t cells)
{
    tp_scene s = scene_any(state);

    if (random_below(state, 4)) {
        kit_gather(&s, state);
        kit_switch_on(&s, state);
    }
    kit_hold(&s, vertices, cells);
    if (random_below(state, 4) == 0)
        kit_deepen(&s, state);
    return s;
}
#endif
