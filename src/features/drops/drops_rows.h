/* SPDX-License-Identifier: MIT */
/* Parameter rows of drops and of the releasing sphere. */
#ifndef TP_DROPS_ROWS_H
#define TP_DROPS_ROWS_H
#include "tidepool/modules.h"

#define TP_DROPS_ROWS \
    TP_ROW_COUNT("drops.count", drops.count, "", 0, 1024, 0, \
        "most drops in the air at once; 0: no sphere and no drops"), \
    TP_ROW_COUNT("drops.rings", drops.rings, "", 0, 1024, 64, \
        "most rings on the water at once"), \
    TP_ROW_CHOICE("drops.into", drops.into, "rings|pool", TP_DROPS_POOL, \
        TP_DROPS_RINGS, "an impact makes a ring, or a splash in the pool"), \
    TP_ROW_NUMBER("drops.x", drops.x, "m", -8000, 8000, 0, \
        "start position of the sphere, to the right of the origin"), \
    TP_ROW_NUMBER("drops.y", drops.y, "m", 0, 100, 3, "height of the sphere"), \
    TP_ROW_NUMBER("drops.z", drops.z, "m", -8000, 8000, 0, \
        "start position of the sphere, towards the viewer"), \
    TP_ROW_NUMBER("drops.radius", drops.radius, "m", 0.002, 1, 0.06, \
        "radius of a drop"), \
    TP_ROW_NUMBER("drops.density", drops.density, "kg/m^3", 100, 10000, 1000, \
        "density of a drop"), \
    TP_ROW_NUMBER("drops.drag", drops.drag, "", 0, 2, 0.47, \
        "drag coefficient Cd in air; 0: no drag"), \
    TP_ROW_NUMBER("drops.bounce", drops.bounce, "", 0.5, 0.8, 0.65, \
        "speed after an impact over the speed before"), \
    TP_ROW_COUNT("drops.impacts", drops.impacts, "", 5, 7, 6, \
        "impacts after which a drop vanishes"), \
    TP_ROW_NUMBER("drops.every", drops.every, "s", 0, 60, 1, \
        "time between automatic drops; 0: no automatic drops"), \
    TP_ROW_NUMBER("drops.scatter", drops.scatter, "m", 0, 1000, 0, \
        "greatest distance of an automatic drop from the sphere"), \
    TP_ROW_NUMBER("drops.efficiency", drops.efficiency, "", 0, 1, 0.2, \
        "share of a drop's lost energy that goes into its ring"), \
    TP_ROW_NUMBER("drops.speed", drops.speed, "m/s", 0.01, 64, 1.2, "speed of rings"), \
    TP_ROW_NUMBER("drops.decay", drops.decay, "s", 0.05, 1000, 2, \
        "time constant with which rings decay"), \
    TP_ROW_NUMBER("drops.spread", drops.spread, "m", 0.01, 1000, 1, \
        "distance at which the height of a ring has fallen to 0.7"), \
    TP_ROW_NUMBER("drops.attack", drops.attack, "s", 0, 8, 0.1, \
        "time in which a ring rises to its full height"), \
    TP_ROW_COLOUR("drops.colour", drops.colour, 0xbfe0f0, "colour of sphere and drops")
#endif
