/* SPDX-License-Identifier: MIT */
/* The state of a card's connectors, read from the kernel. */
#ifndef TP_KMS_CONNECTORS_H
#define TP_KMS_CONNECTORS_H
#include "mode_select.h"

#define KMS_LIMIT 32            /* most connectors, encoders, CRTCs of a card */

typedef struct {
    uint32_t n_crtcs, n_connectors;
    uint32_t crtcs[KMS_LIMIT], connectors[KMS_LIMIT];       /* ids */
    uint32_t driven_by[KMS_LIMIT];      /* CRTC id of each connector; 0: none */
    kms_connector head;                      /* the last one read */
} kms_connectors;

/* Probes every connector and writes the best choice for width x height.  Returns false
 * with errno if the card cannot set modes. */
bool kms_connectors_scan(int card, kms_connectors *all, uint32_t width, uint32_t height,
                         kms_mode_choice *best);

/* True if the monitor is still there, and with `probe` still has the mode.  A probe is
 * slow. */
bool kms_connectors_still_valid(int card, kms_connectors *all, const kms_mode_choice *now,
                                bool probe);
#endif
