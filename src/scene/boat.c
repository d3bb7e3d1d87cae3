/* SPDX-License-Identifier: MIT */
/* A boat that lies on the surface, [E2]: four points of the hull (bow, stern, port,
 * starboard) feel the water above or below their place in the world [E1]; heave is their
 * mean, pitch and roll the slopes between them.  Hull points half a boat apart make the
 * boat ignore waves that are short for it, as real hulls do. */
#include "scene/boat.h"

/* Height of the water `ahead` and `aside` of the boat's place, along its heading. */
static tp_fx height_at(const tp_world *world, const tp_scene *scene, tp_turn heading,
                       tp_fx ahead, tp_fx aside)
{
    tp_q30 s = tp_sin(heading), c = tp_cos(heading);
    tp_fx  x = scene->boat.x + tp_q30_mul(ahead, s) + tp_q30_mul(aside, c);
    tp_fx  z = scene->boat.z - tp_q30_mul(ahead, c) + tp_q30_mul(aside, s);

    return tp_sea_above(&world->sea, world->phases, x, z).position.y;
}

void tp_boat_place(tp_world *world, const tp_scene *scene)
{
    tp_turn heading = tp_turn_of_degrees(scene->boat.heading);
    tp_fx   length = scene->boat.length, beam = scene->boat.beam;
    tp_fx   bow = height_at(world, scene, heading, length / 2, 0);
    tp_fx   stern = height_at(world, scene, heading, -length / 2, 0);
    tp_fx   starboard = height_at(world, scene, heading, 0, beam / 2);
    tp_fx   port = height_at(world, scene, heading, 0, -beam / 2);

    world->boat = (tp_vec3){ scene->boat.x,
                             (bow + stern + port + starboard) / 4 + scene->boat.lift,
                             scene->boat.z };
    world->boat_turn = tp_rotation_of(heading, tp_atan2(bow - stern, length),
                                      tp_atan2(port - starboard, beam));
}
