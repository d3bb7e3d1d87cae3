/* SPDX-License-Identifier: MIT */
/* The preview's window: a picture of any pixel format in its exact colours at an integer
 * scale, the panel at the right or left, and a bar between them for dragging. */
#ifndef TP_APP_PREVIEW_WINDOW_H
#define TP_APP_PREVIEW_WINDOW_H
#include <SDL.h>
#include <stdbool.h>
#include "app/files/picture.h"

typedef struct {
    SDL_Window   *window;
    SDL_Renderer *renderer;
    SDL_Texture  *texture;
    int           width, height;    /* of the texture */
    int           panel;            /* the panel's wanted width, px; 0: none */
    bool          left;             /* the panel is left of the picture */
    int           usual;            /* the panel's width after a double click on the bar */
    bool          dragged;          /* the bar is being dragged */
    bool          lost;             /* the renderer lost its textures: upload the picture
                                     * again, call font_reload() */
    bool          over;             /* private part: the mouse is on the bar */
    int           wide, high;       /* size before full screen */
    SDL_Cursor   *across;
} window;

/* Layout in px of the window.  `room`: all but bar and panel.  `picture`: scale times
 * the picture's size, in the middle of the room. */
typedef struct {
    SDL_Rect room, picture, bar, panel;
} layout;

/* A bool result is false if SDL failed; SDL_GetError() has the reason.  The new window
 * has room for a picture of width x height at the scale, and for the panel. */
bool   window_open(window *w, const char *title, int width, int height, int scale,
                   int panel);
layout window_layout(const window *w, int scale);

/* Writes the size of the largest picture, 16..4096 px a side, that fits into the room. */
void   window_fits(const window *w, int scale, uint32_t *width, uint32_t *height);

/* Handles the mouse on the bar, and the loss of textures.  True: the event was consumed. */
bool   window_event(window *w, const SDL_Event *event);

/* Window position to picture pixel.  False: outside of the picture. */
bool   window_pixel(const window *w, int scale, int x, int y, int *px, int *py);

bool window_upload(window *w, const picture *p);
void window_clear(window *w, int scale);    /* draws the last uploaded picture and the
                                             * bar; overlays and panel come after */
void window_present(window *w);
void window_full(window *w, bool full);
void window_close(window *w);
#endif
