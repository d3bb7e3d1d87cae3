/* SPDX-License-Identifier: MIT */
/* Frame functions for tools: RAM by use, the rungs of the frame, pixel counts, and
 * textures baked in advance. */
#ifndef TP_FRAME_TOOLS_H
#define TP_FRAME_TOOLS_H
#include <stdbool.h>
#include <stdint.h>
#include "tidepool/frame.h"
#include "tidepool/scene.h"

/* RAM by use, bytes. */
typedef struct {
    size_t frame;                   /* the block of tp_frame_bytes */
    size_t vertices, tables;        /* two large shares of the block */
    size_t mirror;                  /* share of the block for mirrors and refraction maps */
    size_t scratch;                 /* samples and pixels of one tile */
} tp_ram_use;

/* The frame's block holds memory for the features that the scene has at init:
 *  - vertices: the grid and its vertices; vertices of boat and land; drops, rings, specks
 *    of spray
 *  - tables: a sky's gradient; shininess, if the program has lit water; a generated or
 *    cube sky, the exposure, the boat's materials, slopes of pools that only change the
 *    light; glass, walls inside a pool, the caustics map (2 bytes a cell)
 *  - mirror: with mirror.method = stencil a map of half the picture's size and four rows
 *    of samples, 88320 bytes at 320x240; with mirror.size = quarter 24960, full 330240.
 *    With mirror.colours = rgb565 the three take 49920, 15360 and 176640.  88320 more for
 *    objects seen under water (water.clarity).  With mirror.method = cube 24576 bytes at
 *    any size.  A boat with smooth outlines takes 10240 more, with quarter 5120, full
 *    20480.  Each mirror has up to 128 bytes of numbers besides. */

tp_ram_use tp_frame_ram(const tp_frame *frame);

/* The rungs that a frame may change from one picture to the next. */
typedef struct {
    tp_visibility visibility;   /* never AUTO; the same holds for the other members */
    tp_shading    shading;
    tp_rate       rate;
} tp_rungs;

/* Rung masks: a bit 1 << rung for each rung of a kind that a frame may use: the exact rungs
 * and those that the scene names.  A frame has no memory for other rungs. */
typedef struct {
    uint8_t visibility, shading, rate;
} tp_rung_mask;

/* Sets the rungs of the following frames, for tests that compare two frames.  NULL: back to
 * those that the scene names.  A rung without memory in this frame (tp_rung_mask) is
 * replaced by the exact rung.  Frames of tp_frame_maker keep their rungs. */
void tp_frame_set_rungs(tp_frame *frame, const tp_rungs *rungs);

/* Returns the number of tiles of the picture. */
uint32_t tp_frame_tiles(const tp_frame *frame);

/* Returns the name of the first module that lacked something at the last tp_frame_begin: a
 * stage, the maker of a table, a table of the scene's numbers.  "sky": no module draws the
 * scene's sky; "samples": the program has no samples for things in the water; "cells": no
 * triangles of the grid.  NULL: nothing with a name was missing. */
const char *tp_frame_lacks(const tp_frame *frame);

/* Returns the number of water pixels of a drawn tile, still present in the scratch. */
uint32_t tp_frame_water_pixels(const tp_frame *frame, const void *scratch,
                               const tp_tile *tile);
#endif
