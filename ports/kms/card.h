/* SPDX-License-Identifier: MIT */
/* A card's screen: set to a mode with black buffers, and restored at the end. */
#ifndef TP_KMS_CARD_H
#define TP_KMS_CARD_H
#include "buffer.h"
#include "connectors.h"

typedef struct {
    const char *device;
    char        seat[128];              /* hardware path, or "" */
    int         fd, both;               /* fd -1: unplugged; both: epoll with fd in it */
    uint32_t    wanted_w, wanted_h;     /* 0: any */
    uint32_t    width, height;          /* of pictures, px; kept while dark */
    bool        master, lit;
    bool        blind;                  /* no display output */
    kms_connectors heads;
    kms_mode_choice now;                /* connector, CRTC and mode, if lit */
    struct drm_mode_crtc before;        /* state as found; crtc_id 0: not yet saved */
    uint32_t    before_on[KMS_LIMIT];
    kms_buffer  buffers[2];
    uint32_t    n_buffers, front;       /* front: the shown buffer */
    char        why[160];               /* reason of the last failure */
} kms_card;

/* Takes the screen.  Returns false with the reason in `why`.  `fits`: accept only a mode
 * at least as large as the wanted picture. */
bool kms_take(kms_card *c, bool fits);

/* The same with `fits`.  Skips cards without display output: some boards render with one
 * card and display with another, card1 instead of card0. */
bool kms_take_first(kms_card *c);

/* True if the screen is as we set it: the monitor is present and no program took the
 * CRTC. */
bool kms_still_ours(kms_card *c, bool probe);

/* Shows another buffer of a lit card.  Returns false with errno. */
bool     kms_set_crtc(kms_card *c, const kms_buffer *b);
uint32_t kms_crtc(const kms_card *c);

void kms_darken(kms_card *c);           /* frees the buffers */
void kms_give_back(kms_card *c);        /* restores the state as found, if permitted */
void kms_close_card(kms_card *c);
#endif
