/* SPDX-License-Identifier: MIT */
/* Drops that fall from a sphere, and the rings that they raise: tidepool/drop.h.
 *
 *     drop.c            fall, impact, bounce and shape of one
 *     drops.c           the module: the list of drops, the list of rings
 *     drops_drawing.c   drops and sphere as spheroids
 *     drops_stage.c     their colour */
#ifndef TP_DROPS_MODULE_H
#define TP_DROPS_MODULE_H
#include "scene/module.h"

#define TP_DROPS_ID TP_MODULE_ID('d', 'r', 'o', 'p')

/* Fills `to` with the rings at `time`, ticks x 65536, up to `room`; returns their count. */
uint32_t tp_drops_rings_at(const tp_drops *drops, const tp_program *program, int64_t time,
                           tp_ring_now *to, uint32_t room);
#endif
