/* SPDX-License-Identifier: MIT */
/* Parameter rows of pools that bend the normals only. */
#ifndef TP_BUMPS_ROWS_H
#define TP_BUMPS_ROWS_H
#include "tidepool/modules.h"

#define TP_BUMPS_ROWS \
    TP_ROW_NUMBER("water.pool_bump", water.pool_bump, "", 0, 4, 0, \
        "above 0: pools bend normals with this strength, not the mesh")
#endif
