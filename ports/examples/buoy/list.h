/* SPDX-License-Identifier: MIT */
/* The modules that this program brings itself.  The library's list and its table of
 * parameters are compiled again with TP_MORE naming this file. */
#ifndef LIST_H
#define LIST_H

#define BUOY_AT 0               /* its first word in tp_scene.own */
#include "buoy.h"

#define TP_MORE_MODULES TP_USE(buoy),
#define TP_MORE_ROWS BUOY_ROWS,
#endif
