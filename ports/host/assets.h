/* SPDX-License-Identifier: MIT */
/* What a scene names, loaded: its boat with materials and pictures, its textures. */
#ifndef HOST_ASSETS_H
#define HOST_ASSETS_H
#include "scene_file.h"
#include "tidepool/frame.h"

typedef struct assets_block assets_block;

enum { ASSETS_PICTURES = 15 };  /* textures that a scene can name */

typedef struct {
    tp_assets     names;        /* what the frame takes: points below */
    tp_mesh       boat;
    tp_texture    picture[ASSETS_PICTURES];
    tp_grey       floor, pool_mask, field_mask;
    assets_block *blocks;       /* all memory of it */
    size_t        mesh_bytes, texture_bytes;
    uint32_t      texels;       /* of a picture's longer side at the most, 0: any */
} assets;

/* Nothing is half-loaded: after a failure, which it has explained, *a is empty.
 * It must not move while names are in use. */
int  assets_open(assets *a, const scene_file *file);
int  assets_open_within(assets *a, const scene_file *file, uint32_t texels);   /* or 0 */
void assets_close(assets *a);

/* After a change of the scene: the row of a picture that it needs now and that they lack,
 * or NULL. */
const char *assets_lack(const assets *a, const scene_file *file);
int  assets_refuse(const scene_file *file, const char *lacking);    /* says so */

/* Closes *to and puts in its place what *from has, which is then empty. */
void assets_move(assets *to, assets *from);
#endif
