/* SPDX-License-Identifier: MIT */
/* Spray and bubbles in double precision: specks are data of the world; a speck is a soft
 * streak over the picture. Its opacity falls from its way in half a tick with the square of
 * the distance, to 0 at 0.5 to 1.5 times spray.size; a streak longer than 6 pixels is
 * reduced to 6 pixels. A long way makes a streak fainter: way and width cover the same
 * area. Specks fade out from 2 m to 1 m before the eye. Everything nearer hides them; a
 * pane of glass lies over all of them. A bubble is seen through clear water at 3/4 of its
 * depth [F4], over the water's colour; opaque water hides bubbles. An eye under water sees
 * spray and bubbles through the water's absorption.
 *
 * With the engine's mipmap levels a streak is as wide as the engine draws it: two pixels
 * or more, and fainter where it is narrower.
 *
 * Left out: spray in the water's mirror and spray seen through the surface from below; the
 * engine draws neither. */
#ifndef TP_TOOLS_REFERENCE_SPRAY_H
#define TP_TOOLS_REFERENCE_SPRAY_H
#include "scene.h"

/* Reads the specks of a world into s->speck; the camera is placed, s->immersion is set. */
void ref_spray_open(ref_scene *s, const tp_world *world);

/* Blends all specks before the distance t1 over a colour. `water`: the ray meets water at
 * t1, and bubbles under the water count. Returns the opacity of all, 0..1. */
double ref_spray_blend(const ref_scene *s, const ref_ray *ray, double t1, bool water,
                       ref_colour *colour);

/* Colour of a speck in a direction from the eye, before haze. */
ref_colour ref_spray_colour(const ref_scene *s, ref_vec way);
#endif
