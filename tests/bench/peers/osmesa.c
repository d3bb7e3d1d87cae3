/* SPDX-License-Identifier: MIT */
/* Draws with Mesa's software renderers by OSMesa; GALLIUM_DRIVER is llvmpipe or softpipe. A
 * frame is a clear, the upload of the points, the draw calls and a finish. The computation
 * of the waves is not timed, which favours these renderers. */
#define GL_GLEXT_PROTOTYPES
#include <GL/osmesa.h>
#include <GL/glext.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "peer.h"

#define FOLDER "tests/bench/peers/"

enum { LAYER0, LAYER1, LAYER2, BEND, RIPPLE, MAPS };

typedef struct {
    peer_job job;
    GLuint   sea, sky, points;
    uint32_t *pixels;
} gl;

static void stop(const char *what, const char *why)
{
    fprintf(stderr, "osmesa: %s: %s\n", what, why);
    exit(1);
}

/* -- shaders --------------------------------------------------------------------- */

static GLuint shader(GLenum kind, const char *name)
{
    static char text[8192], log[1024];
    const char *source = text;
    char path[128];
    GLint good;
    snprintf(path, sizeof path, FOLDER "%s", name);
    FILE *f = fopen(path, "r");
    if (!f)
        stop(path, "cannot be read; start it in the project's folder");
    text[fread(text, 1, sizeof text - 1, f)] = 0;
    fclose(f);
    const GLuint s = glCreateShader(kind);
    glShaderSource(s, 1, &source, NULL);
    glCompileShader(s);
    glGetShaderiv(s, GL_COMPILE_STATUS, &good);
    glGetShaderInfoLog(s, sizeof log, NULL, log);
    if (!good)
        stop(path, log);
    return s;
}

static GLuint program(const char *vertex, const char *fragment)
{
    GLint good;
    const GLuint p = glCreateProgram();
    glAttachShader(p, shader(GL_VERTEX_SHADER, vertex));
    glAttachShader(p, shader(GL_FRAGMENT_SHADER, fragment));
    glLinkProgram(p);
    glGetProgramiv(p, GL_LINK_STATUS, &good);
    if (!good)
        stop(fragment, "does not link");
    return p;
}

static GLint name(GLuint p, const char *uniform)
{
    return glGetUniformLocation(p, uniform);
}

static void set(GLuint p, const char *uniform, float x)
{
    glUniform1f(name(p, uniform), x);
}

static void set_colour(GLuint p, const char *uniform, int32_t c)
{
    glUniform3f(name(p, uniform), (float)(c >> 16 & 255) / 255,
                (float)(c >> 8 & 255) / 255, (float)(c & 255) / 255);
}

/* -- pictures -------------------------------------------------------------------- */

static void upload(const tp_texture *t, int unit, bool linear)
{
    GLuint id;
    glGenTextures(1, &id);
    glActiveTexture(GL_TEXTURE0 + (GLenum)unit);
    glBindTexture(GL_TEXTURE_2D, id);
    for (int l = 0; l < t->levels; l++)
        glTexImage2D(GL_TEXTURE_2D, l, GL_RGBA8, 1 << (t->log2_w - l),
                     1 << (t->log2_h - l), 0, GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV,
                     t->level[l]);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER,
                    linear ? GL_LINEAR_MIPMAP_NEAREST : GL_NEAREST_MIPMAP_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER,
                    linear ? GL_LINEAR : GL_NEAREST);
}

/* OpenGL's cube faces are seen from outside with their own right and down, so each texel is
 * found by its direction: (x, y, z) of OpenGL's face at right r and down d, -1..1. */
static void way_of(int face, int r, int d, int one, int way[3])
{
    const int ways[6][3] = { { one, -d, -r }, { -one, -d, r }, { r, one, d },
                             { r, -one, -d }, { r, -d, one }, { -r, -d, -one } };
    memcpy(way, ways[face], sizeof ways[face]);
}

/* Place of the same direction on the engine's face: right and down (src/shade/env.h). */
static void place_of(int face, const int way[3], int *r, int *d)
{
    const int x = way[0], y = way[1], z = way[2];
    *r = face == 0 ? z : face == 1 ? -z : face == 5 ? x : -x;
    *d = face == 2 ? z : face == 3 ? -z : -y;
}

static void upload_sky(const bench_scene *s, int unit)
{
    static uint32_t texels[BENCH_FACE * BENCH_FACE];
    GLuint id;
    glGenTextures(1, &id);
    glActiveTexture(GL_TEXTURE0 + (GLenum)unit);
    glBindTexture(GL_TEXTURE_CUBE_MAP, id);
    for (int face = 0; face < 6; face++) {
        for (int i = 0; i < BENCH_FACE * BENCH_FACE; i++) {
            int way[3], r, d;
            way_of(face, 2 * (i % BENCH_FACE) + 1 - BENCH_FACE,
                   2 * (i / BENCH_FACE) + 1 - BENCH_FACE, BENCH_FACE, way);
            place_of(face, way, &r, &d);
            texels[i] = s->face[face].level[0][(d + BENCH_FACE) / 2 * BENCH_FACE
                                               + (r + BENCH_FACE) / 2];
        }
        glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + (GLenum)face, 0, GL_RGBA8,
                     BENCH_FACE, BENCH_FACE, 0, GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV,
                     texels);
    }
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

/* Logarithm of the engine: linear between powers of two. */
static float rough_log2(float x)
{
    int e;
    const float m = frexpf(x, &e);
    return (float)(e - 1) + 2 * m - 1;
}

/* Sets a texture map: repeats a metre, the drift at BENCH_TICK, and the mipmap level at 1 m
 * (src/frame/shader_list.c). */
static void set_map(const gl *g, int unit, const char *sampler, const char *how,
                    const tp_texture *texture, const tp_scene_map *map, bool linear,
                    float coarser)
{
    const bench_scene *s = &g->job.s;
    const float size = peer_metres(map->size), seconds = BENCH_TICK / 60.0f;
    float turn[3][3], focal;
    peer_camera(&g->job, turn, &focal);
    const float pixels = focal * (float)g->job.height / 2;
    const float level = rough_log2(BENCH_MAP / size) - rough_log2(pixels)
                      - rough_log2(peer_metres(s->scene.camera.y)) / 2 + coarser;
    upload(texture, unit, linear);
    glUniform1i(name(g->sea, sampler), unit);
    glUniform4f(name(g->sea, how), 1 / size, -seconds * peer_metres(map->drift_x) / size,
                -seconds * peer_metres(map->drift_z) / size, level);
}

static void set_maps(const gl *g)
{
    const bench_scene *s = &g->job.s;
    const bool linear = g->job.work == BENCH_SMOOTH;
    const char *const names[] = { "layer0", "layer1", "layer2" };
    const char *const hows[] = { "map0", "map1", "map2" };
    const int layers = g->job.work == BENCH_PLAIN ? 1 : TP_LAYERS;
    for (int i = 0; i < layers; i++)
        set_map(g, LAYER0 + i, names[i], hows[i], s->assets.layer[i],
                &s->scene.layer[i].map, linear, 0);
    if (g->job.work == BENCH_PLAIN)
        return;
    set_map(g, BEND, "bend", "map_bend", s->assets.distortion, &s->scene.distortion.map,
            true, 0);
    set_map(g, RIPPLE, "ripple", "map_ripple", s->assets.ripple, &s->scene.ripple.map,
            true, 224.0f / 256);
    upload_sky(s, MAPS);
}

/* -- camera and light ------------------------------------------------------------- */

/* Matrices in column-major order, OpenGL's order. */
static void set_camera(const gl *g)
{
    const tp_scene *s = &g->job.s.scene;
    const float near = 0.25f, far = 100, aspect = (float)g->job.width
                                                / (float)g->job.height;
    const float eye[3] = { 0, peer_metres(s->camera.y), peer_metres(s->camera.z) };
    float t[3][3], focal, view[16], rays[16] = { 0 };
    peer_camera(&g->job, t, &focal);
    const float scale[3] = { focal / aspect, focal, (far + near) / (near - far) };
    for (int row = 0; row < 4; row++) {
        const float *axis = t[row < 3 ? row : 2];
        const float by = row < 3 ? scale[row] : -1;
        for (int k = 0; k < 3; k++)
            view[4 * k + row] = by * axis[k];
        view[12 + row] = -by * (axis[0] * eye[0] + axis[1] * eye[1] + axis[2] * eye[2]);
    }
    view[14] += 2 * far * near / (near - far);
    for (int k = 0; k < 3; k++) {
        rays[k] = t[0][k] / scale[0];
        rays[4 + k] = t[1][k] / scale[1];
        rays[8 + k] = -t[2][k];
    }
    glUseProgram(g->sea);
    glUniformMatrix4fv(name(g->sea, "view"), 1, GL_FALSE, view);
    glUniform3fv(name(g->sea, "eye"), 1, eye);
    if (!g->sky)
        return;
    glUseProgram(g->sky);
    glUniformMatrix4fv(name(g->sky, "rays"), 1, GL_FALSE, rays);
    glUniform1i(name(g->sky, "sky"), MAPS);
    set(g->sky, "exposure", peer_metres(s->hdr.exposure_factor));
}

/* The tint is the product of both colours; the engine's colours have 8 bits. */
static void set_water(const gl *g)
{
    const tp_scene *s = &g->job.s.scene;
    float light[3];
    peer_light(&g->job, light);
    glUseProgram(g->sea);
    glUniform3fv(name(g->sea, "light"), 1, light);
    set(g->sea, "ambient", peer_metres(s->light.ambient));
    set_colour(g->sea, "colour0", s->water.colour);
    set_colour(g->sea, "colour1", s->layer[1].colour);
    set_colour(g->sea, "colour2", s->layer[2].colour);
    set(g->sea, "strength", peer_metres(s->distortion.strength));
    set(g->sea, "bump", peer_metres(s->ripple.bump));
    set(g->sea, "specular", peer_metres(s->water.specular));
    set(g->sea, "shininess", peer_metres(s->water.shininess));
    set(g->sea, "reflection", peer_metres(s->water.reflection));
    set(g->sea, "exposure", peer_metres(s->hdr.exposure_factor));
    glUniform1i(name(g->sea, "sky"), MAPS);
    set_maps(g);
}

/* -- frames ------------------------------------------------------------------------ */

static void set_points(gl *g)
{
    const GLsizei stride = sizeof(peer_point);
    GLuint array, index;
    glGenVertexArrays(1, &array);
    glBindVertexArray(array);
    glGenBuffers(1, &g->points);
    glGenBuffers(1, &index);
    glBindBuffer(GL_ARRAY_BUFFER, g->points);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, stride, NULL);
    glVertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, stride,
                          (void *)offsetof(peer_point, rest));
    glVertexAttribPointer(2, 2, GL_FLOAT, GL_FALSE, stride,
                          (void *)offsetof(peer_point, slope));
    for (GLuint i = 0; i < 3; i++)
        glEnableVertexAttribArray(i);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, index);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, g->job.indices * sizeof *g->job.index,
                 g->job.index, GL_STATIC_DRAW);
}

static void draw(void *user)
{
    const gl *g = user;
    const size_t points = (size_t)g->job.points * g->job.points;
    const uint32_t sky = (uint32_t)g->job.s.scene.sky.zenith;
    glClearColor((float)(sky >> 16 & 255) / 255, (float)(sky >> 8 & 255) / 255,
                 (float)(sky & 255) / 255, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glUseProgram(g->sea);
    glBufferData(GL_ARRAY_BUFFER, (GLsizeiptr)(points * sizeof *g->job.mesh), g->job.mesh,
                 GL_STREAM_DRAW);
    glDrawElements(GL_TRIANGLES, (GLsizei)g->job.indices, GL_UNSIGNED_INT, NULL);
    if (g->sky) {
        glUseProgram(g->sky);
        glDrawArrays(GL_TRIANGLES, 0, 3);
    }
    glFinish();
}

static void open_context(gl *g)
{
    static const int wanted[] = { OSMESA_FORMAT, OSMESA_BGRA, OSMESA_DEPTH_BITS, 16,
                                  OSMESA_PROFILE, OSMESA_CORE_PROFILE,
                                  OSMESA_CONTEXT_MAJOR_VERSION, 3,
                                  OSMESA_CONTEXT_MINOR_VERSION, 3, 0 };
    const GLsizei w = (GLsizei)g->job.width, h = (GLsizei)g->job.height;
    OSMesaContext context = OSMesaCreateContextAttribs(wanted, NULL);
    g->pixels = malloc((size_t)w * (size_t)h * 4);
    if (!context || !g->pixels
        || !OSMesaMakeCurrent(context, g->pixels, GL_UNSIGNED_BYTE, w, h))
        stop("OpenGL 3.3", "there is none");
    OSMesaPixelStore(OSMESA_Y_UP, 0);
    fprintf(stderr, "%s", getenv("BENCH_VERBOSE") ? (const char *)glGetString(GL_RENDERER)
                                                  : "");
}

int main(int argc, char **argv)
{
    static gl g;
    peer_begin(&g.job, argc, argv);
    open_context(&g);
    g.sea = program("sea.vert", g.job.work == BENCH_PLAIN ? "plain.frag" : "water.frag");
    if (g.job.work != BENCH_PLAIN)
        g.sky = program("sky.vert", "sky.frag");
    set_camera(&g);
    set_water(&g);
    set_points(&g);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    return peer_run(&g.job, draw, &g, g.pixels);
}
