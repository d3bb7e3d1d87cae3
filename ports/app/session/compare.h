/* SPDX-License-Identifier: MIT */
/* The accuracy view: the loaded scene's picture beside another picture of the same world,
 * drawn by another method. */
#ifndef TP_APP_SESSION_COMPARE_H
#define TP_APP_SESSION_COMPARE_H
#include "app/scene/loaded_scene.h"

typedef enum { COMPARE_OFF, COMPARE_SPLIT, COMPARE_DIFFERENCE, COMPARE_HOWS } compare_how;

/* Methods of the other picture: all rungs exact; the current rungs, but triangles; exact
 * rungs except for the named rung; the reference in double precision
 * (ports/tools/reference), drawn on a thread of its own for seconds. */
typedef enum {
    AGAINST_EXACT, AGAINST_TRIANGLES, AGAINST_ROWS, AGAINST_PROJECTED, AGAINST_FLAT,
    AGAINST_QUICK, AGAINST_LAYERS, AGAINST_COLOUR, AGAINST_REFERENCE,
    AGAINSTS
} compare_against;

typedef struct comparison comparison;

comparison *compare_begin(void);                   /* NULL: no memory */
void     compare_end(comparison *c);
void     compare_set(comparison *c, compare_how how, compare_against against);

/* Returns the default method: exact rungs in 24-bit colour.  If the loaded scene's picture
 * is already exact, returns fast shading, or the reference for a scene unfit for fast
 * shading. */
compare_against compare_usual(const loaded_scene *s);
compare_how     compare_get_how(const comparison *c);
compare_against compare_get_against(const comparison *c);

/* Discards everything made from the scene.  To call before the loaded scene's assets are
 * closed: the assets are in use until the function returns, within some ms.  Changed values
 * and sizes are detected without a call. */
void     compare_forget(comparison *c);

/* To call after frame_renderer_draw of the loaded scene's frame renderer.  Returns the
 * picture to show instead (xrgb8888, same size; owned by `c`).  Split: left half of the
 * loaded scene's picture, right half of the other picture, with a line between.
 * Difference: 8 times the difference, grey = none.  The colours are the displayed colours;
 * the other picture has 24 bits, whatever the loaded scene's format.  Returns NULL if off,
 * without memory, or if no other picture exists yet.  The reference shows the last world
 * that it has finished: the first picture comes soon, is coarse and has no PSNR; while the
 * world stands still, more samples follow. */
const picture *compare_draw(comparison *c, const loaded_scene *s);

double compare_psnr(const comparison *c); /* PSNR, dB, of the whole picture, up to 99;
                                                 * 100: same bits; -1: none yet */
const char *compare_note(comparison *c);  /* "", progress, or a note on the picture;
                                                 * valid until the next call */
bool compare_moves(const comparison *c);  /* true if the reference has a new picture
                                                 * for the next compare_draw */
extern const char *const compare_how_name[COMPARE_HOWS];
extern const char *const compare_against_name[AGAINSTS];
#endif
