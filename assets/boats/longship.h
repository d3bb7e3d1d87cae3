/* SPDX-License-Identifier: MIT */
/* Parts of the longship. Shapes are in metres in the boat's own frame: x to starboard, y up
 * from the waterline, z aft, origin amidships. */
#ifndef LONGSHIP_H
#define LONGSHIP_H
#include "mesh.h"

enum { STRAKES = 9 };

/* Full: all planks, shields and oars.  Middle: the same parts with fewer sides and rings,
 * smooth planks, flat shields. */
typedef enum { FULL, MIDDLE } ship_detail;

/* -- posts.c: keel, stem with the dragon's head, stern with the curled tail ---------- */

typedef enum { BOW, STERN } ship_end;

/* Point where the planks of strake edge 0..STRAKES meet the post. */
vec post_rabbet(ship_end end, double edge);
void posts_build(mesh *m, ship_detail detail);
void posts_build_low(mesh *m);

/* -- hull.c -------------------------------------------------------------------------- */

/* Point of strake edge 0 (keel) .. STRAKES (gunwale) on the starboard side; u runs from -1
 * at the bow to 1 at the stern. */
vec hull_point(double edge, double u);
vec hull_outward(double edge, double u); /* across the strake, level with the frame */
double hull_u_at(double edge, double z); /* the u of the edge's point with this z */
double hull_inner_x(double y, double u); /* half the inner breadth between the skins */

void hull_build(mesh *m, ship_detail detail);
void hull_build_low(mesh *m);

/* -- rig.c: mast, yard, sail, ropes -------------------------------------------------- */

void rig_build(mesh *m, ship_detail detail);
void rig_build_low(mesh *m);

/* -- gear.c: shields, oars, steering oar, thwarts ------------------------------------ */

void gear_build(mesh *m, ship_detail detail);
void gear_build_low(mesh *m);

/* -- paint.c: the textures ----------------------------------------------------------- */

void paint_all(const char *dir);
#endif
