/* SPDX-License-Identifier: MIT */
/* Foam on the water in double precision, by the rule at the head of
 * src/features/foam/foam_stage.c.
 *
 * The cover is data of the world: one byte a cell over rest positions, bilinear between
 * cell centres; beyond the outermost centres the outermost cells count. The cover fades to
 * 0 within the window's outer eighth, except over a pool, whose walls end the foam. A texel
 * of the texture is white if its rank among all texels is above 1 - cover. The threshold is
 * soft, over a third of the ranks. With the engine's mipmap levels the threshold widens by
 * the level, up to all ranks: then foam shows the cover itself.
 *
 * Left out: foam in the water's mirror and foam seen from below; the engine draws
 * neither. */
#ifndef TP_TOOLS_REFERENCE_FOAM_H
#define TP_TOOLS_REFERENCE_FOAM_H
#include "scene.h"

/* Reads the foam of a world into s->foam; scene and assets are set. */
void ref_foam_open(ref_scene *s, const tp_world *world);

/* Cover 0..1 at a rest position. */
double ref_foam_cover(const ref_foam *foam, double x0, double z0);

/* Share of white, 0..1, of a place with this cover and this rank, at a mipmap level. */
double ref_foam_white(const ref_foam *foam, double cover, double rank, int level);

/* Opacity of the foam at a point of the water, 0..15/16. */
double ref_foam_opacity(const ref_scene *s, const ref_water *water);

/* Colour of foam; `nl` is the cosine of the light on the water, 0..1. Foam is matt. */
ref_colour ref_foam_colour(const ref_scene *s, double nl);
#endif
