/* SPDX-License-Identifier: MIT */
/* "Did you mean ...?" */
#ifndef TP_APP_FILES_DID_YOU_MEAN_H
#define TP_APP_FILES_DID_YOU_MEAN_H

/* The best match for a word; use one struct for a whole list of names. */
typedef struct {
    const char *wanted;
    const char *name;       /* best name until now, or NULL: none is near enough */
    unsigned    distance;   /* its distance; initially the limit plus 1 */
} did_you_mean;

did_you_mean did_you_mean_make(const char *wanted);
void    did_you_mean_offer(did_you_mean *best, const char *name);
#endif
