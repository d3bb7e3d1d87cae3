/* SPDX-License-Identifier: MIT */
/* The accuracy view: the picture beside one that is drawn otherwise, of the same world. */
#ifndef HOST_COMPARE_H
#define HOST_COMPARE_H
#include "stage.h"

typedef enum { COMPARE_OFF, COMPARE_SPLIT, COMPARE_DIFFERENCE, COMPARE_HOWS } compare_how;

/* By the exact rungs; as now, but by triangles; by exact ones but for what is named; or by
 * the reference in double precision (tests/reference), which draws in a thread of its own
 * for seconds. */
typedef enum {
    AGAINST_EXACT, AGAINST_TRIANGLES, AGAINST_ROWS, AGAINST_PROJECTED, AGAINST_FLAT,
    AGAINST_QUICK, AGAINST_LAYERS, AGAINST_COLOUR, AGAINST_LOD, AGAINST_REFERENCE,
    AGAINSTS
} compare_against;

typedef struct compare compare;

compare *compare_begin(void);                   /* NULL: no memory */
void     compare_end(compare *c);
void     compare_set(compare *c, compare_how how, compare_against against);

/* What there is to compare with, if nobody has chosen: exact rungs of 24 bits a pixel; or
 * where the stage's picture is that, quick shading, or the reference of a scene that has
 * none. */
compare_against compare_usual(const stage *s);
compare_how     compare_how_of(const compare *c);
compare_against compare_against_of(const compare *c);

/* What was made of a scene is made anew.  Before the stage's assets are closed: those are
 * in use until it returns, within some ms.  Changed values and sizes it sees itself. */
void     compare_forget(compare *c);

/* After canvas_draw of the stage's canvas with its world.  The picture to be shown in its
 * place (xrgb8888, the same size; owned by `c`): left half ours and right half the
 * other's with a line between, or the difference, 8 times, grey = none.  Colours are those
 * that are shown; the other's are of 24 bits, whatever the stage's format.  NULL: off, no
 * memory, or nothing to compare with yet.  With the reference: of the last world that it
 * has finished, the first time soon and coarse, without a PSNR; while the world stands,
 * with ever more samples. */
const picture *compare_draw(compare *c, const stage *s);

double   compare_psnr(const compare *c);        /* dB, up to 99 of the whole picture; 100:
                                                   same bits; -1: none yet */
const char *compare_note(compare *c);           /* "", what is being waited for, or what is
                                                   to be known; until the next call */
bool     compare_moves(const compare *c);       /* a new picture of the reference is there,
                                                   for the next compare_draw */
extern const char *const compare_how_name[COMPARE_HOWS];
extern const char *const compare_against_name[AGAINSTS];
#endif
