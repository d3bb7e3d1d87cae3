/* SPDX-License-Identifier: MIT */
/* The preview's window: a picture of any format in its exact colours, whole pixels large,
 * the panel at its right or left, and a bar between them that can be dragged. */
#ifndef SDL2_WINDOW_H
#define SDL2_WINDOW_H
#include <SDL.h>
#include <stdbool.h>
#include "../host/picture.h"

typedef struct {
    SDL_Window   *window;
    SDL_Renderer *renderer;
    SDL_Texture  *texture;
    int           width, height;    /* of the texture */
    int           panel;            /* the panel's width as wished, px; 0: none */
    bool          left;             /* the panel is at the picture's left */
    int           usual;            /* its width by a double click on the bar */
    bool          dragged;          /* the bar is being moved */
    bool          lost;             /* the renderer lost the picture: upload it again, and
                                       letters_again() */
    bool          over;             /* private part: the mouse is on the bar */
    int           wide, high;       /* before it took the whole screen */
    SDL_Cursor   *across;
} window;

/* Where things lie, in pixels of the window.  `picture` is where its pixels are shown:
 * scale times as large as they are, in the middle of what the panel leaves. */
typedef struct {
    SDL_Rect room, picture, bar, panel;
} layout;

/* Each bool is false where SDL failed: SDL_GetError() tells why.  The window has room for
 * a picture of width x height, scale times as large, and the panel. */
bool   window_open(window *w, const char *title, int width, int height, int scale,
                   int panel);
layout window_layout(const window *w, int scale);

/* The largest picture, 16..4096 a side, that the layout's room shows whole. */
void   window_fits(const window *w, int scale, uint32_t *width, uint32_t *height);

/* Mouse on the bar, and renderers that lose textures; true: it took the event. */
bool   window_event(window *w, const SDL_Event *event);

/* Window to picture; false: beside it. */
bool   window_pixel(const window *w, int scale, int x, int y, int *px, int *py);

bool window_upload(window *w, const picture *p);
void window_clear(window *w, int scale);    /* what was uploaded last, in its place, the
                                               bar, and nothing else: then overlays, panel */
void window_present(window *w);
void window_full(window *w, bool full);
void window_close(window *w);
#endif
