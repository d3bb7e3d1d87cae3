/* SPDX-License-Identifier: MIT */
/* Textures and meshes in the caller's memory, and the set of them that a scene names.  The
 * library opens no file: the caller passes pixels. */
#ifndef TP_ASSETS_H
#define TP_ASSETS_H
#include <stddef.h>
#include <stdint.h>
#include "tidepool/fixed.h"
#include "tidepool/scene.h"
#include "tidepool/status.h"

TP_BEGIN_C

/* -- textures ------------------------------------------------------------------------ */

#define TP_TEXTURE_LEVELS 13            /* 4096 texels down to 1 */

/* A texture with its mipmap levels.  Texels are 0xAARRGGBB, row-major; both sides are
 * powers of two.  Level n has half the width and half the height of level n-1 (never below
 * 1); each texel is the rounded mean of four texels. */
typedef struct {
    const uint32_t *level[TP_TEXTURE_LEVELS];
    uint8_t log2_w, log2_h;
    uint8_t levels;                     /* max(log2_w, log2_h) + 1 */
} tp_texture;

/* Returns the memory in bytes for a texture made from a picture of w x h pixels, 1..4096
 * each; 0: a side is out of range. */
size_t tp_texture_bytes(uint32_t w, uint32_t h);

/* Copies pixels (0xAARRGGBB, row by row) and computes all mipmap levels in `memory`: at
 * least tp_texture_bytes(), aligned to 4.  A side that is no power of two is resampled
 * (linear, wrapping) to the next larger power of two.  The texture points into the memory,
 * which must outlive it; the pixels are no longer needed.
 *  - TP_E_TEXTURE: a side is out of range
 *  - TP_E_NULL, TP_E_ALIGN: err->word is the argument; TP_E_NOSPACE: `bytes` are too few */
tp_status tp_texture_init(tp_texture *texture, const uint32_t *pixels, uint32_t w,
                          uint32_t h, void *memory, size_t bytes, tp_error *err);

/* -- meshes -------------------------------------------------------------------------- */

/* A unit vector in one word: x, y, z as signed 10-bit numbers (x lowest), 511 is 1.0; the
 * upper two bits are free.  "mesh/mesh.h" packs and unpacks it. */
typedef uint32_t tp_packed_dir;

typedef struct {
    tp_vec3       position;             /* 1.0: 2^log2_unit units of the OBJ file */
    tp_packed_dir normal;
    tp_fx         s, t;                 /* texture repeats; t = 0 is the picture's top */
} tp_mesh_vertex;

typedef struct {
    uint32_t      vertex[3];            /* counter-clockwise seen from outside */
    tp_packed_dir tangent;              /* along growing s; bit 30: mirrored */
    uint32_t      material;
} tp_mesh_face;

/* Sign of the bitangent.  The bitangent points to the picture's top (falling t), the green
 * axis of a normal map: N x T, or -(N x T) if this bit is set (a mirrored picture). */
#define TP_TANGENT_MIRRORED (1u << 30)

typedef struct {
    uint32_t diffuse, specular;         /* Kd, Ks as 0x00RRGGBB */
    tp_fx    shininess;                 /* Ns, 1..1000 */
    tp_fx    opacity;                   /* d, 0..1, screen-door pattern; 0: a lid */
    tp_fx    bump;                      /* -bm, +-16, 1 by default */
    const tp_texture *diffuse_map;      /* or NULL */
    const tp_texture *normal_map;       /* tangent space, or NULL */
    tp_fx    texels;                    /* mean texels of the diffuse map per 1.0
                                         * of position */
} tp_material;

/* Largest tp_mesh.log2_unit.  A position of 1.0 is 2^log2_unit units of the OBJ file:
 * log2_unit is 0 if the mesh fits +-16384 units; a larger mesh is stored more coarsely.  A
 * scene draws a unit of the file as boat.scale metres. */
#define TP_MESH_MAX_LOG2_UNIT 8

typedef struct {
    const tp_mesh_vertex *vertices;
    const tp_mesh_face   *faces;
    const tp_material    *materials;
    uint32_t              n_vertices, n_faces, n_materials;
    tp_vec3  low, high;                 /* corners of the bounding box, as positions */
    uint32_t              log2_unit;    /* scale of positions, 0..TP_MESH_MAX_LOG2_UNIT */
} tp_mesh;

/* A picture of one number per pixel, row by row: heights of a sea floor, masks of walls. */
typedef struct {
    uint32_t cols, rows;
    const uint16_t *sample;     /* 0 black, 65535 white */
} tp_grey;

/* -- tables -------------------------------------------------------------------------- */

/* Tables that a frame makes from numbers of its scene and camera: name, how many numbers,
 * type of the entries. */
#define TP_TABLE_LIST(X) \
    X(gradient, 2, uint32_t)    /* the sky between its two colours */ \
    X(shine, 3, tp_entry16)     /* the water's specular lobe */ \
    X(tones, 1, tp_entry8)      /* an exposure's tone curves */ \
    X(dome, 5, uint32_t)        /* a generated sky */ \
    X(light, 19, uint32_t)      /* fast water: Fresnel's share, lobes, mirrored skies */ \
    X(ripples, 2, uint32_t)     /* slope variance of the ripples' mipmap levels */ \
    X(rows, 21, int32_t)        /* rows of the water's grid, and their slope variance */

typedef enum {
#define X(name, numbers, type) TP_TABLE_##name,
    TP_TABLE_LIST(X)
#undef X
    TP_TABLE_COUNT
} tp_table_id;

/* A table as a constant, written by `tidepool bake`.  entries NULL: not baked. */
typedef struct {
    const void    *entries;
    const int32_t *made_of;     /* the numbers */
} tp_table;

typedef struct {
    tp_table table[TP_TABLE_COUNT];
} tp_tables;

/* -- the assets of a scene ----------------------------------------------------------- */

/* The pictures and meshes of a scene, loaded by the application; NULL if not named. */

typedef struct tp_assets {
    const tp_mesh    *boat;
    const tp_texture *layer[TP_LAYERS], *distortion, *ripple, *foam;
    /* Layers, distortion and ripple baked for fast shading (tp_bake_layer) from the scene's
     * numbers.  They do not follow later changes of these numbers.  NULL: the frame bakes
     * them in its block. */
    const tp_texture *baked_layer[TP_LAYERS], *baked_offset, *baked_slope;
    const tp_texture *sky[TP_FACES], *tank_wall, *tank_floor, *floor_texture;
    const tp_grey    *floor;            /* scene.floor.map */
    const tp_grey    *pool_mask, *field_mask;   /* scene.pool.mask, scene.field.mask */
    /* A frame keeps no RAM for a baked table.  If its numbers are not those of the table,
     * it draws by the table all the same, and counts it as dropped.  NULL: none. */
    const tp_tables  *tables;
    /* Tables of the waves over the scene's floor and under its wind, baked from the scene's
     * numbers.  NULL, or a scene of other numbers: each world makes its own tables. */
    const struct tp_coastal_water *coastal;
} tp_assets;

TP_END_C
#endif
