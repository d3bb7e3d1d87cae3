/* SPDX-License-Identifier: MIT */
/* Letters over the picture, of a font of the project's own: 5x7 pixels in cells of 6x10,
 * ASCII and four arrows.  For help, figures and messages, with or without the panel. */
#ifndef SDL2_LETTERS_H
#define SDL2_LETTERS_H
#include <SDL.h>

enum { LETTER_WIDE = 6, LETTER_HIGH = 10, LETTER_SCALES = 8 };

/* Bytes of text that are arrows. */
enum { LETTER_UP = 1, LETTER_DOWN, LETTER_LEFT, LETTER_RIGHT };

typedef struct letters letters;

letters *letters_open(SDL_Renderer *renderer);          /* NULL: SDL_GetError() */
void letters_close(letters *l);
void letters_again(letters *l);         /* the renderer has lost its textures */

/* Cells that a text takes: one for each character, UTF-8's too, which show as '?'. */
int  letters_count(const char *text);

/* A line of text with its upper left corner at x, y of the window, 1..8 times as large,
 * 0xTTRRGGBB: TT is how transparent, 0 not at all. */
void letters_draw(letters *l, int x, int y, int scale, uint32_t colour, const char *text);

/* A rectangle of a colour, 0xRRGGBB; alpha 255 hides what is below.  Empty ones too. */
void letters_fill(letters *l, int x, int y, int wide, int high, uint32_t colour,
                  uint8_t alpha);

/* From now on nothing is drawn outside of it; NULL: everywhere again. */
void letters_clip(letters *l, const SDL_Rect *within);

/* A dark box to draw on. */
void letters_box(letters *l, int x, int y, int wide, int high, uint8_t alpha);
#endif
