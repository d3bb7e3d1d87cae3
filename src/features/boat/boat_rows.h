/* SPDX-License-Identifier: MIT */
/* Parameter rows of the boat. */
#ifndef TP_BOAT_ROWS_H
#define TP_BOAT_ROWS_H
#include "tidepool/modules.h"

#define TP_BOAT_ROWS \
    TP_ROW_NAME("boat.mesh", boat.mesh, MESH, "OBJ file of the boat; empty: no boat"), \
    TP_ROW_NUMBER("boat.x", boat.x, "m", -8000, 8000, 0, \
        "start position, to the right of the origin"), \
    TP_ROW_NUMBER("boat.z", boat.z, "m", -8000, 8000, -12, \
        "start position, from the origin towards the viewer"), \
    TP_ROW_HEADING("boat.heading", boat.heading, 0, \
        "start direction of the bow, clockwise from -z"), \
    TP_ROW_NUMBER("boat.scale", boat.scale, "", 0.001, 100, 1, \
        "metres per unit of the mesh"), \
    TP_ROW_NUMBER("boat.lift", boat.lift, "m", -50, 50, 0, \
        "height of the mesh above the water"), \
    TP_ROW_NUMBER("boat.length", boat.length, "m", 0.1, 200, 10, \
        "distance between the points at bow and stern that sample the water"), \
    TP_ROW_NUMBER("boat.beam", boat.beam, "m", 0.1, 200, 3, \
        "distance between the points at both sides that sample the water"), \
    TP_ROW_CHOICE("boat.mode", boat.mode, "kinematic|dynamic", TP_BOAT_DYNAMIC, \
        TP_BOAT_KINEMATIC, \
        "kinematic: follows the water; dynamic: floats by its weight"), \
    TP_ROW_NUMBER("boat.smooth", boat.smooth, "s", 0, 10, 0, \
        "time constant with which the boat follows the water"), \
    TP_ROW_NUMBER("boat.draft", boat.draft, "m", 0.05, 20, 0.6, \
        "depth of the hull in the water at rest"), \
    TP_ROW_NUMBER("boat.drag", boat.drag, "", 0, 2, 0.3, \
        "damping of heave, roll and pitch; 1: critical, no overshoot"), \
    TP_ROW_NUMBER("boat.speed", boat.speed, "m/s", -30, 30, 0, \
        "speed without any input"), \
    TP_ROW_NUMBER("boat.rudder", boat.rudder, "degrees/s", -90, 90, 0, \
        "turn rate without any input"), \
    TP_ROW_NUMBER("boat.wake", boat.wake, "", 0, 1, 0.5, \
        "share of the displaced volume that makes waves in the pool")
#endif
