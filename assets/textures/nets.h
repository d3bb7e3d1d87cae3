/* SPDX-License-Identifier: MIT */
/* Pictures of warped cell nets: light on water, foam, cracked lava. */
#ifndef NETS_H
#define NETS_H
#include "canvas.h"

void paint_water(canvas *to);
void paint_foam(canvas *to);
void paint_crests(canvas *to);
void paint_lava(canvas *to);
void paint_lava_crust(canvas *to);
void paint_lava_glow(canvas *to);
#endif
