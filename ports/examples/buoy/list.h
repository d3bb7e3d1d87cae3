/* SPDX-License-Identifier: MIT */
/* The modules that this program brings itself.  The library's list of modules and its
 * table of parameters are compiled again with TP_MORE set to this file. */
#ifndef LIST_H
#define LIST_H
#include "buoy_rows.h"

#define BUOY_AT 0               /* index of the buoy's first word in tp_scene.own */
#define TP_MORE_ROWS BUOY_ROWS,

/* Modules as in TP_MODULE_LIST, and the stages of each module. */
#define TP_MORE_LIST(X, N, P) X(buoy)
#define TP_STAGES_OF_buoy(X) X(buoy)
#endif
