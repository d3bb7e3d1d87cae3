/* SPDX-License-Identifier: MIT */
/* A scene and its files as C text.  Numbers are written as numbers, not as bytes: one file
 * serves every byte order; tables of coastal water are words of a layout that some processors
 * do not have, which make their own.  Every name begins with `name`: several scenes fit in one
 * program. */
#ifndef TP_TOOLS_BAKE_BAKE_H
#define TP_TOOLS_BAKE_BAKE_H
#include <stdio.h>
#include "tidepool/assets.h"

/* A texture that is written once, however many names refer to it.  Two files with the same
 * texels count as one texture. */
typedef struct {
    const tp_texture *texture;
    char              name[24];         /* suffix: "layer0", "boat_diffuse3" */
} bake_picture;

struct bake_program;

typedef struct {
    FILE         *out;
    const char   *name;                 /* prefix of all baked names */
    bake_picture *pictures;
    uint32_t      n_pictures;
    const struct bake_program *program;     /* NULL: no program list is written */
    const uint64_t *coastal;            /* tables of coastal water in this machine's layout, ... */
    size_t        coastal_words;        /* ... as words; 0: none */
    const struct program_memory *memory;    /* of that program */
} bake;

/* Returns the entry of the list with the same texels as `texture`, or NULL. */
const bake_picture *bake_find(const bake *b, const tp_texture *texture);

/* Writes NAME_scene. */
void bake_scene(const bake *b, const tp_scene *scene);

/* Each writes a static NAME_PART, visible in the file alone. */
void bake_texture(const bake *b, const bake_picture *picture);
void bake_grey(const bake *b, const char *part, const tp_grey *grey);
void bake_mesh(const bake *b, const char *part, const tp_mesh *mesh);
void bake_coastal(const bake *b);

/* Bytes on a 32-bit machine, of texels, vertices and faces alone. */
size_t bake_texture_bytes(const tp_texture *texture);
size_t bake_grey_bytes(const tp_grey *grey);
size_t bake_mesh_bytes(const tp_mesh *mesh);
#endif
