/* SPDX-License-Identifier: MIT */
/* The list of all movers, as a kit names them. */
#include "scene/moves.h"
#include "base/base.h"
#include "scene/module.h"

/* -- what other files move ----------------------------------------------------------- */

const struct tp_move_boat   tp_move_boat = { tp_boat_init, tp_boat_step };
const struct tp_move_wake   tp_move_wake = { tp_boat_wake };
