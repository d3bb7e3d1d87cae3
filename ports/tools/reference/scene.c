/* SPDX-License-Identifier: MIT */
/* Reads a scene and its world. */
#include "scene.h"
#include <stdlib.h>
#include <string.h>
#include "caustics.h"
#include "features/drops/drops.h"
#include "foam.h"
#include "solids.h"
#include "spray.h"
#include "world/world.h"

static ref_vec between(tp_vec3 last, tp_vec3 now, double back)
{
    const ref_vec a = ref_vec_make(now), b = ref_vec_make(last);
    return ref_plus(a, ref_times_vec(ref_sub(b, a), back));
}

/* Interpolates angles along the shorter arc. */
static tp_turn interpolate_turn(tp_turn last, tp_turn now, double back)
{
    return now + (tp_turn)(int64_t)floor((int32_t)(last - now) * back);
}

static void place_light(ref_scene *s, const tp_scene *scene, const tp_world *world,
                        double back)
{
    const double turn = 2 * PI / 4294967296.0;
    const double heading = turn * interpolate_turn(world->last_light_heading,
                                               world->light_heading, back);
    const double height = turn * interpolate_turn(world->last_light_elevation,
                                              world->light_elevation, back);

    s->light = (ref_vec){ cos(height) * sin(heading), sin(height),
                          -cos(height) * cos(heading) };
    s->ambient = ref_number(scene->light.ambient);
    s->haze = ref_number(scene->sky.haze);
    s->exposure = 1;
    if (scene->hdr.exposure == TP_EXPOSURE_AUTO || scene->hdr.exposure_factor != TP_FX_ONE)
        s->exposure = ref_number(world->exposure)
                    + back * (ref_number(world->last_exposure)
                              - ref_number(world->exposure));
}

/* Rolls the camera about its axis ahead: the right side sinks. */
static void roll_camera(ref_camera *camera, tp_turn roll)
{
    const double angle = (int32_t)roll * (6.283185307179586476925 / 4294967296.0);
    const ref_vec right = camera->right, up = camera->up;

    camera->right =
        ref_plus(ref_times_vec(right, cos(angle)), ref_times_vec(up, -sin(angle)));
    camera->up =
        ref_plus(ref_times_vec(up, cos(angle)), ref_times_vec(right, sin(angle)));
}

/* Places the camera; a camera on deck moves with the boat, which must be placed first. */
static void place_camera(ref_scene *s, const tp_world *world, uint32_t width,
                         uint32_t height, double back)
{
    s->camera = ref_camera_make(world->eye,
                              interpolate_turn(world->last_heading, world->heading, back),
                              interpolate_turn(world->last_pitch, world->pitch, back),
                              s->scene->camera.fov, s->scene->camera.near, width, height);
    s->camera.eye = between(world->last_eye, world->eye, back);
    roll_camera(&s->camera, interpolate_turn(world->last_roll, world->roll, back));
    if (world->aboard != TP_ABOARD_DECK)
        return;
    s->camera.eye =
        ref_plus(s->boat_place, ref_local_to_world(&s->boat_rows, s->camera.eye));
    s->camera.right = ref_local_to_world(&s->boat_rows, s->camera.right);
    s->camera.up = ref_local_to_world(&s->boat_rows, s->camera.up);
    s->camera.ahead = ref_local_to_world(&s->boat_rows, s->camera.ahead);
}

static void place_boat(ref_scene *s, const tp_world *world, double back)
{
    const tp_pose *a = &world->last_boat, *b = &world->boat;
    const tp_mesh *mesh = s->assets->boat;
    const double scale = ldexp(ref_number(s->scene->boat.scale),
                               mesh ? (int)mesh->log2_unit : 0);

    s->boat = ref_mesh_make(mesh, scale, false);
    s->lids = ref_mesh_make(mesh, scale, true);
    s->boat_rows = ref_rows_make(interpolate_turn(a->heading, b->heading, back),
                               interpolate_turn(a->pitch, b->pitch, back),
                               interpolate_turn(a->roll, b->roll, back));
    s->boat_place = between(a->place, b->place, back);
}

ref_camera ref_scene_camera(const tp_scene *scene, const tp_world *world, uint32_t width,
                            uint32_t height)
{
    const double back = ref_number(world->lag);
    const tp_assets none = { 0 };
    ref_scene s = { .scene = scene, .assets = &none };

    place_boat(&s, world, back);
    place_camera(&s, world, width, height, back);
    ref_mesh_free(&s.boat);
    ref_mesh_free(&s.lids);
    return s.camera;
}

/* A drop keeps its volume: with the aspect a = height / width, the width scales with
 * a^(-1/3). */
static ref_drop interpolate_drop(const tp_drop *drop, double back)
{
    const double a = 1 + fmax(-0.5, fmin(0.5, drop->squash / 16384.0));
    const double radius = ref_number(drop->radius);
    return (ref_drop){ between(drop->last, drop->place, back), radius / cbrt(a),
                       radius * cbrt(a * a) };
}

static void place_drops(ref_scene *s, const tp_drops *drops, double back)
{
    const double radius = ref_number(drops->sphere_radius);

    s->drop = calloc(drops->count + 1, sizeof *s->drop);
    if (!s->drop)
        abort();
    for (uint32_t i = 0; i < drops->count; i++)
        s->drop[s->drops++] = interpolate_drop(&tp_drops_list(drops)[i], back);
    s->drop[s->drops++] = (ref_drop){ between(drops->last_sphere, drops->sphere, back),
                                      radius, radius };
}

static void place_tank(ref_scene *s)
{
    const tp_scene *scene = s->scene;
    const double side = ref_number(scene->pool.cell) / 2;

    s->tank = (ref_tank){
        .kind = scene->pool.cols > 0 ? scene->tank.kind : TP_TANK_NONE,
        .x0 = ref_number(scene->pool.x) - side * scene->pool.cols,
        .x1 = ref_number(scene->pool.x) + side * scene->pool.cols,
        .z0 = ref_number(scene->pool.z) - side * scene->pool.rows,
        .z1 = ref_number(scene->pool.z) + side * scene->pool.rows,
        .depth = ref_number(scene->tank.depth), .rim = ref_number(scene->tank.rim),
    };
}

/* Adds the stone walls around the water. A glass tank has no walls for an eye outside. */
static void add_walls(ref_scene *s)
{
    const ref_tank *b = &s->tank;
    const ref_vec e = s->camera.eye;
    const double half = fmin(b->x1 - b->x0, b->z1 - b->z0) / 2;
    const bool glass = b->kind == TP_TANK_GLASS;
    const double t = glass ? fmax(1 / 128.0, fmin(0.125, half / 80))
                           : fmax(1 / 32.0, fmin(1, half / 12));
    const double low = -b->depth, high = b->rim;

    if (!(glass && e.x > b->x1))
        s->block[s->blocks++] = (ref_block){ b->x1, b->x1 + t, low, high, b->z0 - t,
                                             b->z1 + t };
    if (!(glass && e.x < b->x0))
        s->block[s->blocks++] = (ref_block){ b->x0 - t, b->x0, low, high, b->z0 - t,
                                             b->z1 + t };
    if (!(glass && e.z > b->z1))
        s->block[s->blocks++] = (ref_block){ b->x0 - t, b->x1 + t, low, high, b->z1,
                                             b->z1 + t };
    if (!(glass && e.z < b->z0))
        s->block[s->blocks++] = (ref_block){ b->x0 - t, b->x1 + t, low, high, b->z0 - t,
                                             b->z0 };
}

/* Adds a row's wall cells as blocks, run by run; three cells high where no rim is given. */
static void add_row(ref_scene *s, const ref_cells *c, int row, double low, double high)
{
    for (int col = 0, end; col < c->cols; col = end) {
        const bool wall = c->wall[row * c->cols + col];
        for (end = col + 1; end < c->cols && c->wall[row * c->cols + end] == wall; )
            end++;
        if (!wall)
            continue;
        s->block[s->blocks++] = (ref_block){ c->x + col * c->cell, c->x + end * c->cell,
                                             low, high, c->z + row * c->cell,
                                             c->z + (row + 1) * c->cell };
    }
}

static void place_blocks(ref_scene *s)
{
    const ref_cells *c = &s->surface.relief.cells[0];
    const bool tank = s->tank.kind != TP_TANK_NONE;
    const double low = tank ? -s->tank.depth : -ref_number(s->scene->pool.max_height);
    const double high = tank ? s->tank.rim : 3 * c->cell;

    s->block = calloc((size_t)(c->rows * (c->cols / 2 + 1) + 4), sizeof *s->block);
    if (!s->block)
        abort();
    if (tank)
        add_walls(s);
    for (int row = 0; row < c->rows && s->scene->pool.mask[0]; row++)
        add_row(s, c, row, low, high);
}

/* True if the eye is under water. Beside a tank there is no water. */
static bool is_sunk(const ref_scene *s)
{
    const ref_vec e = s->camera.eye;
    const ref_tank *b = &s->tank;
    double rest[2] = { e.x, e.z };

    if (b->kind != TP_TANK_NONE
        && (e.x <= b->x0 || e.x >= b->x1 || e.z <= b->z0 || e.z >= b->z1))
        return false;
    return e.y < ref_surface_height(&s->surface, e.x, e.z, rest, 1e-9);
}

void ref_scene_open(ref_scene *s, const tp_scene *scene, const tp_assets *assets,
                    const tp_world *world, uint32_t width, uint32_t height, bool meshed)
{
    const double back = ref_number(world->lag);

    memset(s, 0, sizeof *s);
    s->scene = scene;
    s->assets = assets;
    s->meshed = meshed;
    s->seconds = ((double)world->tick - back) / TP_TICKS_PER_SECOND;
    place_light(s, scene, world, back);
    place_boat(s, world, back);
    place_camera(s, world, width, height, back);
    if (tp_world_drops(world))
        place_drops(s, tp_world_drops(world), back);
    place_tank(s);
    s->surface = ref_surface_make(scene, world, s->camera.eye);
    place_blocks(s);
    s->immersion = is_sunk(s);
    ref_swash_open(s, world);
    ref_foam_open(s, world);
    ref_spray_open(s, world);
    s->caustics = ref_caustics_make(s);
}

void ref_scene_close(ref_scene *s)
{
    ref_surface_free(&s->surface);
    ref_mesh_free(&s->boat);
    ref_mesh_free(&s->lids);
    free(s->drop);
    free(s->speck);
    free(s->block);
    ref_caustics_free(s->caustics);
}
