/* SPDX-License-Identifier: MIT */
/* Window, renderer, texture.  The texture is ARGB8888, which every renderer of SDL takes
 * as it is: expanding 565 is left to the core, whose bits then reach the screen. */
#include "window.h"
#include "../host/say.h"

/* SDL falls back to drivers that show nothing: those only when somebody asks for them. */
static bool shows_nothing(void)
{
    const char *driver = SDL_GetCurrentVideoDriver();
    return !SDL_getenv("SDL_VIDEODRIVER")
        && (SDL_strcmp(driver, "offscreen") == 0 || SDL_strcmp(driver, "dummy") == 0);
}

bool window_open(window *w, const char *title, int width, int height)
{
    *w = (window){ 0 };
    SDL_SetMainReady();
    if (SDL_Init(SDL_INIT_VIDEO) != 0)
        return false;
    if (shows_nothing()) {
        SDL_SetError("there is no display, or it cannot be reached");
        return false;
    }
    w->window = SDL_CreateWindow(title, SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED,
                                 width, height, SDL_WINDOW_RESIZABLE);
    if (!w->window)
        return false;
    w->renderer = SDL_CreateRenderer(w->window, -1, SDL_RENDERER_PRESENTVSYNC);
    if (!w->renderer)
        w->renderer = SDL_CreateRenderer(w->window, -1, SDL_RENDERER_SOFTWARE);
    return w->renderer != NULL;
}

static bool fit_texture(window *w, int width, int height)
{
    if (w->texture && w->width == width && w->height == height)
        return true;
    if (w->texture)
        SDL_DestroyTexture(w->texture);
    w->texture = SDL_CreateTexture(w->renderer, SDL_PIXELFORMAT_ARGB8888,
                                   SDL_TEXTUREACCESS_STREAMING, width, height);
    w->width = width;
    w->height = height;
    return w->texture && SDL_SetTextureBlendMode(w->texture, SDL_BLENDMODE_NONE) == 0;
}

/* Opaque in the alpha byte too: some desktops blend windows by it. */
bool window_upload(window *w, const picture *p)
{
    void *pixels;
    int pitch;
    if (!fit_texture(w, (int)p->width, (int)p->height)
        || SDL_LockTexture(w->texture, NULL, &pixels, &pitch) != 0)
        return false;
    for (uint32_t y = 0; y < p->height; y++) {
        uint32_t *row = (uint32_t *)(void *)((uint8_t *)pixels + y * (size_t)pitch);
        picture_expand_row(p, y, row);
        for (uint32_t x = 0; x < p->width; x++)
            row[x] |= 0xff000000u;
    }
    SDL_UnlockTexture(w->texture);
    return true;
}

void window_present(window *w)
{
    SDL_RenderClear(w->renderer);
    if (w->texture)
        SDL_RenderCopy(w->renderer, w->texture, NULL, NULL);
    SDL_RenderPresent(w->renderer);
}

void window_close(window *w)
{
    if (w->texture)
        SDL_DestroyTexture(w->texture);
    if (w->renderer)
        SDL_DestroyRenderer(w->renderer);
    if (w->window)
        SDL_DestroyWindow(w->window);
    SDL_Quit();
    *w = (window){ 0 };
}
