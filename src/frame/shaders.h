/* SPDX-License-Identifier: MIT */
/* Shader lists: the span stages of a kind of sample, ordered by place.  A stage of a
 * module finds the module's data in tp_run.mine. */
#ifndef TP_FRAME_SHADERS_H
#define TP_FRAME_SHADERS_H
#include "shade/shade.h"
#include "tidepool/modules.h"

#define TP_SHADERS_WATER 20     /* capacity of the water's list, end included */
#define TP_SHADERS_OTHER 6      /* capacity of any other list */

/* Place of a stage in a list.  Stages of the same place run in the order of addition. */
typedef enum {
    TP_AT_PLACE,                /* a distortion moves texture coordinates */
    TP_AT_COLOUR,               /* textures; fast stages do all their work here */
    TP_AT_SLOPE,                /* ripples and pools change the normals */
    TP_AT_VIEW,
    TP_AT_LIGHT,
    TP_AT_REFRACT,               /* colours seen through the water */
    TP_AT_REFLECT,              /* the sky's reflection */
    TP_AT_OBJECTS,              /* reflections of objects, over the sky's */
    TP_AT_FRESNEL,              /* Fresnel share of the reflection */
    TP_AT_MATT,                 /* matt foam on the water */
    TP_AT_GLINT,
    TP_AT_AIR,                  /* haze */
    TP_AT_TONE,                 /* tone mapping */
    TP_AT_GLASS                 /* panes, over tone-mapped colours */
} tp_shader_order;

typedef struct {
    tp_stage    stage;          /* NULL: end of the list */
    const void *mine;           /* data of its module, or NULL */
} tp_shader;

/* The kind of samples in a list. */
typedef enum {
    TP_LIST_SKY,
    TP_LIST_WATER,
    TP_LIST_FAST,               /* water, by fast stages alone */
    TP_LIST_UNDERSIDE,              /* water seen from below */
    TP_LIST_THINGS              /* land, a boat, drops ... */
} tp_list_kind;

typedef struct {
    tp_shader *shader;
    uint8_t   *order;           /* place of each stage */
    const struct tp_drawing *owner;     /* the module of these samples, or NULL */
    uint8_t    kind;            /* tp_list_kind */
    uint8_t    first;           /* first stencil value of the samples */
    uint8_t    count, room;
    bool       rippled;         /* true: a stage changes the slopes */
    bool       shines;          /* true: a stage leaves a glint */
    uint8_t    lacks;           /* stages wanted by the scene, missing in the program */
    uint8_t    lacking;         /* 1 + the index, in the program's list, of the first
                                 * module that lacks a stage; 0: no module lacks one */
} tp_shaders;

void tp_shaders_init(tp_shaders *list, tp_list_kind kind, tp_shader *shader,
                     uint8_t *place, uint32_t room);
void tp_shaders_clear(tp_shaders *list);

/* Adds a stage after those of the same place.  NULL is not added but counted as lacking. */
void tp_shaders_add(tp_shaders *list, tp_shader_order place, tp_stage stage,
                    const void *mine);

/* Adds a stage at TP_AT_COLOUR without a module. */
static inline void tp_shaders_add_colour(tp_shaders *list, tp_stage stage)
{
    tp_shaders_add(list, TP_AT_COLOUR, stage, NULL);
}

/* Returns the wanted stage.  If the program lacks it, counts the lack and returns the
 * plainer stage. */
tp_stage tp_shaders_pick(tp_shaders *list, tp_stage wanted, tp_stage plainer);

/* True for water drawn by exact stages, seen from above or below. */
static inline bool tp_shaders_is_exact_water(const tp_shaders *list)
{
    return list->kind == TP_LIST_WATER || list->kind == TP_LIST_UNDERSIDE;
}

/* True if the list has a stage of the place. */
bool tp_shaders_has(const tp_shaders *list, tp_shader_order place);
#endif
