/* SPDX-License-Identifier: MIT */
/* Draws the panel's triangles by SDL's renderer, fast without a GPU too. */
#ifndef SDL2_PANEL_INK_H
#define SDL2_PANEL_INK_H
#include <SDL.h>
#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Vertex, in Dear ImGui's layout: x, y in px of the window; u, v in the atlas, 0..1. */
typedef struct { float x, y, u, v; SDL_Color colour; } ink_vertex;

/* One draw call: triangles of three indices each, clipped to a rectangle. */
typedef struct {
    const ink_vertex *vertex;
    int               vertices;
    const uint16_t   *index;
    int               indices;
    SDL_Rect          clip;
} ink_call;

typedef struct {
    SDL_Renderer *renderer;
    SDL_Texture  *atlas;        /* font: white, alpha = coverage */
    int           wide, high;
    float         u, v;         /* the atlas's white texel, for untextured drawing */
    bool          slow;         /* software renderer */
    uint64_t      sum;          /* checksum of the drawing in `kept` */
    SDL_Texture  *kept;         /* cache: the last drawing of the panel */
    SDL_Rect      where;
} ink;

void ink_begin(ink *k, SDL_Renderer *renderer);
void ink_end(ink *k);

/* Takes an atlas of wide x high coverage bytes, 0..255.  Returns false on failure;
 * SDL_GetError() has the reason. */
bool ink_atlas(ink *k, const uint8_t *bytes, int wide, int high, float u, float v);

/* Draws at once. */
void ink_draw(ink *k, const ink_call *call, int calls);

/* Draws opaque content that fills `where`; redraws the cache only if the content has
 * changed. */
void ink_keep(ink *k, const ink_call *call, int calls, const SDL_Rect *where);

#ifdef __cplusplus
}
#endif
#endif
