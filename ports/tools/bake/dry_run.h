/* SPDX-License-Identifier: MIT */
/* A dry run: steps and draws a scene as a program on the target would, at many moments and
 * from many cameras, for comparing two lists.
 *
 * Cameras and inputs follow from a fixed seed: the same scene gives the same run. */
#ifndef TP_TOOLS_BAKE_DRY_RUN_H
#define TP_TOOLS_BAKE_DRY_RUN_H
#include <stdbool.h>
#include "tidepool/frame.h"

/* A program with the scene and the assets that it steps and draws. */
typedef struct {
    const tp_program *program;
    const tp_scene  *scene;
    const tp_assets *assets;
} dry_run_program;

typedef struct {
    uint32_t moment;            /* index of the run's stored worlds */
    bool     own;               /* true: the world's own camera; else the members below */
    tp_vec3  eye;
    tp_turn  heading, pitch;
} dry_run_camera;

typedef struct {
    uint32_t crc, dropped;
} dry_run_picture;

typedef struct {
    tp_config   config;
    bool        acts;
    size_t      world_bytes;
    uint8_t    *worlds;         /* worlds at each moment, one after another */
    uint32_t    moments;
    dry_run_camera *camera;
    uint32_t    cameras;
} dry_run;

/* Steps the world by a program and chooses cameras.  Without a user only the scene's
 * camera.  acts: a user gives inputs in the second half, and further cameras are around all
 * things of the scene, above and under water.  Each function returns an exit code, and
 * prints the reason of a failure; the caller calls dry_run_close in every case. */
int dry_run_open(dry_run *d, const dry_run_program *by, const tp_config *config, bool acts);
void dry_run_close(dry_run *d);

/* True if the program steps the run's worlds bit for bit through the first moments. */
bool dry_run_moves_same(const dry_run *d, const dry_run_program *by, uint32_t moments);

/* Draws the pictures of the cameras `which` (NULL: all); to[camera] gets the picture.
 * want: pictures of another run; drawing then ends soon after the first difference, and
 * *differs is its camera, or `cameras` if there is none. */
int dry_run_draw(const dry_run *d, const dry_run_program *by, const uint32_t *which,
                 uint32_t count, dry_run_picture *to, const dry_run_picture *want,
                 uint32_t *differs);
#endif
