/* SPDX-License-Identifier: MIT */
/* Draws with SDL_RenderGeometry and SDL's software renderer: affine texture coordinates, no
 * depth test, no repeat. The texture is therefore repeated beforehand, far rows are drawn
 * first, and points behind the eye are left out. The frame transforms the points; the waves
 * are computed before. */
#include <SDL.h>
#include <stdio.h>
#include <stdlib.h>
#include "peer.h"

enum { REPEATS = 8, SIDE = BENCH_MAP * REPEATS };

typedef struct {
    peer_job      job;
    SDL_Surface  *surface;
    SDL_Renderer *renderer;
    SDL_Texture  *texture;
    SDL_Vertex   *vertex;
    int          *index;
    float         turn[3][3], focal, light[3];
} sdl;

static void stop(const char *what)
{
    fprintf(stderr, "sdl: %s: %s\n", what, SDL_GetError());
    exit(1);
}

static void repeat_picture(sdl *s)
{
    static uint32_t texels[SIDE * SIDE];
    const uint32_t *one = s->job.s.map[BENCH_MOTTLE].level[0];
    for (uint32_t i = 0; i < SIDE * SIDE; i++)
        texels[i] = one[i / SIDE % BENCH_MAP * BENCH_MAP + i % BENCH_MAP];
    s->texture = SDL_CreateTexture(s->renderer, SDL_PIXELFORMAT_ARGB8888,
                                   SDL_TEXTUREACCESS_STATIC, SIDE, SIDE);
    if (!s->texture || SDL_UpdateTexture(s->texture, NULL, texels, SIDE * 4))
        stop("texture");
    SDL_SetTextureScaleMode(s->texture, SDL_ScaleModeNearest);
}

/* Light of the surface on white. */
static Uint8 lit(const sdl *s, const peer_point *p)
{
    const float *l = s->light, sx = p->slope[0], sz = p->slope[1];
    const float ambient = peer_metres(s->job.s.scene.light.ambient);
    float nl = (l[1] - sx * l[0] - sz * l[2]) / SDL_sqrtf(1 + sx * sx + sz * sz);
    nl = nl < 0 ? 0 : nl;
    return (Uint8)(255 * (ambient + (1 - ambient) * nl) + 0.5f);
}

static void transform(sdl *s)
{
    const tp_scene *scene = &s->job.s.scene;
    const float w = (float)s->job.width, h = (float)s->job.height;
    const float up = peer_metres(scene->camera.y), back = peer_metres(scene->camera.z);
    const uint32_t count = s->job.points * s->job.points;
    for (uint32_t i = 0; i < count; i++) {
        const peer_point *p = &s->job.mesh[i];
        float at[3];
        for (int k = 0; k < 3; k++)
            at[k] = s->turn[k][0] * p->place[0]
                  + s->turn[k][1] * (p->place[1] - up)
                  + s->turn[k][2] * (p->place[2] - back);
        const float scale = at[2] < -0.25f ? s->focal * h / 2 / -at[2] : 0;
        const Uint8 grey = lit(s, p);
        s->vertex[i] = (SDL_Vertex){
            { w / 2 + at[0] * scale, scale > 0 ? h / 2 - at[1] * scale : 4 * h },
            { grey, grey, grey, 255 },
            { p->rest[0] / 20 + 0.5f, p->rest[1] / 20 + 0.5f },
        };
    }
}

static void draw(void *user)
{
    sdl *s = user;
    const int32_t sky = s->job.s.scene.sky.zenith;
    SDL_SetRenderDrawColor(s->renderer, (Uint8)(sky >> 16), (Uint8)(sky >> 8), (Uint8)sky,
                           255);
    SDL_RenderClear(s->renderer);
    transform(s);
    if (SDL_RenderGeometry(s->renderer, s->texture, s->vertex,
                           (int)(s->job.points * s->job.points), s->index,
                           (int)s->job.indices))
        stop("geometry");
    SDL_RenderFlush(s->renderer);
}

/* Far rows first: the job's order reversed. */
static void order(sdl *s)
{
    const uint32_t n = s->job.indices;
    s->vertex = malloc((size_t)s->job.points * s->job.points * sizeof *s->vertex);
    s->index = malloc(n * sizeof *s->index);
    if (!s->vertex || !s->index)
        stop("memory");
    for (uint32_t i = 0; i < n; i++)
        s->index[i] = (int)s->job.index[n - 1 - i];
}

int main(int argc, char **argv)
{
    static sdl s;
    peer_begin(&s.job, argc, argv);
    peer_camera(&s.job, s.turn, &s.focal);
    peer_light(&s.job, s.light);
    s.surface = SDL_CreateRGBSurfaceWithFormat(0, (int)s.job.width, (int)s.job.height, 32,
                                               SDL_PIXELFORMAT_XRGB8888);
    s.renderer = s.surface ? SDL_CreateSoftwareRenderer(s.surface) : NULL;
    if (!s.renderer)
        stop("renderer");
    repeat_picture(&s);
    order(&s);
    const int code = peer_run(&s.job, draw, &s, s.surface->pixels);
    free(s.vertex);
    free(s.index);
    SDL_DestroyRenderer(s.renderer);
    SDL_FreeSurface(s.surface);
    return code;
}
