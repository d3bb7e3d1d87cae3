/* SPDX-License-Identifier: MIT */
/* "Did you mean ...?" */
#ifndef HOST_NEAREST_H
#define HOST_NEAREST_H

/* The distance to beat: keep one for a whole list of names. */
typedef struct {
    const char *wanted;
    const char *name;       /* the nearest so far, or NULL: none is near enough */
    unsigned    distance;   /* of it; at first, one more than is near enough */
} nearest;

nearest nearest_to(const char *wanted);
void    nearest_offer(nearest *best, const char *name);
#endif
