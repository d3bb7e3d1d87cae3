/* SPDX-License-Identifier: MIT */
/* Window, renderer, texture.  Without a graphics card SDL's software renderer is used:
 * an OpenGL emulated by the processor takes several cores to copy a picture, SDL's
 * renderer one plain copy. */
#include "window.h"
#include "app/files/log.h"

#define BAR        6            /* px between picture and panel */
#define ROOM_LEAST 64           /* least px left to the picture */
#define PANEL_LEAST 120         /* least panel width by dragging, px */

/* -- opening ------------------------------------------------------------------------- */

/* True if SDL has fallen back to a driver without a display.  Such a driver is used only
 * if SDL_VIDEODRIVER names it. */
static bool shows_nothing(void)
{
    const char *driver = SDL_GetCurrentVideoDriver();
    return !SDL_getenv("SDL_VIDEODRIVER")
        && (SDL_strcmp(driver, "offscreen") == 0 || SDL_strcmp(driver, "dummy") == 0);
}

/* True if the current OpenGL runs on the processor. */
static bool is_software_gl(SDL_Renderer *renderer)
{
    typedef const unsigned char *get_string(unsigned);
    static const char *const names[] = { "llvmpipe", "softpipe", "swrast", "SwiftShader",
                                         "Software Rasterizer" };
    enum { GL_RENDERER_NAME = 0x1f01 };
    SDL_RendererInfo info;
    if (SDL_GetRendererInfo(renderer, &info) != 0 || !SDL_strstr(info.name, "opengl"))
        return false;
    void *address = SDL_GL_GetProcAddress("glGetString");
    get_string *get = NULL;
    SDL_memcpy(&get, &address, sizeof get);
    const char *name = get ? (const char *)get(GL_RENDERER_NAME) : NULL;
    for (size_t i = 0; name && i < SDL_arraysize(names); i++)
        if (SDL_strstr(name, names[i]))
            return true;
    return false;
}

static SDL_Renderer *make_renderer(SDL_Window *of)
{
    SDL_Renderer *renderer = SDL_CreateRenderer(
        of, -1, SDL_RENDERER_ACCELERATED | SDL_RENDERER_PRESENTVSYNC);
    if (renderer && !SDL_getenv("SDL_RENDER_DRIVER") && is_software_gl(renderer)) {
        SDL_DestroyRenderer(renderer);
        renderer = NULL;
    }
    return renderer ? renderer : SDL_CreateRenderer(of, -1, SDL_RENDERER_SOFTWARE);
}

bool window_open(window *w, const char *title, int width, int height, int scale,
                 int panel)
{
    const int wide = width * scale + (panel ? BAR + panel : 0), high = height * scale;
    *w = (window){ .panel = panel, .usual = panel ? panel : 320 };
    SDL_SetMainReady();
    if (SDL_Init(SDL_INIT_VIDEO) != 0)
        return false;
    if (shows_nothing()) {
        SDL_SetError("no display, or the display cannot be reached");
        return false;
    }
    w->window = SDL_CreateWindow(title, SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED,
                                 wide, high, SDL_WINDOW_RESIZABLE | SDL_WINDOW_HIDDEN);
    if (!w->window)
        return false;
    SDL_InitSubSystem(SDL_INIT_GAMECONTROLLER);         /* a gamepad is optional */
    SDL_SetWindowMinimumSize(w->window, SDL_min(wide, 160), SDL_min(high, 120));
    w->renderer = make_renderer(w->window);     /* may create the window anew */
    if (w->renderer)
        SDL_ShowWindow(w->window);
    return w->renderer != NULL;
}

void window_close(window *w)
{
    if (w->across)
        SDL_FreeCursor(w->across);
    if (w->texture)
        SDL_DestroyTexture(w->texture);
    if (w->renderer)
        SDL_DestroyRenderer(w->renderer);
    if (w->window)
        SDL_DestroyWindow(w->window);
    SDL_Quit();
    *w = (window){ 0 };
}

/* On leaving full screen sets the old size, since some systems have no window manager to
 * restore the size. */
void window_full(window *w, bool full)
{
    if (full)
        SDL_GetWindowSize(w->window, &w->wide, &w->high);
    SDL_SetWindowFullscreen(w->window, full ? SDL_WINDOW_FULLSCREEN_DESKTOP : 0);
    if (!full && w->wide > 0)
        SDL_SetWindowSize(w->window, w->wide, w->high);
}

/* -- layout -------------------------------------------------------------------------- */

layout window_layout(const window *w, int scale)
{
    layout at = { { 0 }, { 0 }, { 0 }, { 0 } };
    int wide = 0, high = 0;
    SDL_GetWindowSize(w->window, &wide, &high);
    int panel = SDL_min(w->panel, wide - BAR - ROOM_LEAST);
    panel = w->panel > 0 ? SDL_max(panel, 0) : 0;
    const int bar = panel ? BAR : 0;
    const int room = wide - bar - panel;
    at.room = (SDL_Rect){ w->left ? panel + bar : 0, 0, room, high };
    at.bar = (SDL_Rect){ w->left ? panel : room, 0, bar, high };
    at.panel = (SDL_Rect){ w->left ? 0 : room + bar, 0, panel, high };
    at.picture.w = w->width * scale;
    at.picture.h = w->height * scale;
    at.picture.x = at.room.x + (at.room.w - at.picture.w) / 2;
    at.picture.y = (at.room.h - at.picture.h) / 2;
    return at;
}

void window_fits(const window *w, int scale, uint32_t *width, uint32_t *height)
{
    const layout at = window_layout(w, scale);
    *width = (uint32_t)SDL_clamp(at.room.w / scale, 16, 4096);
    *height = (uint32_t)SDL_clamp(at.room.h / scale, 16, 4096);
}

static bool has_point(const SDL_Rect *r, int x, int y)
{
    const SDL_Point at = { x, y };
    return SDL_PointInRect(&at, r);
}

bool window_pixel(const window *w, int scale, int x, int y, int *px, int *py)
{
    const layout at = window_layout(w, scale);
    if (!has_point(&at.room, x, y) || !has_point(&at.picture, x, y))
        return false;
    *px = (x - at.picture.x) / scale;
    *py = (y - at.picture.y) / scale;
    return true;
}

/* -- events -------------------------------------------------------------------------- */

/* Shows the resize cursor while the mouse is on the bar or drags the bar. */
static void point(window *w, bool over)
{
    if (over == w->over)
        return;
    w->over = over;
    if (!w->across)
        w->across = SDL_CreateSystemCursor(SDL_SYSTEM_CURSOR_SIZEWE);
    SDL_SetCursor(over && w->across ? w->across : SDL_GetDefaultCursor());
}

static void drag(window *w, int x)
{
    int wide = 0;
    SDL_GetWindowSize(w->window, &wide, NULL);
    const int most = SDL_max(wide - BAR - ROOM_LEAST, 1);
    const int width = (w->left ? x : wide - x) - BAR / 2;
    w->panel = SDL_min(SDL_max(width, PANEL_LEAST), most);
}

static bool button(window *w, const SDL_MouseButtonEvent *event)
{
    const layout at = window_layout(w, 1);
    if (event->button != SDL_BUTTON_LEFT)
        return w->dragged;
    if (event->type == SDL_MOUSEBUTTONUP) {
        const bool was = w->dragged;
        w->dragged = false;
        return was;
    }
    if (!has_point(&at.bar, event->x, event->y))
        return false;
    w->dragged = event->clicks < 2;
    if (event->clicks >= 2)
        w->panel = w->usual;
    return true;
}

static bool motion(window *w, const SDL_MouseMotionEvent *event)
{
    if (w->dragged && !(event->state & SDL_BUTTON_LMASK))
        w->dragged = false;                     /* released outside of the window */
    if (w->dragged) {
        drag(w, event->x);
        return true;
    }
    const layout at = window_layout(w, 1);
    point(w, has_point(&at.bar, event->x, event->y));
    return false;
}

/* Frees the picture's texture after the renderer has lost its textures.  `lost` makes the
 * view load the font again and draw again. */
static void drop_texture(window *w)
{
    if (w->texture)
        SDL_DestroyTexture(w->texture);
    w->texture = NULL;
    w->lost = true;
}

bool window_event(window *w, const SDL_Event *event)
{
    switch (event->type) {
    case SDL_RENDER_TARGETS_RESET:
    case SDL_RENDER_DEVICE_RESET:
        drop_texture(w);
        return false;
    case SDL_MOUSEBUTTONDOWN:
    case SDL_MOUSEBUTTONUP:
        return button(w, &event->button);
    case SDL_MOUSEMOTION:
        return motion(w, &event->motion);
    case SDL_WINDOWEVENT:
        if (event->window.event == SDL_WINDOWEVENT_LEAVE && !w->dragged)
            point(w, false);
        return false;
    default:
        return false;
    }
}

/* -- pictures ------------------------------------------------------------------------ */

/* Returns the texture's format: the window's own for a software renderer, to save a
 * conversion; else ARGB8888, supported by every SDL renderer. */
static uint32_t pixel_format(const window *w)
{
    SDL_RendererInfo info;
    const uint32_t own = SDL_GetWindowPixelFormat(w->window);
    const bool software = SDL_GetRendererInfo(w->renderer, &info) == 0
                       && info.flags & SDL_RENDERER_SOFTWARE;
    return software && own == SDL_PIXELFORMAT_RGB888 ? own : SDL_PIXELFORMAT_ARGB8888;
}

static bool fit_texture(window *w, int width, int height)
{
    if (w->texture && w->width == width && w->height == height)
        return true;
    if (w->texture)
        SDL_DestroyTexture(w->texture);
    w->texture = SDL_CreateTexture(w->renderer, pixel_format(w),
                                   SDL_TEXTUREACCESS_STREAMING, width, height);
    w->width = width;
    w->height = height;
    return w->texture && SDL_SetTextureBlendMode(w->texture, SDL_BLENDMODE_NONE) == 0
        && SDL_SetTextureScaleMode(w->texture, SDL_ScaleModeNearest) == 0;
}

/* Sets alpha to 255: some desktops blend windows by the alpha byte. */
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
    w->lost = false;
    return true;
}

static void fill(window *w, int x, int y, int wide, int high, uint32_t colour)
{
    const SDL_Rect r = { x, y, wide, high };
    if (wide <= 0 || high <= 0)
        return;
    SDL_SetRenderDrawColor(w->renderer, (uint8_t)(colour >> 16), (uint8_t)(colour >> 8),
                           (uint8_t)colour, 255);
    SDL_RenderFillRect(w->renderer, &r);
}

/* Fills the room around the picture, each pixel once. */
static void fill_margins(window *w, const layout *at)
{
    const uint32_t dark = 0x0c1014;
    const SDL_Rect *p = &at->picture, *room = &at->room;
    const int end = room->x + room->w;
    const int top = SDL_max(p->y, 0), left = SDL_max(p->x, room->x);
    const int low = SDL_min(p->y + p->h, room->h), right = SDL_min(p->x + p->w, end);
    fill(w, room->x, 0, room->w, top, dark);
    fill(w, room->x, low, room->w, room->h - low, dark);
    fill(w, room->x, top, left - room->x, low - top, dark);
    fill(w, right, top, end - right, low - top, dark);
}

void window_clear(window *w, int scale)
{
    const layout at = window_layout(w, scale);
    SDL_SetRenderDrawBlendMode(w->renderer, SDL_BLENDMODE_NONE);
    if (w->texture) {
        fill_margins(w, &at);
        SDL_RenderSetClipRect(w->renderer, &at.room);
        SDL_RenderCopy(w->renderer, w->texture, NULL, &at.picture);
        SDL_RenderSetClipRect(w->renderer, NULL);
    } else {
        fill(w, at.room.x, 0, at.room.w, at.room.h, 0x0c1014);
    }
    fill(w, at.bar.x, 0, at.bar.w, at.bar.h, 0x262c34);
    fill(w, at.bar.x + BAR / 2 - 1, at.bar.h / 2 - 16, at.bar.w ? 2 : 0, 32,
         w->dragged || w->over ? 0x7ab8e6 : 0x5a646e);
    fill(w, at.panel.x, 0, at.panel.w, at.panel.h, 0x14181e);
}

/* The panel sets cursors of its own while being drawn: sets the bar's cursor again. */
void window_present(window *w)
{
    if (w->over && w->across && SDL_GetCursor() != w->across)
        SDL_SetCursor(w->across);
    SDL_RenderPresent(w->renderer);
}
