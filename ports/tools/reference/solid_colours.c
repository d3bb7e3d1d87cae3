/* SPDX-License-Identifier: MIT */
/* Colours of solids. */
#include "caustics.h"
#include "map.h"
#include "deep_water.h"
#include "mesh/mesh.h"
#include "sky_light.h"
#include "solids.h"
#include "world/world.h"

typedef struct {
    ref_colour diffuse, specular;
    double     shininess;
} coat;

static ref_vec unpack_dir(tp_packed_dir n)
{
    return (ref_vec){ tp_dir_x(n) / 511.0, tp_dir_y(n) / 511.0, tp_dir_z(n) / 511.0 };
}

/* Vector towards the sun; shorter than 1 under water, where the refracted beam is
 * narrower. */
static ref_vec sun_direction(const ref_scene *s, bool wet)
{
    ref_vec down;

    if (!wet || !ref_refracted(ref_times_vec(s->light, -1), (ref_vec){ 0, 1, 0 },
                               REF_INDEX, &down))
        return s->light;
    return ref_times_vec(down, -s->light.y / -down.y);
}

/* Specular lobe [F5]: Phong's, or Blinn's with four times the exponent. */
static double lobe(const ref_scene *s, double shininess, ref_vec n, ref_vec way,
                   ref_vec sun)
{
    const double nl = ref_dot(n, sun);
    const double rv = -2 * nl * ref_dot(n, way) + ref_dot(sun, way);

    if (nl <= 0)
        return 0;
    if (s->scene->light.model == TP_LIGHT_BLINN)
        return pow(ref_clamp(ref_dot(n, ref_unit_vec(ref_sub(sun, way))), 0, 1),
                   4 * shininess);
    return pow(ref_clamp(rv, 0, 1), shininess);
}

/* Phong shading of a material with normal `n` seen along `way`. The colour of the light tints
 * all light. A narrowed beam scales the diffuse light and the lobe; the width of the lobe
 * does not change. `focus`: factor of the diffuse sunlight. */
static ref_colour phong(const ref_scene *s, const coat *c, ref_vec n, ref_vec way,
                        ref_vec sun, double focus)
{
    const double nl = ref_clamp(ref_dot(n, sun), 0, 1), beam = sqrt(ref_dot(sun, sun));
    const ref_colour tint = ref_colour_unpack((uint32_t)s->scene->light.colour);
    const ref_colour matt = ref_scale(c->diffuse,
                                      s->ambient + (1 - s->ambient) * nl * focus);
    const ref_colour shine =
        ref_scale(c->specular,
                  beam > 0 ? beam * lobe(s, c->shininess, n, way, ref_unit_vec(sun)) : 0);

    return ref_add(ref_times(matt, tint), ref_times(shine, tint));
}

/* -- the boat ------------------------------------------------------------------------ */

/* Normal N bent by a normal map's texel along the tangent T and the bitangent B = +-N x
 * T. */
static ref_vec bent(ref_vec n, uint32_t texel, double bump, tp_packed_dir tangent)
{
    const ref_vec t = unpack_dir(tangent), b = ref_cross(n, t);
    const double hand = tangent & TP_TANGENT_MIRRORED ? -1 : 1;
    const double nx = ((int)(texel >> 16 & 255) - 128) * bump;
    const double ny = ((int)(texel >> 8 & 255) - 128) * bump * hand;
    const double nz = fmax((int)(texel & 255) - 128, 32);

    return ref_plus(ref_times_vec(n, nz),
                    ref_plus(ref_times_vec(t, nx), ref_times_vec(b, ny)));
}

typedef struct {
    double  s, t;
    ref_vec n;
} attributes;

static attributes interpolate_attributes(const tp_mesh *mesh, const ref_face_hit *hit)
{
    attributes a = { 0, 0, { 0, 0, 0 } };

    for (int k = 0; k < 3; k++) {
        const tp_mesh_vertex *v =
            &mesh->vertices[mesh->faces[hit->face].vertex[k]];
        a.s += hit->share[k] * v->s / 65536;
        a.t += hit->share[k] * v->t / 65536;
        a.n = ref_plus(a.n, ref_times_vec(unpack_dir(v->normal), hit->share[k]));
    }
    return a;
}

static ref_colour boat_colour(const ref_scene *s, const ref_solid *solid, ref_vec way,
                              ref_vec sun)
{
    const tp_mesh *mesh = s->boat.mesh;
    const tp_mesh_face *face = &mesh->faces[solid->face.face];
    const tp_material *m = &mesh->materials[face->material];
    const double texels = m->texels / 65536.0 / s->boat.scale;
    const attributes a = interpolate_attributes(mesh, &solid->face);
    coat c = { ref_colour_unpack(m->diffuse), ref_colour_unpack(m->specular),
               ref_clamp(floor(m->shininess / 65536.0), 1, 1000) };
    ref_vec n = a.n;

    const double lod = ref_lod(s, texels, ref_far(s, solid->at), 0) + 96 / 256.0;
    if (m->diffuse_map) {
        const int l = ref_level(s, m->diffuse_map, lod);
        c.diffuse = ref_times(ref_colour_unpack(ref_nearest(m->diffuse_map, l, a.s, a.t)),
                              c.diffuse);
    }
    if (m->normal_map) {
        const int l = ref_level(s, m->normal_map, lod);
        n = bent(n, ref_nearest(m->normal_map, l, a.s, a.t),
                 ref_clamp(m->bump / 65536.0, -16, 16), face->tangent);
    }
    return phong(s, &c, ref_unit_vec(n), ref_world_to_local(&s->boat_rows, way),
                 ref_world_to_local(&s->boat_rows, sun), 1);
}

/* -- drops --------------------------------------------------------------------------- */

/* Surroundings of a drop. Below the horizon lies water: the water's colour in ambient and
 * sun light, mixed with a quarter of the horizon's colour. The water blends with the
 * horizon within 14 degrees. */
static ref_colour around(const ref_scene *s, ref_vec d)
{
    const ref_colour sky = ref_heaven(s, (ref_vec){ d.x, fmax(d.y, 0), d.z });
    const ref_colour water = ref_scale(ref_colour_unpack((uint32_t)s->scene->water.colour),
                                       s->ambient + (1 - s->ambient) * s->light.y);
    return ref_mix(sky, ref_mix(water, sky, 0.25), ref_clamp(-4 * d.y, 0, 1));
}

/* Colour of a drop, a ball of water: the refracted ray leaves turned by 2 (i - r) towards
 * the centre [F4]; the reflection of the first surface and Phong's lobe are added. */
static ref_colour drop_colour(const ref_scene *s, ref_vec n, ref_vec way)
{
    const double c = ref_clamp(-ref_dot(n, way), 0, 1), i = acos(c);
    const double turn = 2 * (i - asin(sin(i) / REF_INDEX));
    const double aside = i > 1e-6 ? sin(turn) / sin(i) : 2 * (1 - 1 / REF_INDEX);
    const ref_vec across = ref_plus(n, ref_times_vec(way, c));
    const ref_vec on = ref_sub(ref_times_vec(way, cos(turn)),
                               ref_times_vec(across, aside));
    const ref_colour tint = ref_colour_unpack((uint32_t)s->scene->drops.colour);
    const double nl = ref_dot(n, s->light);
    const double rv = 2 * nl * c + ref_dot(s->light, way);

    return ref_add(ref_mix(ref_times(around(s, on), tint),
                           around(s, ref_reflected(way, n)),
                           ref_fresnel_reflectance(c, REF_INDEX)),
                   ref_scale(ref_colour_unpack((uint32_t)s->scene->light.colour),
                             nl > 0 ? pow(ref_clamp(rv, 0, 1), 40) : 0));
}

/* -- ground and walls ---------------------------------------------------------------- */

/* Texture laid over a plane in world metres, seen from a distance of `far` m. For the
 * ground the mipmap level also counts the slant of the view; the eye's height counts as at
 * least one metre. */
static ref_colour laid(const ref_scene *s, const tp_texture *t, int32_t colour,
                       tp_fx size, double u, double v, double far, bool ground)
{
    const double side = size / 65536.0;
    const ref_colour plain = ref_colour_unpack((uint32_t)colour);

    if (!t)
        return plain;
    const int l = ref_level(s, t, ref_lod(s, (1 << t->log2_w) / side,
                                          ref_rough_log2(fmax(far, 1.0 / 65536)),
                                          ground ? fabs(s->camera.eye.y) + 1 : 0));
    return ref_times(ref_linear(t, l, u / side, v / side), plain);
}

static ref_colour ground_colour(const ref_scene *s, const ref_solid *solid)
{
    const tp_scene *scene = s->scene;
    const ref_vec p = solid->at, n = solid->normal;

    if (solid->kind == REF_LAND)
        return laid(s, s->assets->floor_texture, scene->floor.colour,
                    scene->floor.texture_size, p.x, p.z, solid->far, true);
    if (solid->kind == REF_BED)
        return laid(s, s->assets->tank_floor, scene->tank.floor_colour, scene->tank.tile,
                    p.x, p.z, solid->far, true);
    return laid(s, s->assets->tank_wall, scene->tank.wall_colour, scene->tank.tile,
                fabs(n.x) > 0.5 ? p.z : p.x, fabs(n.y) > 0.5 ? p.z : -p.y,
                solid->far, false);
}

/* -- swash --------------------------------------------------------------------------- */

/* Phase of a wave `back` ticks before the world's tick, turns. */
static double wave_phase(const tp_swell *w, const tp_world *world, double back)
{
    return ldexp(w->phase, -32)
         - fmod(((double)world->tick - back) * ldexp((double)w->turns_tick, -64), 1);
}

void ref_swash_open(ref_scene *s, const tp_world *world)
{
    const double slope = s->assets->floor ? 0.1 : ref_number(s->scene->floor.slope);

    for (uint32_t i = 0; i < world->deep.count && !s->immersion; i++) {
        const tp_swell *w = &world->deep.swell[i];
        const double height = 2 * ref_number(w->amplitude);
        const double length = 1 / ldexp((double)w->turns, -32);
        const double up = fmin(slope * sqrt(height * length), 2 * height);
        if (up <= s->runup)
            continue;
        s->runup = up;
        s->swash = wave_phase(w, world, ref_number(world->lag));
    }
    if (s->scene->water.clarity <= 0 && !s->assets->floor_texture)
        s->runup = 0;
}

/* Sine of turns that a metre adds, as the engine counts them: 65536 n / 2^32. */
static double turns_sine(double turns)
{
    return sin(2 * PI * turns);
}

double ref_swash_height(const ref_scene *s, double x, double z)
{
    const double far = (x * 1771 + z * 2203) / 65536;
    const double near = (x * 7933 + z * 9973) / 65536;
    const double level = turns_sine(s->swash + turns_sine(far) / 8);

    return s->runup * (0.5 + 0.35 * level + 0.06 * turns_sine(near));
}

/* Colour of sand in and above the swash. */
static ref_colour wet_colour(const ref_scene *s, ref_colour colour, ref_vec at)
{
    const double front = ref_swash_height(s, at.x, at.z), high = s->runup / 10;
    const double lit = s->ambient + (1 - s->ambient) * ref_clamp(s->light.y, 0, 1);
    const ref_colour foam = ref_colour_unpack((uint32_t)s->scene->foam.colour);

    if (at.y > front)
        return ref_scale(colour, 1 - 90 / 256.0 * (s->runup - at.y) / (s->runup - front));
    colour = ref_mix(ref_scale(colour, 1 - 90 / 256.0),
                     ref_colour_unpack((uint32_t)s->scene->sky.horizon), 40 / 256.0);
    return ref_mix(colour, ref_scale(foam, (1 + lit) / 2),
                   200 / 256.0 * fmax(0, 1 - (front - at.y) / high));
}

ref_colour ref_solid_colour(const ref_scene *s, const ref_solid *solid, ref_vec way,
                            bool wet)
{
    const ref_vec sun = sun_direction(s, wet);

    if (solid->kind == REF_BOAT)
        return boat_colour(s, solid, way, sun);
    if (solid->kind == REF_DROP)
        return drop_colour(s, solid->normal, way);
    const coat c = { ground_colour(s, solid), { { 0, 0, 0 } }, 1 };
    const ref_colour colour = phong(s, &c, solid->normal, way, sun,
                                    wet ? ref_caustics_factor(s->caustics, solid->at) : 1);
    return solid->kind == REF_LAND && !wet && solid->at.y < s->runup
         ? wet_colour(s, colour, solid->at) : colour;
}
