/* SPDX-License-Identifier: MIT */
/* Finds the pieces that a scene needs: those without which the worlds and pictures of a dry
 * run would differ, or something would be counted as left out. */
#ifndef HOST_DRY_FIND_H
#define HOST_DRY_FIND_H
#include "dry_run.h"
#include "pieces.h"
#include "tidepool/frame.h"

typedef struct {
    const tp_scene  *scene;     /* as it is; */
    const tp_assets *assets;
    const tp_scene  *named;     /* the same with its plan's rungs named */
    const tp_assets *baked;     /* assets of the program, and ... */
    const tp_assets *lean;      /* ... fewer, if they will do; or NULL */
    tp_config config;
    piece_terms      terms;
    piece_set        with;      /* pieces that stay whatever the run says, and ... */
    piece_set        without;   /* ... that are not there at all */
    bool             acts;
} dry_wish;

typedef struct {
    piece_set in;
    piece_set lacks;            /* of `without`, those that the scene asks for */
    piece_set refused;          /* modules that a scene which changes may not switch on */
    bool      lean;             /* those assets will do */
    bool      planned;          /* the program plans for itself; else by the named scene */
    uint32_t  pictures;         /* that were compared */
} dry_found;

/* All cameras are drawn by the program that was found and by everything but `without`.
 * EXIT_CHECK: a picture or the world differs, which it says; EXIT_INPUT. */
int dry_find(dry_found *found, const dry_wish *wish);
#endif
