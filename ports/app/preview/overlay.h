/* SPDX-License-Identifier: MIT */
/* Overlays over the picture: the list of keys, figures with a graph, messages with a
 * fade, the hint at the start. */
#ifndef TP_APP_PREVIEW_OVERLAY_H
#define TP_APP_PREVIEW_OVERLAY_H
#include <SDL.h>
#include "font.h"
#include "keymap.h"
#include "panel.h"

/* Each draws into the rectangle `where` of the window. */
void overlay_help(font *l, const SDL_Rect *where, int scale, const keymap *keys);
void overlay_performance(font *l, const SDL_Rect *where, int scale,
                         const panel_performance *f, const panel_compare *c);
/* Lines of text at the lower left, the last line lowest; alpha 0..255. */
void overlay_message(font *l, const SDL_Rect *where, int scale, const char *text,
                     uint8_t alpha);
#endif
