/* SPDX-License-Identifier: MIT */
/* The preview's window: shows pictures of any format in their exact colours. */
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
} window;

/* Each returns false where SDL failed: SDL_GetError() tells why. */
bool window_open(window *w, const char *title, int width, int height);
bool window_upload(window *w, const picture *p);
void window_present(window *w);     /* what was uploaded last, stretched to the window */
void window_close(window *w);
#endif
