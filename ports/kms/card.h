/* SPDX-License-Identifier: MIT */
/* A card's screen: taken with a mode and black buffers, and given back as it was. */
#ifndef KMS_CARD_H
#define KMS_CARD_H
#include "buffer.h"
#include "heads.h"

typedef struct {
    const char *device;
    char        seat[128];              /* where its hardware is plugged in, or "" */
    int         fd, both;               /* -1: unplugged; the epoll that it belongs to */
    uint32_t    wanted_w, wanted_h;     /* 0: any */
    uint32_t    width, height;          /* of pictures; kept while it is dark */
    bool        master, lit;
    bool        blind;                  /* a card, but not one for screens */
    kms_heads   heads;
    kms_choice  now;                    /* connector, CRTC and mode, if lit */
    struct drm_mode_crtc before;        /* as it was found; crtc_id 0: not yet */
    uint32_t    before_on[KMS_LIMIT];
    kms_buffer  buffers[2];
    uint32_t    n_buffers, front;       /* the shown one */
    char        why[160];               /* what went wrong last */
} kms_card;

/* False: see why.  `fits`: only a mode that holds the picture wanted will do. */
bool kms_take(kms_card *c, bool fits);

/* The same with `fits`.  Where the card is a blind one, as boards have them that draw by
 * one and show by another, the next that is not: card1 instead of card0. */
bool kms_take_first(kms_card *c);

/* Is it as we took it, or has the monitor gone, or somebody taken the CRTC? */
bool kms_still_ours(kms_card *c, bool probe);

/* Of a lit card: shows another buffer.  False, with errno. */
bool     kms_set_crtc(kms_card *c, const kms_buffer *b);
uint32_t kms_crtc(const kms_card *c);

void kms_darken(kms_card *c);           /* the buffers go */
void kms_give_back(kms_card *c);        /* what was shown before, as far as we may */
void kms_close_card(kms_card *c);
#endif
