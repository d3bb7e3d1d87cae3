/* SPDX-License-Identifier: MIT */
/*
 * Shader lists of a frame: their stages and memory, the stencil values of the samples that
 * they shade, and the numbers for their stages.  A list contains only stages needed by the
 * scene.
 */
#include "base/base.h"
#include "frame/drawing.h"
#include "frame/frame.h"
#include "frame/renderers.h"
#include "raster/raster.h"
#include "world/light.h"

/* Empties the list over two arrays of `room` entries: stages with their data, and their
 * places. */
static void shaders_init(tp_shaders *list, tp_list_kind kind, tp_shader *shader,
                         uint8_t *order, uint32_t room)
{
    *list = (tp_shaders){ .shader = shader, .order = order, .kind = (uint8_t)kind,
                          .room = (uint8_t)room };
    tp_shaders_clear(list);
}

void tp_shaders_clear(tp_shaders *list)
{
    list->shader[0] = (tp_shader){ NULL, NULL };
    list->count = 0;
    list->rippled = list->shines = false;
    list->evens = NULL;
    list->lacks = list->lacking = 0;
}

void tp_shaders_add(tp_shaders *list, tp_shader_order order, tp_stage stage,
                    const void *mine)
{
    uint32_t at = list->count;

    if (!stage) {
        list->lacks++;
        return;
    }
    TP_ASSERT(list->count + 1 < list->room);
    list->shader[++list->count] = (tp_shader){ NULL, NULL };
    for (; at > 0 && list->order[at - 1] > order; at--) {
        list->shader[at] = list->shader[at - 1];
        list->order[at] = list->order[at - 1];
    }
    list->shader[at] = (tp_shader){ stage, mine };
    list->order[at] = (uint8_t)order;
}

tp_stage tp_shaders_pick(tp_shaders *list, tp_stage wanted, tp_stage plainer)
{
    if (wanted)
        return wanted;
    list->lacks++;
    return plainer;
}

bool tp_shaders_has(const tp_shaders *list, tp_shader_order order)
{
    for (uint32_t i = 0; i < list->count; i++)
        if (list->order[i] == order)
            return true;
    return false;
}

/* -- stencil values, and the memory of all lists ------------------------------------- */

enum { LISTS = TP_LIST_WATER + 1 };     /* lists of sky and water */

void tp_marks_init(tp_marks *marks)
{
    *marks = (tp_marks){ .count = TP_MARK_SOLID, .lists = LISTS };
}

uint32_t tp_marks_reserve_stencil_values(tp_marks *marks, uint32_t wanted)
{
    const uint32_t first = marks->count;

    if (wanted == 0 || wanted > TP_MARKS - first)
        return 0;
    marks->count = (uint16_t)(first + wanted);
    marks->lists++;
    return first;
}

/* Returns the index of list i's first stage in the shared memory of all lists; only the
 * water's list is long. */
static uint32_t first_stage_index(uint32_t i)
{
    return i * TP_SHADERS_OTHER
         + (i > TP_LIST_WATER ? TP_SHADERS_WATER - TP_SHADERS_OTHER : 0);
}

/* Assigns shader list i, and the stencil values from `first` on, to their owner. */
static void assign_list(tp_marks *marks, uint32_t i, uint32_t first,
                        const struct tp_drawing *owner)
{
    TP_ASSERT(i < marks->lists && first < marks->count);
    memset(marks->list_of + first, (int)i, marks->count - first);
    marks->list[i].first = (uint8_t)first;
    marks->list[i].owner = owner;
}

void tp_marks_layout(tp_marks *marks, tp_arena *arena, const tp_use *modules,
                     const uint8_t *first, uint32_t count)
{
    const uint32_t room = first_stage_index(marks->lists);
    tp_shader *shader;
    uint8_t   *order;

    marks->list = tp_arena_alloc(arena, marks->lists, sizeof *marks->list);
    shader = tp_arena_alloc(arena, room, sizeof *shader);
    order = tp_arena_alloc(arena, room + marks->count, sizeof *order);
    if (!marks->list)
        return;
    marks->list_of = order + room;
    for (uint32_t i = 0; i < marks->lists; i++)
        shaders_init(&marks->list[i],
                        i < LISTS ? (tp_list_kind)i : TP_LIST_THINGS,
                        shader + first_stage_index(i), order + first_stage_index(i),
                        first_stage_index(i + 1) - first_stage_index(i));
    assign_list(marks, TP_LIST_SKY, TP_MARK_SKY, NULL);
    assign_list(marks, TP_LIST_WATER, TP_MARK_WATER, NULL);
    for (uint32_t i = 0, list = LISTS; i < count; i++)
        if (first[i])
            assign_list(marks, list++, first[i], modules[i].drawing);
}

/* -- sampling numbers of the water's drifting textures ------------------------------- */

/* Returns the drift in metres after `time`, ticks x 65536; 16.16, wrapping. */
static uint32_t drift_distance(tp_fx metres_per_second, int64_t time)
{
    int64_t step =
        tp_quotient((int64_t)metres_per_second * ((int64_t)1 << 32), TP_TICKS_PER_SECOND);
    uint64_t part = (uint64_t)(step >> 16) * (uint32_t)(time & 0xffff);
    return (uint32_t)(((uint64_t)step * (uint64_t)(time >> 16) + part) >> 32);
}

/* Mipmap level at 1 m, Q8: log2 of texels a metre over pixels a metre at 1 m.  For
 * level ground half of log2 of the eye's height is subtracted for the slant (see
 * tp_mip_level_choose). */
int32_t tp_frame_lod(const tp_frame *frame, tp_fx texels_per_metre, bool level_ground)
{
    TP_ASSERT(frame->projection.focal > 0);
    int32_t lod = tp_log2_q8((uint32_t)(texels_per_metre > 0 ? texels_per_metre : 1))
                  - tp_log2_q8((uint32_t)frame->projection.focal);
    tp_fx height = tp_abs(frame->projection.eye.y);

    if (height < TP_FX_ONE)
        height = TP_FX_ONE;
    return level_ground ? lod - (tp_log2_q8((uint32_t)height) - 16 * 256) / 2 : lod;
}

uint32_t tp_frame_repeats_per_metre(tp_fx size)
{
    TP_ASSERT(size > 0);
    return (uint32_t)tp_quotient(((int64_t)1 << 32) + size / 2, size);
}

/* Texels per metre of the longer side.  4096 texels on 0.1 m exceed 16.16 and saturate. */
static tp_fx texels_a_metre(const tp_texture *texture, tp_fx size)
{
    TP_ASSERT(texture->levels > 0 && texture->levels <= TP_TEXTURE_LEVELS);
    return tp_fx_div(TP_FX_ONE << (texture->levels - 1), size);
}

tp_layer tp_frame_layer(const tp_frame *frame, const tp_texture *texture,
                        const tp_scene_map *map)
{
    const int64_t time = frame->drawn.time;
    tp_layer layer = { .texture = texture };

    if (!texture)
        return layer;
    layer.per_metre = tp_frame_repeats_per_metre(map->size);
    layer.drift_s = 0u - drift_distance(map->drift_x, time) * layer.per_metre;
    layer.drift_t = 0u - drift_distance(map->drift_z, time) * layer.per_metre;
    layer.lod = tp_frame_lod(frame, texels_a_metre(texture, map->size), true);
    return layer;
}

/* -- lists of a picture -------------------------------------------------------------- */

static void set_light_direction(tp_frame *frame)
{
    tp_view_axes *axes = &frame->shade.world;
    tp_dir3 light = tp_light_direction(frame->drawn.light_heading,
                                       frame->drawn.light_elevation);

    axes->lx = light.x >> 16;
    axes->ly = light.y >> 16;
    axes->lz = light.z >> 16;
}

/* Fills the water's list with fast stages if the plan says so and the program has all
 * stages for the picture; else with exact stages. */
static void fill_water_shaders(tp_frame *frame)
{
    tp_shaders *water = tp_frame_list(frame, TP_MARK_WATER);

    tp_shaders_clear(water);
    water->kind = TP_LIST_FAST;
    if (frame->rungs.shading == TP_SHADING_QUICK
        && tp_frame_has_module(frame, TP_MODULE_FAST))
        tp_frame_add_stages(frame, water);
    if (tp_shaders_has(water, TP_AT_COLOUR))
        return;
    tp_shaders_clear(water);
    water->kind = TP_LIST_WATER;
    tp_frame_add_stages(frame, water);
    if (!tp_shaders_has(water, TP_AT_COLOUR))
        tp_shaders_add_colour(water, frame->program->stage.plain);
}

/* Fills the water's list for the surface seen from below. */
static void fill_underside_shaders(tp_frame *frame)
{
    tp_shaders *water = tp_frame_list(frame, TP_MARK_WATER);

    tp_shaders_clear(water);
    water->kind = TP_LIST_UNDERSIDE;
    tp_shaders_add(water, TP_AT_VIEW, frame->program->stage.view, NULL);
    tp_frame_add_stages(frame, water);
}

/* Returns the stage of the gradient. */
static tp_stage select_gradient_stage(const tp_frame *frame)
{
    const tp_stages *stage = &frame->program->stage;

    return frame->scene->quality.sky == TP_RUNG_FAST && stage->sky_fast ? stage->sky_fast
                                                                        : stage->sky;
}

/* Fills the sky's list.  A sky without a module becomes the gradient. */
static void fill_sky_shaders(tp_frame *frame)
{
    const bool named = tp_has_dome(frame->scene)
                    || tp_has_cube(frame->scene, &frame->assets);
    tp_shaders *sky = tp_frame_list(frame, TP_MARK_SKY);

    tp_shaders_clear(sky);
    tp_frame_add_stages(frame, sky);
    if (!tp_shaders_has(sky, TP_AT_COLOUR))
        tp_shaders_add_colour(sky, tp_shaders_pick(sky, select_gradient_stage(frame),
                                                   frame->program->stage.plain));
    if (named && frame->shade.env.kind == TP_ENV_GRADIENT)
        sky->lacks++;
}

/* Counts missing stages.  `fallback_lacking` is the name to report if no module lacks
 * the stage. */
static void count_missing_stages(tp_frame *frame, const tp_shaders *list,
                                 uint8_t fallback_lacking)
{
    frame->stats.dropped += list->lacks;
    if (list->lacks && !frame->lacking)
        frame->lacking = list->lacking ? list->lacking : fallback_lacking;
}

static void fill_shader_lists(tp_frame *frame)
{
    fill_sky_shaders(frame);
    count_missing_stages(frame, tp_frame_list(frame, TP_MARK_SKY), TP_LACKING_SKY);
    tp_frame_fill_module_lists(frame);
    if (frame->under)
        fill_underside_shaders(frame);
    else
        fill_water_shaders(frame);
    const tp_shaders *water = tp_frame_list(frame, TP_MARK_WATER);
    frame->shade.evens_only = tp_frame_has_packed_rows(frame) && water->evens
                              && water->evens == water->shader[water->count - 1].stage;
    count_missing_stages(frame, water, 0);
}

static void make_gradient(const tp_frame *frame, const void *from, void *entries)
{
    (void)from;
    tp_shade_sky(entries, (uint32_t)frame->scene->sky.horizon,
                 (uint32_t)frame->scene->sky.zenith);
}

/* Sets the gradient of two colours, which are its ends. */
static void set_sky_gradient(tp_frame *frame)
{
    static const tp_table_maker maker = { make_gradient };
    const int32_t numbers[] = { frame->scene->sky.horizon, frame->scene->sky.zenith };
    const uint32_t dropped = frame->stats.dropped;

    frame->shade.sky = tp_frame_table(frame, TP_TABLE_gradient, frame->buffers.gradient,
                                      numbers, &maker, NULL);
    if (frame->stats.dropped > dropped)
        frame->lacking = TP_LACKING_SKY;
}

void tp_frame_set_up_shading(tp_frame *frame)
{
    TP_ASSERT(frame->projection.zi_near > 0);
    const tp_scene *scene = frame->scene;
    tp_shade *shade = &frame->shade;

    tp_view_set_shade(frame, &frame->projection);
    shade->ambient = scene->light.ambient >> 8;
    shade->mirror = scene->water.reflection >> 8;
    shade->light_colour = (uint32_t)scene->light.colour;
    set_light_direction(frame);
    shade->water_colour = (uint32_t)scene->water.colour;
    shade->shine = NULL;
    shade->dark = 0;
    shade->filtered =       /* a grid leaves nothing out of level water */
        scene->water.rough && tp_surface_has_swells(&frame->surface)
            ? tp_frame_filtered_waves(frame) : NULL;
    shade->ripple = NULL;
    shade->fresnel = NULL;
    set_sky_gradient(frame);
    shade->env = (tp_env){ 0 };
    frame->tone_map = NULL;
    tp_frame_begin_modules(frame);
    fill_shader_lists(frame);
}
