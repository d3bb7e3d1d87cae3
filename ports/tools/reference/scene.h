/* SPDX-License-Identifier: MIT */
/* Scene of the reference: the engine's scene, assets and world are read as data; everything
 * else is computed again in double precision.
 *
 * The heads of surface.h, coastal_water.h, sky_light.h, stars.h, water.h, foam.h, spray.h,
 * solids.h, inside.h and caustics.h list the features. */
#ifndef TP_TOOLS_REFERENCE_SCENE_H
#define TP_TOOLS_REFERENCE_SCENE_H
#include "mesh.h"
#include "optics.h"
#include "ray.h"

/* A drop: half axes, m. */
typedef struct {
    ref_vec centre;
    double  wide, high;
} ref_drop;

/* A block of stone: a wall of a tank, or wall cells of a pool's mask. */
typedef struct {
    double x0, x1, y0, y1, z0, z1;
} ref_block;

/* Light focused by waves (caustics.h). */
typedef struct ref_caustics ref_caustics;

/* Box of a pool: stone or transparent glass. */
typedef struct {
    int    kind;                /* tp_tank_kind */
    double x0, x1, z0, z1, depth, rim;
} ref_tank;

enum { REF_SURF = 1024 };

/* Foam: cover over rest positions of the water. */
typedef struct {
    const uint8_t *cover;       /* torus of cells x cells bytes; NULL: no foam */
    int     cells;
    int32_t first_x, first_z;   /* lowest cell of the window */
    double  cell;               /* side of a cell, m */
    double  drift_x, drift_z;   /* origin of the cells' lattice, m */
    bool    fades;              /* the cover passes into the far cover */
    double  far_old, far_fresh; /* cover beyond the window: of all backs of waves, and over
                                 * the slope's fourth power */
    double  way_x, way_z;       /* unit vector of the waves' mean way */
    double  shore_x, shore_z;   /* direction of a straight beach; both 0: none */
    bool    by_depth;           /* the floor's depth gives the far cover, by ... */
    double  surf[REF_SURF + 1]; /* ... its mean at even depths from 0 to 2 `deep` */
    double  deep;               /* depth from which on crests of open water foam, m */
    double  swing, slope;       /* share of the mean between waves' backs and fronts; slope
                                 * with all of the swing */
    double  rank[256];          /* share of darker texels, by green, 0..1 */
    double  mean;               /* rank of the texture's mean */
} ref_foam;

/* A speck of spray or a bubble as a soft streak. */
typedef struct {
    double u, v, radius;        /* middle and half of the width, pixels of the picture */
    double du, dv;              /* half of the way, pixels */
    double depth;               /* ahead of the eye, m */
    double opacity;             /* on the way, 0..1 */
    bool   through;             /* a bubble seen through the water's surface */
} ref_speck;

typedef struct {
    const tp_scene  *scene;
    const tp_assets *assets;
    bool       meshed;          /* textures have the engine's mipmap levels:
                                 * for comparisons with one sample a pixel */
    ref_camera camera;
    ref_surface surface;
    ref_vec    light;           /* towards the light */
    double     ambient, haze;   /* ambient light, 0..1; haze, m */
    double     exposure;        /* exposure of the camera; 1: neutral */
    double     seconds;         /* since tick 0 */
    bool       immersion;       /* the eye is under water */
    ref_mesh   boat, lids;
    ref_rows   boat_rows;
    ref_vec    boat_place;
    ref_drop  *drop;
    int        drops;
    ref_foam   foam;
    ref_speck *speck;
    int        specks;
    ref_tank   tank;
    double     runup, swash;    /* height of the highest swash, m; its phase, turns */
    ref_block *block;
    int        blocks;
    ref_caustics *caustics;     /* NULL: none */
} ref_scene;

/* The camera alone. */
ref_camera ref_scene_camera(const tp_scene *scene, const tp_world *world, uint32_t width,
                            uint32_t height);

/* Opens a scene. Scene, assets and world must outlive the result. */
void ref_scene_open(ref_scene *s, const tp_scene *scene, const tp_assets *assets,
                    const tp_world *world, uint32_t width, uint32_t height, bool meshed);
void ref_scene_close(ref_scene *s);
#endif
