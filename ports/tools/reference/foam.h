/* SPDX-License-Identifier: MIT */
/* Foam on the water in double precision, by the rule at the head of
 * src/features/foam/foam_stage.c.
 *
 * The cover is data of the world: one byte a cell over rest positions, bilinear between
 * cell centres; beyond the outermost centres the outermost cells count. In the outer
 * quarter of the window's inscribed circle the cover passes into a far cover: half of the
 * field's mean, and 1.125 of the mean times the squares of the slope and of its part on the
 * waves' way, both over their mean; 216 / 255 at most; none on the waves' fronts. A mean
 * below 16 / 255 leaves less old foam and gives more to the slopes. Along a straight beach
 * near the window's middle the middle repeats; over other floors the depth gives the mean
 * cover of the surf, by the rule at the head of foam_surf.c. Over a pool the window ends at
 * the walls instead.
 *
 * A texture four times as large as the foam's moves the cover up and down by its rank. A
 * texel of the texture is white if its rank among all texels is above 1 - cover. The
 * threshold is soft, over a third of the ranks. With the engine's mipmap levels the
 * threshold widens by the level, up to all ranks, and levels from 5 on count as their mean:
 * then foam shows the cover itself. Below the lace a quarter of the cover is white.
 *
 * Left out: foam in the water's mirror and foam seen from below; the engine draws
 * neither. */
#ifndef TP_TOOLS_REFERENCE_FOAM_H
#define TP_TOOLS_REFERENCE_FOAM_H
#include "scene.h"

/* Reads the foam of a world into s->foam; scene and assets are set. */
void ref_foam_open(ref_scene *s, const tp_world *world);

/* Cover 0..1 of the field at a rest position, and its weight against the far cover. */
double ref_foam_cover(const ref_foam *foam, double x0, double z0, double *weight);

/* Cover after the texture of the large scale, by the rank above the mean there. */
double ref_foam_patched(double cover, double rank);

/* Share of white, 0..1, of a place with this cover and this rank above the mean's, at a
 * mipmap level. */
double ref_foam_white(double cover, double rank, int level);

/* Opacity of foam of a cover and a share of white, 0..1. */
double ref_foam_lace(double cover, double white);

/* Opacity of the foam at a point of the water, 0..1. */
double ref_foam_opacity(const ref_scene *s, const ref_water *water);

/* Colour of foam; `nl` is the cosine of the light on the water, 0..1. Foam is matt. */
ref_colour ref_foam_colour(const ref_scene *s, double nl);
#endif
