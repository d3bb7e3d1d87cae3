/* SPDX-License-Identifier: MIT */
/* Reads connectors, their encoders, and the CRTCs usable with the encoders. */
#include "connectors.h"
#include "buffer.h"

static uint32_t least(uint32_t a, uint32_t b)
{
    return a < b ? a : b;
}

static uint32_t crtc_index(const kms_connectors *all, uint32_t crtc)
{
    for (uint32_t i = 0; crtc && i < all->n_crtcs; i++)
        if (all->crtcs[i] == crtc)
            return i;
    return KMS_OFF;
}

/* Reads a connector.  The first call has counts of 0, which makes the kernel probe the
 * monitor; the second call fetches the result. */
static bool read_head(int card, kms_connectors *all, uint32_t connector)
{
    kms_connector *h = &all->head;
    uint32_t encoders[KMS_LIMIT];
    struct drm_mode_get_connector c = { .connector_id = connector };
    *h = (kms_connector){ .connector = connector, .crtc = KMS_OFF };
    if (!kms_ask(card, DRM_IOCTL_MODE_GETCONNECTOR, &c))
        return false;
    c.count_props = 0;
    c.count_modes = KMS_MODES;
    c.modes_ptr = (uintptr_t)h->modes;
    c.count_encoders = KMS_LIMIT;
    c.encoders_ptr = (uintptr_t)encoders;
    if (!kms_ask(card, DRM_IOCTL_MODE_GETCONNECTOR, &c))
        return false;
    h->status = c.connection;
    h->n_modes = c.count_modes <= KMS_MODES ? c.count_modes : 0;    /* none copied */
    for (uint32_t i = 0; i < c.count_encoders && c.count_encoders <= KMS_LIMIT; i++) {
        struct drm_mode_get_encoder e = { .encoder_id = encoders[i] };
        if (!kms_ask(card, DRM_IOCTL_MODE_GETENCODER, &e))
            continue;
        h->crtcs |= e.possible_crtcs;
        if (e.encoder_id == c.encoder_id)
            h->crtc = crtc_index(all, e.crtc_id);
    }
    return true;
}

static uint32_t busy_crtcs(int card, const kms_connectors *all, const uint32_t *encoders,
                           uint32_t n)
{
    uint32_t busy = 0;
    for (uint32_t i = 0; i < n; i++) {
        struct drm_mode_get_encoder e = { .encoder_id = encoders[i] };
        uint32_t crtc = KMS_OFF;
        if (kms_ask(card, DRM_IOCTL_MODE_GETENCODER, &e))
            crtc = crtc_index(all, e.crtc_id);
        busy |= crtc == KMS_OFF ? 0 : 1u << crtc;
    }
    return busy;
}

bool kms_connectors_scan(int card, kms_connectors *all, uint32_t width, uint32_t height,
                         kms_mode_choice *best)
{
    uint32_t encoders[KMS_LIMIT];
    struct drm_mode_card_res r = {
        .crtc_id_ptr = (uintptr_t)all->crtcs, .count_crtcs = KMS_LIMIT,
        .connector_id_ptr = (uintptr_t)all->connectors, .count_connectors = KMS_LIMIT,
        .encoder_id_ptr = (uintptr_t)encoders, .count_encoders = KMS_LIMIT,
    };
    *best = (kms_mode_choice){ 0 };
    if (!kms_ask(card, DRM_IOCTL_MODE_GETRESOURCES, &r))
        return false;
    all->n_crtcs = least(r.count_crtcs, KMS_LIMIT);
    all->n_connectors = least(r.count_connectors, KMS_LIMIT);
    uint32_t busy = busy_crtcs(card, all, encoders, least(r.count_encoders, KMS_LIMIT));
    for (uint32_t i = 0; i < all->n_connectors; i++) {
        bool known = read_head(card, all, all->connectors[i]);
        uint32_t crtc = all->head.crtc;
        all->driven_by[i] = crtc == KMS_OFF ? 0 : all->crtcs[crtc];
        all->head.busy = busy;
        if (known)
            kms_mode_offer(best, &all->head, width, height);
    }
    return true;
}

bool kms_connectors_still_valid(int card, kms_connectors *all, const kms_mode_choice *now,
                                bool probe)
{
    struct drm_mode_modeinfo one;
    struct drm_mode_get_connector c = { .connector_id = now->connector, .count_modes = 1,
                                        .modes_ptr = (uintptr_t)&one };
    if (probe)
        return read_head(card, all, now->connector)
               && kms_connector_has_mode(&all->head, &now->mode);
    return kms_ask(card, DRM_IOCTL_MODE_GETCONNECTOR, &c)
        && c.connection != KMS_DISCONNECTED;
}
