/* SPDX-License-Identifier: MIT */
/* Earlier names of rows of the table of parameters.  Text from outside the program (scene
 * files, --set, tapes, serial lines, addresses of the web page) may use an earlier name for
 * one version. */
#ifndef TP_INTERACT_OLD_NAMES_H
#define TP_INTERACT_OLD_NAMES_H
#include <stddef.h>
#include <stdint.h>
#include "tidepool/scene.h"

#define OLD_NAMES_END "0.3"     /* the version that refuses the old names */

/* Old and new name have the same section: "pool.feed", "pool.drive_amplitude". */
typedef struct { const char *old, *now; } old_name;

/* Returns the table. */
const old_name *old_names(uint32_t *count);

/* Returns the entry of an old name, or NULL. */
const old_name *old_name_find(const char *name, size_t bytes);

/* Returns why a row that had this name is gone, without a successor; NULL: none had. */
const char *old_name_why_gone(const char *name, size_t bytes);

/* Returns the row that has this name now or had this name earlier; NULL: none. */
const tp_param *old_name_param(const char *name, size_t bytes);
#endif
