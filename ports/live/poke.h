/* SPDX-License-Identifier: MIT */
/* Pokes and stirs of the pool.  Without a pool, of the field: that is where it would be
 * poked, but no world takes such an input yet (tidepool/scene.h). */
#ifndef LIVE_POKE_H
#define LIVE_POKE_H
#include "tidepool/scene.h"

#define POKE_POINTS 6           /* of the Czech report: two rows of three */

/* Poke number 0..5 of the scene's pool (or field): far left ... near right, as seen from
 * the scene's south, a quarter of a side from the edges.  Another number, or a scene
 * without either, leaves *input alone. */
void poke_point(const tp_scene *scene, uint32_t number, tp_input *input);

/* At a place; a stir is a poke of a third that is repeated while the mouse moves. */
void poke_at(const tp_scene *scene, tp_fx x, tp_fx z, bool stir, tp_input *input);
#endif
