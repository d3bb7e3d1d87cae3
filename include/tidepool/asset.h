/* SPDX-License-Identifier: MIT */
/* Textures and meshes, in the caller's memory.  The core opens no file.
 *
 * A mesh is read from Wavefront OBJ text twice: once to check and count it, once to
 * fill memory of the size that the counting found.
 *
 *     tp_obj_scan(&obj);        feed the bytes ...  tp_obj_scanned(&obj, &err)
 *     mem = tp_obj_bytes(&obj)
 *     tp_obj_load(&obj, mem);   feed the same bytes ...  tp_obj_loaded(&obj, &err)
 *     for each i < obj.libraries: read the file tp_obj_library(&obj, i), then
 *         tp_mtl_begin(&obj, i);  feed its bytes ...  tp_mtl_end(&obj, &err)
 *     for each i < obj.images: make a texture of the file tp_obj_image(&obj, i)
 *     tp_obj_bind(&obj, textures, &mesh, &err)
 *
 * Every function that takes an error returns its code; after a failure nothing but
 * a new tp_obj_scan may follow, and no mesh exists. */
#ifndef TP_ASSET_H
#define TP_ASSET_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "tidepool/arena.h"
#include "tidepool/fx.h"
#include "tidepool/status.h"

/* -- textures ------------------------------------------------------------------ */

#define TP_TEXTURE_LEVELS 13            /* 4096 texels down to 1 */

/* Texels 0xAARRGGBB, row-major, both sides powers of two; level n is half of n-1 each
 * way (never below 1), each texel the rounded mean of its four. */
typedef struct {
    const uint32_t *level[TP_TEXTURE_LEVELS];
    uint8_t log2_w, log2_h;
    uint8_t levels;                     /* max(log2_w, log2_h) + 1 */
} tp_texture;

/* Memory for a texture made of a picture of w x h pixels, 1..4096 each; 0 outside. */
size_t tp_texture_bytes(uint32_t w, uint32_t h);

/* Copies pixels (0xAARRGGBB, row-major) into `mem` with all levels.  A side that is no
 * power of two is resampled (linear, wrapping) to the next one above. */
tp_status tp_texture_init(tp_texture *texture, const uint32_t *pixels,
                          uint32_t w, uint32_t h, void *mem, tp_error *err);

/* -- meshes -------------------------------------------------------------------- */

/* A unit vector in one word: x, y, z as signed 10 bits (x lowest), 511 is 1.0; the two
 * bits above are free. */
typedef uint32_t tp_packed_dir;

typedef struct {
    tp_vec3       position;             /* metres of the mesh's own frame */
    tp_packed_dir normal;
    tp_fx         s, t;                 /* texture repeats; t = 0 is the picture's top */
} tp_mesh_vertex;

typedef struct {
    uint32_t      vertex[3];            /* counter-clockwise seen from outside */
    tp_packed_dir tangent;              /* along growing s; bit 30: bitangent = -(N x T) */
    uint32_t      material;
} tp_mesh_face;

typedef struct {
    uint32_t diffuse, specular;         /* Kd, Ks as 0x00RRGGBB */
    tp_fx    shininess;                 /* Ns, 1..1000 */
    tp_fx    opacity;                   /* d, 0..1; drawn as a screen-door pattern */
    tp_fx    bump;                      /* -bm, 1 by default */
    const tp_texture *diffuse_map;      /* or NULL */
    const tp_texture *normal_map;       /* tangent space, or NULL */
    tp_fx    texels;                    /* of the diffuse map along one metre, mean */
} tp_material;

typedef struct {
    const tp_mesh_vertex *vertices;
    const tp_mesh_face   *faces;
    const tp_material    *materials;
    uint32_t n_vertices, n_faces, n_materials;
    tp_vec3  low, high;                 /* corners of the bounding box */
} tp_mesh;

/* -- OBJ and MTL ---------------------------------------------------------------- */

#define TP_OBJ_LINE_BYTES  4096         /* of one logical line, continuations joined */
#define TP_OBJ_CORNERS     256          /* of one polygon */
#define TP_OBJ_COUNT       (1u << 24)   /* of vertices, faces, ... of one file */
#define TP_OBJ_RANGE       16384        /* metres, either way */

/* The reader.  About 9 KB, for any place; open in layout so that it can be static. */
typedef struct tp_obj {
    uint32_t libraries;                 /* files named by mtllib, each once */
    uint32_t images;                    /* pictures named by the materials, each once */
    uint32_t skipped;                   /* statements not known or not used, counted */
    /* -- private part -- */
    int private_part;
} tp_obj;

void      tp_obj_scan(tp_obj *obj);
tp_status tp_obj_feed(tp_obj *obj, const void *text, size_t bytes, tp_error *err);
tp_status tp_obj_scanned(tp_obj *obj, tp_error *err);
size_t    tp_obj_bytes(const tp_obj *obj);      /* aligned to 8; includes room for bind */
void      tp_obj_load(tp_obj *obj, void *mem);
tp_status tp_obj_loaded(tp_obj *obj, tp_error *err);

const char *tp_obj_library(const tp_obj *obj, uint32_t i);  /* as written, terminated */
void      tp_mtl_begin(tp_obj *obj, uint32_t library);
tp_status tp_mtl_feed(tp_obj *obj, const void *text, size_t bytes, tp_error *err);
tp_status tp_mtl_end(tp_obj *obj, tp_error *err);

const char *tp_obj_image(const tp_obj *obj, uint32_t i);
uint32_t    tp_obj_image_library(const tp_obj *obj, uint32_t i);    /* that names it */

/* `textures`: one for each image, or NULL for those that could not be had.  The mesh
 * points into the memory given to tp_obj_load and at the textures. */
tp_status tp_obj_bind(tp_obj *obj, const tp_texture *const *textures, tp_mesh *mesh,
                      tp_error *err);
#endif
