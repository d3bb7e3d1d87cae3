/* SPDX-License-Identifier: MIT */
/* Shader lists: the span stages that a kind of sample goes through, in order of places.
 * A stage may belong to a module; it then finds the module's data in tp_run.mine. */
#ifndef TP_FRAME_SHADERS_H
#define TP_FRAME_SHADERS_H
#include "shade/shade.h"
#include "tidepool/modules.h"

#define TP_SHADERS_WATER 20     /* room of the water's list, with its end, */
#define TP_SHADERS_OTHER 6      /* and of any other */

/* The order of stages in a list; stages of one place stand in the order they were added. */
typedef enum {
    TP_AT_PLACE,                /* a distortion moves the places of pictures */
    TP_AT_COLOUR,               /* pictures; all that the fast stages do */
    TP_AT_SLOPE,                /* ripples and pools bend the normals */
    TP_AT_VIEW,
    TP_AT_LIGHT,
    TP_AT_BEHIND,               /* seen through the water */
    TP_AT_REFLECT,              /* what the water mirrors of the sky, */
    TP_AT_OBJECTS,              /* of objects over that, */
    TP_AT_FRESNEL,              /* and its share in the colour */
    TP_AT_MATT,                 /* what lies on the water */
    TP_AT_GLINT,
    TP_AT_AIR,                  /* haze, */
    TP_AT_TONE,                 /* exposure */
    TP_AT_GLASS                 /* panes, over exposed colours */
} tp_place;

typedef struct {
    tp_stage    stage;          /* NULL: the end */
    const void *mine;           /* of the module that added it, or NULL */
} tp_shader;

/* The kind of samples that a list is for. */
typedef enum {
    TP_LIST_SKY,
    TP_LIST_WATER,
    TP_LIST_FAST,               /* water, by fast stages alone */
    TP_LIST_BELOW,              /* water, seen from below */
    TP_LIST_THINGS              /* land, a boat, drops ... */
} tp_list_kind;

typedef struct {
    tp_shader *shader;
    uint8_t   *place;           /* of each */
    const struct tp_drawing *owner;     /* the module that draws these samples, or NULL */
    uint8_t    kind;            /* tp_list_kind */
    uint8_t    first;           /* of the samples' marks */
    uint8_t    count, room;
    bool       rippled;         /* a stage bends the slopes */
    bool       shines;          /* a stage leaves a glint */
    uint8_t    lacks;           /* stages that the scene asks for and the program has not */
    uint8_t    lacking;         /* 1 + the place in the program's list of the first module
                                 * that lacks one; 0: none of them does */
} tp_shaders;

void tp_shaders_init(tp_shaders *list, tp_list_kind kind, tp_shader *shader,
                     uint8_t *place, uint32_t room);
void tp_shaders_clear(tp_shaders *list);

/* Adds a stage behind those of the same place; NULL is not added, but counted as lacking. */
void tp_shaders_add(tp_shaders *list, tp_place place, tp_stage stage, const void *mine);

/* Adds a stage of colour that belongs to no module. */
static inline void tp_shaders_add_colour(tp_shaders *list, tp_stage stage)
{
    tp_shaders_add(list, TP_AT_COLOUR, stage, NULL);
}

/* The stage that a list wants or, counted, the plainer one that the program has. */
tp_stage tp_shaders_pick(tp_shaders *list, tp_stage wanted, tp_stage plainer);

/* True of water by exact stages, seen from above or below. */
static inline bool tp_shaders_is_exact_water(const tp_shaders *list)
{
    return list->kind == TP_LIST_WATER || list->kind == TP_LIST_BELOW;
}

/* True if a stage of that place is in the list. */
bool tp_shaders_has(const tp_shaders *list, tp_place place);
#endif
