/* SPDX-License-Identifier: MIT */
/* A dry run: a scene is stepped and drawn here as a program would do it elsewhere, at many
 * moments and from many places, so that two lists can be compared.
 *
 * Cameras and inputs follow from a fixed seed; the same scene gives the same run. */
#ifndef HOST_DRY_RUN_H
#define HOST_DRY_RUN_H
#include <stdbool.h>
#include "scene/plan.h"
#include "tidepool/frame.h"

/* A program with the scene and the assets that it steps and draws. */
typedef struct {
    const tp_program *program;
    const tp_scene  *scene;
    const tp_assets *assets;
} dry_program;

typedef struct {
    uint32_t moment;            /* of the run's worlds */
    bool     own;               /* the world's own camera; else: */
    tp_vec3  eye;
    tp_turn  heading, pitch;
    uint32_t rung;              /* of the ladder */
} dry_camera;

typedef struct {
    uint32_t crc, dropped;
} dry_picture;

typedef struct {
    tp_config config;
    tp_ladder   ladder;
    bool        acts;
    size_t      world_bytes;
    uint8_t    *worlds;         /* one after another, as they were at each moment */
    uint32_t    moments;
    dry_camera *camera;
    uint32_t    cameras;
} dry_run;

/* Steps the world by a program and chooses cameras: those of the scene alone or, if
 * somebody acts, others around all that the scene has, above and under water, and inputs in
 * the second half.  Each returns an exit code and has said why; close in any case. */
int dry_open(dry_run *d, const dry_program *by, const tp_config *config, bool acts);
void dry_close(dry_run *d);

/* True if the program steps the run's worlds bit for bit. */
bool dry_moves_same(const dry_run *d, const dry_program *by);

/* Pictures of the cameras `which` (NULL: all), each into its place in `to`.  With `want`,
 * another run's pictures, it ends soon after the first that differs: *differs is its
 * camera, or `cameras` if there is none. */
int dry_draw(const dry_run *d, const dry_program *by, const uint32_t *which,
             uint32_t count, dry_picture *to, const dry_picture *want, uint32_t *differs);
#endif
