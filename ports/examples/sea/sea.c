/* SPDX-License-Identifier: MIT */
/* A sea in a window of SDL2.  A camera circles a buoy, which passing crests hide; the graph
 * shows the water's height there in the last four seconds.  Escape ends the program.
 *     make lib
 *     cc -O2 -Iinclude ports/examples/sea/sea.c build/host/libtidepool.a \
 *         $(pkg-config --cflags --libs sdl2) -o sea && ./sea
 *
 * `./sea 300 sea.bmp` draws 300 pictures as fast as it can and saves the last one. */
#include <SDL.h>
#include <stdlib.h>
#include <string.h>
#include "tidepool/tidepool.h"

enum { WIDTH = 640, HEIGHT = 480, SPRITE_W = 16, SPRITE_H = 24 };
enum { GRAPH_X = 16, GRAPH_Y = 408, GRAPH_W = 240, GRAPH_H = 56 };

static const char sprite[SPRITE_H][SPRITE_W + 1] = {
    "       yy       ", "      yyyy      ", "      yyyy      ", "       kk       ",
    "       kk       ", "      kkkk      ", "      rrrd      ", "      rrrd      ",
    "      rrrd      ", "     wwwwss     ", "     wwwwss     ", "     wwwwss     ",
    "     rrrrdd     ", "    rrrrrddd    ", "    rrrrrddd    ", "    wwwwwsss    ",
    "    wwwwwsss    ", "  kkkkkkkkkkkk  ", "  rrrrrrrrdddd  ", " rrrrrrrrrrdddd ",
    " rrrrrrrrrrdddd ", "  rrrrrrrrdddd  ", "   rrrrrrdddd   ", "    dddddddd    ",
};
static const char letters[] = " rdwsky";
static const uint32_t colours[] = { 0,          0xffe03c28, 0xffa42818, 0xfff4f0e4,
                                    0xffb8b8b0, 0xff302c30, 0xffffe070 };

static tp_scene scene;
static tp_fx foot_x, foot_y, top_x, top_y, depth; /* buoy in the picture, px; depth, m */
static bool in_view;
static int heights[GRAPH_W], newest; /* px above the graph's middle */

/* Draws one row of the buoy's sprite, sheared from foot to top; nearer water hides it. */
static void draw_buoy(const tp_overlay_row *row)
{
    const int64_t tall = (int64_t)foot_y - top_y,
                  up = foot_y - (int64_t)row->y * TP_FX_ONE;
    const int64_t wide = (tall * SPRITE_W / SPRITE_H) >> 16;
    uint32_t span[WIDTH];

    if (!in_view || up <= 0 || up >= tall || wide > WIDTH)
        return;
    const char *texels = sprite[SPRITE_H - 1 - up * SPRITE_H / tall];
    for (int64_t i = 0; i < wide; i++)
        span[i] = colours[strchr(letters, texels[i * SPRITE_W / wide]) - letters];
    const int64_t middle = foot_x + (top_x - (int64_t)foot_x) * up / tall;
    tp_overlay_span(row, (int32_t)((middle >> 16) - wide / 2), (uint32_t)wide, depth,
                    span);
}

/* Draws one row of the buoy, and of the graph over everything (depth 0). */
static void draw_row(void *user, const tp_overlay_row *row)
{
    const int y = GRAPH_Y + GRAPH_H / 2 - (int)row->y;
    uint32_t span[GRAPH_W];

    (void)user;
    draw_buoy(row);
    for (int i = 0; i < GRAPH_W; i++) {
        const int off = heights[(newest + 1 + i) % GRAPH_W] - y;
        span[i] = off * off < 4 ? 0xffffffff : y == 0 ? 0x60ffffff : 0x70081828;
    }
    if (row->y >= GRAPH_Y && row->y < GRAPH_Y + GRAPH_H)
        tp_overlay_span(row, GRAPH_X, GRAPH_W, 0, span);
}

/* Returns `part` times a sine with a period of `seconds`. */
static tp_fx swing(uint32_t tick, uint32_t seconds, tp_fx part)
{
    return tp_fx_mul(tp_fx_sin(tick * (UINT32_MAX / 60 / seconds)), part);
}

/* Moves the camera around the buoy, one turn in two minutes, 0.9 m above the water,
 * rolling by up to 6 degrees. */
static void move_camera(tp_world *world, uint32_t tick)
{
    tp_vec3 eye = { swing(tick, 120, TP_FX(17)), 0, swing(tick + 1800, 120, TP_FX(17)) };

    eye.y = tp_world_sample(NULL, world, eye.x, eye.z).height + TP_FX(0.9);
    tp_world_set_camera(world, eye, TP_DEG(4) - tick * (UINT32_MAX / 60 / 120), 0,
                        tp_turn_of_degrees(swing(tick, 7, TP_FX(6))));
}

/* Places the buoy in the water at the world's origin, perpendicular to the surface. */
static void place_buoy(tp_engine *sea)
{
    const tp_water water = tp_world_sample(NULL, tp_engine_world(sea), 0, 0);
    const tp_vec3 foot = { 0, water.height - TP_FX(0.4), 0 };
    const tp_vec3 top = { -2 * water.slope_x, foot.y + TP_FX(2.4), -2 * water.slope_z };

    in_view = tp_frame_project(tp_engine_frame(sea), top, &top_x, &top_y, &depth)
              && tp_frame_project(tp_engine_frame(sea), foot, &foot_x, &foot_y, &depth);
    newest = (newest + 1) % GRAPH_W;
    heights[newest] = water.height * 20 / TP_FX_ONE;
}

static void draw(tp_engine *sea, uint32_t tick, uint32_t *picture)
{
    tp_tile tile;

    scene.wave[0].amplitude = TP_FX(0.7) + swing(tick, 40, TP_FX(0.2));
    scene.wave[1].amplitude = TP_FX(0.25) - swing(tick, 40, TP_FX(0.1));
    tp_engine_apply(sea, NULL);
    tp_engine_step(sea, NULL);
    move_camera(tp_engine_world(sea), tick);
    tp_engine_begin(sea);
    place_buoy(sea);
    while (tp_engine_next_tile(sea, &tile))
        memcpy(picture + tile.y0 * WIDTH, tile.pixels, (tile.y1 - tile.y0) * tile.stride);
}

static bool has_quit_event(void)
{
    SDL_Event e;
    bool over = false;

    while (SDL_PollEvent(&e))
        over |= e.type == SDL_QUIT
                || (e.type == SDL_KEYDOWN && e.key.keysym.sym == SDLK_ESCAPE);
    return over;
}

int main(int argc, char **argv)
{
    static uint64_t memory[40 << 10];
    const tp_config config = { .width = WIDTH,
                               .height = HEIGHT,
                               .overlay = tp_overlay_make(draw_row, NULL) };
    const uint32_t end = argc == 3 ? (uint32_t)atoi(argv[1]) : UINT32_MAX;
    tp_engine *sea;

    tp_scene_init(&scene);
    scene.wave[0].length = TP_FX(24);
    if (tp_engine_init(&sea, &config, &scene, memory, sizeof memory, NULL)
        || SDL_Init(SDL_INIT_VIDEO))
        return 1;
    SDL_Window *window = SDL_CreateWindow("sea", 0, 0, WIDTH, HEIGHT, 0);
    SDL_Surface *picture = SDL_CreateRGBSurface(0, WIDTH, HEIGHT, 32, 0, 0, 0, 0);
    if (window == NULL || picture == NULL)
        return 1;
    for (uint32_t tick = 0; tick < end && !has_quit_event(); tick++) {
        draw(sea, tick, picture->pixels);
        SDL_BlitSurface(picture, NULL, SDL_GetWindowSurface(window), NULL);
        SDL_UpdateWindowSurface(window);
        while (argc != 3 && SDL_GetTicks() < tick * 1000ull / 60)
            SDL_Delay(1);
    }
    return argc == 3 && SDL_SaveBMP(picture, argv[2]) != 0;
}
