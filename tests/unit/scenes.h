/* SPDX-License-Identifier: MIT */
/* Scenes for tests: plain scenes, and scenes with any value that the parameter table
 * allows; with a boat of twelve triangles, two materials and textures with odd sides. */
#ifndef TP_TESTS_SCENES_H
#define TP_TESTS_SCENES_H
#include <string.h>
#include "asset/mesh.h"
#include "chance.h"
#include "fx/fx.h"
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
    s.grid.cols = 60;
    s.grid.rows = 50;
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

/* -- a frame in memory of its own ---------------------------------------------------- */

#define FRAME_GUARD 64

typedef struct {
    tp_frame *frame;
    uint8_t  *block, *scratch;
    size_t    bytes, scratch_bytes;
} test_frame;

/* A block of exact size, filled with 0xA5, with FRAME_GUARD more bytes behind its end. */
static inline uint8_t *frame_block(size_t bytes)
{
    uint8_t *block = malloc(bytes + FRAME_GUARD);
    memset(block, 0xa5, bytes + FRAME_GUARD);
    return block;
}

static inline bool frame_guard_holds(const uint8_t *block, size_t bytes)
{
    for (size_t i = 0; i < FRAME_GUARD; i++) {
        if (block[bytes + i] != 0xa5)
            return false;
    }
    return true;
}

/* The config with another program and with the assets. */
static inline tp_config config_with(const tp_config *config, const tp_program *by,
                                    const tp_assets *assets)
{
    tp_config c = *config;

    c.program = by;
    c.assets = assets;
    return c;
}

static inline test_frame frame_by(const tp_program *by, const tp_scene *scene,
                                  const tp_assets *assets, const tp_config *config)
{
    const tp_config c = config_with(config, by, assets);
    test_frame f = { .bytes = tp_frame_bytes(&c, scene),
                     .scratch_bytes = tp_frame_scratch_bytes(&c, scene) };

    f.block = frame_block(f.bytes);
    f.scratch = frame_block(f.scratch_bytes);
    if (tp_frame_init(&f.frame, &c, scene, f.block, f.bytes, NULL) != TP_OK)
        abort();
    return f;
}

static inline test_frame frame_of(const tp_scene *scene, const tp_assets *assets,
                                  const tp_config *config)
{
    return frame_by(&tp_program_all, scene, assets, config);
}

static inline void frame_free(test_frame *f)
{
    free(f->block);
    free(f->scratch);
}
#endif
