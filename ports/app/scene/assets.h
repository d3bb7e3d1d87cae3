/* SPDX-License-Identifier: MIT */
/* The files that a scene names, in memory: the boat with materials and pictures, textures,
 * grey maps. */
#ifndef TP_APP_SCENE_ASSETS_H
#define TP_APP_SCENE_ASSETS_H
#include "app/files/picture.h"
#include "scene_file.h"
#include "tidepool/assets.h"

typedef struct assets_block assets_block;

enum { ASSETS_PICTURES = 15 };  /* number of textures that a scene can name */

typedef struct {
    uint32_t texels;            /* bound of a texture's sides, texels; 0: none */
    bool     strict;            /* refuse a mesh with missing or faulty files */
    bool     quiet;             /* no warnings about meshes: an earlier load printed them */
    int32_t  mesh;              /* rung of the boat's mesh, if the scene leaves it open */
} assets_options;

typedef struct {
    tp_assets     names;        /* for the core; points at the members below */
    tp_mesh       boat;
    tp_texture    picture[ASSETS_PICTURES];
    tp_grey       floor, pool_mask, field_mask;
    assets_block *blocks;       /* all allocated memory */
    size_t        mesh_bytes, texture_bytes;
    assets_options options;
} asset_set;

/* Each function returns an exit code.  After a failure the reason has been printed, and *a
 * is empty: nothing stays half loaded.  *a must not move while names are in use. */
int  assets_open(asset_set *a, const scene_file *file);            /* default options */
int  assets_load(asset_set *a, const scene_file *file, const assets_options *options);
void assets_close(asset_set *a);

/* To call after a change of the scene.  Returns the name of a parameter whose picture is
 * now needed but not loaded, or NULL. */
const char *assets_lack(const asset_set *a, const scene_file *file);
int  assets_refuse(const scene_file *file, const char *lacking);    /* prints the reason */

/* Closes *to, moves the contents of *from there, and leaves *from empty. */
void assets_move(asset_set *to, asset_set *from);

/* -- shared by assets.c and assets_mesh.c -------------------------------------------- */

/* Returns memory that assets_close frees, or NULL after printing the reason. */
void *assets_take(asset_set *a, size_t bytes);

/* Loads a texture from a PNG.  Returns EXIT_CHECK if the picture is unusable; `why` then
 * holds the reason. */
int  assets_texture(asset_set *a, tp_texture *texture, const char *path,
                    char why[PICTURE_WHY]);

/* Loads the mesh of a scene with its material libraries and pictures.  scale: metres per
 * unit of the file, Q16.16.  Messages about the OBJ itself begin with `who`, the place of
 * its name. */
int assets_mesh(asset_set *a, tp_mesh *mesh, const char *path, const char *who,
                tp_fx scale);
#endif
