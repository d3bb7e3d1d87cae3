/* SPDX-License-Identifier: MIT */
/* What a scene names, loaded: its boat with materials and pictures, its textures. */
#ifndef HOST_ASSETS_H
#define HOST_ASSETS_H
#include "picture.h"
#include "scene_file.h"
#include "tidepool/assets.h"

typedef struct assets_block assets_block;

enum { ASSETS_PICTURES = 15 };  /* textures that a scene can name */

typedef struct {
    uint32_t texels;            /* of a picture's longer side at the most, 0: any */
    bool     strict;            /* what a mesh lacks is refused, not left out */
    bool     quiet;             /* or is left out without a word: it was said before */
} assets_options;

typedef struct {
    tp_assets     names;        /* what the frame takes: points below */
    tp_mesh       boat;
    tp_texture    picture[ASSETS_PICTURES];
    tp_grey       floor, pool_mask, field_mask;
    assets_block *blocks;       /* all memory of it */
    size_t        mesh_bytes, texture_bytes;
    assets_options options;
} asset_set;

/* Nothing is half-loaded: after a failure, which it has explained, *a is empty.
 * It must not move while names are in use. */
int  assets_open(asset_set *a, const scene_file *file);            /* without options */
int  assets_load(asset_set *a, const scene_file *file, const assets_options *options);
void assets_close(asset_set *a);

/* After a change of the scene: the row of a picture that it needs now and that they lack,
 * or NULL. */
const char *assets_lack(const asset_set *a, const scene_file *file);
int  assets_refuse(const scene_file *file, const char *lacking);    /* says so */

/* Closes *to and puts in its place what *from has, which is then empty. */
void assets_move(asset_set *to, asset_set *from);

/* -- between assets.c and assets_mesh.c ------------------------------------------- */

/* Memory that assets_close gives back; NULL: there is none, and it said so. */
void *assets_take(asset_set *a, size_t bytes);

/* A texture of a PNG.  EXIT_CHECK: the picture cannot be used, and `why` tells. */
int  assets_texture(asset_set *a, tp_texture *texture, const char *path,
                    char why[PICTURE_WHY]);

/* The mesh that a scene draws `scale` metres a unit, with its libraries and pictures.
 * Messages about the OBJ itself begin with `who`, which named it. */
int  assets_mesh(asset_set *a, tp_mesh *mesh, const char *path, const char *who, tp_fx scale);
#endif
