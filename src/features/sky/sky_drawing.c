/* SPDX-License-Identifier: MIT */
/* Chooses the stages of the sky, makes their tables, and estimates their cost. */
#include "features/sky/sky.h"
#include "frame/frame.h"
#include "quality/prices.h"

/* -- light beyond white -------------------------------------------------------------- */

static bool has_light_beyond_white(const tp_scene *scene, const tp_assets *assets)
{
    if (tp_has_dome(scene))
        return scene->sky.sun > 0;
    if (tp_has_cube(scene, assets))
        for (int i = 0; i < TP_FACES; i++)
            if (tp_cube_face_mask(assets->sky[i]) >> 24)
                return true;
    return false;
}

uint32_t tp_beyond_white(const tp_scene *scene, const tp_assets *assets)
{
    return has_light_beyond_white(scene, assets)
               ? (uint32_t)scene->hdr.share * TP_WHITES >> 8 : 0;
}

/* -- a generated sky ----------------------------------------------------------------- */

/* Indices in the program's table of stages. */
enum { DOME_SKY, DOME_SKY_HDR, DOME_SKY_QUICK, DOME_REFLECTION, DOME_SKY_FAST };

typedef struct {
    tp_own_table *own;          /* NULL: baked */
} dome;

static void make_dome(const tp_frame *frame, const void *from, void *entries)
{
    const tp_dome_config config = tp_dome_config_make(frame->scene);

    (void)from;
    tp_dome_init(entries, &config);
}

const struct tp_draw_dome tp_draw_dome = { { make_dome } };

static void begin_dome(tp_frame *frame, void *mine)
{
    const tp_scene *scene = frame->scene;
    const tp_dome_config config = tp_dome_config_make(scene);
    const int32_t numbers[] = { config.kind, (int32_t)config.horizon,
                                (int32_t)config.zenith, (int32_t)config.light, config.sun };
    const dome *own = mine;
    tp_env  *env = &frame->shade.env;

    if (scene->water.specular > 0)      /* the glitter is the disc's reflection */
        env->least = TP_DISC_END;
    env->kind = TP_ENV_DOME;
    env->beyond = tp_beyond_white(scene, &frame->assets);
    env->dome = tp_frame_table(frame, TP_TABLE_dome, own->own, numbers,
                               TP_TABLE_MAKER(frame->program->draw.dome), NULL);
}

/* True if the scene asks for the fast sky. */
static bool is_sky_fast(const tp_frame *frame)
{
    return frame->scene->quality.sky == TP_RUNG_FAST;
}

/* Returns the stage of the visible sky: the rung that the scene names; else a fast stage
 * with fast water, if the sky has neither stars nor light above white.  No fast stage
 * computes the view vectors that the exact stage of stars reads. */
static tp_stage select_dome_sky_stage(const tp_frame *frame, const tp_stage *stage)
{
    const tp_env *env = &frame->shade.env;

    if (is_sky_fast(frame) && stage[DOME_SKY_FAST])
        return stage[DOME_SKY_FAST];
    if (tp_has_hdr_stages(frame->shade.env.beyond, frame->scene))
        return stage[DOME_SKY_HDR];
    if (frame->rungs.shading == TP_SHADING_QUICK && env->stars == 0
        && stage[DOME_SKY_QUICK])
        return stage[DOME_SKY_QUICK];
    return stage[DOME_SKY];
}

static void add_dome_stages(const tp_frame *frame, const void *mine, const tp_stage *stage,
                            tp_shaders *list)
{
    if (list->kind == TP_LIST_SKY && !frame->under)
        tp_shaders_add(list, TP_AT_COLOUR, select_dome_sky_stage(frame, stage), mine);
    if (tp_frame_reflects_sky(frame, list))
        tp_shaders_add(list, TP_AT_REFLECT, stage[DOME_REFLECTION], mine);
}

/* -- the module sky_dome ------------------------------------------------------------- */

bool tp_sky_dome_enabled(const tp_module_conditions *conditions)
{
    return tp_has_dome(conditions->scene);
}

static void *layout_dome(tp_arena *arena, const tp_module_conditions *conditions)
{
    dome *made = tp_arena_alloc(arena, 1, sizeof *made);
    tp_own_table *own =
        tp_table_layout(arena, conditions->assets, TP_TABLE_dome, sizeof(tp_dome));

    if (made)
        made->own = own;
    return made;
}

const tp_module tp_sky_dome_module = {
    .name = "sky_dome", .id = TP_SKY_DOME_ID, .is = TP_MODULE_DOME,
    .trait = TP_TRAIT_dome, .enabled = tp_sky_dome_enabled,
};

const tp_drawing tp_sky_dome_drawing = {
    .layout = layout_dome,
    .begin = begin_dome,
    .stages = add_dome_stages,
};

/* -- stars over a night's dome ------------------------------------------------------- */

typedef struct {
    uint32_t recip[TP_RECIP + 2];
} stars;

static void init_stars(tp_frame *frame, void *mine)
{
    stars *s = mine;

    (void)frame;
    tp_recip_init(s->recip);
}

/* Sets the stars' count and size.  A star's radius is 0.85 px; a pixel is
 * 65536 / 2 / focal units of a face.  The radius stays within the margin of the stars'
 * cells. */
static void begin_stars(tp_frame *frame, void *mine)
{
    const stars *s = mine;
    tp_env  *env = &frame->shade.env;
    uint32_t focal = (uint32_t)frame->projection.focal >> 16;
    uint32_t radius = 32768 * 85 / 100 / (focal > 110 ? focal : 110);

    radius = radius > 8 ? radius : 8;
    env->stars = (uint32_t)frame->scene->sky.stars >> 10;
    env->star = (1u << 24) / (radius * radius);
    env->recip = s->recip;
}

/* Indices in the program's table of stages. */
enum { STARS, STARS_FAST };

/* Adds the stars' stage.  The exact stage reads the vectors of the dome's exact stage. */
static void add_stars_stage(const tp_frame *frame, const void *mine, const tp_stage *stage,
                            tp_shaders *list)
{
    if (list->kind == TP_LIST_SKY && !frame->under && frame->shade.env.stars > 0
        && tp_shaders_has(list, TP_AT_COLOUR))
        tp_shaders_add(list, TP_AT_COLOUR, stage[is_sky_fast(frame) ? STARS_FAST : STARS],
                       mine);
}

/* -- the module stars ---------------------------------------------------------------- */

bool tp_stars_enabled(const tp_module_conditions *conditions)
{
    return conditions->scene->sky.kind == TP_SKY_NIGHT
           && conditions->above & TP_MODULE_DOME;
}

static void *layout_stars(tp_arena *arena, const tp_module_conditions *conditions)
{
    (void)conditions;
    return tp_arena_alloc(arena, 1, sizeof(stars));
}

const tp_module tp_stars_module = {
    .name = "stars", .id = TP_STARS_ID, .is = TP_MODULE_STARS,
    .enabled = tp_stars_enabled,
};

const tp_drawing tp_stars_drawing = {
    .layout = layout_stars,
    .init = init_stars,
    .begin = begin_stars,
    .stages = add_stars_stage,
};

/* -- a cube map of six textures ------------------------------------------------------ */

/* Indices in the program's table of stages. */
enum { CUBE_SKY, CUBE_SKY_HDR, CUBE_REFLECTION, CUBE_SKY_FAST };

typedef struct {
    tp_cube  cube;
    uint32_t recip[TP_RECIP + 2];
} sky_cube;

static void init_cube(tp_frame *frame, void *mine)
{
    sky_cube *sky = mine;

    tp_cube_init(&sky->cube, frame->assets.sky);
    tp_recip_init(sky->recip);
}

/* Sets the environment.  A face spans 90 degrees, so half of its texels span a tangent of
 * 1; the mipmap level follows from the projection's focal length. */
static void begin_cube(tp_frame *frame, void *mine)
{
    sky_cube *sky = mine;
    tp_env   *env = &frame->shade.env;
    int32_t   focal = tp_log2_q8((uint32_t)frame->projection.focal) - 16 * 256;

    sky->cube.lod = (sky->cube.face[0]->log2_w - 1) * 256 - focal;
    env->kind = TP_ENV_CUBE;
    env->beyond = tp_beyond_white(frame->scene, &frame->assets);
    env->cube = &sky->cube;
    env->recip = sky->recip;
}

static tp_stage select_cube_sky_stage(const tp_frame *frame, const tp_stage *stage)
{
    if (is_sky_fast(frame) && stage[CUBE_SKY_FAST])
        return stage[CUBE_SKY_FAST];
    return stage[tp_has_hdr_stages(frame->shade.env.beyond, frame->scene) ? CUBE_SKY_HDR
                                                                          : CUBE_SKY];
}

static void add_cube_stages(const tp_frame *frame, const void *mine, const tp_stage *stage,
                            tp_shaders *list)
{
    if (list->kind == TP_LIST_SKY && !frame->under)
        tp_shaders_add(list, TP_AT_COLOUR, select_cube_sky_stage(frame, stage), mine);
    if (tp_frame_reflects_sky(frame, list))
        tp_shaders_add(list, TP_AT_REFLECT, stage[CUBE_REFLECTION], mine);
}

/* -- the module sky_cube ------------------------------------------------------------- */

bool tp_sky_cube_enabled(const tp_module_conditions *conditions)
{
    return tp_has_cube(conditions->scene, conditions->assets);
}

static void *layout_cube(tp_arena *arena, const tp_module_conditions *conditions)
{
    (void)conditions;
    return tp_arena_alloc(arena, 1, sizeof(sky_cube));
}

const tp_module tp_sky_cube_module = {
    .name = "sky_cube", .id = TP_SKY_CUBE_ID, .is = TP_MODULE_CUBE,
    .trait = TP_TRAIT_cube, .enabled = tp_sky_cube_enabled,
};

const tp_drawing tp_sky_cube_drawing = {
    .layout = layout_cube,
    .init = init_cube,
    .begin = begin_cube,
    .stages = add_cube_stages,
};

/* -- cost ---------------------------------------------------------------------------- */

/* The pixels of the sky, and light above white in the water's reflection. */

static void count_hdr_pixel_work(tp_site *w, const tp_work_pixels *px)
{
    const tp_scene *s = w->scene;

    if (!tp_has_hdr_stages(tp_beyond_white(s, w->assets), s))
        return;
    w->fixed_cost.of[TP_WORK_sky_hdr] = px->sky;
    w->fixed_cost.of[TP_WORK_hdr] = s->water.reflection > 0 ? px->water : 0;
}

static void count_dome_pixel_work(tp_site *w, const tp_work_pixels *px)
{
    const bool quick = w->quick && !(w->is & TP_MODULE_STARS);

    w->fixed_cost.of[quick ? TP_WORK_sky_quick : TP_WORK_sky_dome] = px->sky;
    count_hdr_pixel_work(w, px);
}

static void count_cube_pixel_work(tp_site *w, const tp_work_pixels *px)
{
    w->fixed_cost.of[TP_WORK_sky_cube] = px->sky;
    count_hdr_pixel_work(w, px);
}

static void count_star_pixel_work(tp_site *w, const tp_work_pixels *px)
{
    w->fixed_cost.of[TP_WORK_sky_stars] = px->sky;
}

const tp_cost tp_sky_dome_cost = { .pixels = count_dome_pixel_work };
const tp_cost tp_sky_cube_cost = { .pixels = count_cube_pixel_work };
const tp_cost tp_stars_cost = { .pixels = count_star_pixel_work };
