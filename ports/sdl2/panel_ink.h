/* SPDX-License-Identifier: MIT */
/* Triangles of the panel through SDL's renderer, quickly where that has no GPU. */
#ifndef SDL2_PANEL_INK_H
#define SDL2_PANEL_INK_H
#include <SDL.h>
#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* As Dear ImGui lays it out: place in the window, place in the atlas 0..1. */
typedef struct { float x, y, u, v; SDL_Color colour; } ink_vertex;

/* One call: triangles of `index`, three a piece, within a rectangle. */
typedef struct {
    const ink_vertex *vertex;
    int               vertices;
    const uint16_t   *index;
    int               indices;
    SDL_Rect          clip;
} ink_call;

typedef struct {
    SDL_Renderer *renderer;
    SDL_Texture  *atlas;        /* letters: white, as opaque as the ink is thick */
    int           wide, high;
    float         u, v;         /* of its white texel: what lies there is plain */
    bool          slow;         /* the renderer draws triangles itself */
    uint64_t      sum;          /* of what `kept` shows */
    SDL_Texture  *kept;         /* the panel's own window, when it was last drawn */
    SDL_Rect      where;
} ink;

void ink_begin(ink *k, SDL_Renderer *renderer);
void ink_end(ink *k);

/* Takes an atlas of wide x high bytes, ink as 0..255.  False: SDL_GetError(). */
bool ink_atlas(ink *k, const uint8_t *bytes, int wide, int high, float u, float v);

/* Draws now. */
void ink_draw(ink *k, const ink_call *call, int calls);

/* The same for what fills `where`, opaque: drawn anew only when it is not what it was. */
void ink_keep(ink *k, const ink_call *call, int calls, const SDL_Rect *where);

#ifdef __cplusplus
}
#endif
#endif
