/* SPDX-License-Identifier: MIT */
/* The pieces that a program's list may hold or lack, as the lists of tidepool/modules.h name
 * them, and a list that is made of some of them. */
#ifndef HOST_PIECES_H
#define HOST_PIECES_H
#include <stdbool.h>
#include <stdio.h>
#include "tidepool/modules.h"

typedef enum {
    PIECE_STAGE, PIECE_WATER, PIECE_DRAW, PIECE_METHOD,
    PIECE_MODULE,               /* a use; its drawing and stages, if any, follow it */
    PIECE_DRAWING, PIECE_MODULE_STAGE
} piece_kind;

typedef struct {
    const char *name;           /* "sky", "swells", "foam" */
    piece_kind  kind;
} piece;

#define PIECES_MOST 256

extern const piece  pieces[];
extern const size_t piece_count;        /* up to PIECES_MOST */

/* A set of pieces, by their numbers. */
typedef struct {
    bool has[PIECES_MOST];
} piece_set;

/* What a list has beside its pieces. */
typedef struct {
    tp_format format;           /* the one that it stores */
    bool      streams;          /* crossings are not stored: tp_method_streamed */
    bool      few;              /* room for the scene's own waves: tp_water_few_swells */
    bool      checks;           /* scenes are checked: tp_scene_check */
} piece_terms;

/* A list in memory; `program` points into it. */
typedef struct {
    tp_program program;
    tp_use   use[PIECES_MOST];
    tp_stage stage[PIECES_MOST];        /* the tables of modules, one after another */
} piece_list;

/* Drawings and stages of a module that is not in the set are left out with it.  The list
 * refuses nothing. */
void pieces_list(piece_list *to, const piece_set *of, const piece_terms *terms);

/* The same with stages that note when they run; pieces_ran tells which have since
 * pieces_forget.  Threads may draw at once. */
void pieces_watch(piece_list *to, const piece_set *of, const piece_terms *terms);
void pieces_forget(void);
bool pieces_ran(size_t i);

/* All pieces of that name, a module's drawing and stages with it; false: there is none. */
bool pieces_named(piece_set *to, const char *name, size_t length);

/* Adds the models of the water's surface that modules of the set work on. */
void pieces_add_models(piece_set *set);

/* Pieces of the kinds that a world asks for. */
bool piece_moves(size_t i);

static inline bool piece_is_stage(size_t i)
{
    return pieces[i].kind == PIECE_STAGE || pieces[i].kind == PIECE_MODULE_STAGE;
}

/* "stage sky", "module foam": as people read them. */
const char *piece_word(size_t i);

/* True if a module is on in the scene, by a program of the other pieces of the set. */
bool piece_is_on(size_t i, const piece_set *of, const piece_terms *terms,
                 const tp_scene *scene, const tp_assets *assets);

/* The list as text in C: NAME_program and, before it, what it points to.  Modules in
 * `lacks` are refused by name when a scene comes to have them. */
void pieces_write(FILE *out, const char *name, const piece_set *of, const piece_set *lacks,
                  const piece_terms *terms);
#endif
