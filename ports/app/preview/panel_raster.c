/* SPDX-License-Identifier: MIT */
/* Draws the panel's triangles into the window.
 *
 * A GPU takes the triangles unchanged.  SDL's software renderer is fast with rectangles
 * and slow with triangles, and nearly all of a panel is rectangles made of two
 * triangles: for a software renderer this file finds the rectangles again.  A panel at
 * rest has the same vertices in each frame, so its drawing is cached in a texture, valid
 * while the checksum of the vertices stays the same. */
#include "panel_raster.h"
#include <string.h>

void panel_raster_begin(panel_raster *k, SDL_Renderer *renderer)
{
    SDL_RendererInfo info;
    *k = (panel_raster){ .renderer = renderer };
    k->slow = SDL_GetRendererInfo(renderer, &info) == 0
           && (info.flags & SDL_RENDERER_SOFTWARE) != 0;
}

static void forget(SDL_Texture **t)
{
    if (*t)
        SDL_DestroyTexture(*t);
    *t = NULL;
}

void panel_raster_end(panel_raster *k)
{
    forget(&k->atlas);
    forget(&k->kept);
}

bool panel_raster_set_atlas(panel_raster *k, const uint8_t *bytes, int wide, int high,
                            float u, float v)
{
    void *pixels;
    int pitch;
    panel_raster_end(k);
    k->atlas = SDL_CreateTexture(k->renderer, SDL_PIXELFORMAT_ARGB8888,
                                 SDL_TEXTUREACCESS_STREAMING, wide, high);
    if (!k->atlas || SDL_LockTexture(k->atlas, NULL, &pixels, &pitch) != 0)
        return false;
    for (int y = 0; y < high; y++) {
        uint32_t *const row = (uint32_t *)(void *)((uint8_t *)pixels + y * pitch);
        for (int x = 0; x < wide; x++)
            row[x] = (uint32_t)bytes[y * wide + x] << 24 | 0xffffffu;
    }
    SDL_UnlockTexture(k->atlas);
    SDL_SetTextureBlendMode(k->atlas, SDL_BLENDMODE_BLEND);
    SDL_SetTextureScaleMode(k->atlas, SDL_ScaleModeNearest);
    k->wide = wide;
    k->high = high;
    k->u = u;
    k->v = v;
    return true;
}

/* -- rectangles from triangles ------------------------------------------------------- */

static bool same(SDL_Color a, SDL_Color b)
{
    return memcmp(&a, &b, sizeof a) == 0;
}

/* True if six indices form an axis-aligned rectangle of one colour: triangles 0 1 2 and
 * 0 2 3, vertices in order from the upper left. */
static bool is_rectangle(const panel_vertex *v, const uint16_t *i)
{
    const panel_vertex *const a = &v[i[0]], *const b = &v[i[1]], *const c = &v[i[2]],
                     *const d = &v[i[5]];
    return i[3] == i[0] && i[4] == i[2] && a->y == b->y && b->x == c->x && c->y == d->y
        && d->x == a->x && a->x <= c->x && a->y <= c->y && same(a->colour, b->colour)
        && same(a->colour, c->colour) && same(a->colour, d->colour);
}

static int whole(float x)
{
    return (int)SDL_floorf(x + 0.5f);
}

static SDL_Rect between(float x0, float y0, float x1, float y1)
{
    const int x = whole(x0), y = whole(y0);
    return (SDL_Rect){ x, y, whole(x1) - x, whole(y1) - y };
}

static void rectangle(panel_raster *k, const panel_vertex *a, const panel_vertex *c)
{
    const SDL_Rect to = between(a->x, a->y, c->x, c->y);
    const SDL_Color by = a->colour;
    if (by.a == 0)
        return;
    if (a->u == k->u && c->u == k->u && a->v == k->v) {
        SDL_SetRenderDrawBlendMode(k->renderer, by.a == 255 ? SDL_BLENDMODE_NONE
                                                            : SDL_BLENDMODE_BLEND);
        SDL_SetRenderDrawColor(k->renderer, by.r, by.g, by.b, by.a);
        SDL_RenderFillRect(k->renderer, &to);
        return;
    }
    const float wide = (float)k->wide, high = (float)k->high;
    const SDL_Rect from = between(a->u * wide, a->v * high, c->u * wide, c->v * high);
    SDL_SetTextureColorMod(k->atlas, by.r, by.g, by.b);
    SDL_SetTextureAlphaMod(k->atlas, by.a);
    SDL_RenderCopy(k->renderer, k->atlas, &from, &to);
}

static void triangles(panel_raster *k, const panel_draw_call *c, int first, int count)
{
    const panel_vertex *const v = c->vertex;
    const bool plain = v[c->index[first]].u == k->u && v[c->index[first]].v == k->v;
    SDL_SetTextureColorMod(k->atlas, 255, 255, 255);
    SDL_SetTextureAlphaMod(k->atlas, 255);
    SDL_SetRenderDrawBlendMode(k->renderer, SDL_BLENDMODE_BLEND);
    SDL_RenderGeometryRaw(k->renderer, k->slow && plain ? NULL : k->atlas, &v->x,
                          sizeof *v, &v->colour, sizeof *v, &v->u, sizeof *v,
                          c->vertices, c->index + first, count, sizeof *c->index);
}

static void pieces(panel_raster *k, const panel_draw_call *c)
{
    for (int i = 0; i < c->indices;) {
        const uint16_t *const index = c->index + i;
        if (i + 6 <= c->indices && is_rectangle(c->vertex, index)) {
            rectangle(k, &c->vertex[index[0]], &c->vertex[index[2]]);
            i += 6;
        } else {
            triangles(k, c, i, 3);
            i += 3;
        }
    }
}

void panel_raster_draw(panel_raster *k, const panel_draw_call *call, int calls)
{
    for (int i = 0; i < calls; i++) {
        SDL_RenderSetClipRect(k->renderer, &call[i].clip);
        if (k->slow)
            pieces(k, &call[i]);
        else
            triangles(k, &call[i], 0, call[i].indices);
    }
    SDL_RenderSetClipRect(k->renderer, NULL);
}

/* -- cache --------------------------------------------------------------------------- */

/* Adds data to a checksum, in words of 4 bytes; order matters.  The odd multiplier and
 * the xor shift are bijective: two different words never give the same sum. */
static uint64_t add(uint64_t sum, const void *data, size_t bytes)
{
    const uint8_t *at = data;
    for (; bytes >= 4; bytes -= 4, at += 4) {
        uint32_t word;
        memcpy(&word, at, 4);
        sum = (sum ^ word) * 0x9e3779b97f4a7c15u;
        sum ^= sum >> 29;
    }
    return sum;
}

static uint64_t checksum_calls(const panel_draw_call *call, int calls,
                               const SDL_Rect *where)
{
    uint64_t sum = add(1, where, sizeof *where);
    const panel_vertex *last = NULL;
    for (int i = 0; i < calls; i++) {
        const panel_draw_call *const c = &call[i];
        sum = add(sum, &c->clip, sizeof c->clip);
        sum = add(sum, c->index, (size_t)c->indices * sizeof *c->index);
        if (c->vertex != last)
            sum = add(sum, c->vertex, (size_t)c->vertices * sizeof *c->vertex);
        last = c->vertex;
    }
    return sum;
}

static bool fit(panel_raster *k, const SDL_Rect *where)
{
    if (k->kept && k->where.w == where->w && k->where.h == where->h)
        return true;
    forget(&k->kept);
    k->kept = SDL_CreateTexture(k->renderer, SDL_PIXELFORMAT_ARGB8888,
                                SDL_TEXTUREACCESS_TARGET, where->w, where->h);
    k->sum = 0;
    return k->kept && SDL_SetTextureBlendMode(k->kept, SDL_BLENDMODE_NONE) == 0;
}

/* Draws into the cache texture.  Its origin is at 0, 0: a viewport shifts the drawing
 * and the clip rectangles by -where. */
static void draw_kept(panel_raster *k, const panel_draw_call *call, int calls,
                      const SDL_Rect *where)
{
    SDL_Texture *const before = SDL_GetRenderTarget(k->renderer);
    const SDL_Rect moved = { -where->x, -where->y, where->x + where->w,
                             where->y + where->h };
    SDL_SetRenderTarget(k->renderer, k->kept);
    SDL_RenderSetViewport(k->renderer, &moved);
    panel_raster_draw(k, call, calls);
    SDL_RenderSetViewport(k->renderer, NULL);
    SDL_SetRenderTarget(k->renderer, before);
}

void panel_raster_draw_cached(panel_raster *k, const panel_draw_call *call, int calls,
                              const SDL_Rect *where)
{
    if (!k->slow || !fit(k, where)) {
        panel_raster_draw(k, call, calls);
        return;
    }
    const uint64_t sum = checksum_calls(call, calls, where);
    if (sum != k->sum) {
        k->where = *where;
        draw_kept(k, call, calls, where);
        k->sum = sum;
    }
    SDL_RenderCopy(k->renderer, k->kept, NULL, where);
}
