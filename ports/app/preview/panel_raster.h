/* SPDX-License-Identifier: MIT */
/* Draws the panel's triangles by SDL's renderer, fast without a GPU too. */
#ifndef TP_APP_PREVIEW_PANEL_RASTER_H
#define TP_APP_PREVIEW_PANEL_RASTER_H
#include <SDL.h>
#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Vertex, in Dear ImGui's layout: x, y in px of the window; u, v in the atlas, 0..1. */
typedef struct { float x, y, u, v; SDL_Color colour; } panel_vertex;

/* One draw call: triangles of three indices each, clipped to a rectangle. */
typedef struct {
    const panel_vertex *vertex;
    int               vertices;
    const uint16_t   *index;
    int               indices;
    SDL_Rect          clip;
} panel_draw_call;

typedef struct {
    SDL_Renderer *renderer;
    SDL_Texture  *atlas;        /* font: white, alpha = coverage */
    int           wide, high;
    float         u, v;         /* the atlas's white texel, for untextured drawing */
    bool          slow;         /* software renderer */
    uint64_t      sum;          /* checksum of the drawing in `kept` */
    SDL_Texture  *kept;         /* cache: the last drawing of the panel */
    SDL_Rect      where;
} panel_raster;

void panel_raster_begin(panel_raster *k, SDL_Renderer *renderer);
void panel_raster_end(panel_raster *k);

/* Takes an atlas of wide x high coverage bytes, 0..255.  Returns false on failure;
 * SDL_GetError() has the reason. */
bool panel_raster_set_atlas(panel_raster *k, const uint8_t *bytes, int wide, int high,
                            float u, float v);

/* Draws at once. */
void panel_raster_draw(panel_raster *k, const panel_draw_call *call, int calls);

/* Draws opaque content that fills `where`; redraws the cache only if the content has
 * changed. */
void panel_raster_draw_cached(panel_raster *k, const panel_draw_call *call, int calls,
                              const SDL_Rect *where);

#ifdef __cplusplus
}
#endif
#endif
