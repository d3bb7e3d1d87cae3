/* SPDX-License-Identifier: MIT */
/* What the kernel says of a card's connectors. */
#ifndef KMS_HEADS_H
#define KMS_HEADS_H
#include "choose.h"

#define KMS_LIMIT 32            /* connectors, encoders, CRTCs of a card */

typedef struct {
    uint32_t n_crtcs, n_connectors;
    uint32_t crtcs[KMS_LIMIT], connectors[KMS_LIMIT];       /* ids */
    uint32_t driven_by[KMS_LIMIT];      /* a connector's CRTC, id; 0: none */
    kms_head head;                      /* the one read last */
} kms_heads;

/* Probes every connector; the best of them, if it holds width x height.  False, with
 * errno: the card sets no modes. */
bool kms_scan(int card, kms_heads *all, uint32_t width, uint32_t height,
              kms_choice *best);

/* Is the monitor still there, with that mode?  Only a probe, which is slow, sees it. */
bool kms_still(int card, kms_heads *all, const kms_choice *now, bool probe);
#endif
