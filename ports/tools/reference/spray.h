/* SPDX-License-Identifier: MIT */
/* Spray and bubbles in double precision: specks are data of the world; a speck is a disc
 * that faces the eye, 0.5 to 1.5 times spray.size across, opaque, of one colour, with haze,
 * hidden by everything nearer. A bubble is seen through clear water at 3/4 of its depth
 * [F4], over the water's colour; opaque water hides bubbles. An eye under water sees spray
 * and bubbles through the water's absorption.
 *
 * A disc keeps its true width at any distance. With the engine's mipmap levels a disc is as
 * wide as the engine draws it: 48 pixels at most, and one whole pixel or nothing where it
 * is narrower than a pixel.
 *
 * Left out: spray in the water's mirror and spray seen through the surface from below; the
 * engine draws neither. */
#ifndef TP_TOOLS_REFERENCE_SPRAY_H
#define TP_TOOLS_REFERENCE_SPRAY_H
#include "scene.h"

/* Reads the specks of a world into s->speck; the camera is placed, s->immersion is set. */
void ref_spray_open(ref_scene *s, const tp_world *world);

/* Distance to the nearest speck between t0 and t1, HUGE_VAL if there is none. `water`: the
 * ray meets water at t1, and bubbles under the water count. */
double ref_spray_meets(const ref_scene *s, const ref_ray *ray, double t0, double t1,
                       bool water);

ref_colour ref_spray_colour(const ref_scene *s);
#endif
