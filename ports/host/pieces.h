/* SPDX-License-Identifier: MIT */
/* The pieces of a program list, named as in the lists of tidepool/modules.h, and a program
 * list made from a set of pieces. */
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

/* A set of pieces, by their indices. */
typedef struct {
    bool has[PIECES_MOST];
} piece_set;

/* Settings of a list beside its pieces. */
typedef struct {
    tp_format format;           /* pixel format */
    bool      streams;          /* grid vertices are not stored: tp_method_streamed */
    bool      few;              /* room for the scene's waves only: tp_water_few_swells */
    bool      checks;           /* scenes are checked: tp_scene_check */
} piece_terms;

/* A list in memory; `program` points into the struct. */
typedef struct {
    tp_program program;
    tp_use   use[PIECES_MOST];
    tp_stage stage[PIECES_MOST];        /* tables of stages of modules, one after another */
} piece_list;

/* Makes a list.  Drawings and stages of a module that is not in the set are left out too.
 * The list refuses no scene. */
void pieces_list(piece_list *to, const piece_set *of, const piece_terms *terms);

/* The same with stages that note when they run.  pieces_ran: true if a stage has run since
 * pieces_forget.  Several threads may draw. */
void pieces_watch(piece_list *to, const piece_set *of, const piece_terms *terms);
void pieces_forget(void);
bool pieces_ran(size_t i);

/* Adds all pieces with a name, a module with its drawing and stages; false: no such
 * name. */
bool pieces_named(piece_set *to, const char *name, size_t length);

/* Adds the wave models of the water that modules of the set need. */
void pieces_add_models(piece_set *set);

/* True if a piece belongs to the world: a wave model or a module. */
bool piece_moves(size_t i);

static inline bool piece_is_stage(size_t i)
{
    return pieces[i].kind == PIECE_STAGE || pieces[i].kind == PIECE_MODULE_STAGE;
}

/* Returns the kind in words: "stage" of "stage sky", "module" of "module foam". */
const char *piece_word(size_t i);

/* True if the scene switches the module on, with the set's other pieces in the program. */
bool piece_is_active(size_t i, const piece_set *of, const piece_terms *terms,
                     const tp_scene *scene, const tp_assets *assets);

/* Writes the list as C text: NAME_program, preceded by its tables.  The program refuses
 * scenes with a module of `lacks` by the module's name. */
void pieces_write(FILE *out, const char *name, const piece_set *of, const piece_set *lacks,
                  const piece_terms *terms);
#endif
