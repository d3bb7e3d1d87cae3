/* SPDX-License-Identifier: MIT */
/* Letters over the picture, of a font of the project's own: 5x7 pixels in cells of 6x10,
 * ASCII.  For help, figures and messages, with or without the panel. */
#ifndef SDL2_LETTERS_H
#define SDL2_LETTERS_H
#include <SDL.h>

enum { LETTER_WIDE = 6, LETTER_HIGH = 10 };

typedef struct letters letters;

letters *letters_open(SDL_Renderer *renderer);          /* NULL: SDL_GetError() */
void letters_close(letters *l);

/* A line of text with its upper left corner at x, y of the window, 0xRRGGBB. */
void letters_draw(letters *l, int x, int y, int scale, uint32_t colour, const char *text);

/* A dark box to draw on. */
void letters_box(letters *l, int x, int y, int wide, int high, uint8_t alpha);
#endif
