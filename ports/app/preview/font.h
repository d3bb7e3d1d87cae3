/* SPDX-License-Identifier: MIT */
/* Text over the picture, in a font of the project: 5x7 pixels in cells of 6x10, ASCII
 * and four arrows.  For help, figures and messages, with or without the panel. */
#ifndef TP_APP_PREVIEW_FONT_H
#define TP_APP_PREVIEW_FONT_H
#include <SDL.h>

enum { FONT_WIDE = 6, FONT_HIGH = 10, FONT_SCALES = 8 };

/* Byte values of the arrows in a text. */
enum { FONT_UP = 1, FONT_DOWN, FONT_LEFT, FONT_RIGHT };

typedef struct font font;

font *font_open(SDL_Renderer *renderer);          /* NULL: SDL_GetError() */
void font_close(font *l);
void font_reload(font *l);         /* the renderer lost its textures */

/* Returns the number of cells of a text: one per character.  A non-ASCII UTF-8 character
 * is one '?'. */
int  font_cell_count(const char *text);

/* Draws a line of text with its upper left corner at x, y of the window. scale 1..8;
 * colour 0xTTRRGGBB, TT = transparency, 0 = opaque. */
void font_draw(font *l, int x, int y, int scale, uint32_t colour, const char *text);

/* Fills a rectangle with a colour 0xRRGGBB; alpha 255 = opaque.  An empty rectangle
 * draws nothing. */
void font_fill(font *l, int x, int y, int wide, int high, uint32_t colour,
               uint8_t alpha);

/* Clips all later drawing to the rectangle; NULL: no clip. */
void font_set_clip(font *l, const SDL_Rect *within);

/* A dark background for text. */
void font_draw_background(font *l, int x, int y, int wide, int high, uint8_t alpha);
#endif
