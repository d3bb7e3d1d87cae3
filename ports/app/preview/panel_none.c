/* SPDX-License-Identifier: MIT */
/* Stub of the panel, for builds without Dear ImGui or without a C++ compiler. */
#include "panel.h"

bool panel_is_built(void)
{
    return false;
}

panel *panel_open(SDL_Window *window, SDL_Renderer *renderer, const panel_host *host)
{
    (void)window;
    (void)renderer;
    (void)host;
    return NULL;
}

bool panel_event(panel *p, const SDL_Event *event)
{
    (void)p;
    (void)event;
    return false;
}

void panel_draw(panel *p, const SDL_Rect *where)
{
    (void)p;
    (void)where;
}

void panel_scale(panel *p, float scale)
{
    (void)p;
    (void)scale;
}

void panel_search(panel *p)
{
    (void)p;
}

bool panel_types(const panel *p)
{
    (void)p;
    return false;
}

void panel_close(panel *p)
{
    (void)p;
}
