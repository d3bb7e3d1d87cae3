/* SPDX-License-Identifier: MIT */
/* The accuracy view: the picture beside one that is drawn otherwise, of the same world. */
#ifndef HOST_COMPARE_H
#define HOST_COMPARE_H
#include "stage.h"

typedef enum { COMPARE_OFF, COMPARE_SPLIT, COMPARE_DIFFERENCE, COMPARE_HOWS } compare_how;

/* By another rung, all of the exact ones, or the reference in double precision
 * (tests/reference), which draws in a thread of its own for seconds. */
typedef enum {
    AGAINST_EXACT, AGAINST_TRIANGLES, AGAINST_ROWS, AGAINST_PROJECTED, AGAINST_FLAT,
    AGAINST_QUICK, AGAINST_LAYERS, AGAINST_COLOUR, AGAINST_LOD, AGAINST_REFERENCE,
    AGAINSTS
} compare_against;

typedef struct compare compare;

compare *compare_begin(void);                   /* NULL: no memory */
void     compare_end(compare *c);
void     compare_set(compare *c, compare_how how, compare_against against);
compare_how     compare_how_of(const compare *c);
compare_against compare_against_of(const compare *c);

/* A scene, a size or a value has changed: what was made of it is made anew. */
void     compare_forget(compare *c);

/* After canvas_draw of the stage's canvas with its world.  The picture to be shown in its
 * place (xrgb8888, the same size; owned by `c`): left half ours and right half the
 * other's with a line between, or the difference, 8 times, grey = none.  NULL: off, or no
 * memory.  With the reference: of the last world that it has finished. */
const picture *compare_draw(compare *c, const stage *s);

double   compare_psnr(const compare *c);        /* dB; 100: same bits; -1: none yet */
const char *compare_note(const compare *c);     /* "" or what is being waited for */
bool     compare_moves(const compare *c);       /* a new picture of the reference is there */
extern const char *const compare_how_name[COMPARE_HOWS];
extern const char *const compare_against_name[AGAINSTS];
#endif
