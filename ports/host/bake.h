/* SPDX-License-Identifier: MIT */
/* A scene and what it names as text in C.  Numbers are written as numbers, not as bytes,
 * so that one file serves every byte order; every name begins with `name`, so that
 * several scenes can be in one program. */
#ifndef HOST_BAKE_H
#define HOST_BAKE_H
#include <stdio.h>
#include "tidepool/assets.h"

/* What is written once however often it is named: two files may hold the same picture. */
typedef struct {
    const tp_texture *texture;
    char              name[24];         /* "layer0", "boat_diffuse3" */
} bake_picture;

struct bake_program;

typedef struct {
    FILE         *out;
    const char   *name;                 /* what all names begin with */
    bake_picture *pictures;
    uint32_t      n_pictures;
    const struct bake_program *program;     /* NULL: no list is written */
} bake;

/* The picture of the list that is this one, texel by texel, or NULL. */
const bake_picture *bake_find(const bake *b, const tp_texture *texture);

/* NAME_scene. */
void bake_scene(const bake *b, const tp_scene *scene);

/* NAME_PART, for names in the file alone. */
void bake_texture(const bake *b, const bake_picture *picture);
void bake_grey(const bake *b, const char *part, const tp_grey *grey);
void bake_mesh(const bake *b, const char *part, const tp_mesh *mesh);

/* Bytes that they take on a machine of 32 bits, texels and corners and faces alone. */
size_t bake_texture_bytes(const tp_texture *texture);
size_t bake_grey_bytes(const tp_grey *grey);
size_t bake_mesh_bytes(const tp_mesh *mesh);
#endif
