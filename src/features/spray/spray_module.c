/* SPDX-License-Identifier: MIT */
/* Spray and bubbles.  A speck of spray falls with a drag proportional to its speed, as
 * fine drops do, and vanishes at the water.  A bubble rises slowly and bursts at the
 * surface.
 *
 * Crests are found at random places around the eye, more often close to the eye, since
 * far specks are too small to see.  Where the water breaks, or the Jacobian is below
 * SHARP, a few specks leave the water with the water's velocity and a random velocity of
 * their own.  A full list drops and counts new specks. */
#include "base/base.h"
#include "features/spray/spray.h"
#include "view/wave_models.h"
#include "waves/coastal_tables.h"
#include "waves/deep_water.h"
#include "world/module.h"
#include "world/world.h"

#define TICK(x)     ((x) / TP_TICKS_PER_SECOND)
#define SLOWER      TP_FX(0.9726)           /* e^(-1/60 s / 0.6 s), speed kept per tick */
#define KICK        TP_FX(0.016437)         /* 0.6 s (1 - SLOWER), times gravity */
#define SPRAY_AGE   (4 * TP_TICKS_PER_SECOND)
#define BUBBLE_AGE  (6 * TP_TICKS_PER_SECOND)
#define SPEED_MOST  (60 * TP_FX_ONE)        /* m/s */
#define FAR_MOST    (12000 * TP_FX_ONE)     /* m: far beyond drops, waves and flights */
#define REACH       40                      /* radius of the search around the eye, m */
#define SHARP       TP_FX(0.55)             /* threshold of the Jacobian */
#define TRIES       4                       /* specks of capacity per try in a tick */

static tp_speck *list(tp_spray *spray)
{
    return (tp_speck *)(void *)(spray + 1);
}

const tp_speck *tp_spray_list(const tp_spray *spray)
{
    return (const tp_speck *)(const void *)(spray + 1);
}

bool tp_spray_enabled(const tp_module_conditions *conditions)
{
    return conditions->scene->spray.count > 0;
}

static size_t bytes(const tp_module_conditions *conditions)
{
    return sizeof(tp_spray) + (size_t)conditions->scene->spray.count * sizeof(tp_speck);
}

/* Refuses drops whose spray the program lacks. */
static tp_status check(const tp_module_conditions *conditions, tp_error *err)
{
    const tp_wave_models *by = conditions->water;

    return by && conditions->scene->drops.count > 0 && !by->spray_splashes
               ? tp_program_fail_lacking("spray_splashes", err) : TP_OK;
}

static tp_status init(void *mine, tp_world *world, const tp_module_conditions *conditions,
                      tp_error *err)
{
    tp_spray *spray = mine;

    (void)world, (void)err;
    TP_ASSERT(conditions->scene->spray.count > 0);
    spray->capacity = (uint32_t)conditions->scene->spray.count;
    spray->random = 1;
    return TP_OK;
}

/* -- random numbers ------------------------------------------------------------------ */

/* Return a random number, 16.16: random_unit() 0..1, random_signed_unit() -1..1.  Call at
 * most one of them per expression: C leaves the order of two calls open, and compilers
 * differ. */
static tp_fx random_unit(tp_spray *spray)
{
    return (tp_fx)(tp_random(&spray->random) >> 16);
}

static tp_fx random_signed_unit(tp_spray *spray)
{
    return 2 * random_unit(spray) - TP_FX_ONE;
}

/* Returns random numbers: x and z in -1..1, y in 0..1. */
static tp_vec3 random_upward_vector(tp_spray *spray)
{
    tp_vec3 a;

    a.x = random_signed_unit(spray);
    a.y = random_unit(spray);
    a.z = random_signed_unit(spray);
    return a;
}

static void throw(tp_spray *spray, tp_vec3 place, tp_vec3 speed, tp_speck_kind kind)
{
    TP_ASSERT(spray->count <= spray->capacity);
    uint8_t chance = (uint8_t)(tp_random(&spray->random) >> 24);

    if (spray->count == spray->capacity) {
        spray->dropped++;
        return;
    }
    speed.x = tp_clamp(speed.x, -SPEED_MOST, SPEED_MOST);
    speed.y = tp_clamp(speed.y, -SPEED_MOST, SPEED_MOST);
    speed.z = tp_clamp(speed.z, -SPEED_MOST, SPEED_MOST);
    list(spray)[spray->count++] = (tp_speck){ .place = place, .last = place,
                                              .speed = speed, .kind = (uint8_t)kind,
                                              .chance = chance };
}

/* -- flight -------------------------------------------------------------------------- */

/* Returns the place after a tick, moved by the mean of two speeds. */
static tp_fx advance_coordinate(tp_fx place, tp_fx speed, tp_fx next_speed)
{
    return tp_fx_saturate((int64_t)place + TICK((speed + next_speed) / 2));
}

/* Advances a speck by one tick.  The equation v' = -g - v / 0.6 s has an exact solution
 * for a tick.  A bubble keeps its speed. */
static void advance_speck(tp_speck *s, tp_fx gravity)
{
    tp_vec3 v = s->speed, next = v, at = s->place;

    if (s->kind == TP_SPECK_SPRAY)
        next = (tp_vec3){ tp_fx_mul(v.x, SLOWER),
                          tp_fx_mul(v.y, SLOWER) - tp_fx_mul(gravity, KICK),
                          tp_fx_mul(v.z, SLOWER) };
    s->last = at;
    s->place = (tp_vec3){ advance_coordinate(at.x, v.x, next.x),
                          advance_coordinate(at.y, v.y, next.y),
                          advance_coordinate(at.z, v.z, next.z) };
    s->speed = next;
    s->age++;
}

/* True if a speck's life has ended.  Falling specks and bubbles are tested against the
 * water in turn, each every fourth tick. */
static bool has_speck_ended(const tp_speck *s, const tp_surface *surface)
{
    if (s->kind == TP_SPECK_BUBBLE)
        return s->age >= BUBBLE_AGE
               || ((s->age & 3) == 0
                   && s->place.y
                          >= tp_surface_rough_height(surface, s->place.x, s->place.z));
    return s->age >= SPRAY_AGE
           || (s->speed.y < 0 && (s->age & 3) == 0
               && s->place.y <= tp_surface_rough_height(surface, s->place.x, s->place.z));
}

static void step_specks(tp_spray *spray, const tp_scene *scene, const tp_surface *surface)
{
    for (uint32_t i = 0; i < spray->count; ) {
        tp_speck *s = &list(spray)[i];
        advance_speck(s, scene->water.gravity);
        if (has_speck_ended(s, surface))
            *s = list(spray)[--spray->count];
        else
            i++;
    }
}

/* -- crests -------------------------------------------------------------------------- */

/* Returns the Jacobian u.x w.z - u.z w.x from differences over half a metre, clamped to
 * +-8.  Water with spray never exceeds 8, since the highest waves of the table stand 256
 * m apart. */
static tp_fx jacobian_from_differences(tp_vec3 u, tp_vec3 w)
{
    int64_t across = ((int64_t)u.x * w.z * 4 + 0x8000) >> 16;
    int64_t along = ((int64_t)u.z * w.x * 4 + 0x8000) >> 16;

    return (tp_fx)tp_clamp_abs(across - along, 8 * TP_FX_ONE);
}

/* Returns the strength of spray at a rest position, 0 to about 1. */
static tp_fx coastal_spray_strength(const tp_surface *surface, tp_fx x, tp_fx z)
{
    const tp_fx d = TP_FX_ONE / 4;
    tp_coastal_point at =
        surface->by->coastal->breaking(surface->coastal, surface->phases, x, z);

    if (at.depth <= tp_coastal_breaking_foam_depth(surface->coastal) || at.position.y < 0)
        return at.breaking * 257;
    tp_vec3 u = tp_vec3_sub(tp_surface_displace(surface, x + d, z),
                            tp_surface_displace(surface, x - d, z));
    tp_vec3 w = tp_vec3_sub(tp_surface_displace(surface, x, z + d),
                            tp_surface_displace(surface, x, z - d));
    tp_fx jacobian = jacobian_from_differences(u, w);
    return jacobian < SHARP ? (SHARP - jacobian) * 4 : 0;
}

static tp_fx sample_spray_strength(const tp_surface *surface, tp_fx x, tp_fx z)
{
    if (surface->coastal)
        return coastal_spray_strength(surface, x, z);
    tp_fx jacobian = tp_deep_water_jacobian(surface->deep, surface->phases, x, z);
    return jacobian < SHARP ? (SHARP - jacobian) * 4 : 0;
}

/* Returns the velocity of the water particle with the rest position (x, z), m/s. */
static tp_vec3 sample_velocity(const tp_surface *now, const tp_surface *before, tp_fx x,
                               tp_fx z)
{
    tp_vec3 way =
        tp_vec3_sub(tp_surface_displace(now, x, z), tp_surface_displace(before, x, z));
    const int64_t rate = TP_TICKS_PER_SECOND;

    return (tp_vec3){ (tp_fx)tp_clamp_abs(way.x * rate, SPEED_MOST),
                      (tp_fx)tp_clamp_abs(way.y * rate, SPEED_MOST),
                      (tp_fx)tp_clamp_abs(way.z * rate, SPEED_MOST) };
}

/* Throws the specks of a crest.  Specks start scattered over +-1/3 m, with the water's
 * horizontal velocity times 1 to 2, and a random part upwards. */
static void throw_crest_specks(tp_spray *spray, const tp_surface *now,
                               const tp_surface *before, tp_fx x, tp_fx z, tp_fx strength)
{
    tp_vec3 from = tp_surface_displace(now, x, z),
            flow = sample_velocity(now, before, x, z);
    int32_t count = 3 + (tp_fx_mul(strength, 9 * TP_FX_ONE) >> 16);

    for (int32_t i = 0; i < count; i++) {
        tp_vec3 off = random_upward_vector(spray), own = random_upward_vector(spray);
        tp_vec3 place = { from.x + off.x / 3, from.y + off.y / 8, from.z + off.z / 3 };
        tp_fx more = TP_FX_ONE + random_unit(spray), lift = random_unit(spray);
        tp_fx up = tp_fx_mul(lift, own.y) + tp_fx_mul(strength, lift);
        tp_vec3 speed = { tp_fx_mul(flow.x, more) + own.x / 2,
                          flow.y + TP_FX(0.4) + 3 * up,
                          tp_fx_mul(flow.z, more) + own.z / 2 };
        throw(spray, place, speed, TP_SPECK_SPRAY);
    }
}

/* Tries random places around the eye.  A try succeeds with a probability equal to the
 * crest's strength; a crest of strength 1 throws specks at each try. */
static void throw_random_crests(tp_world *world, const tp_scene *scene, tp_spray *spray,
                                const tp_surface *now)
{
    tp_turn phases[TP_WAVES];
    tp_surface before = *now;
    tp_vec3  eye = tp_camera_interpolate(world, 0).eye;
    uint32_t tries = spray->capacity / TRIES + 1;

    if (scene->spray.crest <= 0 || (!now->coastal && world->deep.steepness_sum == 0))
        return;
    tp_deep_water_phases(&world->deep, world->tick - 1, 0, phases);
    before.phases = phases;
    for (uint32_t i = 0; i < tries; i++) {
        tp_turn way = tp_random(&spray->random);
        tp_fx far = random_unit(spray) * REACH;
        tp_fx x = eye.x + tp_q30_mul(far, tp_sin(way));
        tp_fx z = eye.z + tp_q30_mul(far, tp_cos(way));
        tp_fx strength = tp_fx_mul(sample_spray_strength(now, x, z), scene->spray.crest);
        if (strength > random_unit(spray))
            throw_crest_specks(spray, now, &before, x, z, tp_clamp(strength, 0, TP_FX_ONE));
    }
}

/* -- impacts and the bow ------------------------------------------------------------- */

static tp_vec3 offset_horizontally(tp_vec3 from, tp_turn heading, tp_fx distance)
{
    return (tp_vec3){ from.x + tp_q30_mul(distance, tp_sin(heading)), from.y,
                      from.z + tp_q30_mul(distance, tp_cos(heading)) };
}

/* Throws a crown of specks, and bubbles under it.  The crown rises to eight amplitudes of
 * the ring: its speed is sqrt(2 g 8 A). */
void tp_spray_splash(tp_spray *spray, const tp_scene *scene, const tp_impact *impact,
                     tp_fx level)
{
    int64_t square = (int64_t)scene->water.gravity * 16 * impact->amplitude >> 16;
    tp_fx up = tp_fx_sqrt(tp_fx_saturate(square)), radius = impact->length / 8;
    int32_t count = tp_fx_mul(scene->spray.impact, tp_clamp(up * 6, 0, 16 * TP_FX_ONE))
                    >> 16;
    tp_vec3 middle = { impact->x, level, impact->z };

    for (int32_t i = 0; i < count; i++) {
        tp_turn way = tp_random(&spray->random);
        tp_fx   part = TP_FX(0.5) + random_unit(spray) / 2;
        tp_vec3 out = offset_horizontally((tp_vec3){ 0, tp_fx_mul(up, part), 0 }, way,
                             tp_fx_mul(up, random_unit(spray) / 3 + TP_FX(0.1)));
        throw(spray, offset_horizontally(middle, way, radius), out, TP_SPECK_SPRAY);
        if (i % 2)
            continue;
        tp_vec3 under =
            offset_horizontally(middle, way, tp_fx_mul(radius, 2 * random_unit(spray)));
        under.y -= radius + tp_fx_mul(radius, 4 * random_unit(spray));
        tp_vec3 own = random_upward_vector(spray);
        throw(spray, under, (tp_vec3){ own.x / 16, TP_FX(0.15) + own.y / 6, own.z / 16 },
              TP_SPECK_BUBBLE);
    }
}

const struct tp_water_spray_splashes tp_water_spray_splashes = { tp_spray_splash };

#define BOW_PACE 2              /* m/s: lowest speed with bow spray */

static void throw_bow_spray(tp_world *world, const tp_scene *scene, tp_spray *spray,
                            const tp_surface *surface)
{
    const tp_hull *hull = &world->boat_state.hull;
    tp_vec3 way = tp_vec3_sub(world->boat.place, world->last_boat.place);
    tp_q30  s = tp_sin(hull->heading), c = tp_cos(hull->heading);
    int64_t gone = (int64_t)way.x * s - (int64_t)way.z * c;     /* Q46 m; 16 km: 2^60 */
    int64_t pace = tp_clamp_abs(gone, (int64_t)1 << 50) * TP_TICKS_PER_SECOND >> 30;
    tp_fx   over = (tp_fx)tp_clamp_abs(pace - BOW_PACE * TP_FX_ONE, 30 * TP_FX_ONE);

    for (tp_fx due = over / 2; due > random_unit(spray); due -= TP_FX_ONE) {
        tp_fx lag = random_unit(spray),
              side = random_signed_unit(spray) >= 0 ? TP_FX_ONE : -TP_FX_ONE;
        tp_fx ahead = scene->boat.length / 2 - tp_fx_mul(scene->boat.length / 5, lag);
        tp_fx aside = tp_fx_mul(tp_fx_mul(scene->boat.beam / 3, lag), side);
        tp_vec3 at = { hull->x + tp_q30_mul(ahead, s) + tp_q30_mul(aside, c), 0,
                       hull->z - tp_q30_mul(ahead, c) + tp_q30_mul(aside, s) };
        tp_fx out = tp_fx_mul(over / 3 + TP_FX(0.3) + random_unit(spray), side);
        tp_fx on = over / 3, lift = random_unit(spray), up = random_unit(spray);
        at.y = tp_surface_rough_height(surface, at.x, at.z);
        throw(spray, at,
              (tp_vec3){ tp_q30_mul(on, s) + tp_q30_mul(out, c),
                         TP_FX(0.8) + tp_fx_mul(on, lift) + up,
                         tp_q30_mul(out, s) - tp_q30_mul(on, c) }, TP_SPECK_SPRAY);
    }
}

/* ----------------------------------------------------------------------------------- */

static void step(void *mine, const tp_program *program, tp_world *world,
                 const tp_scene *scene, const tp_input *input)
{
    (void)input;
    tp_spray *spray = mine;
    const tp_surface surface = tp_world_surface(program, world);

    step_specks(spray, scene, &surface);
    throw_random_crests(world, scene, spray, &surface);
    if (scene->boat.mesh[0] && world->boat_state.placed)
        throw_bow_spray(world, scene, spray, &surface);
}

/* -- validation of a state from outside ---------------------------------------------- */

static bool is_vector_within(tp_vec3 v, tp_fx limit)
{
    return v.x >= -limit && v.x <= limit && v.y >= -limit && v.y <= limit && v.z >= -limit
        && v.z <= limit;
}

/* True if a speck is in range.  At 60 m/s and the table's largest gravity a tick of
 * gravity adds only the speed lost to drag. */
static bool is_speck_valid(const tp_speck *s)
{
    return is_vector_within(s->place, FAR_MOST) && is_vector_within(s->last, FAR_MOST)
           && is_vector_within(s->speed, SPEED_MOST + TP_FX_ONE)
           && s->kind <= TP_SPECK_BUBBLE && s->age < BUBBLE_AGE;
}

static bool is_valid(const void *mine, const void *fresh_state, const tp_world *world)
{
    (void)world;
    const tp_spray *spray = mine, *fresh = fresh_state;
    if (spray->capacity != fresh->capacity || spray->count > spray->capacity)
        return false;
    for (uint32_t i = 0; i < spray->count; i++)
        if (!is_speck_valid(&tp_spray_list(spray)[i]))
            return false;
    return true;
}

/* -- the module ---------------------------------------------------------------------- */

static bool fits(const void *mine, const tp_scene *scene)
{
    const tp_spray *spray = mine;
    return spray->capacity == (uint32_t)scene->spray.count;
}

static bool handle_impact(void *mine, const tp_program *program,
                          const tp_scene *scene, const tp_impact *impact, tp_fx level)
{
    if (program->water.spray_splashes)
        program->water.spray_splashes->add(mine, scene, impact, level);
    return false;
}

const tp_spray *tp_world_spray(const tp_world *world)
{
    return tp_spray_of_world(world);
}

const tp_module tp_spray_module = {
    .name = "spray", .id = TP_SPRAY_ID, .enabled = tp_spray_enabled, .check = check,
    .bytes = bytes, .init = init, .fits = fits, .step = step, .hit = handle_impact,
    .is_valid = is_valid,
};
