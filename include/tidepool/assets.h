/* SPDX-License-Identifier: MIT */
/* Textures and meshes, in the caller's memory, and what a scene names of them.  The
 * library opens no file: the caller hands over pixels. */
#ifndef TP_ASSETS_H
#define TP_ASSETS_H
#include <stddef.h>
#include <stdint.h>
#include "tidepool/fixed.h"
#include "tidepool/scene.h"
#include "tidepool/status.h"

TP_BEGIN_C

/* -- textures ------------------------------------------------------------------ */

#define TP_TEXTURE_LEVELS 13            /* 4096 texels down to 1 */

/* Texels 0xAARRGGBB, row-major, both sides powers of two; level n is half of n-1 each
 * way (never below 1), each texel the rounded mean of its four. */
typedef struct {
    const uint32_t *level[TP_TEXTURE_LEVELS];
    uint8_t log2_w, log2_h;
    uint8_t levels;                     /* max(log2_w, log2_h) + 1 */
} tp_texture;

/* The bytes of memory that a texture of a picture of w x h pixels needs, 1..4096 each; 0:
 * a side is out of range. */
size_t tp_texture_bytes(uint32_t w, uint32_t h);

/* Copies pixels (0xAARRGGBB, row by row) with all their levels into `memory`, at least
 * tp_texture_bytes(), aligned to 4.  A side that is no power of two is resampled (linear,
 * wrapping) to the next larger one.  The texture points into the memory, which must outlive
 * it; the pixels may go.
 *  - TP_E_TEXTURE: a side is out of range
 *  - TP_E_NULL, TP_E_ALIGN: err->word is the argument; TP_E_NOSPACE: `bytes` are too few */
tp_status tp_texture_init(tp_texture *texture, const uint32_t *pixels, uint32_t w,
                          uint32_t h, void *memory, size_t bytes, tp_error *err);

/* -- meshes -------------------------------------------------------------------- */

/* A unit vector in one word: x, y, z as signed 10 bits (x lowest), 511 is 1.0; the two
 * bits above are free.  "asset/mesh.h" packs and unpacks it. */
typedef uint32_t tp_packed_dir;

typedef struct {
    tp_vec3       position;             /* in the mesh's own frame and units: see below */
    tp_packed_dir normal;
    tp_fx         s, t;                 /* texture repeats; t = 0 is the picture's top */
} tp_mesh_vertex;

typedef struct {
    uint32_t      vertex[3];            /* counter-clockwise seen from outside */
    tp_packed_dir tangent;              /* along growing s; bit 30: see below */
    uint32_t      material;
} tp_mesh_face;

/* The bitangent points to the picture's top (falling t), as the green of a normal map is
 * meant: it is N x T, or -(N x T) where the picture is mirrored, which bit 30 tells. */
#define TP_TANGENT_MIRRORED (1u << 30)

typedef struct {
    uint32_t diffuse, specular;         /* Kd, Ks as 0x00RRGGBB */
    tp_fx    shininess;                 /* Ns, 1..1000 */
    tp_fx    opacity;                   /* d, 0..1, as a screen-door pattern; 0: a lid */
    tp_fx    bump;                      /* -bm, +-16, 1 by default */
    const tp_texture *diffuse_map;      /* or NULL */
    const tp_texture *normal_map;       /* tangent space, or NULL */
    tp_fx    texels;                    /* of the diffuse map along 1.0 of positions, mean */
} tp_material;

/* A position of 1.0 is 2^log2_unit units of the file, 0 to TP_MESH_LOG2_UNIT: meshes that
 * reach beyond +-16384 of those are stored coarser.  A scene draws a unit of the file as
 * boat.scale metres. */
#define TP_MESH_LOG2_UNIT 8

typedef struct {
    const tp_mesh_vertex *vertices;
    const tp_mesh_face   *faces;
    const tp_material    *materials;
    uint32_t n_vertices, n_faces, n_materials;
    tp_vec3  low, high;                 /* corners of the bounding box, as positions */
    uint32_t log2_unit;
} tp_mesh;

/* A picture of one number a pixel, row by row: heights of a sea floor, masks of walls. */
typedef struct {
    uint32_t cols, rows;
    const uint16_t *sample;     /* 0 black, 65535 white */
} tp_grey;

/* -- what a scene names, as the port loaded it; NULL for what it does not name ------ */

typedef struct tp_assets {
    const tp_mesh    *boat;
    const tp_texture *layer[TP_LAYERS], *distortion, *ripple, *foam;
    /* Layers, distortion and ripple prepared for the quick rung (tp_prepare), for the scene's
     * numbers; they do not follow a change of those.  NULL: the frame prepares them in its
     * block. */
    const tp_texture *graded[TP_LAYERS], *offsets, *slopes;
    const tp_texture *sky[TP_FACES], *tank_wall, *tank_floor, *floor_texture;
    const tp_grey    *floor;            /* scene.floor.map */
    const tp_grey    *pool_mask, *field_mask;   /* scene.pool.mask, scene.field.mask */
} tp_assets;

TP_END_C
#endif
