/* SPDX-License-Identifier: MIT */
/* What is drawn over the picture: the list of keys, figures with a graph, messages that
 * fade, and at the start what to press. */
#ifndef SDL2_OVERLAY_H
#define SDL2_OVERLAY_H
#include <SDL.h>
#include "keymap.h"
#include "letters.h"
#include "panel.h"

/* In the rectangle `where` of the window. */
void overlay_help(letters *l, const SDL_Rect *where, int scale, const keymap *keys);
void overlay_figures(letters *l, const SDL_Rect *where, int scale,
                     const panel_figures *f, const panel_compare *c);
/* Lines at the lower left, the newest lowest; alpha 0..255. */
void overlay_message(letters *l, const SDL_Rect *where, int scale, const char *text,
                     uint8_t alpha);
#endif
